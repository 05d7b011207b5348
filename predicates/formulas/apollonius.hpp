#pragma once
/// The polynomials that decide the Euclidean predicates and place their vertices, for numbers of
/// any type: in exact numbers (exact.cpp), in rationals and double-doubles (the vertices), with
/// their magnitudes (the margins of a study).
///
/// With p_ab = |c_a - c_b|² - (r_a - r_b)² and the rows (x, y, r, p) of j, k and q relative to i,
/// E_ab the 2x2 minors over j, k and D_abc the 3x3 minors over j, k, q:
///     C = E_xy                                    Q = E_xr² + E_yr² - E_xy²
///     Γ = p_ij p_ik p_jk                        2ab = E_xp E_xr + E_yp E_yr
///     L = D_xyr                                   A = E_xy D_xyp - E_xr D_xrp - E_yr D_yrp
///     H(a,b,c) = a² + b² + c² - 2(ab + bc + ca)   at a = p_ij p_kq, b = p_ik p_jq, c = p_iq p_jk
///
/// Laws:
///  1. the circle that touches i, j, k counterclockwise has the radius R - r_i with
///     R = (2ab - C √Γ) / 2Q, and q conflicts with it where Q (A - L √Γ) > 0;
///  2. A² - L² Γ = Q H / 4, so that A, L, Q and H, of degree 8 at most, have all the signs needed;
///  3. H = 0 is Casey's theorem: one circle touches all four. H(p_ij, p_ik, p_jk) = 4Q: one line
///     touches all three.
///  4. |c_j - c_i|² Q = W² - p_ij C² with W = |c_j - c_i|² r_k - r_j (c_j - c_i)·(c_k - c_i); so
///     Q = 0 and C = 0 only together with W;
///  5. along the bisector of i and j, walked with i on the left, the coordinate
///     t = (c_j - c_i) x (X - c_i) rises. The part nearer to k runs, cyclically through infinity,
///     from vertex (i,j,k), at t = M + N, to vertex (j,i,k), at t = M - N, with
///     M = p_ij C e / 4Q,  e = p_ij - p_ik - p_jk,  N = W √Γ / 2Q.
/// Proved by tests/oracle/apollonius_identities_test.cpp on all kinds of degenerate configurations;
/// law 5 by tests/property/euclidean_predicates_test.cpp.

#include <array>
#include <type_traits>

#include "../../core/sign.hpp"

namespace signum::euclidean {

/// The types that hold polynomials of degree 1, 2, up to 4 and up to 8, all the same one.
template <class Number>
struct Uniform {
    using Linear = Number;
    using Quadratic = Number;
    using Quartic = Number;
    using Octic = Number;
};

template <class Degrees>
struct Disc {
    typename Degrees::Linear x;
    typename Degrees::Linear y;
    typename Degrees::Linear r;
};

namespace polynomials {

/// The number in a type that has room for what comes; no copy where it is of that type.
template <class Wide, class Number>
[[nodiscard]] decltype(auto) as(const Number& number) {
    if constexpr (std::is_same_v<Wide, Number>) {
        return (number);
    } else {
        return Wide(number);
    }
}

template <class Number>
[[nodiscard]] Sign sign(const Number& number) {
    if constexpr (requires { number.sign(); }) {
        return number.sign();
    } else {
        return static_cast<int>(number > 0) - static_cast<int>(number < 0);
    }
}

/// a·b
template <class Wide, class A, class B>
[[nodiscard]] Wide product(const A& a, const B& b) {
    return as<Wide>(a) * as<Wide>(b);
}

/// a·d - b·c
template <class Wide, class A, class B, class C, class D>
[[nodiscard]] Wide minor(const A& a, const B& b, const C& c, const D& d) {
    return product<Wide>(a, d) - product<Wide>(b, c);
}

/// The sign of u - v √g, from the signs of u, v and u² - v² g. `resultant` is asked only where the
/// others do not suffice.
template <class Resultant>
[[nodiscard]] Sign sign_of_difference(Sign u, Sign v, Resultant resultant) {
    if (v == 0 || u == -v) return u;
    if (u == 0) return -v;
    return u * resultant();
}

/// H
template <class Wide, class Number>
[[nodiscard]] Wide casey(const Number& a, const Number& b, const Number& c) {
    const Number rest = a - b - c;
    return product<Wide>(rest, rest) - 4 * product<Wide>(b, c);
}

/// p
template <class D>
[[nodiscard]] typename D::Quadratic power(const Disc<D>& a, const Disc<D>& b) {
    const typename D::Quadratic x = a.x - b.x;
    const typename D::Quadratic y = a.y - b.y;
    const typename D::Quadratic r = a.r - b.r;
    return x * x + y * y - r * r;
}

/// A site relative to another.
template <class D>
struct Row {
    typename D::Linear x;
    typename D::Linear y;
    typename D::Linear r;
    typename D::Quadratic p;

