#pragma once
/// The check of power triangulations.

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "../structure/spatial_order.hpp"
#include "../structure/tie_order.hpp"
#include "arrays_check.hpp"
#include "judging.hpp"
#include "near_sites.hpp"

namespace signum::triangulation {

/// The checks in their order; each may rely on those before.
///
/// Why they suffice: counterclockwise faces whose interior stars wind once, inside a convex polygon
/// that winds once, with Euler's count, cover the hull exactly once (the angles at the hull add up
/// to those of the polygon only if every hull star winds as it should). A closed surface without
/// infinity would be made of counterclockwise faces alone, whose areas add up to 0: there is none.
/// A triangulation of the hull that is regular across each edge is regular.
/// Predicates: see JudgingPower. Distance: see near_sites.hpp.
template <power::PowerSite S, class Predicates, class Distance>
class PowerCheck : private ArraysCheck {
 public:
    PowerCheck(const TessellationArrays& arrays, const StridedSites& sites,
               const ValidationOptions& options)
        : ArraysCheck(arrays, sites.size(), options, 2), site_(load<S>(sites)) {
        std::vector<RankedSite> ranked(site_.size());
        std::vector<Index> numbers(site_.size());
        for (std::size_t i = 0; i < site_.size(); ++i) {
            ranked[i] = {{site_[i].x, site_[i].y, power::weight_key(site_[i])}, 0};
            numbers[i] = static_cast<Index>(i);
        }
        rank(ranked, numbers);
        for (const RankedSite& site : ranked) rank_.push_back(site.rank);
    }

    [[nodiscard]] Validation run() {
        Validation result = judgement([this] {
            check_sites();
            is_line_ = std::all_of(arrays_.faces.begin(), arrays_.faces.end(), [](const Face& v) {
                return v[0] == infinite || v[1] == infinite || v[2] == infinite;
            });
            glue();
            if (visible_ >= 2) {
                check_infinity();
                if (is_line_) {
                    check_line();
                } else {
                    check_stars();
                    check_hull();
                    check_edges();
                }
            }
            check_hidden();
            check_canonical_order();
        });
        result.filtered = tally_.stages[static_cast<int>(Stage::filter)] + intervals_;
        result.multiprecision = tally_.stages[static_cast<int>(Stage::multiprecision)];
        return result;
    }

 private:
    [[nodiscard]] const S& site(Index i) const { return site_[at(i)]; }
    /// The site's three numbers, whatever the third is.
    [[nodiscard]] signum::Site plain(Index i) const {
        const auto [x, y, third] = site(i);
        return {x, y, third};
    }
    [[nodiscard]] Point centre(Index i) const { return power::centre(site(i)); }
    [[nodiscard]] bool precedes(Index a, Index b) const { return rank_[at(a)] < rank_[at(b)]; }

    Sign count(const Decision& decision) {
        tally_.count_stage(decision.stage);
        return decision.sign;
    }
    [[nodiscard]] Sign ccw(Index a, Index b, Index c) {
        return count(Predicates::ccw(site(a), site(b), site(c)));
    }

    /// Along the edges where there are no neighbours. In the power metric an edge between two sites
    /// is unique; only sites on a line have two edges to infinity, which neighbours along the line
    /// share in pairs.
    void glue() {
        if (!must_find_neighbours()) {
            connect();
        } else {
            connect_unique([this](const Edge& edge) {
                return !is_line_ || (edge[0] != infinite && edge[1] != infinite);
            });
            if (is_line_) connect_line_at_infinity();
        }
    }

    /// Around a site inside the line: two faces on each side, glued where they meet; around an end:
    /// two.
    void connect_line_at_infinity() {
        std::vector<std::vector<HalfEdge>> spokes(sites_);  // out of each site to infinity
        for (Index f = 0; f < faces(); ++f) {
            const HalfEdge h = Topology::next(topology_.finite_edge(f));
            spokes[at(topology_.origin(h))].push_back(h);
        }
        for (std::size_t i = 0; i < spokes.size(); ++i)
            for (const HalfEdge h : spokes[i]) {
                // Turn about the site: over its finite edge to the face on the other side. There
                // the spoke into the site belongs to the same line edge; of the two spokes that
                // leave the site it matches the other one, or the same at an end.
                const HalfEdge inward = Topology::previous(topology_.twin(Topology::previous(h)));
                if (spokes[i].size() > 2)
                    throw Invalid{name(static_cast<Index>(i)) +
                                  " has more than two neighbours on a line"};
                const HalfEdge outward =
                    spokes[i].size() == 1 || spokes[i][0] != h ? spokes[i][0] : spokes[i][1];
                topology_.glue(outward, inward);
            }
    }

