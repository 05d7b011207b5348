#include "far_end.hpp"

#include "../exact/floating_environment.hpp"
#include "../exact/multiprecision.hpp"
#include "../predicates/formulas/apollonius.hpp"
#include "../triangulation/kernels/predicates_of.hpp"

namespace signum {
namespace {

using exact::Rational;
using exact::to_rational;

/// What far_end() is asked for.
struct Question {
    WeightIs weight_is;
    const Site& a;
    const Site& b;
    const Site& apex;
    EndOfEdge end;
};

/// Along the bisector, walked with a on its left, the power of the apex less that of a changes at
/// one rate, whose sign the face's turn tells: falling towards its vertex. So that lies ahead of
/// the line of centres where the apex is farther than a at the foot F on that line,
///     2d (F - a) = (d + w_a - w_b) (b - a),  d = |b - a|²,
/// and behind it at the other end.
Sign side_in(Power /*metric*/, const Question& of) {
    const bool is_weight = of.weight_is == WeightIs::weight;
    const Site& a = of.a;
    const auto weight = [is_weight](const Site& s) {
        const Rational r = to_rational(s.r);
        return is_weight ? r : Rational(r * r);
    };
    const auto difference = [](double p, double q) {
        return Rational(to_rational(p) - to_rational(q));
    };
    const Rational bx = difference(of.b.x, a.x);
    const Rational by = difference(of.b.y, a.y);
    const Rational cx = difference(of.apex.x, a.x);
    const Rational cy = difference(of.apex.y, a.y);
    const Rational square = bx * bx + by * by;
    const Rational of_apex = cx * cx + cy * cy + weight(a) - weight(of.apex);
    const Rational of_b = square + weight(a) - weight(of.b);
    const Sign farther = Rational(square * of_apex - of_b * (bx * cx + by * cy)).sign();
    return of.end == EndOfEdge::to ? farther : -farther;
}

/// By law 5 of polynomials.hpp, for i, j, k = a, b, apex: the vertices of the two faces lie at
///     4Q t = p_ij C e ± 2W √Γ,
/// + where the face turns as a, b, apex. With laws 3 and 4 the product of the two is
///     4Q t t' = p_ij² C² - d Γ,  d = |b - a|².
/// Where Q = 0 one of them is at infinity, the one whose addends have the same sign, in the
/// direction C (E_yr, -E_xr) of the common tangent line's normal, whose part along t is -C W; and
/// the other one at the quotient. Where C = 0, too, all three touch two lines, each from the other
/// side, and the order along these tells: the apex is the middle one where e > 0.
Sign side_in(Euclidean /*metric*/, const Question& of) {
    namespace polynomials = euclidean::polynomials;
    using Exact = euclidean::Uniform<Rational>;
    const auto disc = [](const Site& s) -> euclidean::Disc<Exact> {
        return {to_rational(s.x), to_rational(s.y), to_rational(s.r)};
    };
    const polynomials::Triple<Exact> t(disc(of.a), disc(of.b), disc(of.apex));
    const Rational square = t.j.x * t.j.x + t.j.y * t.j.y;
    const Rational w = square * t.k.r - t.j.r * (t.j.x * t.k.x + t.j.y * t.k.y);
    const Rational gamma = t.j.p * t.k.p * t.jk;
    const Rational e = t.j.p - t.k.p - t.jk;
    const Sign first = t.xy.sign() * e.sign();
    const Sign second = (of.end == EndOfEdge::to ? 1 : -1) * w.sign() * gamma.sign();
    const auto of_product = [&] {
        return Rational(t.j.p * t.j.p * t.xy * t.xy - square * gamma).sign();
    };
    if (const Sign q = t.q.sign(); q != 0)
        return q *
               polynomials::sign_of_difference(first, -second, [&] { return q * of_product(); });
    if (t.xy.is_zero()) return of.end == EndOfEdge::to ? -e.sign() : e.sign();
    if (first == -second) return first * of_product();
    return -t.xy.sign() * w.sign();
}

/// Squares have no vertex at infinity but those of infinite faces.
template <triangulation::Rectangular M>
Sign side_in(M /*metric*/, const Question& /*of*/) {
    return 0;
}

}  // namespace

Sign far_end(Metric metric, WeightIs weight_is, const Site& a, const Site& b, const Site& apex,
             EndOfEdge end) {
    const exact::IeeeEnvironment environment;
    return with_metric(metric, [&](auto each) {
        return side_in(each, {weight_is, a, b, apex, end});
    });
}

}  // namespace signum
