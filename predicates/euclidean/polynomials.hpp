#pragma once
/// The polynomials that decide the Euclidean predicates, for exact numbers of any type, and the
/// signs that follow from them without a square root: in integers and rationals the exact stages,
/// in sums of doubles ESSA, in doubles the naive predicates where filter.hpp::rounded leaves a 0.
/// Included by sources only.
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
///  4. |c_j - c_i|² Q = W² - p_ij C² with W = |c_j - c_i|² r_k - r_j (c_j - c_i)·(c_k - c_i), so
///  that
///     Q = 0 and C = 0 only together with W;
///  5. along the bisector of i and j, walked with i on the left, the coordinate
///     t = (c_j - c_i) x (X - c_i) rises. The part nearer to k runs, cyclically through infinity,
///     from vertex (i,j,k), at t = M + N, to vertex (j,i,k), at t = M - N, with
///     M = p_ij C e / 4Q,  e = p_ij - p_ik - p_jk,  N = W √Γ / 2Q.
/// Proved by tests/unit/apollonius_identities_test.cpp on all kinds of degenerate configurations;
/// law 5 by tests/property/euclidean_predicates_test.cpp.

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>

#include "../../core/index.hpp"
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

/// A site relative to i.
template <class D>
struct Row {
    typename D::Linear x;
    typename D::Linear y;
    typename D::Linear r;
    typename D::Quadratic p;

    Row(const Disc<D>& m, const Disc<D>& i)
        : x(m.x - i.x), y(m.y - i.y), r(m.r - i.r), p(power(m, i)) {}
};

/// What i, j, k alone decide.
template <class D>
struct Triple {
    using Quadratic = typename D::Quadratic;
    using Quartic = typename D::Quartic;
    using Octic = typename D::Octic;

    Row<D> j;
    Row<D> k;
    Quadratic jk;
    Quadratic xy;
    Quadratic xr;
    Quadratic yr;
    Quartic q;

    Triple(const Disc<D>& i, const Disc<D>& site_j, const Disc<D>& site_k)
        : j(site_j, i),
          k(site_k, i),
          jk(power(site_j, site_k)),
          xy(minor<Quadratic>(j.x, j.y, k.x, k.y)),
          xr(minor<Quadratic>(j.x, j.r, k.x, k.r)),
          yr(minor<Quadratic>(j.y, j.r, k.y, k.r)),
          q(product<Quartic>(xr, xr) + product<Quartic>(yr, yr) - product<Quartic>(xy, xy)) {}

    [[nodiscard]] Quartic xp() const { return minor<Quartic>(j.x, j.p, k.x, k.p); }
    [[nodiscard]] Quartic yp() const { return minor<Quartic>(j.y, j.p, k.y, k.p); }
    [[nodiscard]] Quartic rp() const { return minor<Quartic>(j.r, j.p, k.r, k.p); }
    /// The sign of 2ab.
    [[nodiscard]] Sign twice_ab() const {
        return sign(Octic(product<Octic>(xp(), xr) + product<Octic>(yp(), yr)));
    }

    /// Neither hides another, nor touches it from inside.
    [[nodiscard]] bool apart() const { return j.p > 0 && k.p > 0 && jk > 0; }
    /// Where not apart: nothing but a touch keeps them from it.
    [[nodiscard]] bool touch() const { return j.p >= 0 && k.p >= 0 && jk >= 0; }
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
    [[nodiscard]] Sign casey() const {
        using Quartic = typename D::Quartic;
        return sign(polynomials::casey<typename D::Octic>(
            product<Quartic>(ij, kq), product<Quartic>(ik, jq), product<Quartic>(iq, jk)));
    }
};

template <std::size_t n>
[[nodiscard]] std::size_t last_of(const std::array<Index, n>& ranks, std::size_t count) {
    return static_cast<std::size_t>(
        std::max_element(ranks.begin(), ranks.begin() + static_cast<std::ptrdiff_t>(count)) -
        ranks.begin());
}

}  // namespace polynomials

// ---- the questions -----------------------------------------------------------------------------
// `ranks` are the places of the sites in the order of the tie rule; only their order counts.

