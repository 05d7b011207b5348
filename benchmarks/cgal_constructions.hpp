#pragma once
/// CGAL's triangulations as its manual says to build them: the usual kernels, a whole range of
/// points, which CGAL sorts along a curve (Delaunay, regular), by radius (Apollonius) or at random.
/// Copying the sites into CGAL's points is not part of a construction. Without CGAL there are none.

#include <array>
#include <string>
#include <vector>

#include "../core/index.hpp"
#include "../core/site.hpp"

#include "construction.hpp"

namespace signum::benchmarks::cgal {

#if defined(SIGNUM_WITH_CGAL)
inline constexpr bool is_there = true;
[[nodiscard]] std::string version();
/// Delaunay_triangulation_2 of the centres.
[[nodiscard]] Construction delaunay(const std::vector<Site>& sites);
/// Regular_triangulation_2, weights r² rounded.
[[nodiscard]] Construction regular(const std::vector<Site>& sites);
/// Apollonius_graph_hierarchy_2 with filtered traits.
[[nodiscard]] Construction apollonius(const std::vector<Site>& sites);
/// Segment_Delaunay_graph_Linf_hierarchy_2 of the centres, with filtered traits.
[[nodiscard]] Construction linf(const std::vector<Site>& sites);
/// Delaunay_triangulation_3 of the centres, or Regular_triangulation_3, weights r² rounded.
[[nodiscard]] Construction in_space(const std::vector<Site3>& sites, bool is_regular);

/// The finite cells of the latter, each in rising order, sorted: to be compared with others. Of
/// equal centres CGAL keeps one, and so does this, the last.
[[nodiscard]] std::vector<std::array<Index, 4>> cells(const std::vector<Site3>& sites,
                                                      bool is_regular);

/// CGAL's exact predicates on the faces of a Delaunay triangulation or, where `weighted`, a regular
/// one with weights r² rounded: every finite face counterclockwise, every edge locally regular, no
/// hull edge reflex. Not whether a site is missing.
[[nodiscard]] bool are_regular(const std::vector<Face>& faces, const std::vector<Site>& sites,
                               bool weighted);
#else
inline constexpr bool is_there = false;
inline std::string version() {
    return {};
}
inline constexpr Construction (*delaunay)(const std::vector<Site>&) = nullptr;
inline constexpr auto regular = delaunay;
inline constexpr auto apollonius = delaunay;
inline constexpr auto linf = delaunay;
inline Construction in_space(const std::vector<Site3>& /*sites*/, bool /*is_regular*/) {
    return {};
}
inline std::vector<std::array<Index, 4>> cells(const std::vector<Site3>& /*sites*/,
                                               bool /*is_regular*/) {
    return {};
}
#endif

}  // namespace signum::benchmarks::cgal
