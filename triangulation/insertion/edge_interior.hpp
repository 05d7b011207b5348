#pragma once
/// The middle of an edge of the diagram: may a new site take it and leave both ends, or leave it
/// and take both ends?
///
/// The bisector of sites i and j, closed through infinity, is a circle on which every other site m
/// takes an interval K_m, from vertex (i,j,m) to vertex (j,i,m) where it does not take all or
/// nothing; where one of the two does not exist the interval begins or ends at infinity, which
/// takes a point itself. An edge with the faces (i,j,k) and (j,i,l) is what lies between the end of
/// K_l and the start of K_k. Where K_k and K_l are disjoint, another stretch lies between the end
/// of K_k and the start of K_l. Laws, for a site q that has two vertices with i, j:
///  1. q's vertex (j,i,q), the end of K_q, lies on one of the two where it is neither in K_k nor in
///     K_l.
///  2. If q takes both ends of the edge or neither, and (j,i,q) lies on the edge, then so does
///     (i,j,q), and q does the same to the other stretch's ends. Where q does that to all four
///     ends, K_q or the rest of the bisector is an interval within one of the two stretches.
///  3. There the order of three disjoint intervals tells which. Infinity is in K_k, in K_l or on
///     the other stretch, never on the edge.
/// None of this asks how many sites there are: edges between the same sites with the same sites
/// across them are told apart (docs/other-metrics.md).

#include <array>

#include "../../core/index.hpp"

namespace signum::triangulation {

/// The questions of a kernel, put for infinity as for any site.
template <class Kernel>
class ExtendedKernel {
 public:
    explicit ExtendedKernel(Kernel& kernel) noexcept : kernel_(kernel) {}

    /// Whether i, j, k have vertices in both orders.
    [[nodiscard]] bool exist_twice(Index i, Index j, Index k) {
        if (i == infinite) return are_apart(j, k);
        if (j == infinite) return are_apart(i, k);
        if (k == infinite) return true;
        return kernel_.exist_twice(i, j, k);
    }
    /// Whether q, which may be hidden, conflicts with the vertex of i, j, k.
    [[nodiscard]] bool conflicts(Index i, Index j, Index k, Index q) {
        if (i == infinite) return kernel_.conflicts_infinite(k, j, q);
        if (j == infinite) return kernel_.conflicts_infinite(i, k, q);
        if (k == infinite) return kernel_.conflicts_infinite(j, i, q);
        return q != infinite && kernel_.conflicts_if_visible(i, j, k, q);
    }

 private:
    [[nodiscard]] bool are_apart(Index i, Index j) {
        return !kernel_.hides(i, j) && !kernel_.hides(j, i);
    }

    Kernel& kernel_;
};

/// Whether the bisector of i and j leads from vertex (j,i,l) to (i,j,k), of which neither l nor k
/// takes the other's, without passing through infinity: where k or l takes an end of the bisector
/// it must; otherwise the part of l comes first. All four are sites.
template <class Kernel>
[[nodiscard]] bool runs_forward(Kernel& kernel, Index i, Index j, Index k, Index l) {
    if (!kernel.exist_twice(i, j, k) || !kernel.exist_twice(i, j, l)) return true;
    for (const Index side : {k, l})
        if (kernel.conflicts_infinite(j, i, side) || kernel.conflicts_infinite(i, j, side))
            return true;
    return k != l && kernel.precedes_on_bisector(i, j, l, k);
}

/// Whether both vertices of q on the bisector of an edge's two sites lie on the edge, both of whose
/// ends q takes (`taken`) or neither: then q leaves, or takes, no more than its middle. `about`:
/// i, j, k, l (Topology::about()).
template <class Kernel>
[[nodiscard]] bool ends_within(const std::array<Index, 4>& about, Kernel& exact, Index q,
                               bool taken) {
    ExtendedKernel<Kernel> kernel(exact);
    const auto [i, j, k, l] = about;
    if (!kernel.exist_twice(i, j, q)) return false;
    if (kernel.conflicts(j, i, q, k) || kernel.conflicts(j, i, q, l)) return false;
    // The other stretch runs from vertex (j, i, from) to (i, j, to). Visible sites exist twice with
    // infinity: not asked, for rounded predicates may deny it, and (j, infinity, infinity) is no
    // vertex.
    const bool at_infinity = i == infinite || j == infinite;
    const Index from = at_infinity || kernel.exist_twice(i, j, k) ? k : infinite;
    const Index to = at_infinity || kernel.exist_twice(i, j, l) ? l : infinite;
    if (from == to || kernel.conflicts(j, i, from, l) || kernel.conflicts(i, j, to, k)) return true;
    if (kernel.conflicts(j, i, from, q) != taken || kernel.conflicts(i, j, to, q) != taken)
        return false;
    // On a bisector with infinity, a circle of directions, K runs clockwise from (i, infinity, m).
    if (i == infinite) return exact.in_order_at_infinity(j, k, q, l, taken);
    if (j == infinite) return exact.in_order_at_infinity(i, l, q, k, taken);
    // Infinity is in K_k, in K_l or on the other stretch, and the intervals that do not hold it are
    // ordered. Of k and l one at most is infinity, which no rounded answer may bring into
    // precedes_on_bisector.
    const auto holds_infinity = [&, i = i, j = j](Index m) {
        return m == infinite || kernel.conflicts(i, j, infinite, m) ||
               kernel.conflicts(j, i, infinite, m);
    };
    if (l != infinite && holds_infinity(k)) return exact.precedes_on_bisector(i, j, l, q);
    if (holds_infinity(l)) return exact.precedes_on_bisector(i, j, q, k);
    return holds_infinity(q) == taken && exact.precedes_on_bisector(i, j, l, q) &&
           exact.precedes_on_bisector(i, j, q, k);
}

}  // namespace signum::triangulation
