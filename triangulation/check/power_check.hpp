#pragma once
/// The check of power triangulations, with the multiprecision kernel alone.

#include <algorithm>
#include <vector>

#include "../insertion/hiders.hpp"
#include "../kernels/power_kernel.hpp"
#include "arrays_check.hpp"

namespace signum::triangulation {

/// A directed edge of a face, from its smaller to its larger end or back.
struct DirectedEdge {
    Index from;
    Index to;
    HalfEdge half_edge;
    friend bool operator<(const DirectedEdge& a, const DirectedEdge& b) noexcept {
        return std::pair(a.from, a.to) < std::pair(b.from, b.to);
    }
};

/// The checks in their order; each may rely on those before.
///
/// Why they suffice: counterclockwise faces whose interior stars wind once, inside a convex polygon
/// that winds once, with Euler's count, cover the hull exactly once (the angles at the hull add up
/// to those of the polygon only if every hull star winds as it should). A triangulation of the hull
/// that is regular across each edge is regular. The cell of a site is bounded by its neighbours'
/// alone, so that what is nearest among them is nearest of all.
template <power::PowerSite S>
class PowerCheck : private ArraysCheck {
 public:
    PowerCheck(const TessellationArrays& arrays, const StridedSites& sites)
        : ArraysCheck(arrays, sites.size()), site_(load<S>(sites)), numbers_(sites.size()) {
        for (std::size_t i = 0; i < numbers_.size(); ++i) numbers_[i] = static_cast<Index>(i);
    }

    [[nodiscard]] Validation run() {
        return judgement([this] {
            check_sites();
            if (visible_ >= 2) {
                is_line_ =
                    std::all_of(arrays_.faces.begin(), arrays_.faces.end(), [](const Face& v) {
                        return v[0] == infinite || v[1] == infinite || v[2] == infinite;
                    });
                connect();
            }
            check_neighbours();
            if (visible_ >= 2) {
                if (is_line_) {
                    check_line();
                } else {
                    check_orientation();
                    check_stars();
                    check_hull();
                    check_edges();
                }
            }
            check_hidden();
            check_canonical_order();
        });
    }

 private:
    using Kernel = PowerKernel<S, Arithmetic::multiprecision, filters::NoTally>;

    [[nodiscard]] const S& site(Index i) const { return site_[at(i)]; }

