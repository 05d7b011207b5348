#pragma once
/// The tie rule in the power metric: what an exact zero means to a tessellation.
///
/// Law: sites are ordered by falling weight, then rising x, y and index; every weight is thought of
/// as reduced by its own infinitesimal, infinitely larger for the later site. Reducing the weight
/// of site m lifts its height by the infinitesimal; the derivative of in_circle by the height of m
/// is an orientation of the other three centres (for q itself -ccw(i,j,k)). So the last site in the
/// order whose coefficient is not 0 decides. q's coefficient never vanishes, hence the answer is
/// never 0.

#include <array>

#include "../../core/index.hpp"
#include "../../core/sign.hpp"
#include "../../core/site.hpp"
#include "weight.hpp"

namespace signum::power {

/// Whether site a (of index a_index) comes before site b in the tie rule's order.
template <PowerSite S>
[[nodiscard]] bool precedes(const S& a, Index a_index, const S& b, Index b_index) noexcept {
    using filters::compare_numbers;
    int order = compare_numbers(weight_key(b), weight_key(a));
    if (order == 0) order = compare_numbers(a.x, b.x);
    if (order == 0) order = compare_numbers(a.y, b.y);
    return order != 0 ? order < 0 : a_index < b_index;
}

/// What in_circle(i,j,k,q) = 0 becomes: +1 conflict or -1 none. `ranks` are the places of i, j, k
/// and q in the order; only their order counts. Precondition: ccw(i,j,k) > 0, in_circle(i,j,k,q) =
/// 0.
[[nodiscard]] Sign in_circle_tie(Point i, Point j, Point k, Point q,
                                 const std::array<Index, 4>& ranks) noexcept;

/// What the one-dimensional in_circle(a,b,q) = 0 becomes: +1 conflict or -1 none. `ranks` are the
/// places of a, b and q. Precondition: a and b differ, q lies on their line.
[[nodiscard]] Sign in_segment_tie(Point a, Point b, Point q,
                                  const std::array<Index, 3>& ranks) noexcept;

}  // namespace signum::power
