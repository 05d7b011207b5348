#pragma once
/// The balls of a simulation at one time, as frames show them.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "../../motion/simulation.hpp"
#include "../io/write_motion.hpp"

namespace signum {

/// A box where it is at a time, if it shakes.
template <int D>
[[nodiscard]] motion::Box<D> box_at(motion::Box<D> box, const motion::Effects<D>& effects,
                                    double time) {
    if (!effects.shake) return box;
    const double share = std::sin(effects.shake->frequency * time + effects.shake->phase);
    for (int k = 0; k < D; ++k) {
        box.low[k] += effects.shake->amplitude[k] * share;
        box.high[k] += effects.shake->amplitude[k] * share;
    }
    return box;
}

/// The balls at a time, in the box where it is periodic.
template <int D>
class Snapshot {
 public:
    Snapshot(const motion::State<D>& state, const motion::Effects<D>& effects, double time) {
        frame_.time = time;
        frame_.dimension = D;
        frame_.periodic = effects.periodic;
        balls_.reserve(state.balls.size());
        for (const motion::Ball<D>& ball : state.balls) {
            MotionFrame::Ball shown;
            for (int k = 0; k < D; ++k) {
                shown.x[static_cast<std::size_t>(k)] =
                    in_box(coordinate(ball, k, time, effects), k, effects);
                shown.v[static_cast<std::size_t>(k)] = speed(ball, k, time, effects);
            }
            shown.radius = radius_at(ball, time, effects);
            balls_.push_back(shown);
        }
        frame_.balls = balls_;
    }
    Snapshot(const Snapshot&) = delete;
    Snapshot& operator=(const Snapshot&) = delete;
    [[nodiscard]] MotionFrame& frame() noexcept { return frame_; }

 private:
    std::vector<MotionFrame::Ball> balls_;
    MotionFrame frame_;
};

}  // namespace signum