    /// Glues the faces along their edges. In the power metric an edge between two sites is unique;
    /// only sites on a line have two edges to infinity, which neighbours along the line share in
    /// pairs.
    void connect() {
        topology_ = Topology(sites_);
        std::vector<DirectedEdge> edges;
        for (Index f = 0; f < faces(); ++f) {
            const Face& v = face(f);
            topology_.add_face(v[0], v[1], v[2]);
            for (unsigned k = 0; k < 3; ++k)
                edges.push_back({v[k], v[(k + 1) % 3], Topology::first_edge(f) + k});
        }
        std::sort(edges.begin(), edges.end());
        for (std::size_t i = 0; i < edges.size(); ++i) {
            const DirectedEdge& edge = edges[i];
            const auto [first, last] =
                std::equal_range(edges.begin(), edges.end(), DirectedEdge{edge.to, edge.from, 0});
            const bool multiple = i > 0 && !(edges[i - 1] < edge);
            if (is_line_ && (edge.from == infinite || edge.to == infinite)) continue;
            if (multiple || last - first != 1)
                throw Invalid{face_name(Topology::face(edge.half_edge)) + ": the edge from " +
                              name(edge.from) + " to " + name(edge.to) + " belongs to " +
                              (first == last ? "one face only" : "more than two faces")};
            topology_.glue(edge.half_edge, first->half_edge);
        }
        if (is_line_) connect_line_at_infinity();
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

    /// The neighbours that the arrays give, where they give any, are those across the edges.
    void check_neighbours() {
        if (arrays_.neighbours.empty() && faces() > 0) {
            note("the neighbours are missing");
            return;
        }
        if (arrays_.neighbours.size() != arrays_.faces.size())
            throw Invalid{"there are " + std::to_string(arrays_.faces.size()) + " faces, but " +
                          std::to_string(arrays_.neighbours.size()) + " triples of neighbours"};
        for (Index f = 0; f < faces(); ++f)
            for (unsigned k = 0; k < 3; ++k) {
                const HalfEdge opposite = Topology::first_edge(f) + (k + 1) % 3;
                const Index across = Topology::face(topology_.twin(opposite));
                if (arrays_.neighbours[at(f)][k] != across)
                    throw Invalid{face_name(f) + ": neighbour " + std::to_string(k) +
                                  " is given as " + std::to_string(arrays_.neighbours[at(f)][k]) +
                                  ", but face " + std::to_string(across) + " shares the edge"};
            }
    }

    /// Every finite face is counterclockwise.
    void check_orientation() {
        for (Index f = 0; f < faces(); ++f)
            if (!topology_.is_infinite(f) && kernel_.ccw(face(f)[0], face(f)[1], face(f)[2]) <= 0)
                throw Invalid{face_name(f) + " is not counterclockwise"};
    }

    /// The faces at each site form one cycle; where infinity is not among them they wind once.
    void check_stars() {
        std::vector<Index> degree(sites_, 0);
        std::vector<HalfEdge> spoke(sites_, 0);
        Index hull_edges = 0;
        HalfEdge hull_spoke = 0;
        for (Index f = 0; f < faces(); ++f)
            for (unsigned k = 0; k < 3; ++k) {
                const HalfEdge h = Topology::first_edge(f) + k;
                const Index v = topology_.origin(h);
                if (v == infinite) {
                    ++hull_edges;
                    hull_spoke = h;
                } else {
                    ++degree[at(v)];
                    spoke[at(v)] = h;
                }
            }
        if (hull_edges != degree_at(hull_spoke)) throw Invalid{"the hull is not one cycle"};
        for (Index v = 0; v < static_cast<Index>(sites_); ++v) {
            if (degree[at(v)] == 0) continue;
            if (degree_at(spoke[at(v)]) != degree[at(v)])
                throw Invalid{"the faces at " + name(v) + " are not one cycle"};
            const int turns = winding(v, spoke[at(v)]);
            if (turns != 1)
                throw Invalid{"the faces at " + name(v) + " wind " + std::to_string(turns) +
                              " times around it"};
        }
    }

    /// How often the spokes of a site turn from below it to above it, counterclockwise; 1 for a
    /// site on the hull, whose star is checked with the hull.
    [[nodiscard]] int winding(Index v, HalfEdge first) const {
        const auto above = [&](Index u) {
            return site(u).y != site(v).y ? site(u).y > site(v).y : site(u).x > site(v).x;
        };
        int turns = 0;
        for (const HalfEdge h : topology_.fan(first)) {
            const Index u = topology_.target(h);
            const Index w = topology_.apex(h);
            if (u == infinite || w == infinite) return 1;
            turns += static_cast<int>(!above(u) && above(w));
        }
        return turns;
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
            const Sign side = kernel_.ccw(a, b, c);
            const auto rises = [&](Index from, Index to) {
                return site(to).y != site(from).y ? site(to).y > site(from).y
                                                  : site(to).x > site(from).x;
            };
            if (side < 0 || (side == 0 && rises(a, b) != rises(b, c)))
                throw Invalid{"the hull turns right at " + name(b)};
            turns += static_cast<int>(!rises(a, b) && rises(b, c));
            if (side == 0) judge_on_line(a, b, c);
        }
        if (turns != 1) throw Invalid{"the hull winds " + std::to_string(turns) + " times"};
    }

    /// No site across an edge is in conflict with the face.
    void check_edges() {
        for (Index f = 0; f < faces(); ++f) {
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
            if (kernel_.centre(a) == kernel_.centre(b))
                throw Invalid{face_name(f) + " joins sites with equal centres"};
            if (c == a) {
                ++ends;
                continue;
            }
            if (kernel_.ccw(a, b, c) != 0 || before(kernel_.centre(a), kernel_.centre(b)) !=
                                                 before(kernel_.centre(b), kernel_.centre(c)))
                throw Invalid{face_name(f) + " is infinite, but its sites do not follow one line"};
            judge_on_line(a, b, c);
        }
        if (ends != 2) throw Invalid{"the sites on a line are not one chain"};
        for (Index f = 0; f < faces(); ++f)
            for (const Index v : face(f))
                if (v != infinite) line_.push_back(v);
        std::sort(line_.begin(), line_.end(),
                  [&](Index i, Index k) { return before(kernel_.centre(i), kernel_.centre(k)); });
        line_.erase(std::unique(line_.begin(), line_.end()), line_.end());
    }

    void judge(Index f, Index q) {
        const Face& v = face(f);
        const Sign sign =
            power::multiprecision::in_circle(site(v[0]), site(v[1]), site(v[2]), site(q));
        if (sign > 0) throw Invalid{name(q) + " is in conflict with " + face_name(f)};
        if (sign == 0 && kernel_.conflicts(v[0], v[1], v[2], q))
            note("by the tie rule " + name(q) + " is in conflict with " + face_name(f));
    }

