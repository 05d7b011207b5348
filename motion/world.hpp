#pragma once
/// The balls and what acts on them: what the loop changes and structures read.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "ball.hpp"
#include "meeting.hpp"

namespace signum::motion {

/// A ball's place in the arrays of a simulation; its number in the input is another one.
using Slot = std::uint32_t;

template <int D>
struct World {
    std::vector<Ball<D>> balls;
    Effects<D> effects;
    /// When the structures begin.
    double start = 0.0;

    /// The centre at a time, rounded.
    [[nodiscard]] Vector<D> centre(Slot i, double now) const noexcept {
        const Ball<D>& ball = balls[i];
        const double dt = now - ball.time;
        Vector<D> x;
        for (int k = 0; k < D; ++k)
            x[k] = ball.x[k] + ball.v[k] * dt + 0.5 * effects.gravity[k] * (dt * dt);
        return x;
    }
    /// The least of all images of a difference of places.
    void unwrap(Vector<D>& d) const noexcept {
        if (!effects.periodic) return;
        for (int k = 0; k < D; ++k) {
            const double length = effects.box->high[k] - effects.box->low[k];
            d[k] -= length * nearest_integer(d[k] / length);
        }
    }
    [[nodiscard]] Vector<D> velocity(Slot i, double now) const noexcept {
        const Ball<D>& ball = balls[i];
        Vector<D> v;
        for (int k = 0; k < D; ++k) v[k] = ball.v[k] + effects.gravity[k] * (now - ball.time);
        return v;
    }
};

}  // namespace signum::motion
