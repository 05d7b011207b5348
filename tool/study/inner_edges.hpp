#pragma once
/// The questions that the edges of a tessellation stand for, in space the facets.

#include <array>
#include <vector>

#include "../../triangulation/space/triangulate.hpp"
#include "../../triangulation/tessellation.hpp"

namespace signum::study {

/// For every edge between two finite faces of four sites the calls of in_circle that it answers:
/// the sites of one face, and the one across. O(n).
[[nodiscard]] std::vector<std::array<Index, 4>> inner_edges(const Tessellation& tessellation);

/// For every facet between two finite cells of sites that span space the calls of in_sphere: the
/// sites of one cell, and the one across. O(n). None of flat sites.
[[nodiscard]] std::vector<std::array<Index, 5>> inner_facets(const SpaceTessellation& tessellation);

}  // namespace signum::study
