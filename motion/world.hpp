#pragma once
/// The balls and what acts on them: what the loop changes and structures read.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "ball.hpp"
#include "large_vector.hpp"
#include "meeting.hpp"

namespace signum::motion {

/// Rounded down; |x| < 2^62. Without a call, which std::floor is on some processors.
[[nodiscard]] inline std::int64_t rounded_down(double x) noexcept {
    const auto whole = static_cast<std::int64_t>(x);
    return whole - static_cast<std::int64_t>(static_cast<double>(whole) > x);
}

template <int D>
struct World {
    World(LargeVector<Ball<D>> balls_then, const Effects<D>& effects_then, double start_then)
        : balls(std::move(balls_then)), effects(effects_then), start(start_then) {
        if (!effects.box) return;
        for (int k = 0; k < D; ++k) {
            length[k] = effects.box->high[k] - effects.box->low[k];
            inverse_length[k] = 1.0 / length[k];
            if (effects.periodic) far = std::min(far, 0.2 * length[k] * length[k]);
        }
    }

    LargeVector<Ball<D>> balls;
    Effects<D> effects;
    /// When the structures begin.
    double start;
    /// Of the box, rounded.
    Vector<D> length{};
    Vector<D> inverse_length{};
    /// Whose square of the distance is less is seen in the image that is nearest; infinite where
    /// there are no images.
    double far = infinity;

    /// The centre at a time, rounded.
    [[nodiscard]] Vector<D> centre(Slot i, double now) const noexcept {
        const Ball<D>& ball = balls[i];
        const double dt = now - ball.time;
        Vector<D> x;
        for (int k = 0; k < D; ++k)
            x[k] = ball.x[k] + ball.v[k] * dt + 0.5 * effects.gravity[k] * (dt * dt);
        return x;
    }
    /// The square of a distance, that of the nearest image, to which the difference is brought.
    [[nodiscard]] double nearest_square(Vector<D>& d) const noexcept {
        double square = dot(d, d);
        if (square < far) [[likely]]
            return square;
        for (int k = 0; k < D; ++k) d[k] -= length[k] * nearest_integer(d[k] * inverse_length[k]);
        return dot(d, d);
    }
    [[nodiscard]] Vector<D> velocity(Slot i, double now) const noexcept {
        const Ball<D>& ball = balls[i];
        Vector<D> v;
        for (int k = 0; k < D; ++k) v[k] = ball.v[k] + effects.gravity[k] * (now - ball.time);
        return v;
    }
};

}  // namespace signum::motion
