#include <signum/predicates/power/ties.hpp>

#include <algorithm>

#include <signum/core/contract.hpp>
#include <signum/exact/floating_environment.hpp>
#include <signum/predicates/ccw.hpp>

namespace signum::power {
namespace {

/// The coefficient of one site's infinitesimal: what lifting that site does to in_circle.
struct Term {
    Index rank;
    Sign coefficient;
};

template <std::size_t n>
Sign last_nonzero(std::array<Term, n> terms) noexcept {
    std::sort(terms.begin(), terms.end(),
              [](const Term& a, const Term& b) { return a.rank > b.rank; });
    const auto decisive =
        std::find_if(terms.begin(), terms.end(), [](const Term& t) { return t.coefficient != 0; });
    SIGNUM_EXPECTS(decisive != terms.end());
    return decisive->coefficient;
}

}  // namespace

Sign in_circle_tie(Point i, Point j, Point k, Point q, const std::array<Index, 4>& ranks) noexcept {
    return last_nonzero<4>({{{ranks[0], ccw(j, k, q)},
                             {ranks[1], ccw(k, i, q)},
                             {ranks[2], ccw(i, j, q)},
                             {ranks[3], -1}}});
}

namespace {

Sign decide_in_segment(const Point& a, const Point& b, const Point& q,
                       const std::array<Index, 3>& ranks) noexcept {
    // Any coordinate that separates a from b runs along the line; its differences need their sign alone.
    const bool along_x = a.x != b.x;
    const auto order = [along_x](Point from, Point to) -> Sign {
        return along_x ? (from.x < to.x) - (from.x > to.x) : (from.y < to.y) - (from.y > to.y);
    };
    const Sign direction = order(a, b);
    return last_nonzero<3>(
        {{{ranks[0], order(q, b) * direction}, {ranks[1], order(a, q) * direction}, {ranks[2], -1}}});
}

}  // namespace

Sign in_segment_tie(Point a, Point b, Point q, const std::array<Index, 3>& ranks) noexcept {
    return exact::in_ieee_environment(decide_in_segment, a, b, q, ranks);
}

}  // namespace signum::power
