/// The edges of diagrams in the Manhattan and the supremum metric.

#include <algorithm>

#include "../predicates/additive.hpp"
#include "../predicates/ladder/forms.hpp"
#include "of_metric.hpp"
#include "vector.hpp"

namespace signum {
namespace {

/// For each side of a square (diamond) whether b touches it first, and not a, as squares shrink
/// onto the two. Exact, by the tie rule where both do.
template <class Directions>
std::array<bool, 4> sides_touched_by_second(const NumberedSite& a, const NumberedSite& b) {
    const std::array<const Site*, 2> sites = {&a.site, &b.site};
    rectangular::Forms<Directions, Arithmetic::exact, 2> forms(
        sites, additive::ranks_of<2>(sites, {a.index, b.index}));
    std::array<bool, 4> second{};
    for (int side = 0; side < 4; ++side)
        second[static_cast<std::size_t>(side)] = forms.compare(side, 1, 0) > 0;
    return second;
}

/// The centres of the squares that touch a and b: while a touches the left side and b the right
/// one, a line upwards, and beyond it, where the one that is in the way above or below holds the
/// corner of growing squares, a diagonal ray on either side. "Right" is the direction from a to b
/// in which they lie farther apart.
template <class Directions>
StraightCurve rectangular_bisector(const Site& a, const Site& b,
                                   const std::array<bool, 4>& b_touches) {
    const auto at = [](int side) { return static_cast<std::size_t>(side & 3); };
    const auto direction = [&](int side) -> Point {
        return {Directions::x[at(side)], Directions::y[at(side)]};
    };

    const Point to_b = {b.x - a.x, b.y - a.y};
    double farthest = -1.0;
    int right = 0;
    for (int side = 0; side < 4; ++side)
        if (b_touches[at(side)] && !b_touches[at(side + 2)] &&
            dot(direction(side), to_b) > farthest) {
            farthest = dot(direction(side), to_b);
            right = side;
        }

    // The forms relative to a, whose own are 0: only differences of radii count.
    const double r_b = b.r - a.r;
    const auto form = [&](int side) {
        return b_touches[at(side)] ? dot(direction(side), to_b) - r_b : 0.0;
    };
    const double rho = form(right) / 2;  // of the squares that a and b touch left and right
    const double lowest = form(right + 1) - rho;
    const double highest = std::max(lowest, rho - form(right + 3));
    return {{a.x, a.y},
            direction(right),
            direction(right + 1),
            {lowest, highest},
            rho,
            {b_touches[at(right + 1)] ? 1.0 : -1.0, b_touches[at(right + 3)] ? 1.0 : -1.0}};
}

template <class Directions>
std::optional<Curve> bisector_along(const PairOfSites& pair) {
    return rectangular_bisector<Directions>(
        pair.a, pair.b, sides_touched_by_second<Directions>(pair.first, pair.second));
}

}  // namespace

template <>
std::optional<Curve> bisector_in<Manhattan>(const PairOfSites& pair) {
    return bisector_along<rectangular::Manhattan>(pair);
}
template <>
std::optional<Curve> bisector_in<Supremum>(const PairOfSites& pair) {
    return bisector_along<rectangular::Supremum>(pair);
}

// Squares have no vertex at infinity but those of infinite faces.
template <>
Sign far_end_in<Manhattan>(WeightIs, const Site&, const Site&, const Site&, EndOfEdge) {
    return 0;
}
template <>
Sign far_end_in<Supremum>(WeightIs, const Site&, const Site&, const Site&, EndOfEdge) {
    return 0;
}

}  // namespace signum
