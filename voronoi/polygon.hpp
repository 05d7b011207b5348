#pragma once
/// Cells as polygons, for programs that know no arcs.

#include <vector>

#include "clip.hpp"

namespace signum {

/// One polygon a loop of the shape, counterclockwise, its first point not repeated at the end; of
/// arcs as many points as are needed to stay within `tolerance` (at most 2^16 each), and the one
/// where a hyperbola turns, so that however coarse they are they go around their sites. Both cells
/// at an edge get the same points of it. Polygons of no area are left out. Throws
/// std::invalid_argument unless the tolerance is positive.
[[nodiscard]] std::vector<std::vector<Point>> polygons(const CellShape& shape, double tolerance);

}  // namespace signum
