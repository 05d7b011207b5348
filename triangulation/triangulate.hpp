#pragma once
/// From sites to their tessellation: the main entrance of the library.

#include <optional>

#include "../core/strided_sites.hpp"
#include "metric.hpp"
#include "options.hpp"
#include "tessellation.hpp"

namespace signum {

/// The tessellation of the sites in a metric: Power{} (regular triangulation, squared distances
/// less weights) or, with additive weights, the distance |x-c| - r in a norm, Euclidean{} (discs,
/// Apollonius), Manhattan{} (diamonds) and Supremum{} (squares); or a Metric that is known only
/// when the program runs. Hidden sites are reported. Ties are decided by one rule ("The tie
/// rule" in ARCHITECTURE.md), so that the result is the same for every order and seed. Any finite
/// doubles are legal, negative radii too; sites may intersect, nest, touch and coincide. Throws
/// std::invalid_argument, naming the site, for NaN or infinity, for more than max_sites, and where
/// the third number of a site is a weight and the metric is not power. Time: O(n log n) expected on
/// sites spread at random. The order of insertion, random rounds along a curve, keeps the calls of
/// predicates a site bounded on all families that were tried, too: giants among small sites,
/// chains, sites on lines and curves, hidden ones by the thousand (tests/property/growth_test.cpp);
/// to say who hides whom takes n√n calls where many cells meet around the hidden. In the worst case
/// it is O(n²). At most 150 bytes a site at the peak, the result included, from a hundred thousand
/// sites on; with several threads 20 more.
[[nodiscard]] Tessellation triangulate(StridedSites sites, Metric metric,
                                       const Options& options = {});

/// What flipping edges in the order in which they are found comes to.
struct FlipOutcome {
    Tessellation tessellation;        ///< empty where there is an obstruction
    std::optional<Edge> obstruction;  ///< an edge that is not regular and cannot be flipped
};

/// The power triangulation from the Delaunay triangulation of the centres by a queue of edges
/// (thesis, Algorithm 6.5.1). Where sites intersect it may meet an obstruction, which Method::flips
/// never does. Exact; options.arithmetic and method are not looked at.
[[nodiscard]] FlipOutcome flip_from_delaunay(StridedSites sites, const Options& options = {});

}  // namespace signum
