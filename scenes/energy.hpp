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

/// Energies as CSV, a time a line: time,kinetic, and, where there is gravity, height,total.
template <int D>
class EnergyWriter {
 public:
    /// Writes the header.
    EnergyWriter(std::ostream& out, const motion::Effects<D>& effects)
        : text_(out), effects_(effects), has_height_(effects.gravity != motion::Vector<D>{}) {
        text_.put(has_height_ ? "time,kinetic,height,total\n" : "time,kinetic\n");
    }
    /// O(balls).
    void put(const motion::State<D>& state, double time) {
        const Energy<D> energy(state, effects_, time);
        text_.put(FMT_COMPILE("{},{}"), time, energy.kinetic);
        if (has_height_)
            text_.put(FMT_COMPILE(",{},{}"), energy.total - energy.kinetic, energy.total);
        text_.put("\n");
    }
    /// To be called at the end.
    void finish() { text_.flush(); }

 private:
    TextWriter text_;
    motion::Effects<D> effects_;
    bool has_height_;
};

}  // namespace signum
