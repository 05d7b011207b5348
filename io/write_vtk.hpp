#pragma once
/// A tessellation of space as an unstructured grid of VTK in its legacy form, ASCII, which ParaView
/// opens.

#include <ostream>
#include <span>

#include "../spatial/triangulate.hpp"

namespace signum {

/// All sites as points with their radius or weight and whether they are hidden, and the finite
/// cells: tetrahedra, turning as VTK wants them; of flat sites triangles, lines or a vertex.
void write_vtk(std::ostream& out, const SpaceTessellation& tessellation,
               std::span<const Site3> sites, WeightIs weight_is);

}  // namespace signum
