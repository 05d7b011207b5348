#pragma once
/// The questions about discs: signs that follow from the polynomials of apollonius.hpp without a
/// square root, one text for numbers of any type.

#include <algorithm>
#include <array>
#include <cstddef>

#include "../../core/index.hpp"
#include "apollonius.hpp"

namespace signum::euclidean::polynomials {

// `ranks` are the places of the sites in the order of the tie rule; only their order counts.

/// A sign that is never 0, and whether the tie rule chose it.
struct Answer {
    Sign sign;
    bool tied = false;
};

/// Whether i hides q.
template <class D>
[[nodiscard]] Answer hides_one(const Disc<D>& i, const Disc<D>& q, bool i_precedes_q) {
    if (q.r > i.r) return {-1};
    const auto p = power(i, q);
    if (!(p <= 0)) return {-1};
    if (q.r == i.r) return {i_precedes_q ? 1 : -1, true};
    return {1, p == 0};
}
template <class D>
[[nodiscard]] Answer hides(const std::array<Disc<D>, 2>& d, const std::array<Index, 2>& ranks) {
    return hides_one(d[0], d[1], ranks[0] < ranks[1]);
}

/// The sign of |p-b| - |p-a| + r_a - r_b for the centre of the first disc, and a, b the others.
/// With u = |p-b|², v = |p-a|², d = r_a - r_b: where √u - √v and d differ in sign, √u + d and √v
/// (or √u and √v - d) are compared by their squares: the sign of u + d² - v + 2d√u, and so on.
template <class D>
[[nodiscard]] Sign compare_distances(const std::array<Disc<D>, 3>& discs) {
    using Quadratic = typename D::Quadratic;
    using Quartic = typename D::Quartic;
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
    const Sign sign = compare_distances(d);
    if (sign != 0) return {sign};
    return {ranks[0] < ranks[1] ? 1 : -1, true};
}

/// Precondition: t.apart(). Where Q = 0 the finite root is R = (E_xp² + E_yp²) / (4·[2ab]).
template <class D>
[[nodiscard]] bool has_finite_circle(const Triple<D>& t) {
    const Sign of_q = sign(t.q);
    if (of_q < 0) return t.xy > 0;
    if (of_q > 0) return sign(t.twice_ab()) > 0;
    return t.xy > 0 && sign(t.twice_ab()) > 0;
}

template <std::size_t n>
[[nodiscard]] std::size_t last_of(const std::array<Index, n>& ranks, std::size_t count) {
    return static_cast<std::size_t>(
        std::max_element(ranks.begin(), ranks.begin() + static_cast<std::ptrdiff_t>(count)) -
        ranks.begin());
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

/// Whether a circle touches the three counterclockwise. Without the tie rule a line that touches
/// all three, C and 2ab of different signs, is no circle.
template <class D>
[[nodiscard]] Answer exists(const std::array<Disc<D>, 3>& d, const std::array<Index, 3>& ranks) {
    const Triple<D> t(d[0], d[1], d[2]);
    if (!t.apart()) return {-1, t.touch()};
    if (t.q != 0) return {has_finite_circle(t) ? 1 : -1};
    const bool at_infinity = sign(t.xy) * sign(t.twice_ab()) < 0 && last_lies_between(t, ranks);
    return {has_finite_circle(t) || at_infinity ? 1 : -1, true};
}

/// Whether one circle touches the three counterclockwise and another one clockwise. Where Q = 0 one
/// of them is finite, the other one of nearly infinite radius; then C is not 0, for with it 2ab
/// would be 0 as well (law 4).
template <class D>
[[nodiscard]] Answer exists_twice(const std::array<Disc<D>, 3>& d,
                                  const std::array<Index, 3>& ranks) {
    const Triple<D> t(d[0], d[1], d[2]);
    if (t.q < 0) return {-1};
    if (!t.apart()) return {-1, t.touch()};
    const bool above = sign(t.twice_ab()) > 0;
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
[[nodiscard]] Answer precedes_on_bisector(const std::array<Disc<D>, 4>& d) {
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

template <class D>
[[nodiscard]] Sign in_finite_circle(const Triple<D>& t, const Powers<D>& p, const Row<D>& q) {
    const Sign of_l = sign(t.l(q));
    const Sign of_q = sign(t.q);
    if (of_q == 0) return of_l != 0 ? p.sign_of_h() * of_l : -sign(t.xy) * sign(t.xyp(q));
    const Sign of_a = sign(t.a(q));
    return of_q * sign_of_difference(of_a, of_l, [&] { return of_q * p.sign_of_h(); });
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

/// With u, s the row of b relative to a and w, z that of q: the sign of
/// (z |u|² - s u·w) - √p_ab (u x w), whose resultant is |u|² H(p_ab, p_aq, p_bq) / 4.
template <class D>
[[nodiscard]] Sign in_circle_infinite_touch(const std::array<Disc<D>, 3>& d) {
    using Quadratic = typename D::Quadratic;
    using Quartic = typename D::Quartic;
    const Row<D> u = row(d[1], d[0]);
    const Row<D> w = row(d[2], d[0]);
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
    const Triple<D> t(d[0], d[1], d[2]);
    if (t.q == 0 && !has_finite_circle(t)) {
        // A circle of nearly infinite radius touches the last of the three between the others.
        const std::size_t m = last_of(ranks, 3);
        return in_circle_infinite_touch(std::array{d[(m + 1) % 3], d[(m + 2) % 3], d[3]});
    }
    return in_finite_circle(t, Powers<D>(t, d), row(d[3], d[0]));
}

/// The same under the tie rule, without the precondition.
template <class D>
[[nodiscard]] Answer in_circle(const std::array<Disc<D>, 4>& d, const std::array<Index, 4>& ranks) {
    for (std::size_t m = 0; m < 3; ++m) {
        const Answer hidden = hides_one(d[m], d[3], ranks[m] < ranks[3]);
        if (hidden.sign > 0) return {-1, hidden.tied};
    }
    const Sign sign = in_circle_touch(d, ranks);
    if (sign != 0) return {sign};
    const Triple<D> t(d[0], d[1], d[2]);
    return {in_circle_tie(Powers<D>(t, d), ranks), true};
}

/// Under the tie rule: as for a finite vertex, with the powers in the place of their products.
/// Precondition: neither of a and b hides the other.
template <class D>
[[nodiscard]] Answer in_circle_infinite(const std::array<Disc<D>, 3>& d,
                                        const std::array<Index, 3>& ranks) {
    const auto& [a, b, q] = d;
    const Sign sign = in_circle_infinite_touch(d);
    if (sign != 0) return {sign};
    if (hides_one(a, q, ranks[0] < ranks[2]).sign > 0 ||
        hides_one(b, q, ranks[1] < ranks[2]).sign > 0)
        return {-1, true};
    const std::size_t m = last_of(ranks, 3);
    if (m == 2) return {-1, true};
    const auto opposite = power(d[m], q);
    const bool between = opposite > power(a, b) && opposite > power(d[1 - m], q);
    return {between ? -1 : 1, true};
}

}  // namespace signum::euclidean::polynomials