    void judge_on_line(Index a, Index b, Index q) {
        const Sign sign = power::multiprecision::in_segment(site(a), site(b), site(q));
        const std::string where = name(q) + " is in conflict with the edge from " + name(a) +
                                  " to " + name(b) + " on their line";
        if (sign > 0) throw Invalid{where};
        if (sign == 0 && kernel_.conflicts_on_line(a, b, q)) note("by the tie rule " + where);
    }

    /// Every hidden site lies above the tessellation, and the site it names is nearest to its
    /// centre.
    void check_hidden() {
        if (arrays_.hidden.empty()) return;
        const std::vector<Index> face_of =
            visible_ < 2 ? std::vector<Index>(sites_, -1) : faces_of_vertices(topology_, sites_);
        for (const Hidden& hidden : arrays_.hidden) {
            const Index q = hidden.site;
            check_nearest(q, hidden.by, face_of);
            if (visible_ < 2) {
                check_hidden_by_one(q, hidden.by);
            } else if (is_line_) {
                check_hidden_on_line(q);
            } else {
                judge(containing_face(q, face_of[at(hidden.by)]), q);
            }
        }
    }

    /// A face that contains the centre of q. The walk may go in circles, for a triangulation that
    /// is valid by a choice of ties need not be regular for any weights; then all faces are
    /// searched.
    [[nodiscard]] Index containing_face(Index q, Index start) {
        Index f = topology_.is_infinite(start)
                      ? Topology::face(topology_.twin(topology_.finite_edge(start)))
                      : start;
        for (Index steps = 0; steps < faces() && !topology_.is_infinite(f); ++steps) {
            const unsigned k = separating_edge(face(f), q);
            if (k == 3) return f;
            f = Topology::face(topology_.twin(Topology::first_edge(f) + k));
        }
        if (!topology_.is_infinite(f))
            for (Index g = 0; g < faces(); ++g)
                if (!topology_.is_infinite(g) && separating_edge(face(g), q) == 3) return g;
        throw Invalid{name(q) + " is said to be hidden, but lies outside the hull"};
    }

    /// The first edge of a finite face with q strictly on its right, 3 where there is none.
    [[nodiscard]] unsigned separating_edge(const Face& v, Index q) {
        unsigned k = 0;
        while (k < 3 && kernel_.ccw(v[k], v[(k + 1) % 3], q) >= 0) ++k;
        return k;
    }

    void check_nearest(Index q, Index by, const std::vector<Index>& face_of) {
        const Point centre = kernel_.centre(q);
        const Index f = face_of[at(by)];
        if (f < 0) return;
        for (const HalfEdge h : topology_.fan(topology_.spoke(f, by))) {
            const Index v = topology_.target(h);
            if (v != infinite) {
                if (power::multiprecision::nearer(centre, site(v), site(by)) > 0)
                    throw Invalid{name(q) + " is said to be hidden by " + name(by) + ", but " +
                                  name(v) + " is nearer"};
                if (kernel_.nearer(centre, v, by))
                    note("by the tie rule " + name(q) + " is hidden by " + name(v) + ", not " +
                         name(by));
            }
        }
    }

    void check_hidden_by_one(Index q, Index by) {
        if (kernel_.centre(q) != kernel_.centre(by) ||
            power::multiprecision::nearer(kernel_.centre(q), site(q), site(by)) > 0)
            throw Invalid{name(by) + " does not hide " + name(q)};
        if (kernel_.precedes(q, by)) note("by the tie rule " + name(q) + " hides " + name(by));
    }

    /// The line edge whose two ends enclose q, by bisection.
    void check_hidden_on_line(Index q) {
        const auto first_after = std::partition_point(line_.begin(), line_.end(), [&](Index v) {
            return before(kernel_.centre(v), kernel_.centre(q));
        });
        const bool at_site =
            first_after != line_.end() && kernel_.centre(*first_after) == kernel_.centre(q);
        if (first_after == line_.end() || (first_after == line_.begin() && !at_site))
            throw Invalid{name(q) + " is said to be hidden, but lies outside the hull"};
        const Index b = first_after == line_.begin() ? line_[1] : *first_after;
        const Index a = first_after == line_.begin() ? line_[0] : *(first_after - 1);
        if (kernel_.ccw(a, b, q) != 0)
            throw Invalid{name(q) + " is said to be hidden, but lies outside the hull"};
        judge_on_line(a, b, q);
    }

    std::vector<S> site_;
    std::vector<Index> numbers_;
    Kernel kernel_{site_.data(), numbers_.data()};
    std::vector<Index> line_;  // the visible sites of a line in their order along it
    bool is_line_ = false;     // infinite faces only: all sites are collinear
};

}  // namespace signum::triangulation
