#pragma once
/// A tessellation as a grid of VTK (io/vtk_grid.hpp).

#include <span>

#include "../../triangulation/space/triangulate.hpp"
#include "../../triangulation/tessellation.hpp"
#include "vtk_grid.hpp"

namespace signum {

/// All sites as points at z = 0 with their radius or weight and whether they are hidden; the finite
/// faces as triangles, and before them as lines the edges that bound none of these. O(n log n).
[[nodiscard]] VtkGrid vtk_grid(const Tessellation& tessellation);

/// All sites as points with their radius or weight and whether they are hidden, and the finite
/// cells: tetrahedra, turning as VTK wants them; of flat sites triangles, lines or a vertex. O(n).
[[nodiscard]] VtkGrid vtk_grid(const SpaceTessellation& tessellation, std::span<const Site3> sites,
                               WeightIs weight_is);

}  // namespace signum
