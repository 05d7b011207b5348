#pragma once
/// Balls that are in one another, or in walls: for what is checked, and for what a run has left.

#include <span>

#include "../../motion/simulation.hpp"

namespace signum {

/// The larger number; a NaN where one of them is, so that no maximum hides it.
[[nodiscard]] inline double larger(double a, double b) noexcept {
    return a >= b || a != a ? a : b;
}

/// How deep balls at a time are in one another and in walls.
struct Overlaps {
    double of_balls = 0.0;
    double of_walls = 0.0;
};
/// As parts of the smaller radius, of points of the largest one; 0 where nothing overlaps, NaNs
/// where a coordinate is none.
/// O(n (log n + walls) + pairs that overlap), as a rule.
template <int D>
[[nodiscard]] Overlaps deepest_overlaps(const motion::State<D>& state,
                                        const motion::Effects<D>& effects, double time);

/// Rounding leaves balls inside one another, and contacts that stand do by a 256th of the smaller
/// radius and a little more. Those that are no deeper in one another, or in walls at t = 0, are
/// made smaller until they are apart by a part in 10^9; those that are deeper stay, and where there
/// are more pairs than balls that are apart could have, so may others. O(n (log n + walls)), as a
/// rule.
template <int D>
void part(std::span<motion::Body<D>> bodies, const motion::Effects<D>& effects);

}  // namespace signum
