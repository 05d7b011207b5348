#pragma once
/// What the library says of balls in flight.

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "../../motion/meeting_time.hpp"
#include "../../motion/simulation.hpp"
#include "motion_case.hpp"

namespace signum::hard {

template <std::size_t D>
class LibraryOfMotion {
 public:
    LibraryOfMotion(const std::vector<Flight<D>>& flights, motion::Structure structure)
        : structure_(structure) {
        for (const Flight<D>& flight : flights) {
            motion::Body<d> body;
            for (int k = 0; k < d; ++k) {
                body.x[k] = flight.x[static_cast<std::size_t>(k)];
                body.v[k] = flight.v[static_cast<std::size_t>(k)];
            }
            body.radius = flight.radius;
            bodies_.push_back(body);
        }
    }
    double meeting_time(std::size_t a, std::size_t b) const {
        return motion::meeting_time(ball(a), ball(b), motion::Effects<d>{});
    }
    std::vector<StrikeOfTwo> strikes(double until) const {
        const motion::Effects<d> effects;
        motion::Simulation<d> simulation(
            motion::start<d>(std::span<const motion::Body<d>>(bodies_), effects), effects,
            {.structure = structure_});
        std::vector<StrikeOfTwo> result;
        static_cast<void>(simulation.run({.until = until, .strikes = most_strikes},
                                         [&](const motion::Strike& strike) {
                                             result.push_back({strike.time, strike.a, strike.b});
                                         }));
        return result;
    }

 private:
    static constexpr int d = static_cast<int>(D);
    motion::GrowingBall<d> ball(std::size_t i) const {
        motion::GrowingBall<d> result;
        result.x = bodies_[i].x;
        result.v = bodies_[i].v;
        result.radius = bodies_[i].radius;
        return result;
    }

    std::vector<motion::Body<d>> bodies_;
    motion::Structure structure_;
};

}  // namespace signum::hard
