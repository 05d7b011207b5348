#pragma once
/// Whether faces and edges that were right for some centres are right for others, too.
///
/// Law: where every face and every edge is right and the hull winds once, the structure is the
/// canonical tessellation of its vertices. That the faces are glued to a sphere, on which infinity
/// is one vertex, is known: it has been a tessellation once, and deletions and flips keep a sphere.
///
/// Power metric. The finite faces are a disc, mapped to the plane, each of them counterclockwise.
/// So a point in general position is covered as often as the disc's border winds around it. The
/// border turns left at every corner, or goes straight on, and winds once: it is a convex polygon,
/// and what lies inside is covered once. No change of the centres escapes that, however large:
/// where sites passed through each other, or the hull is turned over, a face has changed its
/// orientation or the border turns elsewhere. A triangulation that is regular across each edge is
/// regular, and the regular one of perturbed weights is unique.
///
/// Additive metrics. What is asked is what validate() asks: every face has its vertex, every edge
/// its stretch of the bisector, and the hull turns once. So the sphere of faces covers the plane
/// once (check/additive_check.hpp), and nothing is asked there about how the faces came about.
/// validate() asks about both ends of an edge. Where i, j, k have one vertex alone, and i, j, l
/// too, what k takes of the bisector of i and j is all that lies beyond its vertex, and what l
/// takes all before its own: each takes the other's vertex, or neither does, and one question
/// suffices.
///
/// Hidden sites are no part of the structure; Live looks after them.

#include <algorithm>
#include <cstddef>
#include <span>

#include "../../core/index.hpp"
#include "../../core/site.hpp"
#include "../insertion/edge_interior.hpp"
#include "../structure/topology.hpp"

namespace signum::triangulation {

template <class Kernel>
class LocalChecks {
 public:
    static constexpr bool is_straight = Kernel::is_straight;

    /// Neither is copied.
    LocalChecks(const Topology& topology, Kernel& kernel) noexcept
        : topology_(topology), kernel_(kernel) {}

    /// Whether three vertices in this order may be a face: infinite in the power metric, or
    /// counterclockwise; in the others, one that has a vertex.
    [[nodiscard]] bool may_be_face(Index a, Index b, Index c) {
        const bool is_infinite = (a | b | c) < 0;
        if constexpr (is_straight) {
            return is_infinite || kernel_.ccw(a, b, c) > 0;
        } else {
            if (!is_infinite) return kernel_.exists(a, b, c);
            const Index p = a == infinite ? b : a;
            const Index q = c == infinite ? b : c;
            return !kernel_.hides(p, q) && !kernel_.hides(q, p);
        }
    }
    [[nodiscard]] bool face(Index f) {
        const auto& v = topology_.vertices(f);
        return may_be_face(v[0], v[1], v[2]);
    }

    /// Precondition: both faces of the edge are right.
    [[nodiscard]] bool edge(HalfEdge h) {
        if constexpr (is_straight)
            return straight_edge(h);
        else
            return curved_edge(h, exists_twice(Topology::face(h)) ||
                                      exists_twice(Topology::face(topology_.twin(h))));
    }

    /// Tells what is wrong: every face that is, and every edge of two faces that are not; as long
    /// as it is not enough, which is asked now and then.
    ///
    /// A few faces are looked at, and then their edges. Which of its two faces looks at an edge is
    /// anybody's guess, and the face across lies anywhere: what is known early is neither guessed
    /// nor waited for.
    template <class WrongFace, class WrongEdge, class IsEnough>
    void survey(const WrongFace& wrong_face, const WrongEdge& wrong_edge,
                const IsEnough& is_enough) {
        constexpr Index few = 32;
        HalfEdge edges[3 * few];
        for (Index first = 0; first < topology_.faces() && !is_enough(); first += few) {
            std::size_t count = 0;
            const Index end = std::min(first + few, topology_.faces());
            for (Index f = first; f < end; ++f) {
                if (topology_.is_vacant(f)) [[unlikely]]
                    continue;
                if (!face(f)) [[unlikely]] {
                    wrong_face(f);
                    continue;
                }
                if (exists_twice(f)) [[unlikely]] {
                    survey_all_edges(f, wrong_edge);
                    continue;
                }
                for (unsigned k = 0; k < 3; ++k) {
                    const HalfEdge h = Topology::first_edge(f) + k;
                    const Index across = Topology::face(topology_.twin(h));
                    __builtin_prefetch(&topology_.record(across));
                    edges[count] = h;
                    count += static_cast<std::size_t>(f < across);
                }
            }
            const std::span<const HalfEdge> found(edges, count);
            for (const HalfEdge h : found)
                __builtin_prefetch(&kernel_.site(std::max(topology_.apex(topology_.twin(h)), 0)));
            for (const HalfEdge h : found)
                if (!edge_of_once(h)) [[unlikely]]
                    wrong_edge(h);
        }
    }

