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

#include "../insertion/edge_interior.hpp"
#include "../insertion/hiders.hpp"
#include "../kernels/additive_kernel.hpp"
#include "../structure/tie_order.hpp"
#include "arrays_check.hpp"

namespace signum::triangulation {

/// Predicates: those of the metric in rationals.
template <class Predicates>
class AdditiveCheck : private ArraysCheck {
 public:
    AdditiveCheck(const TessellationArrays& arrays, const StridedSites& sites)
        : ArraysCheck(arrays, sites.size()) {
        for (const Site& site : load<Site>(sites)) site_.push_back({site, 0});
        std::vector<Index> numbers(sites.size());
        std::iota(numbers.begin(), numbers.end(), 0);
        rank(site_, numbers);
        kernel_ = Kernel(site_.data());
    }

    [[nodiscard]] Validation run() {
        return judgement([this] {
            check_sites();
            connect();
            if (visible_ >= 2) {
                check_sphere();
                check_vertices();
                check_edges();
                check_hull();
            }
            check_hidden();
            check_canonical_order();
        });
    }

 private:
    using Kernel = AdditiveKernel<Predicates, Arithmetic::multiprecision, filters::Tally>;

    static void require(bool holds, const std::string& why) {
        if (!holds) throw Invalid{why};
    }

    /// Throws if the question is answered yes; where nothing but the tie rule does so, notes it.
    /// Whether the answer is no.
    template <class Question>
    bool forbid(Question question, const std::string& why) {
        const auto before = kernel_.tally().ties;
        if (!question()) return true;
        require(kernel_.tally().ties != before, why);
        note("by the tie rule " + why);
        return false;
    }

    /// Glues the faces as their neighbours say; two sites may share several edges. Without
    /// neighbours the edges must be unique.
    void connect() {
        topology_ = Topology(sites_);
        for (const Face& v : arrays_.faces) topology_.add_face(v[0], v[1], v[2]);
        if (arrays_.neighbours.empty() && faces() > 0) {
            note("the neighbours are missing");
            connect_unique();
            return;
        }
        if (arrays_.neighbours.size() != arrays_.faces.size())
            throw Invalid{"there are " + std::to_string(arrays_.faces.size()) + " faces, but " +
                          std::to_string(arrays_.neighbours.size()) + " triples of neighbours"};
        for (Index f = 0; f < faces(); ++f)
            for (unsigned k = 0; k < 3; ++k) {
                const Index g = arrays_.neighbours[at(f)][k];
                const HalfEdge h = Topology::first_edge(f) + (k + 1) % 3;
                topology_.glue(h, edge_of_neighbour(f, k, g, h));
            }
    }

    /// The edge of face g that is h, backwards; g must say so too.
    [[nodiscard]] HalfEdge edge_of_neighbour(Index f, unsigned k, Index g, HalfEdge h) const {
        if (g >= 0 && g < faces())
            for (unsigned m = 0; m < 3; ++m) {
                const HalfEdge back = Topology::first_edge(g) + (m + 1) % 3;
                if (arrays_.neighbours[at(g)][m] == f && topology_.origin(back) == target(h) &&
                    target(back) == topology_.origin(h))
                    return back;
            }
        throw Invalid{face_name(f) + ": neighbour " + std::to_string(k) + " is given as " +
                      std::to_string(g) + ", which does not share the edge"};
    }
    [[nodiscard]] Index target(HalfEdge h) const { return topology_.origin(Topology::next(h)); }

    void connect_unique() {
        std::vector<std::pair<Edge, HalfEdge>> edges;
        for (Index f = 0; f < faces(); ++f)
            for (unsigned k = 0; k < 3; ++k) {
                const HalfEdge h = Topology::first_edge(f) + k;
                edges.push_back({{topology_.origin(h), target(h)}, h});
            }
        std::sort(edges.begin(), edges.end());
        for (std::size_t e = 0; e < edges.size(); ++e) {
            const auto [from, to] = edges[e].first;
            const std::string which = "the edge from " + name(from) + " to " + name(to);
            if (e > 0 && edges[e - 1].first == edges[e].first)
                throw Invalid{which + " occurs twice: only neighbours can tell which is which"};
            const auto back = std::lower_bound(edges.begin(), edges.end(),
                                               std::pair(Edge{to, from}, HalfEdge{0}));
            if (back == edges.end() || back->first != Edge{to, from})
                throw Invalid{face_name(Topology::face(edges[e].second)) + ": " + which +
                              " belongs to one face only"};
            topology_.glue(edges[e].second, back->second);
        }
    }

