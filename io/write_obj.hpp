#pragma once
/// The finite faces of a tessellation as a Wavefront OBJ mesh in the plane z = 0, which Blender and
/// MeshLab open.

#include <ostream>

#include "../triangulation/tessellation.hpp"

namespace signum {

/// "v x y 0" for every site, hidden ones included, and "f a b c" with numbers of sites from 1,
/// counterclockwise.
void write_obj(std::ostream& out, const Tessellation& tessellation);

}  // namespace signum