    /// Whether the hull winds once. Precondition: faces and edges are right, f is infinite.
    [[nodiscard]] bool hull(Index f) {
        int turns = 0;
        for (const HalfEdge h : topology_.fan(topology_.spoke(f, infinite))) {
            const Index a = topology_.apex(h);
            const Index b = topology_.target(h);
            const Index c = topology_.apex(topology_.twin(h));
            if constexpr (is_straight)
                turns += static_cast<int>(!rises(a, b) && rises(b, c));
            else
                turns += static_cast<int>(kernel_.holds_first_direction(a, b, c));
        }
        return turns == 1;
    }

 private:
    /// Of an edge to infinity: the hull turns left there, or goes straight on past a site that is
    /// visible on its line.
    [[nodiscard]] bool straight_edge(HalfEdge h) {
        const auto [i, j, k, l] = topology_.about(h);
        if (i == infinite) return turns_left(k, j, l);
        if (j == infinite) return turns_left(l, i, k);
        if (l == infinite) return true;
        return k == infinite || !kernel_.conflicts(i, j, k, l);
    }
    [[nodiscard]] bool turns_left(Index a, Index b, Index c) {
        if (a == c) return false;
        const Sign side = kernel_.ccw(a, b, c);
        if (side != 0) return side > 0;
        return rises(a, b) == rises(b, c) && !kernel_.conflicts_on_line(a, b, c);
    }
    [[nodiscard]] bool rises(Index a, Index b) const { return kernel_.compare_along(a, b) < 0; }

    [[nodiscard]] bool exists_twice(Index f) {
        const auto& v = topology_.vertices(f);
        if constexpr (is_straight)
            return false;
        else
            return (v[0] | v[1] | v[2]) < 0 || kernel_.exist_twice(v[0], v[1], v[2]);
    }
    template <class WrongEdge>
    void survey_all_edges(Index f, const WrongEdge& wrong_edge) {
        for (unsigned k = 0; k < 3; ++k) {
            const HalfEdge h = Topology::first_edge(f) + k;
            if (face(Topology::face(topology_.twin(h))) && !edge(h)) wrong_edge(h);
        }
    }
    /// Of an edge whose face exists once; where the one across does not, that one looks at it.
    [[nodiscard]] bool edge_of_once(HalfEdge h) {
        if constexpr (is_straight)
            return straight_edge(h);
        else
            return topology_.apex(topology_.twin(h)) == infinite || curved_edge(h, false);
    }
    /// Neither end lies nearer to the site across, and on the way between them the bisector does
    /// not pass through infinity. Where no three of the sites exist `twice` one question answers
    /// all.
    [[nodiscard]] bool curved_edge(HalfEdge h, bool twice) {
        const auto [i, j, k, l] = topology_.about(h);
        if (!twice) return !kernel_.conflicts_if_visible(i, j, k, l);
        if (k != l) {
            ExtendedKernel<Kernel> extended(kernel_);
            if (extended.conflicts(i, j, k, l) || extended.conflicts(j, i, l, k)) return false;
        }
        return ((i | j) | (k | l)) < 0 || runs_forward(kernel_, i, j, k, l);
    }

    const Topology& topology_;
    Kernel& kernel_;
};

}  // namespace signum::triangulation
