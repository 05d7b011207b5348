#pragma once
/// The result of a triangulation: plain arrays of indices, and questions about them.

#include <cstdint>
#include <span>
#include <vector>

#include "../core/index.hpp"
#include "../core/site.hpp"
#include "arrays.hpp"
#include "metric.hpp"

namespace signum {

/// What a construction did. Counters are 0 unless Options::count asked for them. The calls, of four
/// kinds, are as many as the decisions, of five stages.
struct Statistics {
    bool counted = false;              ///< whether anybody counted
    std::uint64_t ccw = 0;             ///< calls of ccw
    std::uint64_t in_circle = 0;       ///< calls of in_circle, at infinity too
    std::uint64_t nearer = 0;          ///< comparisons of two sites' distances from a point
    std::uint64_t others = 0;          ///< calls of predicates that curved edges need
    std::uint64_t filtered = 0;        ///< calls decided by the floating-point filter
    std::uint64_t refined = 0;         ///< ... by double-double arithmetic
    std::uint64_t exact = 0;           ///< ... by expansions or integers
    std::uint64_t essa = 0;            ///< ... by ESSA, the exact sign of a sum
    std::uint64_t multiprecision = 0;  ///< ... by rationals
    std::uint64_t ties = 0;            ///< exact zeros that the tie rule resolved
    std::uint64_t flips = 0;           ///< edges swapped
    std::uint64_t events = 0;          ///< site and circle events of the sweep
    double seconds = 0.0;              ///< construction alone
};

/// The counters, by the names that files give them.
struct Counter {
    const char* name;                  ///< as in files
    std::uint64_t Statistics::*count;  ///< where it is
};
/// All of them, in the order of files.
inline constexpr Counter counters[] = {
    {"ccw", &Statistics::ccw},
    {"in_circle", &Statistics::in_circle},
    {"nearer", &Statistics::nearer},
    {"others", &Statistics::others},
    {"filtered", &Statistics::filtered},
    {"refined", &Statistics::refined},
    {"exact", &Statistics::exact},
    {"essa", &Statistics::essa},
    {"multiprecision", &Statistics::multiprecision},
    {"ties", &Statistics::ties},
    {"flips", &Statistics::flips},
    {"events", &Statistics::events},
};

class Tessellation;
namespace triangulation {
/// What a construction has made, whose numbers need not be looked through again.
[[nodiscard]] Tessellation constructed(TessellationArrays arrays, std::vector<Site> sites,
                                       const Statistics& statistics);
}  // namespace triangulation

/// A generalized Delaunay tessellation of sites in the plane.
class Tessellation {
 public:
    Tessellation() = default;
    /// Takes over a result; the third numbers of `sites` are what arrays.weight_is says. Throws
    /// std::invalid_argument where a number in the arrays names no site or face. Precondition: the
    /// neighbours fit the faces, which EdgeList and validate() find out; they may be missing.
    Tessellation(TessellationArrays arrays, std::vector<Site> sites, Statistics statistics);

    /// Throws std::invalid_argument for a tessellation that was made without its neighbours, which
    /// whoever walks around sites asks for.
    void expect_neighbours() const;

    /// The metric of the distance.
    [[nodiscard]] Metric metric() const noexcept { return arrays_.metric; }
    /// What the third number of a site is.
    [[nodiscard]] WeightIs weight_is() const noexcept { return arrays_.weight_is; }
    /// All of it, as files carry it.
    [[nodiscard]] const TessellationArrays& arrays() const noexcept { return arrays_; }

    /// All sites in the order given, hidden ones included; r is a radius or a weight (weight_is()).
    [[nodiscard]] std::span<const Site> sites() const noexcept { return sites_; }
    /// All 2n-2 of n visible sites: counterclockwise triples, sorted as arrays().order says; -1 is
    /// infinity.
    [[nodiscard]] std::span<const Face> faces() const noexcept { return arrays_.faces; }
    /// Three faces for every face: neighbours()[f][k] lies across the edge opposite faces()[f][k].
    [[nodiscard]] std::span<const Face> neighbours() const noexcept { return arrays_.neighbours; }
    /// Sorted by site.
    [[nodiscard]] std::span<const Hidden> hidden() const noexcept { return arrays_.hidden; }
    /// What the construction did.
    [[nodiscard]] const Statistics& statistics() const noexcept { return statistics_; }

    /// All 3n-3 edges, those to infinity (-1, a) included, smaller number first, sorted. Two sites
    /// that share several edges appear as often. O(n log n).
    [[nodiscard]] std::vector<Edge> edges() const;

    /// The vertices joined to a site, counterclockwise from the smallest, -1 where infinity is
    /// among them; empty for a hidden site. Throws std::out_of_range where there is no such site.
    /// O(degree).
    [[nodiscard]] std::vector<Index> neighbours(Index site) const;

    /// In the power metric, whose edges are straight, a face whose closure contains the point: a
    /// finite one, or outside the convex hull an infinite one whose hull edge sees the point (where
    /// all sites are collinear, one on the point's side, on the line itself one whose edge contains
    /// the point if any does). In the other metrics edges are curved, and faces have no shape of
    /// their own: there it is the first face at the site nearest(point). -1 where there is no face
    /// (fewer than two visible sites). Exact. The point must be finite (std::invalid_argument).
    /// Expected O(n^(1/3)) on uniform sites; O(n) in the worst case, as nearest() and where all
    /// sites are collinear.
    [[nodiscard]] Index locate(Point point) const;

    /// The site whose cell contains the point, ties going to the first in the tie rule's order; -1
    /// without sites. Exact. The point must be finite (std::invalid_argument). Expected O(n^(1/3))
    /// on uniform sites. It asks all neighbours of every site on its way: O(n) where one of them
    /// has nearly all others for neighbours, a giant among small ones.
    [[nodiscard]] Index nearest(Point point) const;

 private:
    friend Tessellation triangulation::constructed(TessellationArrays, std::vector<Site>,
                                                   const Statistics&);
    void find_faces_of_sites();
    [[nodiscard]] Point centre(Index site) const noexcept;
    /// The visible one of about n^(1/3) sites that is nearest to the point, roughly.
    [[nodiscard]] Index nearest_of_samples(Point point) const noexcept;
    /// A visible site to start from, near the point where a sample is. Precondition: there are
    /// faces.
    [[nodiscard]] Index visible_sample(Point point) const noexcept;
    /// locate() in the power metric. Precondition: there are faces.
    [[nodiscard]] Index locate_straight(Point point) const noexcept;
    [[nodiscard]] Index locate_beside_line(Point point) const noexcept;

    TessellationArrays arrays_;
    std::vector<Site> sites_;
    std::vector<Index> face_of_site_;
    Statistics statistics_;
};

}  // namespace signum