    /// Every finite face is counterclockwise, and where infinity is not among the faces at a site
    /// they wind once: the spokes turn from below it to above it, counterclockwise, in one face.
    /// The star of a site on the hull is checked with the hull.
    void check_stars() {
        std::vector<Index> turns(sites_, 0);
        std::vector<char> on_hull(sites_, 0);
        for (Index f = 0; f < faces(); ++f, advance()) {
            const Face& v = face(f);
            if (topology_.is_infinite(f)) {
                for (const Index i : v)
                    if (i != infinite) on_hull[at(i)] = 1;
                continue;
            }
            if (ccw(v[0], v[1], v[2]) <= 0)
                throw Invalid{face_name(f) + " is not counterclockwise"};
            for (std::size_t k = 0; k < 3; ++k) {
                const Index next = v[(k + 1) % 3];
                turns[at(v[k])] +=
                    static_cast<Index>(!rises(v[k], next) && rises(v[k], v[(k + 2) % 3]));
            }
        }
        for (std::size_t i = 0; i < sites_; ++i)
            if (turns[i] > 1 && on_hull[i] == 0)
                throw Invalid{"the faces at " + name(static_cast<Index>(i)) + " wind " +
                              std::to_string(turns[i]) + " times around it"};
    }

    /// Whether b lies above a, or as high and farther to the right.
    [[nodiscard]] bool rises(Index a, Index b) const {
        return site(b).y != site(a).y ? site(b).y > site(a).y : site(b).x > site(a).x;
    }

    /// The hull turns left or goes straight on everywhere, and around once; where it goes straight
    /// on the one-dimensional in_circle holds.
    void check_hull() {
        int turns = 0;
        for (Index f = 0; f < faces(); ++f) {
            if (!topology_.is_infinite(f)) continue;
            const HalfEdge h =
                topology_.finite_edge(f);  // runs from b to a for the hull edge a -> b
            const Index a = topology_.target(h);
            const Index b = topology_.origin(h);
            const HalfEdge spoke = topology_.around_origin(h);  // from b to infinity
            const Index c = topology_.apex(spoke);
            const Sign side = ccw(a, b, c);
            if (side < 0 || (side == 0 && rises(a, b) != rises(b, c)))
                throw Invalid{"the hull turns right at " + name(b)};
            turns += static_cast<int>(!rises(a, b) && rises(b, c));
            if (side == 0) judge_on_line(a, b, c);
        }
        if (turns != 1) throw Invalid{"the hull winds " + std::to_string(turns) + " times"};
    }

    /// No site across an edge is in conflict with the face.
    void check_edges() {
        for (Index f = 0; f < faces(); ++f, advance()) {
            if (topology_.is_infinite(f)) continue;
            for (unsigned k = 0; k < 3; ++k) {
                const HalfEdge across = topology_.twin(Topology::first_edge(f) + k);
                const Index q = topology_.apex(across);
                // Each edge once: from the smaller face.
                if (q != infinite && f < Topology::face(across)) judge(f, q);
            }
        }
    }

    [[nodiscard]] static bool before(Point p, Point q) noexcept {
        return p.x != q.x ? p.x < q.x : p.y < q.y;
    }

    /// The sites along a line, each visible one between its neighbours.
    void check_line() {
        Index ends = 0;
        for (Index f = 0; f < faces(); ++f) {
            const HalfEdge h = topology_.finite_edge(f);
            const Index a = topology_.target(h);
            const Index b = topology_.origin(h);
            const Index c = topology_.apex(topology_.around_origin(h));
            if (centre(a) == centre(b))
                throw Invalid{face_name(f) + " joins sites with equal centres"};
            if (c == a) {
                ++ends;
                continue;
            }
            if (ccw(a, b, c) != 0 || before(centre(a), centre(b)) != before(centre(b), centre(c)))
                throw Invalid{face_name(f) + " is infinite, but its sites do not follow one line"};
            judge_on_line(a, b, c);
        }
        if (ends != 2) throw Invalid{"the sites on a line are not one chain"};
        for (Index f = 0; f < faces(); ++f)
            for (const Index v : face(f))
                if (v != infinite) line_.push_back(v);
        std::sort(line_.begin(), line_.end(),
                  [&](Index i, Index k) { return before(centre(i), centre(k)); });
        line_.erase(std::unique(line_.begin(), line_.end()), line_.end());
    }

