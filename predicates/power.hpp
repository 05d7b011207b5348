#pragma once
/// The predicates of the power metric (Laguerre, regular, weighted Delaunay): distance |x-c|² - w.
///
/// Each takes three kinds of sites: Point (no weight: Delaunay), power::Site (weight w) and
/// signum::Site (radius r, weight r², the exact product). Each is exact for all finite doubles.

#include <array>

#include "ccw.hpp"
#include "power/edge.hpp"
#include "power/in_circle.hpp"
#include "power/infinite.hpp"
#include "power/ties.hpp"
#include "power/weight.hpp"

namespace signum::power {

/// Whether a circle touches i, j, k counterclockwise: ccw of their centres is +1.
template <PowerSite S>
[[nodiscard]] inline bool exists(const S& i, const S& j, const S& k) noexcept {
    return ccw(i, j, k) > 0;
}

/// +1 where q conflicts with the vertex of i, j, k (is nearer than they are), 0 where it touches,
/// -1 otherwise. Preconditions: exists(i,j,k), finite numbers. Thesis: Theorem 4.4.1.
template <PowerSite S>
[[nodiscard]] inline Sign in_circle(const S& i, const S& j, const S& k, const S& q) noexcept {
    SIGNUM_EXPECTS(are_finite(i, j, k, q));
    return in_circle_decision(i, j, k, q).sign;
}

/// The same at the hull edge a -> b, all other sites on its left or on its line: +1 where q
/// conflicts with the vertex at infinity, 0 where it touches, -1 otherwise. Preconditions: centres
/// of a and b differ, finite numbers.
template <PowerSite S>
[[nodiscard]] inline Sign in_circle_infinite(const S& a, const S& b, const S& q) noexcept {
    SIGNUM_EXPECTS(are_finite(a, b, q));
    const Sign side = ccw(a, b, q);
    return side != 0 ? -side : in_segment_decision(a, b, q).sign;
}

/// +1 where the point p is nearer to a than to b, 0 where both are as near, -1 otherwise.
template <PowerSite S>
[[nodiscard]] inline Sign nearer(Point p, const S& a, const S& b) noexcept {
    SIGNUM_EXPECTS(are_finite(p, a, b));
    return nearer_decision(p, a, b).sign;
}

/// Whether i alone hides q: in this metric only where the centres agree and i weighs no less.
template <PowerSite S>
[[nodiscard]] inline bool hidden(const S& q, const S& i) noexcept {
    return filters::same_number(q.x, i.x) && filters::same_number(q.y, i.y) &&
           nearer(centre(q), q, i) <= 0;
}

/// in_circle under the tie rule, never 0. `ranks` are the places of i, j, k and q in the rule's
/// order (falling weight, rising x, y, index); only their order counts.
template <PowerSite S>
[[nodiscard]] inline Sign in_circle_perturbed(const S& i, const S& j, const S& k, const S& q,
                                              const std::array<Index, 4>& ranks) noexcept {
    const Sign sign = in_circle(i, j, k, q);
    return sign != 0 ? sign : in_circle_tie(centre(i), centre(j), centre(k), centre(q), ranks);
}

/// in_circle_infinite under the tie rule, never 0. `ranks` are the places of a, b and q.
template <PowerSite S>
[[nodiscard]] inline Sign in_circle_infinite_perturbed(const S& a, const S& b, const S& q,
                                                       const std::array<Index, 3>& ranks) noexcept {
    const Sign sign = in_circle_infinite(a, b, q);
    return sign != 0 ? sign : in_segment_tie(centre(a), centre(b), centre(q), ranks);
}

}  // namespace signum::power
