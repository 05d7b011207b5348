#pragma once
/// Comparing two sites at a point, and the shape of the bisectors of three.

#include <signum/core/sign.hpp>
#include <signum/core/site.hpp>
#include <signum/filters/tally.hpp>

namespace signum::euclidean {

/// +1 where the point p is nearer to a than to b, 0 where both are as near, -1 otherwise: the sign
/// of (|p-b| - r_b) - (|p-a| - r_a). Exact; square roots are compared by their squares.
/// Precondition: finite numbers.
[[nodiscard]] Decision nearer_decision(Point p, const Site& a, const Site& b) noexcept;

/// The sign of Q = E_xr² + E_yr² - E_xy². Circles that touch i, j, k counterclockwise and clockwise
/// can both exist only where Q > 0, or under the tie rule where Q = 0: there a line touches all
/// three from one side, or their centres and radii lie on one line. Where Q < 0 one of the two
/// exists, or none if one site hides another. Precondition: finite numbers.
[[nodiscard]] Decision edge_bounded_decision(const Site& i, const Site& j, const Site& k) noexcept;

}  // namespace signum::euclidean
