#pragma once
/// The energy of a simulation at one time, and how it goes.

#include <ostream>

#include "../../motion/effects/friction.hpp"
#include "../../motion/simulation.hpp"
#include "../io/text_writer.hpp"

namespace signum {

/// Kinetic energy, that of spins where there is friction, and their sum with that of height, which
/// is 0 at the origin. O(balls).
template <int D>
struct Energy {
    double kinetic = 0.0;
    double spin = 0.0;
    double total = 0.0;

    Energy(const motion::State<D>& state, const motion::Effects<D>& effects, double time) {
        for (std::size_t i = 0; i < state.balls.size(); ++i) {
            const motion::Ball<D>& ball = state.balls[i];
            const double mass = state.masses[i];
            const motion::Vector<D> x = centre_in_box(ball, time, effects);
            const motion::Vector<D> v = velocity(ball, time, effects);
            if (effects.friction)
                spin += motion::energy_of<D>(state.spins[i], radius_at(ball, time, effects), mass,
                                             *effects.friction);
            for (int k = 0; k < D; ++k) {
                kinetic += 0.5 * mass * v[k] * v[k];
                total -= mass * effects.gravity[k] * x[k];
            }
        }
        total += kinetic;
        total += spin;
    }
};

/// Energies as CSV, a time a line: time,kinetic; spin where there is friction and height where
/// there is gravity; and, where there is either, total.
template <int D>
class EnergyWriter {
 public:
    /// Writes the header.
    EnergyWriter(std::ostream& out, const motion::Effects<D>& effects)
        : text_(out), effects_(effects), has_height_(effects.gravity != motion::Vector<D>{}) {
        text_.put(FMT_COMPILE("time,kinetic{}{}{}\n"), has_spin() ? ",spin" : "",
                  has_height_ ? ",height" : "", has_total() ? ",total" : "");
    }
    /// O(balls).
    void put(const motion::State<D>& state, double time) {
        const Energy<D> energy(state, effects_, time);
        text_.put(FMT_COMPILE("{},{}"), time, energy.kinetic);
        if (has_spin()) text_.put(FMT_COMPILE(",{}"), energy.spin);
        if (has_height_) text_.put(FMT_COMPILE(",{}"), energy.total - energy.kinetic - energy.spin);
        if (has_total()) text_.put(FMT_COMPILE(",{}"), energy.total);
        text_.put("\n");
    }
    /// To be called at the end.
    void finish() { text_.flush(); }

 private:
    [[nodiscard]] bool has_spin() const { return effects_.friction.has_value(); }
    [[nodiscard]] bool has_total() const { return has_spin() || has_height_; }

    TextWriter text_;
    motion::Effects<D> effects_;
    bool has_height_;
};

}  // namespace signum
