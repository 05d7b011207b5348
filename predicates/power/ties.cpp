#include "ties.hpp"

#include <algorithm>
#include <limits>

#include "../../core/contract.hpp"
#include "../../exact/floating_environment.hpp"
#include "../ccw.hpp"

namespace signum::power {
namespace {

/// The first coefficient that is not 0, from the last site in the order to the first.
/// `coefficient(m)` is asked only where it is needed: q, whose coefficient is -1, is the last one
/// often.
template <std::size_t n, class Coefficient>
Sign last_nonzero(std::array<Index, n> ranks, Coefficient coefficient) noexcept {
    for (std::size_t round = 0; round < n; ++round) {
        const auto last = std::max_element(ranks.begin(), ranks.end());
        const Sign sign = coefficient(last - ranks.begin());
        if (sign != 0) return sign;
        *last = std::numeric_limits<Index>::min();
    }
    SIGNUM_EXPECTS(false && "the coefficient of q is not 0");
    return -1;
}

}  // namespace

Sign in_circle_tie(Point i, Point j, Point k, Point q, const std::array<Index, 4>& ranks) noexcept {
    return last_nonzero(ranks, [&](std::ptrdiff_t m) {
        return m == 0 ? ccw(j, k, q) : m == 1 ? ccw(k, i, q) : m == 2 ? ccw(i, j, q) : -1;
    });
}

namespace {

Sign decide_in_segment(const Point& a, const Point& b, const Point& q,
                       const std::array<Index, 3>& ranks) noexcept {
    // Any coordinate that separates a from b runs along the line; its differences need their sign
    // alone.
    const bool along_x = a.x != b.x;
    const auto order = [along_x](Point from, Point to) -> Sign {
        return along_x ? (from.x < to.x) - (from.x > to.x) : (from.y < to.y) - (from.y > to.y);
    };
    const Sign direction = order(a, b);
    return last_nonzero(ranks, [&](std::ptrdiff_t m) {
        return m == 0 ? order(q, b) * direction : m == 1 ? order(a, q) * direction : -1;
    });
}

}  // namespace

Sign in_segment_tie(Point a, Point b, Point q, const std::array<Index, 3>& ranks) noexcept {
    return exact::in_ieee_environment(decide_in_segment, a, b, q, ranks);
}

}  // namespace signum::power
