/// The edges of diagrams in the power metric.

#include <cmath>

#include "../exact/multiprecision.hpp"
#include "straight_bisector.hpp"

namespace signum {
namespace {

using exact::Rational;
using exact::to_rational;

}  // namespace

template <>
std::optional<Curve> bisector_in<Power>(const PairOfSites& pair) {
    const Way way(pair);
    const bool is_weight = pair.weight_is == WeightIs::weight;
    const double excess = pair.first.site.r - pair.second.site.r;
    const double sum = pair.a.r + pair.b.r;
    if (way.is_close) {
        // Of radii the product of excess and sum, whose exponents may be far apart.
        int exponent = -pair.exponent;
        const double product = is_weight ? excess : std::frexp(excess, &exponent) * sum;
        return straight_bisector(pair, way,
                                 std::ldexp(product / way.distance / 2, exponent - way.exponent));
    }
    const double divided = pair.a.r - pair.b.r;
    return straight_bisector(
        pair, way,
        (is_weight ? std::ldexp(divided, -pair.exponent) : divided * sum) / way.distance / 2);
}

/// Along the bisector, walked with a on its left, the power of the apex less that of a changes at
/// one rate, whose sign the face's turn tells: falling towards its vertex. So that lies ahead of
/// the line of centres where the apex is farther than a at the foot F on that line,
///     2d (F - a) = (d + w_a - w_b) (b - a),  d = |b - a|²,
/// and behind it at the other end.
template <>
Sign far_end_in<Power>(WeightIs weight_is, const Site& a, const Site& b, const Site& apex,
                       EndOfEdge end) {
    const auto weight = [is_weight = weight_is == WeightIs::weight](const Site& s) {
        const Rational r = to_rational(s.r);
        return is_weight ? r : Rational(r * r);
    };
    const auto difference = [](double p, double q) {
        return Rational(to_rational(p) - to_rational(q));
    };
    const Rational bx = difference(b.x, a.x);
    const Rational by = difference(b.y, a.y);
    const Rational cx = difference(apex.x, a.x);
    const Rational cy = difference(apex.y, a.y);
    const Rational square = bx * bx + by * by;
    const Rational of_apex = cx * cx + cy * cy + weight(a) - weight(apex);
    const Rational of_b = square + weight(a) - weight(b);
    const Sign farther = Rational(square * of_apex - of_b * (bx * cx + by * cy)).sign();
    return end == EndOfEdge::to ? farther : -farther;
}

}  // namespace signum
