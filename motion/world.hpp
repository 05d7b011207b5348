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

/// How long who flies so takes for a way, at least: v s + g s²/2 = way.
template <int D>
[[nodiscard]] inline double time_for(const Vector<D>& v, double pull, double way) noexcept {
    const double square = dot(v, v);
    return 2.0 * way / (std::sqrt(square) + std::sqrt(square + 2.0 * pull * way));
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
          pull(norm(effects.gravity)),
          region(effects.box) {
        if (effects.growth) swelling = largest_growth(*effects.growth);
        if (!effects.box) return;
        region = swept(*effects.box, effects);
        length = effects.box->lengths();
        for (int k = 0; k < D; ++k) {
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
        return falls ? motion::centre(ball, now, effects) : ball.x + (now - ball.time) * ball.v;
    }
    /// How long a ball takes to fly so far, at least.
    [[nodiscard]] double time_for(Slot i, double now, double way) const noexcept {
        return motion::time_for(velocity(i, now), pull, way);
    }
    /// How far a ball may fly until it is to be asked again in a periodic box (pairs.cpp): an
    /// eighth of it.
    [[nodiscard]] double stride() const noexcept {
        return effects.periodic ? *std::ranges::min_element(length) / 8.5 : infinity;
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
        return falls ? motion::velocity(balls[i], now, effects) : balls[i].v;
    }
};

}  // namespace signum::motion
