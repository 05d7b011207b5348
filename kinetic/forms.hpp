#pragma once
/// The determinants of moving sites as polynomials in time, for any type of number. For sources
/// only.
///
/// All are those of predicates/power at the centres of the time, relative to the last site, so that
/// what all have in common (a drift, a fall) cancels: a difference of two centres is linear.

#include "../roots/polynomial_in.hpp"
#include "moving_site.hpp"

namespace signum::kinetic {

using roots::constant;
using roots::PolynomialIn;

/// Along an axis, x + v (t - time).
template <class Number>
[[nodiscard]] PolynomialIn<Number, 1> along(double x, double v, double time) {
    PolynomialIn<Number, 1> p = roots::line<Number>(x, v);
    if (time != 0.0) p.c[0] = p.c[0] - constant<Number>(v).c[0] * constant<Number>(time).c[0];
    return p;
}

/// A site relative to another one.
template <class Number>
struct Relative {
    PolynomialIn<Number, 1> x;
    PolynomialIn<Number, 1> y;
    PolynomialIn<Number, 0> weight;

    Relative(const MovingSite& m, const MovingSite& q)
        : x(along<Number>(m.x, m.vx, m.time) - along<Number>(q.x, q.vx, q.time)),
          y(along<Number>(m.y, m.vy, m.time) - along<Number>(q.y, q.vy, q.time)),
          weight((constant<Number>(m.r) - constant<Number>(q.r)) *
                 (constant<Number>(m.r) + constant<Number>(q.r))) {}

    /// |m - q|² - (w_m - w_q).
    [[nodiscard]] PolynomialIn<Number, 2> height() const { return (x * x + y * y) - weight; }
};
template <class Number>
[[nodiscard]] PolynomialIn<Number, 2> cross(const Relative<Number>& a, const Relative<Number>& b) {
    return a.x * b.y - b.x * a.y;
}

/// Above 0 where a, b and q turn left.
struct Orientation {
    static constexpr int degree = 2;
    MovingSite a;
    MovingSite b;
    MovingSite q;

    template <class Number>
    [[nodiscard]] PolynomialIn<Number, degree> in() const {
        return cross(Relative<Number>(a, q), Relative<Number>(b, q));
    }
};

/// Above 0 where q is in conflict with the power circle of a, b and c, which turn left.
struct InCircle {
    static constexpr int degree = 4;
    MovingSite a;
    MovingSite b;
    MovingSite c;
    MovingSite q;

    template <class Number>
    [[nodiscard]] PolynomialIn<Number, degree> in() const {
        const Relative<Number> i(a, q);
        const Relative<Number> j(b, q);
        const Relative<Number> k(c, q);
        return (i.height() * cross(j, k) + j.height() * cross(k, i)) + k.height() * cross(i, j);
    }
};

/// How far a lies beyond b along an axis.
struct Beyond {
    static constexpr int degree = 1;
    MovingSite a;
    MovingSite b;
    bool along_x;

    template <class Number>
    [[nodiscard]] PolynomialIn<Number, degree> in() const {
        const Relative<Number> r(a, b);
        return along_x ? r.x : r.y;
    }
};

/// The one-dimensional InCircle of three on a line, times the sign of Beyond{b, a}.
struct InSegment {
    static constexpr int degree = 3;
    MovingSite a;
    MovingSite b;
    MovingSite q;
    bool along_x;

    template <class Number>
    [[nodiscard]] PolynomialIn<Number, degree> in() const {
        const Relative<Number> i(a, q);
        const Relative<Number> j(b, q);
        return along_x ? i.height() * j.x - j.height() * i.x : i.height() * j.y - j.height() * i.y;
    }
};

/// Above 0 where p is nearer to a than to b, in power distances: |p - b|² - w_b less that of a.
/// Linear but for the squares of a and b.
struct Nearer {
    static constexpr int degree = 2;
    MovingSite p;
    MovingSite a;
    MovingSite b;

    template <class Number>
    [[nodiscard]] PolynomialIn<Number, degree> in() const {
        return Relative<Number>(b, p).height() - Relative<Number>(a, p).height();
    }
};

}  // namespace signum::kinetic
