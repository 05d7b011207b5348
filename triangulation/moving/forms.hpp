#pragma once
/// The determinants of moving sites as polynomials in time, for any type of number. For sources
/// only.
///
/// All are those of predicates/power at the centres of the time, relative to the last site, so that
/// what all have in common (a drift, a fall) cancels: a difference of two centres is linear.

#include <array>
#include <cstddef>

#include "../../roots/polynomial_in.hpp"
#include "moving_site.hpp"

namespace signum::kinetic {

using roots::constant;
using roots::PolynomialIn;

/// Where polynomials begin: they are about t - origin.
struct Frame {
    Fall fall;
    double origin;
};

/// Along an axis, x + v (t - time) + g (t - time)²/2 but for g (t - origin)²/2, which all sites
/// have.
template <class Number>
[[nodiscard]] PolynomialIn<Number, 1> along(double x, double v, double time, double g,
                                            double origin) {
    PolynomialIn<Number, 1> p = roots::line<Number>(x, v);
    if (time == origin) return p;
    const Number flown = constant<Number>(origin).c[0] - constant<Number>(time).c[0];
    if (g == 0.0) {
        p.c[0] = p.c[0] + flown * p.c[1];
    } else {
        const Number gained = constant<Number>(g).c[0] * flown;
        p.c[0] = p.c[0] + flown * (p.c[1] + constant<Number>(0.5).c[0] * gained);
        p.c[1] = p.c[1] + gained;
    }
    return p;
}

/// Where a site is.
template <class Number>
struct Placed {
    PolynomialIn<Number, 1> x;
    PolynomialIn<Number, 1> y;
    double r;

    Placed(const MovingSite& m, const Frame& at)
        : x(along<Number>(m.x, m.vx, m.time, at.fall.x, at.origin)),
          y(along<Number>(m.y, m.vy, m.time, at.fall.y, at.origin)),
          r(m.r) {}
};

/// A site relative to another one.
template <class Number>
struct Relative {
    PolynomialIn<Number, 1> x;
    PolynomialIn<Number, 1> y;
    PolynomialIn<Number, 0> weight;

    constexpr Relative() = default;
    Relative(const Placed<Number>& m, const Placed<Number>& q)
        : x(m.x - q.x),
          y(m.y - q.y),
          weight((constant<Number>(m.r) - constant<Number>(q.r)) *
                 (constant<Number>(m.r) + constant<Number>(q.r))) {}

    /// |m - q|² - (w_m - w_q).
    [[nodiscard]] constexpr PolynomialIn<Number, 2> height() const {
        return (x * x + y * y) - weight;
    }
};
template <class Number>
[[nodiscard]] constexpr PolynomialIn<Number, 2> cross(const Relative<Number>& a,
                                                      const Relative<Number>& b) {
    return a.x * b.y - b.x * a.y;
}
template <class Number>
[[nodiscard]] constexpr PolynomialIn<Number, 4> determinant(const Relative<Number>& i,
                                                            const Relative<Number>& j,
                                                            const Relative<Number>& k) {
    return (i.height() * cross(j, k) + j.height() * cross(k, i)) + k.height() * cross(i, j);
}

/// Above 0 where a, b and q turn left.
template <class Number>
[[nodiscard]] PolynomialIn<Number, 2> orientation(const MovingSite& a, const MovingSite& b,
                                                  const MovingSite& q, const Frame& at) {
    const Placed<Number> last(q, at);
    return cross(Relative<Number>({a, at}, last), Relative<Number>({b, at}, last));
}

/// Above 0 where q is in conflict with the power circle of a, b and c, which turn left.
template <class Number>
[[nodiscard]] PolynomialIn<Number, 4> in_circle(const MovingSite& a, const MovingSite& b,
                                                const MovingSite& c, const MovingSite& q,
                                                const Frame& at) {
    const Placed<Number> last(q, at);
    return determinant(Relative<Number>({a, at}, last), Relative<Number>({b, at}, last),
                       Relative<Number>({c, at}, last));
}

/// How far a lies beyond b along an axis.
template <class Number>
[[nodiscard]] PolynomialIn<Number, 1> beyond(const MovingSite& a, const MovingSite& b, bool along_x,
                                             const Frame& at) {
    const Relative<Number> r({a, at}, {b, at});
    return along_x ? r.x : r.y;
}

/// Of three on a line: above 0 where q is in conflict with the stretch from a to b, be it beyond it
/// or below the chord of their heights.
template <class Number>
[[nodiscard]] PolynomialIn<Number, 4> in_segment(const MovingSite& a, const MovingSite& b,
                                                 const MovingSite& q, bool along_x,
                                                 const Frame& at) {
    const Placed<Number> last(q, at);
    const Relative<Number> i({a, at}, last);
    const Relative<Number> j({b, at}, last);
    const PolynomialIn<Number, 1>& to_a = along_x ? i.x : i.y;
    const PolynomialIn<Number, 1>& to_b = along_x ? j.x : j.y;
    return (i.height() * to_b - j.height() * to_a) * beyond<Number>(b, a, along_x, at);
}

/// Above 0 where p is nearer to a than to b, in power distances: |p - b|² - w_b less that of a.
/// Linear but for the squares of a and b.
template <class Number>
[[nodiscard]] PolynomialIn<Number, 2> nearer(const MovingSite& p, const MovingSite& a,
                                             const MovingSite& b, const Frame& at) {
    const Placed<Number> from(p, at);
    return Relative<Number>({b, at}, from).height() - Relative<Number>({a, at}, from).height();
}

}  // namespace signum::kinetic
