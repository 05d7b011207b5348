#pragma once
/// The balls and what acts on them: what the loop changes and structures read.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "../core/large_array.hpp"
#include "ball.hpp"
#include "meeting.hpp"

namespace signum::motion {

/// Rounded down; |x| < 2^62. Without a call, which std::floor is on some processors.
[[nodiscard]] inline std::int64_t rounded_down(double x) noexcept {
    const auto whole = static_cast<std::int64_t>(x);
    return whole - static_cast<std::int64_t>(static_cast<double>(whole) > x);
}

template <int D>
using Balls = LargeArray<Ball<D>, Pages::large>;

template <int D>
struct World {
    World(Balls<D> balls_then, const Effects<D>& effects_then, double start_then)
        : balls(std::move(balls_then)),
          effects(effects_then),
          start(start_then),
          falls(effects.gravity != Vector<D>{}),
          pull(std::sqrt(dot(effects.gravity, effects.gravity))),
          region(effects.box) {
        if (effects.growth) swelling = largest_growth(*effects.growth);
        if (!effects.box) return;
        if (effects.shake) {
            for (int k = 0; k < D; ++k) {
                const double reach = std::fabs(effects.shake->amplitude[k]);
                region->low[k] -= reach;
                region->high[k] += reach;
            }
        }
        for (int k = 0; k < D; ++k) {
            length[k] = effects.box->high[k] - effects.box->low[k];
            inverse_length[k] = 1.0 / length[k];
            if (effects.periodic) far = std::min(far, 0.2 * length[k] * length[k]);
        }
    }

    Balls<D> balls;
    Effects<D> effects;
    /// When the structures begin.
    double start;
    /// Whether there is gravity, and how much.
    bool falls;
    double pull;
    /// In which centres stay: the box, as far as it shakes.
    std::optional<Box<D>> region;
    /// By how much radii grow at most, as a factor.
    double swelling = 1.0;
    /// Of the box, rounded.
    Vector<D> length{};
    Vector<D> inverse_length{};
    /// Whose square of the distance is less is seen in the image that is nearest; infinite where
    /// there are no images.
    double far = infinity;

    /// The largest that it becomes.
    [[nodiscard]] double radius(Slot i) const noexcept { return balls[i].radius * swelling; }
    /// The centre at a time, rounded.
    [[nodiscard]] Vector<D> centre(Slot i, double now) const noexcept {
        const Ball<D>& ball = balls[i];
        if (falls) return motion::centre(ball, now, effects);
        Vector<D> x;
        for (int k = 0; k < D; ++k) x[k] = ball.x[k] + ball.v[k] * (now - ball.time);
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
        if (!falls) return balls[i].v;
        Vector<D> v;
        for (int k = 0; k < D; ++k) v[k] = speed(balls[i], k, now, effects);
        return v;
    }
};

}  // namespace signum::motion
