#pragma once
/// The check of tessellations in the metrics with additive weights.
///
/// Why it suffices. The faces are glued to a sphere (one cycle around each vertex, Euler's count,
/// connected). Draw every edge as the stretch of the bisector between the vertices of its two
/// faces. That maps the sphere to the plane closed at infinity:
///  1. at a vertex of the diagram the three stretches leave in the right order, for the circle
///     exists in this order;
///  2. along an edge the map goes forward, for its stretch does not pass through infinity;
///  3. around a site it turns, as the bisectors seen from a site do, once or several times.
/// So it is a covering, branched at sites and at infinity, and its degree is how often the hull
/// turns, infinity being covered there alone: once, which is checked. A covering of degree one is
/// the plane itself: the cells tile it, neighbours meet on their bisector, and each cell contains
/// its centre. On the way from any point x to the centre of any site t the distance to the cell one
/// is in falls no faster than that to t; at the centre it is the same; so at x the cell's site was
/// no farther than t. Hence every point lies in the cell of a nearest site.
///
/// With ties the same holds of the tie rule's infinitely small changes. Where a site conflicts with
/// a vertex only by the tie rule, and without it touches the circle, the tessellation is not
/// canonical, but valid. A vertex must exist under the tie rule: one that would under another
/// counts as wrong.

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "../kernels/additive_kernel.hpp"
#include "../structure/tie_order.hpp"
#include "additive_questions.hpp"
#include "arrays_check.hpp"
#include "near_sites.hpp"

namespace signum::triangulation {

/// Predicates: those of the metric, as a judge asks them. Distance: see near_sites.hpp.
template <class Predicates, class Distance>
class AdditiveCheck : private ArraysCheck {
 public:
    AdditiveCheck(const TessellationArrays& arrays, const StridedSites& sites,
                  const ValidationOptions& options)
        : ArraysCheck(arrays, sites.size(), options) {
        for (const Site& site : load<Site>(sites)) site_.push_back({site, 0});
        std::vector<Index> numbers(sites.size());
        std::iota(numbers.begin(), numbers.end(), 0);
        rank(site_, numbers, workers());
    }

    [[nodiscard]] Validation run() {
        Validation result = judgement([this] {
            check_sites();
            if (must_find_neighbours()) {
                connect_unique();
            } else {
                connect();
            }
            if (visible_ >= 2) {
                check_infinity();
                check_vertices();
                check_edges();
                check_hull();
            }
            check_hidden();
            check_canonical_order(view_of(std::span(site_)));
        });
        result.filtered = filtered_ + intervals_;
        result.multiprecision = multiprecision_;
        return result;
    }

 private:
    using Kernel = AdditiveKernel<Predicates, filters::Tally>;

    using Part = AdditiveQuestions<Kernel>;

    /// judge(part, i) for 0 … size; see judge_each().
    template <class Judge>
    void judge_all(std::size_t size, std::size_t advances, const Judge& judge) {
        this->judge_each(
            size, advances, Part(notes(), Kernel(site_.data())),
            [&](Part& part, std::size_t i) { judge(part, static_cast<Index>(i)); },
            [this](const Part& part) {
                const auto& stages = part.kernel.tally().stages;
                filtered_ += stages[static_cast<int>(Stage::filter)];
                multiprecision_ += stages[static_cast<int>(Stage::multiprecision)];
                intervals_ += part.intervals;
            });
    }

    /// What messages call a face, and the one across an edge.
    struct Names {
        Index face;
        Index across = infinite;
        [[nodiscard]] std::string of(Index site) const { return name(site); }
        [[nodiscard]] std::string of_face() const { return face_name(face); }
        [[nodiscard]] std::string of_face_across() const { return face_name(across); }
    };

    void check_vertices() {
        judge_all(arrays_.faces.size(), 1,
                  [this](Part& part, Index f) { part.judge_vertex(face(f), Names{f}); });
    }
    void check_edges() {
        judge_all(arrays_.faces.size(), 3, [this](Part& part, Index f) {
            for (unsigned side = 0; side < 3; ++side) {
                const HalfEdge h = Topology::first_edge(f) + side;
                part.judge_edge(topology_.about(h), Names{f, Topology::face(topology_.twin(h))});
            }
        });
    }

    /// The hull turns once: one of its arcs of directions contains the first direction.
    void check_hull() {
        int turns = 0;
        judge_all(1, 0, [&](Part& part, Index) {
            for (Index f = 0; f < faces(); ++f)
                for (unsigned k = 0; k < 3; ++k) {
                    const HalfEdge h = Topology::first_edge(f) + k;
                    if (topology_.origin(h) == infinite)
                        turns += static_cast<int>(part.kernel.holds_first_direction(
                            topology_.apex(h), topology_.target(h),
                            topology_.apex(topology_.twin(h))));
                }
        });
        if (turns != 1) throw Invalid{"the hull turns " + std::to_string(turns) + " times"};
    }

    /// Every hidden site is hidden by the visible one nearest to its centre.
    void check_hidden() {
        if (arrays_.hidden.empty()) return;
        const auto site_of = [this](Index i) -> const Site& { return site_[at(i)]; };
        const NearSites<Distance> visible(visible_sites(), site_of, workers());
        judge_all(arrays_.hidden.size(), 1, [&](Part& part, Index h) {
            const auto& [q, by] = arrays_.hidden[at(h)];
            Kernel& kernel = part.kernel;
            if (!kernel.hides(by, q)) {
                if (!kernel.hides_if_first(by, q))
                    throw Invalid{name(by) + " does not hide " + name(q)};
                part.note("by the tie rule " + name(by) + " does not hide " + name(q));
            }
            const auto ask = [&, q = q, by = by](Index v) {
                if (v == by) return;
                part.forbid([&] { return kernel.is_nearer(q, v, by); },
                            [&] {
                                return name(v) + " is nearer to the centre of " + name(q) +
                                       " than " + name(by) + ", which is said to hide it";
                            });
            };
            part.intervals += visible.visit_near(kernel.centre(q), site_of(by), ask);
        });
    }

    std::vector<RankedSite> site_;
    std::uint64_t filtered_ = 0;  // questions that filters decided
    std::uint64_t multiprecision_ = 0;
    std::uint64_t intervals_ = 0;
};

}  // namespace signum::triangulation
