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
    const motion::Vector<D> shift = share * effects.shake->amplitude;
    return {box.low + shift, box.high + shift};
}

/// The square of the distance of two centres, in a periodic box that of the nearest images; null
/// where there is none.
template <int D>
[[nodiscard]] double square_between(const motion::Vector<D>& a, const motion::Vector<D>& b,
                                    const motion::Box<D>* periodic) {
    motion::Vector<D> d = a - b;
    if (periodic != nullptr) {
        const motion::Vector<D> length = periodic->lengths();
        for (int k = 0; k < D; ++k) d[k] -= length[k] * std::nearbyint(d[k] / length[k]);
    }
    return dot(d, d);
}
template <int D>
[[nodiscard]] const motion::Box<D>* periodic_box(const motion::Effects<D>& effects) {
    return effects.periodic ? &*effects.box : nullptr;
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
            std::ranges::copy(centre_in_box(ball, time, effects), shown.x.begin());
            std::ranges::copy(velocity(ball, time, effects), shown.v.begin());
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