    Row(const typename D::Linear& dx, const typename D::Linear& dy, const typename D::Linear& dr)
        : x(dx), y(dy), r(dr), p(dx * dx + dy * dy - dr * dr) {}
};
template <class D>
[[nodiscard]] Row<D> row(const Disc<D>& m, const Disc<D>& i) {
    return {m.x - i.x, m.y - i.y, m.r - i.r};
}

/// The minors of the rows of j and k, and what they and a third row make.
template <class D>
struct Minors {
    using Quadratic = typename D::Quadratic;
    using Quartic = typename D::Quartic;
    using Octic = typename D::Octic;

    Row<D> j;
    Row<D> k;
    Quadratic xy;
    Quadratic xr;
    Quadratic yr;
    Quartic q;

    Minors(const Row<D>& row_j, const Row<D>& row_k)
        : j(row_j),
          k(row_k),
          xy(minor<Quadratic>(j.x, j.y, k.x, k.y)),
          xr(minor<Quadratic>(j.x, j.r, k.x, k.r)),
          yr(minor<Quadratic>(j.y, j.r, k.y, k.r)),
          q(product<Quartic>(xr, xr) + product<Quartic>(yr, yr) - product<Quartic>(xy, xy)) {}

    [[nodiscard]] Quartic xp() const { return minor<Quartic>(j.x, j.p, k.x, k.p); }
    [[nodiscard]] Quartic yp() const { return minor<Quartic>(j.y, j.p, k.y, k.p); }
    [[nodiscard]] Quartic rp() const { return minor<Quartic>(j.r, j.p, k.r, k.p); }
    [[nodiscard]] Octic twice_ab() const {
        return product<Octic>(xp(), xr) + product<Octic>(yp(), yr);
    }

    /// L
    [[nodiscard]] Quartic l(const Row<D>& m) const {
        return product<Quartic>(m.x, yr) - product<Quartic>(m.y, xr) + product<Quartic>(m.r, xy);
    }
    /// D_xyp
    [[nodiscard]] Quartic xyp(const Row<D>& m) const {
        return product<Quartic>(m.x, yp()) - product<Quartic>(m.y, xp()) +
               product<Quartic>(m.p, xy);
    }
    /// A
    [[nodiscard]] Octic a(const Row<D>& m) const {
        const Quartic of_x = xp();
        const Quartic of_y = yp();
        const Quartic of_r = rp();
        const Quartic xyp =
            product<Quartic>(m.x, of_y) - product<Quartic>(m.y, of_x) + product<Quartic>(m.p, xy);
        const Quartic xrp =
            product<Quartic>(m.x, of_r) - product<Quartic>(m.r, of_x) + product<Quartic>(m.p, xr);
        const Quartic yrp =
            product<Quartic>(m.y, of_r) - product<Quartic>(m.r, of_y) + product<Quartic>(m.p, yr);
        return product<Octic>(xy, xyp) - product<Octic>(xr, xrp) - product<Octic>(yr, yrp);
    }
};

/// What i, j, k alone decide.
template <class D>
struct Triple : Minors<D> {
    typename D::Quadratic jk;

    Triple(const Disc<D>& i, const Disc<D>& site_j, const Disc<D>& site_k)
        : Minors<D>(row(site_j, i), row(site_k, i)), jk(power(site_j, site_k)) {}

    /// Neither hides another, nor touches it from inside.
    [[nodiscard]] bool apart() const { return this->j.p > 0 && this->k.p > 0 && jk > 0; }
    /// Where not apart: nothing but a touch keeps them from it.
    [[nodiscard]] bool touch() const { return this->j.p >= 0 && this->k.p >= 0 && jk >= 0; }
};

/// The powers of four sites.
template <class D>
struct Powers {
    typename D::Quadratic ij, ik, jk, iq, jq, kq;

    Powers(const Triple<D>& t, const std::array<Disc<D>, 4>& d)
        : ij(t.j.p),
          ik(t.k.p),
          jk(t.jk),
          iq(power(d[0], d[3])),
          jq(power(d[1], d[3])),
          kq(power(d[2], d[3])) {}

    /// The sign of H.
    [[nodiscard]] Sign sign_of_h() const {
        using Quartic = typename D::Quartic;
        return sign(casey<typename D::Octic>(product<Quartic>(ij, kq), product<Quartic>(ik, jq),
                                             product<Quartic>(iq, jk)));
    }
};

}  // namespace polynomials
}  // namespace signum::euclidean
