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
