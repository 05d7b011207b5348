#pragma once
/// Sites of space from the vertices of a mesh.
///
/// Laws: as of read_sites().

#include "input_file.hpp"
#include "read_sites.hpp"

namespace signum {

/// The vertices of a PLY file in ASCII: their properties x, y, z and, where there is one, radius or
/// weight; others, and other elements, are left out. Throws InputError.
[[nodiscard]] SitesFile read_ply_sites(InputFile& file);

}  // namespace signum
