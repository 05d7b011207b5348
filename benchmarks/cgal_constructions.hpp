#pragma once
/// CGAL's triangulations as its manual says to build them: the usual kernels, a whole range of
/// points, which CGAL sorts along a curve (Delaunay, regular), by radius (Apollonius) or at random.
/// Copying the sites into CGAL's points is not part of a construction.

#include <string>
#include <vector>

#include "../core/site.hpp"

#include "construction.hpp"

namespace signum::benchmarks::cgal {

[[nodiscard]] std::string version();
/// Delaunay_triangulation_2 of the centres.
[[nodiscard]] Construction delaunay(const std::vector<Site>& sites);
/// Regular_triangulation_2, weights r² rounded.
[[nodiscard]] Construction regular(const std::vector<Site>& sites);

/// Apollonius_graph_hierarchy_2 with filtered traits.
[[nodiscard]] Construction apollonius(const std::vector<Site>& sites);
/// Segment_Delaunay_graph_Linf_hierarchy_2 of the centres, with filtered traits.
[[nodiscard]] Construction linf(const std::vector<Site>& sites);

}  // namespace signum::benchmarks::cgal