/// A sign that is never 0, and whether the tie rule chose it.
struct Answer {
    Sign sign;
    bool tied = false;
};

/// Whether i hides q.
template <class D>
[[nodiscard]] Answer hides(const Disc<D>& i, const Disc<D>& q, bool i_precedes_q) {
    if (q.r > i.r) return {-1};
    const auto power = polynomials::power(i, q);
    if (!(power <= 0)) return {-1};
    if (q.r == i.r) return {i_precedes_q ? 1 : -1, true};
    return {1, power == 0};
}
template <class D>
[[nodiscard]] Answer hides(const std::array<Disc<D>, 2>& d, const std::array<Index, 2>& ranks) {
    return hides(d[0], d[1], ranks[0] < ranks[1]);
}

/// The sign of |p-b| - |p-a| + r_a - r_b for the centre of the first disc, and a, b the others.
/// With u = |p-b|², v = |p-a|², d = r_a - r_b: where √u - √v and d differ in sign, √u + d and √v
/// (or √u and √v - d) are compared by their squares: the sign of u + d² - v + 2d√u, and so on.
template <class D>
[[nodiscard]] Sign nearer(const std::array<Disc<D>, 3>& discs) {
    using Quadratic = typename D::Quadratic;
    using Quartic = typename D::Quartic;
    using namespace polynomials;
    const auto square = [&](const Disc<D>& s) {
        const Quadratic x = s.x - discs[0].x;
        const Quadratic y = s.y - discs[0].y;
        return Quadratic(x * x + y * y);
    };
    const Quadratic u = square(discs[2]);
    const Quadratic v = square(discs[1]);
    const Quadratic d = discs[1].r - discs[2].r;
    const Sign of_radii = sign(d);
    const Sign of_centres = sign(Quadratic(u - v));
    if (of_radii == 0 || of_centres != -of_radii) return of_centres != 0 ? of_centres : of_radii;
    // The site of the greater radius has the greater square of a distance: is it far enough?
    const Quadratic& near = of_radii > 0 ? u : v;
    const Quadratic& far = of_radii > 0 ? v : u;
    const Quadratic square_d = d * d;
    const Quadratic rest = near + square_d - far;
    const Sign of_rest = sign(rest);
    if (of_rest >= 0) return near == 0 ? of_radii * of_rest : of_radii;
    return of_radii *
           sign(Quartic(4 * product<Quartic>(square_d, near) - product<Quartic>(rest, rest)));
}

/// Whether the centre of the first disc is nearer to the second than to the third.
template <class D>
[[nodiscard]] Answer nearer(const std::array<Disc<D>, 3>& d, const std::array<Index, 2>& ranks) {
    const Sign sign = nearer(d);
    if (sign != 0) return {sign};
    return {ranks[0] < ranks[1] ? 1 : -1, true};
}

namespace polynomials {

/// Precondition: t.apart(). Where Q = 0 the finite root is R = (E_xp² + E_yp²) / (4·[2ab]).
template <class D>
[[nodiscard]] bool exists(const Triple<D>& t) {
    const Sign of_q = sign(t.q);
    if (of_q < 0) return t.xy > 0;
    if (of_q > 0) return t.twice_ab() > 0;
    return t.xy > 0 && t.twice_ab() > 0;
}

/// Whether the last of the three lies between the others: then it recedes from a line that touches
/// all of them, and the line becomes a circle of nearly infinite radius.
template <class D>
[[nodiscard]] bool last_lies_between(const Triple<D>& t, const std::array<Index, 3>& ranks) {
    const std::array<const typename D::Quadratic*, 3> opposite = {&t.jk, &t.k.p, &t.j.p};
    const std::size_t m = last_of(ranks, 3);
    const auto& others = *opposite[m];
    return others > *opposite[(m + 1) % 3] && others > *opposite[(m + 2) % 3];
}

}  // namespace polynomials

/// Whether a circle touches the three counterclockwise. Without the tie rule a line that touches
/// all three, C and 2ab of different signs, is no circle.
template <class D>
[[nodiscard]] Answer exists(const std::array<Disc<D>, 3>& d, const std::array<Index, 3>& ranks) {
    using namespace polynomials;
    const Triple<D> t(d[0], d[1], d[2]);
    if (!t.apart()) return {-1, t.touch()};
    if (t.q != 0) return {exists(t) ? 1 : -1};
    const bool at_infinity = sign(t.xy) * t.twice_ab() < 0 && last_lies_between(t, ranks);
    return {exists(t) || at_infinity ? 1 : -1, true};
}

