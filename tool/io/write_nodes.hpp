#pragma once
/// A tessellation as the files that Triangle and TetGen read and write: .node, .ele and .neigh,
/// numbered from 0 as in all files of the tool. Numbers are written so that reading them gives the
/// same double.

#include <ostream>
#include <span>

#include "../../triangulation/space/triangulate.hpp"
#include "../../triangulation/tessellation.hpp"

namespace signum {

/// All sites, hidden ones included, with their radius or weight as the only attribute and without
/// boundary markers.
void write_node(std::ostream& out, std::span<const Site> sites);
void write_node(std::ostream& out, std::span<const Site3> sites);

/// The finite faces, counterclockwise; in space the finite cells, which turn positively. Of flat
/// sites in space none.
void write_ele(std::ostream& out, const Tessellation& tessellation);
void write_ele(std::ostream& out, const SpaceTessellation& tessellation);

/// By face or cell of write_ele() those across from its corners; -1 beyond the hull.
void write_neigh(std::ostream& out, const Tessellation& tessellation);
void write_neigh(std::ostream& out, const SpaceTessellation& tessellation);

}  // namespace signum
