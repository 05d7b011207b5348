#pragma once
/// The tie rule in the power metric of space: what an exact zero means to a tessellation.
///
/// Law: as in the plane (predicates/power/ties.hpp): the weight of each site is thought of as
/// reduced by an infinitesimal, infinitely larger for the later site in the rule's order. To reduce
/// the weight of i lifts it, and with it the hyperplane of the cell above q where q lies on i's
/// side of the facet of the others: the coefficient of i is the orientation of the cell with q in
/// i's place. To reduce that of q lifts q itself: its coefficient is -1. So the last site in the
/// order whose coefficient is not 0 decides, and it is never undecided.

#include <algorithm>
#include <array>

#include "../../core/index.hpp"
#include "../power/weight.hpp"
#include "in_sphere.hpp"

namespace signum::power {

/// Whether site a (of index a_index) comes before site b in the tie rule's order: falling weight,
/// rising x, y, z, index.
template <PowerSite3 S>
[[nodiscard]] bool precedes(const S& a, Index a_index, const S& b, Index b_index) noexcept {
    if (const int weight = filters::compare_numbers(weight_key(a), weight_key(b)); weight != 0)
        return weight > 0;
    if (const int x = filters::compare_numbers(a.x, b.x); x != 0) return x < 0;
    if (const int y = filters::compare_numbers(a.y, b.y); y != 0) return y < 0;
    if (const int z = filters::compare_numbers(a.z, b.z); z != 0) return z < 0;
    return a_index < b_index;
}

/// What in_sphere(i,j,k,l,q) = 0 becomes: +1 conflict or -1 none. The sites in the order i, j, k,
/// l, q; only the order of their indices counts beside them.
/// Preconditions: ccw(i,j,k,l) > 0, in_sphere(i,j,k,l,q) = 0.
template <PowerSite3 S>
[[nodiscard, gnu::cold]] Sign in_sphere_tie(const std::array<S, 5>& sites,
                                            const std::array<Index, 5>& indices) noexcept {
    std::array<std::size_t, 5> order = {0, 1, 2, 3, 4};
    std::ranges::sort(order, [&](std::size_t a, std::size_t b) {
        return precedes(sites[b], indices[b], sites[a], indices[a]);
    });
    for (const std::size_t last : order) {
        if (last == 4) return -1;
        std::array<Point3, 4> cell;
        for (std::size_t m = 0; m < 4; ++m) cell[m] = centre3(sites[m == last ? 4 : m]);
        if (const Sign sign = ccw(cell[0], cell[1], cell[2], cell[3]); sign != 0) return sign;
    }
    return -1;
}

}  // namespace signum::power