/// Whether one circle touches the three counterclockwise and another one clockwise. Where Q = 0 one
/// of them is finite, the other one of nearly infinite radius; then C is not 0, for with it 2ab
/// would be 0 as well (law 4).
template <class D>
[[nodiscard]] Answer exists_twice(const std::array<Disc<D>, 3>& d,
                                  const std::array<Index, 3>& ranks) {
    using namespace polynomials;
    const Triple<D> t(d[0], d[1], d[2]);
    if (t.q < 0) return {-1};
    if (!t.apart()) return {-1, t.touch()};
    const bool above = t.twice_ab() > 0;
    if (t.q != 0) return {above ? 1 : -1};
    return {above && last_lies_between(t, ranks) ? 1 : -1, true};
}

/// Whether the part of the bisector of i and j that belongs to q, or where that is all but an
/// interval, that interval, comes before the part that belongs to k, walked in the direction of law
/// 5. Discs i, j, q, k. Preconditions: each of q and k exists twice with i and j, k's part is an
/// interval, both intervals are disjoint.
///
/// Disjoint intervals are ordered as their middles M. Under the tie rule Q = 0 is positive, but
/// infinitely small, and C and e are not 0.
template <class D>
[[nodiscard]] Answer precedes(const std::array<Disc<D>, 4>& d) {
    using namespace polynomials;
    using Quartic = typename D::Quartic;
    using Octic = typename D::Octic;
    const Triple<D> q(d[0], d[1], d[2]);
    const Triple<D> k(d[0], d[1], d[3]);
    const auto middle = [](const Triple<D>& t) -> Quartic {
        return product<Quartic>(t.xy, Quartic(as<Quartic>(t.j.p) - t.k.p - t.jk));
    };
    const Quartic of_q = middle(q);
    const Quartic of_k = middle(k);
    const bool tied = q.q == 0 || k.q == 0;
    if (q.q == 0 && k.q == 0) return {sign(of_k) > sign(of_q) ? 1 : -1, tied};
    const bool rises = product<Octic>(of_k, q.q) > product<Octic>(of_q, k.q);
    return {rises ? 1 : -1, tied};
}

namespace polynomials {

template <class D>
[[nodiscard]] Sign in_circle(const Triple<D>& t, const Powers<D>& p,
                             const std::array<Disc<D>, 4>& d) {
    using Quartic = typename D::Quartic;
    using Octic = typename D::Octic;
    const Row<D> q(d[3], d[0]);
    const Sign of_l = sign(Quartic(product<Quartic>(q.x, t.yr) - product<Quartic>(q.y, t.xr) +
                                   product<Quartic>(q.r, t.xy)));
    const Sign of_q = sign(t.q);
    if (of_q == 0 && of_l != 0) return p.casey() * of_l;
    const Quartic xp = t.xp();
    const Quartic yp = t.yp();
    const Quartic xyp =
        product<Quartic>(q.x, yp) - product<Quartic>(q.y, xp) + product<Quartic>(q.p, t.xy);
    if (of_q == 0) return -sign(t.xy) * sign(xyp);
    const Quartic rp = t.rp();
    const Quartic xrp =
        product<Quartic>(q.x, rp) - product<Quartic>(q.r, xp) + product<Quartic>(q.p, t.xr);
    const Quartic yrp =
        product<Quartic>(q.y, rp) - product<Quartic>(q.r, yp) + product<Quartic>(q.p, t.yr);
    const Sign of_a = sign(
        Octic(product<Octic>(t.xy, xyp) - product<Octic>(t.xr, xrp) - product<Octic>(t.yr, yrp)));
    return of_q * sign_of_difference(of_a, of_l, [&] { return of_q * p.casey(); });
}

/// What 0 becomes: no conflict where q is the last, otherwise conflict, unless q touches the circle
/// on the arc opposite the last one, which is when their product is strictly the largest (Ptolemy).
template <class D>
[[nodiscard]] Sign in_circle_tie(const Powers<D>& p, const std::array<Index, 4>& ranks) {
    using Quartic = typename D::Quartic;
    const std::size_t m = last_of(ranks, 4);
    if (m == 3) return -1;
    const std::array<Quartic, 3> products = {
        product<Quartic>(p.iq, p.jk), product<Quartic>(p.jq, p.ik), product<Quartic>(p.kq, p.ij)};
    const Quartic& opposite = products[m];
    return opposite > products[(m + 1) % 3] && opposite > products[(m + 2) % 3] ? -1 : 1;
}

}  // namespace polynomials