    /// The faces at every vertex are one cycle, and all faces hang together.
    void check_sphere() {
        std::vector<Index> degree(sites_ + 1, 0);  // infinity's comes first
        std::vector<HalfEdge> spoke(sites_ + 1, 0);
        for (Index f = 0; f < faces(); ++f)
            for (unsigned k = 0; k < 3; ++k) {
                const HalfEdge h = Topology::first_edge(f) + k;
                ++degree[at(topology_.origin(h) + 1)];
                spoke[at(topology_.origin(h) + 1)] = h;
            }
        if (degree[0] == 0) throw Invalid{"infinity is no vertex"};
        for (std::size_t v = 0; v < degree.size(); ++v)
            if (degree[v] != 0 && degree_at(spoke[v]) != degree[v])
                throw Invalid{"the faces at " + name(static_cast<Index>(v) - 1) +
                              " are not one cycle"};
        std::vector<char> seen(at(faces()), 0);
        std::vector<Index> pending = {0};
        seen[0] = 1;
        std::size_t count = 0;
        while (!pending.empty()) {
            const Index f = pending.back();
            pending.pop_back();
            ++count;
            for (unsigned k = 0; k < 3; ++k) {
                const Index g = Topology::face(topology_.twin(Topology::first_edge(f) + k));
                if (std::exchange(seen[at(g)], 1) == 0) pending.push_back(g);
            }
        }
        if (count != at(faces())) throw Invalid{"the faces do not hang together"};
    }

    /// Every face has its vertex: a circle that touches the three, or at infinity two sites of
    /// which neither hides the other.
    void check_vertices() {
        for (Index f = 0; f < faces(); ++f) {
            const Face& v = face(f);
            if (topology_.is_infinite(f)) {
                const HalfEdge h = topology_.finite_edge(f);
                require(!kernel_.hides(topology_.origin(h), topology_.target(h)) &&
                            !kernel_.hides(topology_.target(h), topology_.origin(h)),
                        face_name(f) + " joins a site to one it hides");
            } else {
                require(kernel_.exists(v[0], v[1], v[2]),
                        "no circle touches the sites of " + face_name(f) + " counterclockwise");
            }
        }
    }

    /// Every edge has its stretch: neither end lies nearer to the site across, and on the way
    /// between them the bisector does not pass through infinity.
    void check_edges() {
        for (Index f = 0; f < faces(); ++f)
            for (unsigned side = 0; side < 3; ++side) {
                const HalfEdge h = Topology::first_edge(f) + side;
                const Index across = Topology::face(topology_.twin(h));
                const Index i = topology_.origin(h);
                const Index j = topology_.target(h);
                const Index k = topology_.apex(h);
                const Index l = topology_.apex(topology_.twin(h));
                const bool apart =
                    k == l || forbid([&] { return extended_.conflicts(i, j, k, l); },
                                     name(l) + " is in conflict with " + face_name(f));
                if (apart && i < j && i != infinite && k != infinite && l != infinite)
                    require(runs_forward(i, j, k, l), "the edge of " + face_name(f) + " and " +
                                                          face_name(across) +
                                                          " would pass through infinity");
            }
    }

    /// Whether the bisector leads from vertex (j,i,l) to (i,j,k) without passing through infinity:
    /// where k or l takes an end of the bisector it must; otherwise the part of l comes first.
    [[nodiscard]] bool runs_forward(Index i, Index j, Index k, Index l) {
        if (!kernel_.exist_twice(i, j, k) || !kernel_.exist_twice(i, j, l)) return true;
        for (const Index side : {k, l})
            if (kernel_.conflicts_infinite(j, i, side) || kernel_.conflicts_infinite(i, j, side))
                return true;
        return k != l && kernel_.precedes(i, j, l, k);
    }

    /// The hull turns once: one of its arcs of directions contains the first direction.
    void check_hull() {
        int turns = 0;
        for (Index f = 0; f < faces(); ++f)
            for (unsigned k = 0; k < 3; ++k) {
                const HalfEdge h = Topology::first_edge(f) + k;
                if (topology_.origin(h) == infinite)
                    turns += static_cast<int>(kernel_.holds_first_direction(
                        topology_.apex(h), topology_.target(h), topology_.apex(topology_.twin(h))));
            }
        require(turns == 1, "the hull turns " + std::to_string(turns) + " times");
    }

    /// Every hidden site is hidden by the visible one nearest to its centre. Cells are star-shaped:
    /// a site that has no nearer neighbour is the nearest.
    void check_hidden() {
        if (arrays_.hidden.empty()) return;
        const std::vector<Index> face_of = faces_of_vertices(topology_, sites_);
        for (const Hidden& hidden : arrays_.hidden) {
            const Index q = hidden.site;
            if (!kernel_.hides(hidden.by, q)) {
                require(kernel_.hides_if_first(hidden.by, q),
                        name(hidden.by) + " does not hide " + name(q));
                note("by the tie rule " + name(hidden.by) + " does not hide " + name(q));
            }
            const Index f = face_of[at(hidden.by)];
            if (f < 0) continue;
            for (const HalfEdge h : topology_.fan(topology_.spoke(f, hidden.by))) {
                const Index v = topology_.target(h);
                if (v != infinite)
                    forbid([&] { return kernel_.is_nearer(q, v, hidden.by); },
                           name(v) + " is nearer to the centre of " + name(q) + " than " +
                               name(hidden.by) + ", which is said to hide it");
            }
        }
    }

    std::vector<RankedSite> site_;
    Kernel kernel_{nullptr};
    ExtendedKernel<Kernel> extended_{kernel_};
};

}  // namespace signum::triangulation
