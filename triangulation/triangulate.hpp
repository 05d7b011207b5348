#pragma once
/// From sites to their tessellation: the main entrance of the library.

#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <stop_token>

#include "../core/strided_sites.hpp"
#include "../predicates/arithmetic.hpp"
#include "tessellation.hpp"

namespace signum {

/// How a tessellation is built; the result is the same.
enum class Method : std::uint8_t {
    incremental,  ///< site by site
    flips,        ///< power metric: from the Delaunay triangulation of the centres, by flips
    sweep         ///< Manhattan and supremum: a line sweeps the plane
};

[[nodiscard]] std::string_view name_of(Method method) noexcept;

struct Options {
    /// The single kernel takes the sites rounded to floats: std::invalid_argument, naming the site,
    /// for a number beyond 3.4e38.
    Arithmetic arithmetic = Arithmetic::exact;
    /// std::invalid_argument with a metric that the method does not build, and for flips with any
    /// arithmetic but the exact one.
    Method method = Method::incremental;
    /// Seeds the random insertion order. The result does not depend on it.
    std::uint64_t seed = 1;
    /// Fill the counters of Statistics; costs a few per cent of the time.
    bool count = false;
    /// Checked every few thousand sites; a stopped construction throws Stopped.
    std::stop_token stop = {};
    /// Called now and then with the share of the work done, from 0 to 1, by the calling thread.
    std::function<void(double)> progress = {};
};

/// Thrown when Options::stop asked for it.
class Stopped : public std::runtime_error {
 public:
    Stopped() : std::runtime_error("the construction was stopped") {}
};

/// Thrown when inexact arithmetic led the construction astray: a walk without end, a conflict
/// region that is no disc. Exact kernels never throw it.
class BrokenStructure : public std::runtime_error {
 public:
    using std::runtime_error::runtime_error;
};

/// The power (regular) triangulation of the sites, hidden ones reported. Ties are decided by one
/// rule (geometry in ARCHITECTURE.md), so that the result is the same for every order and
/// seed. Any finite doubles are legal; sites may intersect, nest, touch and coincide.
/// Throws std::invalid_argument, naming the site, for NaN or infinity, and for more than max_sites.
/// Time: O(n log n) expected on sites spread at random. The order of insertion, random rounds along
/// a curve, keeps the calls of predicates a site bounded on all families that were tried, too:
/// giants among small sites, chains, sites on lines and curves, hidden ones by the thousand
/// (tests/property/growth_test.cpp); to say who hides whom takes n√n calls where many cells meet
/// around the hidden. In the worst case it is O(n²). At most 160 bytes a site at the peak (200 in
/// the other metrics), the result included, from a hundred thousand sites on.
[[nodiscard]] Tessellation triangulate(StridedSites sites, Power metric,
                                       const Options& options = {});

/// The tessellation of discs (Euclidean, Apollonius), of diamonds (Manhattan) and of squares
/// (supremum), additively weighted: distance |x-c| - r in the norm. As above; the third number of a
/// site must be a radius (std::invalid_argument), which may be negative.
[[nodiscard]] Tessellation triangulate(StridedSites sites, Euclidean metric,
                                       const Options& options = {});
[[nodiscard]] Tessellation triangulate(StridedSites sites, Manhattan metric,
                                       const Options& options = {});
[[nodiscard]] Tessellation triangulate(StridedSites sites, Supremum metric,
                                       const Options& options = {});

/// The same for a metric that is known only when the program runs.
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
