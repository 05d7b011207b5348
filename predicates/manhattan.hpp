#pragma once
/// The predicates of the Manhattan metric: diamonds, distance |x-cx| + |y-cy| - r.

#include <array>

#include "additive.hpp"
#include "rectangular/squares.hpp"

namespace signum::manhattan {

/// The predicates under the tie rule.
template <Arithmetic arithmetic = Arithmetic::exact>
using Perturbed = rectangular::Perturbed<rectangular::Manhattan, arithmetic>;

/// Whether a diamond touches i, j, k counterclockwise, ties decided by the tie rule.
[[nodiscard]] inline bool exists(const Site& i, const Site& j, const Site& k) noexcept {
    return Perturbed<>::exists(i, j, k, additive::ranks_of<3>({&i, &j, &k})).sign > 0;
}

/// +1 where q conflicts with the vertex of i, j, k (is nearer than they are), 0 where it touches,
/// -1 otherwise. Preconditions: exists(i,j,k), q hidden by none of them, finite numbers.
[[nodiscard]] inline Sign in_circle(const Site& i, const Site& j, const Site& k,
                                    const Site& q) noexcept {
    return rectangular::in_circle_decision<rectangular::Manhattan>(
               i, j, k, q, additive::ranks_of<4>({&i, &j, &k, &q}))
        .sign;
}

/// The same at the hull edge a -> b, all other sites on its left. Preconditions: neither of a and b
/// hides the other, finite numbers.
[[nodiscard]] inline Sign in_circle_infinite(const Site& a, const Site& b, const Site& q) noexcept {
    return rectangular::in_circle_infinite_decision<rectangular::Manhattan>(
               a, b, q, additive::ranks_of<3>({&a, &b, &q}))
        .sign;
}

/// Whether i alone hides q: covers it, the same place and size included.
[[nodiscard]] inline bool hidden(const Site& q, const Site& i) noexcept {
    return Perturbed<>::hides(i, q, {0, 1}).sign > 0;
}

/// Whether the point p is nearer to a than to b (+1) or not (-1), a coming first in the tie rule's
/// order where both are as near.
[[nodiscard]] inline Sign nearer(Point p, const Site& a, const Site& b) noexcept {
    return Perturbed<>::nearer(p, a, b, {0, 1}).sign;
}

/// in_circle under the tie rule, never 0; q may be hidden. `ranks` are the places of i, j, k and q
/// in the rule's order (falling radius, rising x, y, index); only their order counts.
[[nodiscard]] inline Sign in_circle_perturbed(const Site& i, const Site& j, const Site& k,
                                              const Site& q,
                                              const std::array<Index, 4>& ranks) noexcept {
    return Perturbed<>::in_circle(i, j, k, q, ranks).sign;
}

/// in_circle_infinite under the tie rule, never 0. `ranks` are the places of a, b and q.
[[nodiscard]] inline Sign in_circle_infinite_perturbed(const Site& a, const Site& b, const Site& q,
                                                       const std::array<Index, 3>& ranks) noexcept {
    return Perturbed<>::in_circle_infinite(a, b, q, ranks).sign;
}

}  // namespace signum::manhattan