    void judge(Index f, Index q) {
        const Face& v = face(f);
        const Sign sign = count(Predicates::in_circle(site(v[0]), site(v[1]), site(v[2]), site(q)));
        if (sign > 0) throw Invalid{name(q) + " is in conflict with " + face_name(f)};
        if (sign == 0 && conflicts_by_the_rule({v[0], v[1], v[2], q}))
            note("by the tie rule " + name(q) + " is in conflict with " + face_name(f));
    }

    /// Whether the last of four sites that a circle touches is in conflict with the face of the
    /// others. Reducing a site's weight raises the determinant by an orientation of the other
    /// three; the last site in the order for which that is not 0 decides.
    [[nodiscard]] bool conflicts_by_the_rule(const std::array<Index, 4>& sites) {
        const auto [i, j, k, q] = sites;
        std::array<std::size_t, 4> order = {0, 1, 2, 3};
        std::sort(order.begin(), order.end(),
                  [&](std::size_t a, std::size_t b) { return precedes(sites[b], sites[a]); });
        for (const std::size_t m : order) {
            const Sign sign = m == 0   ? ccw(j, k, q)
                              : m == 1 ? ccw(k, i, q)
                              : m == 2 ? ccw(i, j, q)
                                       : -1;
            if (sign != 0) return sign > 0;
        }
        return false;
    }

    void judge_on_line(Index a, Index b, Index q) {
        const Sign sign = count(Predicates::in_segment(site(a), site(b), site(q)));
        if (sign < 0) return;
        const std::string where = name(q) + " is in conflict with the edge from " + name(a) +
                                  " to " + name(b) + " on their line";
        if (sign > 0) throw Invalid{where};
        const std::array<Index, 3> ranks = {rank_[at(a)], rank_[at(b)], rank_[at(q)]};
        if (power::in_segment_tie(centre(a), centre(b), centre(q), ranks) > 0)
            note("by the tie rule " + where);
    }

    /// Every hidden site lies above the tessellation, and the site it names is nearest to its
    /// centre.
    void check_hidden() {
        if (arrays_.hidden.empty()) return;
        NearSites<Distance> visible(visible_sites(), [this](Index i) { return plain(i); });
        const std::vector<Index> face_of = faces_of_vertices(topology_, sites_);
        Index hub = infinite;
        Index last = -1;  // the face of the last hidden site
        for (const auto& [q, by] : hidden_in_order()) {
            check_nearest(q, by, visible);
            if (visible_ < 2) {
                check_hidden_by_one(q, by);
            } else if (is_line_) {
                check_hidden_on_line(q);
            } else {
                if (by != hub) sort_star(by, face_of[at(by)]);
                hub = by;
                last = containing_face(q, face_toward(by, q), last);
                judge(last, q);
            }
            advance();
        }
    }

    /// The hidden sites, those of one site along a curve.
    [[nodiscard]] std::vector<Hidden> hidden_in_order() const {
        std::vector<Point> centres;
        for (const Hidden& hidden : arrays_.hidden) centres.push_back(centre(hidden.site));
        std::vector<Hidden> result;
        for (const Index i : spatial_order(centres, 1)) result.push_back(arrays_.hidden[at(i)]);
        std::stable_sort(result.begin(), result.end(),
                         [](const Hidden& a, const Hidden& b) { return a.by < b.by; });
        return result;
    }

