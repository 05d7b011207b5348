#pragma once
/// CGAL's triangulations of space as its manual says to build them; see cgal_constructions.hpp.

#include <array>
#include <vector>

#include "../core/index.hpp"
#include "../core/site.hpp"

#include "construction.hpp"

namespace signum::benchmarks::cgal {

/// Delaunay_triangulation_3 of the centres.
[[nodiscard]] Construction delaunay(const std::vector<Site3>& sites);
/// Regular_triangulation_3, weights r² rounded.
[[nodiscard]] Construction regular(const std::vector<Site3>& sites);

/// The finite cells of these, each in rising order, sorted: to be compared with others. Of equal
/// centres CGAL keeps one, and so does this, the last.
[[nodiscard]] std::vector<std::array<Index, 4>> delaunay_cells(const std::vector<Site3>& sites);
[[nodiscard]] std::vector<std::array<Index, 4>> regular_cells(const std::vector<Site3>& sites);

}  // namespace signum::benchmarks::cgal
