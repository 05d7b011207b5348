#pragma once
/// The vertices of the power diagram of space: for each finite cell the point at equal power
/// distance from its four sites.

#include <span>
#include <vector>

#include "triangulate.hpp"

namespace signum {

/// A vertex of the diagram: its place and the power distance rho to its sites; for equal weights of
/// 0 the square of the sphere's radius. Each number is the double nearest to the exact value,
/// halves to even; NaN where it exceeds the doubles. NaN in all four for a cell with the vertex at
/// infinity, and for one of flat sites, whose points at equal distance are a line or more.
struct SpaceVertex {
    double x;    ///< the first coordinate of the centre
    double y;    ///< the second
    double z;    ///< the third
    double rho;  ///< the power distance
};

/// One vertex a cell, in the order of the cells, whatever the number of threads (Options::threads).
/// Double-doubles with a bound, rationals behind them; O(cells). Throws std::invalid_argument where
/// the tessellation is not one of as many sites, or a cell names a site that there is not.
[[nodiscard]] std::vector<SpaceVertex> vertices(const SpaceTessellation& tessellation,
                                                std::span<const Point3> sites, int threads = 0);
/// The same of balls.
[[nodiscard]] std::vector<SpaceVertex> vertices(const SpaceTessellation& tessellation,
                                                std::span<const Site3> sites, int threads = 0);
/// The same of sites with weights.
[[nodiscard]] std::vector<SpaceVertex> vertices(const SpaceTessellation& tessellation,
                                                std::span<const power::Site3> sites,
                                                int threads = 0);

}  // namespace signum