    /// The directions of the spokes of a site, rounded, with the faces on their left: where a walk
    /// from the site starts, which may start anywhere.
    void sort_star(Index v, Index face_of_v) {
        star_.clear();
        for (const HalfEdge h : topology_.fan(topology_.spoke(face_of_v, v)))
            if (topology_.target(h) != infinite)
                star_.emplace_back(direction(v, topology_.target(h)), Topology::face(h));
        std::sort(star_.begin(), star_.end());
    }
    [[nodiscard]] Index face_toward(Index v, Index q) const {
        const auto after =
            std::upper_bound(star_.begin(), star_.end(), std::pair(direction(v, q), faces()));
        return (after == star_.begin() ? star_.back() : *(after - 1)).second;
    }
    [[nodiscard]] double direction(Index from, Index to) const {
        return std::atan2(site(to).y - site(from).y, site(to).x - site(from).x);
    }

    /// A face that contains the centre of q: most often a few steps from the site that hides it,
    /// and otherwise, where that is far away, not far from the face of the hidden site before. The
    /// walk may go in circles, for a triangulation that is valid by a choice of ties need not be
    /// regular for any weights; then all faces are searched.
    [[nodiscard]] Index containing_face(Index q, Index start, Index last) {
        constexpr Index few = 4;
        Index f = topology_.is_infinite(start)
                      ? Topology::face(topology_.twin(topology_.finite_edge(start)))
                      : start;
        for (Index steps = 0; steps < faces() && !topology_.is_infinite(f); ++steps) {
            const unsigned k = separating_edge(face(f), q);
            if (k == 3) return f;
            f = steps == few && last >= 0
                    ? last
                    : Topology::face(topology_.twin(Topology::first_edge(f) + k));
        }
        if (!topology_.is_infinite(f))
            for (Index g = 0; g < faces(); ++g)
                if (!topology_.is_infinite(g) && separating_edge(face(g), q) == 3) return g;
        throw Invalid{name(q) + " is said to be hidden, but lies outside the hull"};
    }

    /// The first edge of a finite face with q strictly on its right, 3 where there is none.
    [[nodiscard]] unsigned separating_edge(const Face& v, Index q) {
        unsigned k = 0;
        while (k < 3 && ccw(v[k], v[(k + 1) % 3], q) >= 0) ++k;
        return k;
    }

    void check_nearest(Index q, Index by, NearSites<Distance>& visible) {
        intervals_ += visible.visit_near(centre(q), plain(by), [&](Index v) {
            if (v == by) return;
            const Sign sign = count(Predicates::nearer(centre(q), site(v), site(by)));
            if (sign > 0)
                throw Invalid{name(q) + " is said to be hidden by " + name(by) + ", but " +
                              name(v) + " is nearer"};
            if (sign == 0 && precedes(v, by))
                note("by the tie rule " + name(q) + " is hidden by " + name(v) + ", not " +
                     name(by));
        });
    }

    void check_hidden_by_one(Index q, Index by) {
        if (centre(q) != centre(by) || count(Predicates::nearer(centre(q), site(q), site(by))) > 0)
            throw Invalid{name(by) + " does not hide " + name(q)};
        if (precedes(q, by)) note("by the tie rule " + name(q) + " hides " + name(by));
    }

    /// The line edge whose two ends enclose q, by bisection.
    void check_hidden_on_line(Index q) {
        const auto first_after = std::partition_point(
            line_.begin(), line_.end(), [&](Index v) { return before(centre(v), centre(q)); });
        const bool at_site = first_after != line_.end() && centre(*first_after) == centre(q);
        if (first_after == line_.end() || (first_after == line_.begin() && !at_site))
            throw Invalid{name(q) + " is said to be hidden, but lies outside the hull"};
        const Index b = first_after == line_.begin() ? line_[1] : *first_after;
        const Index a = first_after == line_.begin() ? line_[0] : *(first_after - 1);
        if (ccw(a, b, q) != 0)
            throw Invalid{name(q) + " is said to be hidden, but lies outside the hull"};
        judge_on_line(a, b, q);
    }

    std::vector<S> site_;
    std::vector<Index> rank_;  // places in the tie rule's order
    filters::Tally tally_;
    std::uint64_t intervals_ = 0;                 // questions that intervals decided
    std::vector<std::pair<double, Index>> star_;  // of the site that hides
    std::vector<Index> line_;  // the visible sites of a line in their order along it
    bool is_line_ = false;     // infinite faces only: all sites are collinear
};

}  // namespace signum::triangulation
