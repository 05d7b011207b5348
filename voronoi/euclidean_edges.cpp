/// The edges of diagrams in the Euclidean metric.

#include <algorithm>
#include <cmath>

#include "../exact/multiprecision.hpp"
#include "../exact/surd.hpp"
#include "../predicates/formulas/apollonius.hpp"
#include "straight_bisector.hpp"

namespace signum {
namespace {

using exact::Rational;
using Exact = euclidean::Uniform<Rational>;

euclidean::Disc<Exact> disc(const Site& s) {
    return {exact::to_rational(s.x), exact::to_rational(s.y), exact::to_rational(s.r)};
}

/// √(1 - s²), s the difference of the radii over the distance: of two discs that all but touch from
/// inside nothing is left of it in doubles. 0 where they do, and below the doubles.
double exact_rise(const Site& a, const Site& b) {
    const auto row = euclidean::polynomials::row(disc(b), disc(a));
    if (row.p <= 0) return 0.0;
    return exact::round_surd(0, 1, Rational(row.p / (row.x * row.x + row.y * row.y)));
}

std::optional<Curve> hyperbola(const PairOfSites& pair, const Way& way) {
    const Site& a = pair.a;
    const Site& b = pair.b;
    const Point to_b = {b.x - a.x, b.y - a.y};
    const Point middle = plus({a.x, a.y}, to_b, 0.5);
    const double excess = way.is_close
                              ? std::ldexp(pair.first.site.r - pair.second.site.r, -way.exponent)
                              : a.r - b.r;
    const double slant = std::clamp(excess / way.distance, -1.0, 1.0);
    const double rise = std::abs(slant) < 1 - 0x1p-20
                            ? std::sqrt((1 - slant) * (1 + slant))
                            : exact_rise(pair.first.site, pair.second.site);
    if (!std::isfinite(way.right.x + way.right.y + slant)) return std::nullopt;
    if (way.is_close) {
        // From where it can be seen it is its asymptotes.
        const double slope = slant / rise;
        if (!std::isfinite(slope)) return std::nullopt;
        return StraightCurve{middle, way.right, turned_left(way.right), {0, 0}, 0, {slope, slope}};
    }
    return HyperbolaCurve{middle, way.right, turned_left(way.right), slant * (way.distance / 2),
                          rise * (way.distance / 2)};
}

}  // namespace

template <>
std::optional<Curve> bisector_in<Euclidean>(const PairOfSites& pair) {
    const Way way(pair);
    if (pair.first.site.r == pair.second.site.r) return straight_bisector(pair, way, 0);
    return hyperbola(pair, way);
}

/// By law 5 of apollonius.hpp, for i, j, k = a, b, apex: the vertices of the two faces lie at
///     4Q t = p_ij C e ± 2W √Γ,
/// + where the face turns as a, b, apex. With laws 3 and 4 the product of the two is
///     4Q t t' = p_ij² C² - d Γ,  d = |b - a|².
/// Where Q = 0 one of them is at infinity, the one whose addends have the same sign, in the
/// direction C (E_yr, -E_xr) of the common tangent line's normal, whose part along t is -C W; and
/// the other one at the quotient. Where C = 0, too, all three touch two lines, each from the other
/// side, and the order along these tells: the apex is the middle one where e > 0.
template <>
Sign far_end_in<Euclidean>(WeightIs /*weight_is*/, const Site& a, const Site& b, const Site& apex,
                           EndOfEdge end) {
    namespace polynomials = euclidean::polynomials;
    const polynomials::Triple<Exact> t(disc(a), disc(b), disc(apex));
    const Rational square = t.j.x * t.j.x + t.j.y * t.j.y;
    const Rational w = square * t.k.r - t.j.r * (t.j.x * t.k.x + t.j.y * t.k.y);
    const Rational gamma = t.j.p * t.k.p * t.jk;
    const Rational e = t.j.p - t.k.p - t.jk;
    const Sign first = t.xy.sign() * e.sign();
    const Sign second = (end == EndOfEdge::to ? 1 : -1) * w.sign() * gamma.sign();
    const auto of_product = [&] {
        return Rational(t.j.p * t.j.p * t.xy * t.xy - square * gamma).sign();
    };
    if (const Sign q = t.q.sign(); q != 0)
        return q *
               polynomials::sign_of_difference(first, -second, [&] { return q * of_product(); });
    if (t.xy.is_zero()) return end == EndOfEdge::to ? -e.sign() : e.sign();
    if (first == -second) return first * of_product();
    return -t.xy.sign() * w.sign();
}

}  // namespace signum
