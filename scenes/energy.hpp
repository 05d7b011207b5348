#pragma once
/// The energy of a simulation at one time, and how it goes.

#include <ostream>

#include "../io/text_writer.hpp"
#include "snapshot.hpp"

namespace signum {

/// Kinetic energy, and its sum with that of height, which is 0 at the origin. O(balls).
template <int D>
struct Energy {
    double kinetic = 0.0;
    double total = 0.0;

    Energy(const motion::State<D>& state, const motion::Effects<D>& effects, double time) {
        Snapshot<D> snapshot(state, effects, time);
        std::size_t i = 0;
        for (const MotionFrame::Ball& ball : snapshot.frame().balls) {
            const double mass = state.masses[i++];
            for (int k = 0; k < D; ++k) {
                kinetic += 0.5 * mass * ball.v[static_cast<std::size_t>(k)] *
                           ball.v[static_cast<std::size_t>(k)];
                total -= mass * effects.gravity[k] * ball.x[static_cast<std::size_t>(k)];
            }
        }
        total += kinetic;
    }
};

}  // namespace signum