/// With u, s the row of b relative to a and w, z that of q: the sign of
/// (z |u|² - s u·w) - √p_ab (u x w), whose resultant is |u|² H(p_ab, p_aq, p_bq) / 4.
template <class D>
[[nodiscard]] Sign in_circle_infinite(const std::array<Disc<D>, 3>& d) {
    using Quadratic = typename D::Quadratic;
    using Quartic = typename D::Quartic;
    using namespace polynomials;
    const Row<D> u(d[1], d[0]);
    const Row<D> w(d[2], d[0]);
    const Quadratic square = product<Quadratic>(u.x, u.x) + product<Quadratic>(u.y, u.y);
    const Quadratic inner = product<Quadratic>(u.x, w.x) + product<Quadratic>(u.y, w.y);
    const Sign rational = sign(minor<Quartic>(w.r, u.r, inner, square));
    const Sign cross = sign(minor<Quadratic>(u.x, u.y, w.x, w.y));
    return sign_of_difference(rational, cross,
                              [&] { return sign(casey<Quartic>(u.p, w.p, power(d[1], d[2]))); });
}

/// Whether q conflicts with the vertex of i, j, k that exists under the tie rule; 0 where it
/// touches. Precondition: none of them hides q.
template <class D>
[[nodiscard]] Sign in_circle_touch(const std::array<Disc<D>, 4>& d,
                                   const std::array<Index, 4>& ranks) {
    const polynomials::Triple<D> t(d[0], d[1], d[2]);
    if (t.q == 0 && !polynomials::exists(t)) {
        // A circle of nearly infinite radius touches the last of the three between the others.
        const std::size_t m = polynomials::last_of(ranks, 3);
        return in_circle_infinite(std::array{d[(m + 1) % 3], d[(m + 2) % 3], d[3]});
    }
    return polynomials::in_circle(t, polynomials::Powers<D>(t, d), d);
}

/// The same under the tie rule, without the precondition.
template <class D>
[[nodiscard]] Answer in_circle(const std::array<Disc<D>, 4>& d, const std::array<Index, 4>& ranks) {
    for (std::size_t m = 0; m < 3; ++m) {
        const Answer hidden = hides(d[m], d[3], ranks[m] < ranks[3]);
        if (hidden.sign > 0) return {-1, hidden.tied};
    }
    const Sign sign = in_circle_touch(d, ranks);
    if (sign != 0) return {sign};
    const polynomials::Triple<D> t(d[0], d[1], d[2]);
    return {polynomials::in_circle_tie(polynomials::Powers<D>(t, d), ranks), true};
}

/// Under the tie rule: as for a finite vertex, with the powers in the place of their products.
/// Precondition: neither of a and b hides the other.
template <class D>
[[nodiscard]] Answer in_circle_infinite(const std::array<Disc<D>, 3>& d,
                                        const std::array<Index, 3>& ranks) {
    const auto& [a, b, q] = d;
    const Sign sign = in_circle_infinite(d);
    if (sign != 0) return {sign};
    if (hides(a, q, ranks[0] < ranks[2]).sign > 0 || hides(b, q, ranks[1] < ranks[2]).sign > 0)
        return {-1, true};
    const std::size_t m = polynomials::last_of(ranks, 3);
    if (m == 2) return {-1, true};
    const auto opposite = polynomials::power(d[m], q);
    const bool between =
        opposite > polynomials::power(a, b) && opposite > polynomials::power(d[1 - m], q);
    return {between ? -1 : 1, true};
}

}  // namespace signum::euclidean
