#pragma once
/// The shaker of the study: discs in a box that goes up and down.

#include <cstdint>
#include <vector>

#include "../../../motion/simulation.hpp"
#include "../plan.hpp"

namespace signum::study {

/// The side of the box: 200 up to 100 balls, as in the thesis; beyond, its area grows with their
/// number.
[[nodiscard]] double side_of_box(std::int64_t balls);

/// Radii, whose squares sum to the packing: discs of any size and of twice that size fill as much
/// in all, so small ones are many. That is how nearly all pairs of packing and radii in the
/// thesis's tables come out. Without chance, from the largest to the smallest.
[[nodiscard]] std::vector<double> radii_of(const Setting& setting);

struct Shaker {
    motion::State<2> state;
    motion::Effects<2> effects;
};

/// Gravity 9.81 down, the box to and fro along it by 5 once a second, restitution 0.9 (within
/// a thousandth of a second 1), density 1. Places by chance below a packing of 0.4, by growth
/// above. Discs are at rest, but for a `speed` above 0: then each component of their velocities is
/// normal, that being the standard deviation for a disc of mean mass, and all have one temperature.
[[nodiscard]] Shaker shaker_of(const Setting& setting, double speed, std::uint64_t seed);

/// The shaker of a cell when measuring begins. Made once a program: what is dense takes minutes.
[[nodiscard]] const Shaker& shaker_for(const Cell& cell);

}  // namespace signum::study
