#pragma once
/// The finite faces of a tessellation as a Wavefront OBJ mesh, in the plane z = 0 or in space,
/// which Blender and MeshLab open.

#include <ostream>
#include <span>

#include "../../triangulation/space/triangulate.hpp"
#include "../../triangulation/tessellation.hpp"

namespace signum {

/// "v x y 0" for every site, hidden ones included, and "f a b c" with numbers of sites from 1,
/// counterclockwise.
void write_obj(std::ostream& out, const Tessellation& tessellation);

/// "v x y z" for every site of a tessellation of space, and all finite facets of its cells, each
/// once: those of the hull, which turn counterclockwise as seen from outside, as group hull, the
/// others as group inside. Of flat sites triangles "f a b c", lines "l a b" or a point "p a".
void write_obj(std::ostream& out, const SpaceTessellation& tessellation,
               std::span<const Site3> sites);

}  // namespace signum
