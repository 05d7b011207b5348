#include <optional>

#include "../../exact/multiprecision.hpp"
#include "../../exact/surd.hpp"
#include "../../filters/bounded.hpp"
#include "../../predicates/formulas/apollonius.hpp"
#include "vertex_of_face.hpp"

namespace signum::triangulation {
namespace {

using exact::Rational;

template <class Number>
using Row = euclidean::polynomials::Row<euclidean::Uniform<Number>>;

Row<filters::Bounded> bounded_row(const Site& m, const Site& origin) {
    const auto difference = [](double a, double b) {
        return filters::Bounded::exactly(filters::exact_difference(a, b));
    };
    return {difference(m.x, origin.x), difference(m.y, origin.y), difference(m.r, origin.r)};
}

Row<Rational> rational_row(const Site& m, const Site& origin) {
    const auto difference = [](double a, double b) {
        return Rational(exact::to_rational(a) - exact::to_rational(b));
    };
    return {difference(m.x, origin.x), difference(m.y, origin.y), difference(m.r, origin.r)};
}

/// (alpha - beta √Γ) / 2Q, which is also conjugate / 2(alpha + beta √Γ).
template <class Number>
struct Root {
    Number alpha;
    Number beta;
    Number conjugate;
};

/// The circle that i, j, k touch, for any type of number, from the rows of j and k relative to i
/// and that of k relative to j. With (X, Y) the centre and R its distance from the centre of i,
///
///     x_m X + y_m Y + r_m R = p_m / 2   for m = j, k,    X² + Y² = R²:
///
/// a line along N = (E_yr, -E_xr, E_xy) that meets a cone, N being Q long in the cone's form. Each
/// coordinate solves a quadratic equation with discriminant Γ; the product of its roots gives the
/// conjugate.
template <class Number>
struct Circle {
    Number xy, xr, yr, xp, yp, rp;  // minors E of the rows of j and k
    Number q, gamma;
    Root<Number> distance, x, y;

    Circle(const Row<Number>& j, const Row<Number>& k, const Row<Number>& j_to_k)
        : Circle(euclidean::polynomials::Minors<euclidean::Uniform<Number>>(j, k),
                 j.p * k.p * j_to_k.p) {}

 private:
    Circle(const euclidean::polynomials::Minors<euclidean::Uniform<Number>>& e, const Number& g)
        : xy(e.xy),
          xr(e.xr),
          yr(e.yr),
          xp(e.xp()),
          yp(e.yp()),
          rp(e.rp()),
          q(e.q),
          gamma(g),
          distance{xp * xr + yp * yr, xy, xp * xp + yp * yp},
          x{xy * yp - xr * rp, yr, (rp - yp) * (rp + yp)},
          y{-(xy * xp + yr * rp), -xr, (rp - xp) * (rp + xp)} {}
};

/// Of the two forms of a root the one without cancellation.
filters::Bounded value_of(const Root<filters::Bounded>& root, const filters::Bounded& sqrt_gamma,
                          const filters::Bounded& q) {
    const filters::Bounded surd = root.beta * sqrt_gamma;
    if ((root.alpha.value.high > 0.0) != (surd.value.high > 0.0))
        return (root.alpha - surd) / (q + q);
    const filters::Bounded sum = root.alpha + surd;
    return root.conjugate / (sum + sum);
}

std::optional<DiagramVertex> fast_vertex(const Site& i, const Site& j, const Site& k) {
    const Row<filters::Bounded> to_j = bounded_row(j, i);
    const Row<filters::Bounded> to_k = bounded_row(k, i);
    const Row<filters::Bounded> j_to_k = bounded_row(k, j);
    if (!to_j.p.is_positive() || !to_k.p.is_positive() || !j_to_k.p.is_positive())
        return std::nullopt;
    const Circle<filters::Bounded> circle(to_j, to_k, j_to_k);
    const filters::Bounded sqrt_gamma = sqrt(circle.gamma);
    // The vertex exists where the distance is positive.
    const filters::Bounded distance = value_of(circle.distance, sqrt_gamma, circle.q);
    if (!distance.is_positive()) return std::nullopt;
    const auto rho = (distance - filters::Bounded::exactly(i.r)).rounded();
    if (!rho) return std::nullopt;
    const auto x =
        (value_of(circle.x, sqrt_gamma, circle.q) + filters::Bounded::exactly(i.x)).rounded();
    const auto y =
        (value_of(circle.y, sqrt_gamma, circle.q) + filters::Bounded::exactly(i.y)).rounded();
    if (!x || !y) return std::nullopt;
    return DiagramVertex{*x, *y, *rho};
}

DiagramVertex exact_vertex(const Site& i, const Site& j, const Site& k) {
    const Row<Rational> to_j = rational_row(j, i);
    const Row<Rational> to_k = rational_row(k, i);
    const Row<Rational> j_to_k = rational_row(k, j);
    if (to_j.p <= 0 || to_k.p <= 0 || j_to_k.p <= 0) return no_vertex();
    const Circle<Rational> circle(to_j, to_k, j_to_k);
    const Rational x = exact::to_rational(i.x);
    const Rational y = exact::to_rational(i.y);
    const Rational r = exact::to_rational(i.r);
    const Sign sign_q = circle.q.sign();
    if (sign_q != 0) {
        if ((sign_q < 0 ? circle.xy : circle.distance.alpha) <= 0) return no_vertex();
        const Rational twice_q = 2 * circle.q;
        const auto rounded = [&](const Rational& start, const Root<Rational>& root) {
            return exact::round_surd(Rational(start + root.alpha / twice_q),
                                     Rational(-root.beta / twice_q), circle.gamma);
        };
        return {rounded(x, circle.x), rounded(y, circle.y), rounded(-r, circle.distance)};
    }
    // The line runs along the cone and meets it once; where it does not, three sites touch a common
    // line, and a circle only under the tie rule.
    if (circle.xy <= 0 || circle.distance.alpha <= 0) return no_vertex();
    const Rational distance = circle.distance.conjugate / (4 * circle.distance.alpha);
    return {
        exact::round_to_double(Rational(x + (distance * circle.yr - circle.yp / 2) / circle.xy)),
        exact::round_to_double(Rational(y + (circle.xp / 2 - distance * circle.xr) / circle.xy)),
        exact::round_to_double(Rational(distance - r))};
}

}  // namespace

template <>
DiagramVertex vertex_of_face<Euclidean>(const std::array<const Site*, 3>& sites,
                                        const Face& /*face*/, WeightIs /*weight_is*/) {
    const auto& [i, j, k] = sites;
    if (const auto vertex = fast_vertex(*i, *j, *k)) return *vertex;
    return exact_vertex(*i, *j, *k);
}

}  // namespace signum::triangulation
