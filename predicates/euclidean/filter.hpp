#pragma once
/// The filters of the Euclidean predicates: the polynomials of formulas/apollonius.hpp in plain
/// doubles, each with a bound on its error. Under the tie rule as without it: what is certain is no
/// tie.
///
/// The bounds. For two sites let (x, y, r) be their rounded difference and l = |x| + |y| + |r|.
/// Every polynomial here is bounded by products of such l: the products of the coordinates of two
/// rows add up to l_j l_k, and so do the three minors E together; p is at most l², E_xp and E_yp
/// and E_rp together at most l_j l_k (l_j + l_k). Where every operation commits a relative error of
/// at most e, a polynomial of at most n roundings on the way from input to result is off by at most
/// ((1+e)^n - 1) times this product (the lemma of filters/rounding_count.hpp). The counts are given
/// at each bound, and checked by machine beside the formulas; one to three units more pay for terms
/// in e² and for the roundings of the bound itself.
///
/// The window. All l lie in [2^-110, 2^110] (sites that coincide are left to the exact stages). No
/// product has more than nine factors l: below 2^990 times a small number, nothing overflows.
/// Underflow costs a product at most 2^-1074, at a place where the l that bound it multiply to
/// 2^-990 or more: 2^-84 of the bound, and some hundred of them are nothing beside e.
///
/// Nothing is divided, and no root is taken of a negative number: in the window no flag is raised
/// but those of inexact and tiny results.

#include <initializer_list>

#include "../../core/sign.hpp"
#include "../../core/site.hpp"
#include "../../filters/bounds.hpp"
#include "../../filters/rounding_count.hpp"
#include "../../filters/verdict.hpp"
#include "../additive.hpp"

SIGNUM_IEEE_BEGIN

namespace signum::euclidean::filter {

using filters::epsilon;
using filters::magnitude;
using filters::Verdict;

/// A site relative to another. Its making is never a call, nor that of a triple: many numbers come
/// out, most of which the user keeps in registers, and compilers that weigh the size of a source
/// would decide now so, now otherwise.
template <class Number>
struct DifferenceOf {
    Number x;
    Number y;
    Number r;
    Number l;
    Number p;

    [[gnu::always_inline]] constexpr DifferenceOf(const Site& m, const Site& i) noexcept
        : x(Number(m.x) - Number(i.x)),
          y(Number(m.y) - Number(i.y)),
          r(Number(m.r) - Number(i.r)),
          l(magnitude(x) + magnitude(y) + magnitude(r)),
          p((x * x + y * y) - r * r) {}

    /// p is of 5 roundings of at most l².
    [[nodiscard, gnu::always_inline]] constexpr filters::Compared<Number> compared_power() const {
        return {p, 7 * epsilon * (l * l)};
    }
};
using Difference = DifferenceOf<double>;

/// The rows of which the roundings are counted.
using CountedDifference = DifferenceOf<filters::RoundingCount>;
inline constexpr CountedDifference counted_difference(Site{}, Site{});
static_assert(counted_difference.p.roundings == 5);

template <class... Size>
[[nodiscard]] inline bool in_window(double first, Size... others) noexcept {
    double least = first;
    double greatest = first;
    ((least = others < least ? others : least), ...);
    ((greatest = others > greatest ? others : greatest), ...);
    // An l that is not a number is not above the least and not below the greatest; the predicates
    // on finite sites make no other than inf - inf, of which inf itself is a summand: l is inf.
    return least >= 0x1p-110 && greatest <= 0x1p110;
}

/// NaN for a negative number; without a word to errno where the compiler has a word for the
/// instruction.
[[nodiscard]] inline double square_root(double value) noexcept {
#if __has_builtin(__builtin_ia32_sqrtsd)
    return __builtin_ia32_sqrtsd(filters::Two{value, 0.0})[0];
#else
    return __builtin_sqrt(value);
#endif
}
[[nodiscard]] inline float square_root(float value) noexcept {
#if __has_builtin(__builtin_ia32_sqrtss)
    using Four = float __attribute__((vector_size(16)));
    return __builtin_ia32_sqrtss(Four{value, 0.0F, 0.0F, 0.0F})[0];
#else
    return __builtin_sqrtf(value);
#endif
}

/// The root of a number that only its rounding can have made negative.
[[nodiscard]] inline double root_of_positive(double value) noexcept {
    return square_root(value > 0.0 ? value : 0.0);
}

[[nodiscard]] inline Verdict sign(double value, double bound) noexcept {
    if (magnitude(value) > bound) [[likely]]
        return Verdict::certain(filters::sign_of_nonzero(value));
    return Verdict::uncertain();
}
[[nodiscard]] inline Verdict sign(const filters::Compared<double>& compared) noexcept {
    return sign(compared.value, compared.bound);
}

/// What i, j, k alone decide.
template <class Number>
struct TripleOf {
    DifferenceOf<Number> j;
    DifferenceOf<Number> k;
    DifferenceOf<Number> jk;
    Number xy;
    Number xr;
    Number yr;
    Number q;
    Number l_jk;  // l_j l_k

    [[gnu::always_inline]] constexpr TripleOf(const Site& i, const Site& site_j,
                                              const Site& site_k) noexcept
        : j(site_j, i),
          k(site_k, i),
          jk(site_k, site_j),
          xy(j.x * k.y - j.y * k.x),
          xr(j.x * k.r - j.r * k.x),
          yr(j.y * k.r - j.r * k.y),
          q((xr * xr + yr * yr) - xy * xy),
          l_jk(j.l * k.l) {}

    [[nodiscard]] bool in_window() const noexcept { return filter::in_window(j.l, k.l, jk.l); }
    [[nodiscard]] constexpr Number xp() const noexcept { return j.x * k.p - j.p * k.x; }
    [[nodiscard]] constexpr Number yp() const noexcept { return j.y * k.p - j.p * k.y; }
    [[nodiscard]] constexpr Number rp() const noexcept { return j.r * k.p - j.p * k.r; }
    /// The product of the three powers.
    [[nodiscard]] constexpr Number gamma() const noexcept { return j.p * k.p * jk.p; }
    [[nodiscard]] constexpr Number twice_ab() const noexcept { return xp() * xr + yp() * yr; }
    /// Twice the middle of k's part of the bisector of i and j, times the size of Q.
    [[nodiscard]] constexpr Number middle() const noexcept { return xy * ((j.p - k.p) - jk.p); }

    /// Whether no site hides another: +1 or -1.
    [[nodiscard]] Verdict apart() const noexcept;

    /// The sign of 2ab: 14 roundings of at most (l_j l_k)² (l_j + l_k).
    [[nodiscard, gnu::always_inline]] constexpr filters::Compared<Number> compared_twice_ab()
        const {
        return {twice_ab(), 17 * epsilon * (l_jk * l_jk) * (j.l + k.l)};
    }
    [[nodiscard]] Verdict sign_of_twice_ab() const noexcept { return sign(compared_twice_ab()); }
    /// The sign of Q: 11 roundings of at most (l_j l_k)².
    [[nodiscard, gnu::always_inline]] constexpr filters::Compared<Number> compared_q() const {
        return {q, 13 * epsilon * (l_jk * l_jk)};
    }
    [[nodiscard]] Verdict sign_of_q() const noexcept { return sign(compared_q()); }
    /// The same where the window is not asked for.
    [[nodiscard, gnu::always_inline]] constexpr filters::Compared<Number> compared_q_anywhere()
        const {
        return {q, 13 * epsilon * (l_jk * l_jk) + (0x1p-1000 * l_jk + 0x1p-1000)};
    }
    /// The sign of C: 4 roundings of at most l_j l_k.
    [[nodiscard, gnu::always_inline]] constexpr filters::Compared<Number> compared_xy() const {
        return {xy, 5 * epsilon * l_jk};
    }
};
using Triple = TripleOf<double>;
using CountedTriple = TripleOf<filters::RoundingCount>;
inline constexpr CountedTriple counted_triple(Site{}, Site{}, Site{});
static_assert(counted_triple.xy.roundings == 4 && counted_triple.q.roundings == 11);
static_assert(counted_triple.twice_ab().roundings == 14 && counted_triple.gamma().roundings == 17);

[[nodiscard]] inline Verdict sign_of_power(const Difference& m) noexcept {
    return sign(m.compared_power());
}

template <class Number>
inline Verdict TripleOf<Number>::apart() const noexcept {
    Verdict result = Verdict::certain(1);
    for (const DifferenceOf<Number>* m : {&j, &k, &jk}) {
        const Verdict of_power = sign_of_power(*m);
        if (!of_power.is_certain()) [[unlikely]]
            return of_power;
        if (of_power.sign() < 0) result = of_power;
    }
    return result;
}

/// +1 where m hides q, -1 where it does not, for the row of q relative to m.
[[nodiscard]] inline Verdict hides(const Difference& q) noexcept {
    // To nearest no difference underflows, so that its sign is that of r_q - r_m.
    if (q.r > 0.0) return Verdict::certain(-1);
    if (!in_window(q.l)) [[unlikely]]
        return Verdict::uncertain();
    const Verdict of_power = sign_of_power(q);
    return of_power.is_certain() ? Verdict::certain(-of_power.sign()) : of_power;
}
[[nodiscard]] inline Verdict hides(const Site& m, const Site& q) noexcept {
    if (!filters::environment_is_default()) [[unlikely]]
        return Verdict::uncertain();
    return hides(Difference(filters::pinned(q), filters::pinned(m)));
}

/// Whether a circle touches i, j, k counterclockwise: +1 or -1.
[[nodiscard]] inline Verdict exists(const Site& i, const Site& j, const Site& k) noexcept {
    if (!filters::environment_is_default()) [[unlikely]]
        return Verdict::uncertain();
    const Triple t(filters::pinned(i), filters::pinned(j), filters::pinned(k));
    if (!t.in_window()) [[unlikely]]
        return Verdict::uncertain();
    const Verdict apart = t.apart();
    if (!apart.is_certain()) [[unlikely]]
        return apart;
    if (apart.sign() < 0) return apart;
    const Verdict of_q = t.sign_of_q();
    if (!of_q.is_certain()) [[unlikely]]
        return of_q;
    if (of_q.sign() < 0) return sign(t.compared_xy());
    return t.sign_of_twice_ab();
}

/// Whether a circle touches them counterclockwise and another one clockwise. Almost always Q < 0,
/// where the window is not asked for: E_xr² and so on underflow by less than 2^-1070 (1 + l_j l_k)
/// together, and where a product overflows the bound does.
[[nodiscard]] inline Verdict exists_twice(const Site& i, const Site& j, const Site& k) noexcept {
    const Triple t(filters::pinned(i), filters::pinned(j), filters::pinned(k));
    const double bound = t.compared_q_anywhere().bound;
    if (!filters::environment_is_default()) [[unlikely]]
        return Verdict::uncertain();
    if (t.q < -bound) [[likely]]
        return Verdict::certain(-1);
    if (!(t.q > bound) || !t.in_window()) return Verdict::uncertain();
    const Verdict apart = t.apart();
    if (!apart.is_certain() || apart.sign() < 0) return apart;
    return t.sign_of_twice_ab();
}

/// C_k e_k Q_q - C_q e_q Q_k, for the rows of q and those of k.
template <class Number>
[[nodiscard]] constexpr Number order_of_middles(const TripleOf<Number>& q,
                                                const TripleOf<Number>& k) noexcept {
    return k.middle() * q.q - q.middle() * k.q;
}
static_assert(order_of_middles(counted_triple, counted_triple).roundings == 25);

/// 25 roundings. C and Q are at most l_j l_k and its square, e = p_ij - p_ik - p_jk is at most
/// l_j² + l_k² + l_jk².
template <class Number>
[[nodiscard, gnu::always_inline]] constexpr filters::Compared<Number> compared_order_of_middles(
    const TripleOf<Number>& first, const TripleOf<Number>& second) noexcept {
    // A bound of the magnitude of a middle.
    const auto size = [](const TripleOf<Number>& t) {
        return t.l_jk * (t.j.l * t.j.l + t.k.l * t.k.l + t.jk.l * t.jk.l);
    };
    return {order_of_middles(first, second), 29 * epsilon *
                                                 (size(second) * (first.l_jk * first.l_jk) +
                                                  size(first) * (second.l_jk * second.l_jk))};
}

/// The sign of C_k e_k Q_q - C_q e_q Q_k.
[[nodiscard]] inline Verdict precedes_on_bisector(const Site& i, const Site& j, const Site& q,
                                                  const Site& k) noexcept {
    if (!filters::environment_is_default()) [[unlikely]]
        return Verdict::uncertain();
    const Site first_site = filters::pinned(i);
    const Site second_site = filters::pinned(j);
    const Triple first(first_site, second_site, filters::pinned(q));
    const Triple second(first_site, second_site, filters::pinned(k));
    if (!in_window(first.j.l, first.k.l, first.jk.l, second.k.l, second.jk.l)) [[unlikely]]
        return Verdict::uncertain();
    // Neither Q may be 0.
    const Verdict of_first = first.sign_of_q();
    const Verdict of_second = second.sign_of_q();
    if (!of_first.is_certain() || !of_second.is_certain()) [[unlikely]]
        return Verdict::uncertain();
    return sign(compared_order_of_middles(first, second));
}

/// A - L √Γ, where A is put in the order of q's row:
///     A = x_q (E_xy E_yp - E_xr E_rp) - y_q (E_xy E_xp + E_yr E_rp) + r_q [2ab] - p_q Q.
template <class Number>
struct ConflictOf {
    Number a;
    Number l;
    Number gamma;

    /// For the row of q relative to i.
    [[gnu::always_inline]] constexpr ConflictOf(const TripleOf<Number>& t,
                                                const DifferenceOf<Number>& c) noexcept
        : a((c.x * (t.xy * t.yp() - t.xr * t.rp()) - c.y * (t.xy * t.xp() + t.yr * t.rp())) +
            (c.r * t.twice_ab() - c.p * t.q)),
          l((c.x * t.yr - c.y * t.xr) + c.r * t.xy),
          gamma(t.gamma()) {}

    /// What the magnitude of A is at most, and the root of what that of Γ is.
    [[nodiscard, gnu::always_inline]] static constexpr Number size_of_a(
        const TripleOf<Number>& t, const DifferenceOf<Number>& c) noexcept {
        return c.l * (t.l_jk * t.l_jk) * (t.j.l + t.k.l + c.l);
    }
    [[nodiscard, gnu::always_inline]] static constexpr Number root_of_gamma_size(
        const TripleOf<Number>& t) noexcept {
        return t.l_jk * t.jk.l;
    }
};
using Conflict = ConflictOf<double>;
inline constexpr ConflictOf<filters::RoundingCount> counted_conflict(counted_triple,
                                                                     counted_difference);
static_assert(counted_conflict.a.roundings == 19 && counted_conflict.l.roundings == 8);

/// The sign of Q (A - L √Γ). The magnitude of A is at most m = l_q (l_j l_k)² (l_j + l_k + l_q),
/// that of L at most t = l_j l_k l_q, that of Γ at most g² for g = l_j l_k l_jk; and t g <= m,
/// since l_jk <= l_j + l_k. The errors of what is computed, a, l and the root s of the rounded Γ:
///     |a - A|    19e m
///     |l - L|    8e t
///     |s - √Γ|   19e g²/s: Γ is off by 17e g², so that its root, as |√x - √y| <= |x - y| / √x, is
///                by 17e g²/s, and its own rounding is e s = e s²/s
///     |l s - L √Γ| <= |l| |s - √Γ| + |l - L| √Γ
/// and e (|a| + 2 |l| s) for product and difference. √Γ is not bounded by s where that is small:
/// √Γ <= (1+e) s + 2^-23 g, as √(x + y) <= √x + √y; and it is l, not L, that the error of s is
/// multiplied by, as in the bound. All is compared times s, of degree 9, without a division: where
/// s is 0, nothing is certain. With s <= (1 + 2^-10) g and t g <= m it comes to
///     (19 + 8 + 3) e m s + 19e |l| g²
/// but for parts of 2^-9, and the bound, as it is computed, to more. A script says all this to
/// gappa (tests/structure/proofs/conflict.hpp).
inline constexpr int conflict_error_of_a = 34;
inline constexpr int conflict_error_of_root = 22;
static_assert(conflict_error_of_a >
                  counted_conflict.a.roundings + counted_conflict.l.roundings + 3 &&
              conflict_error_of_root > counted_conflict.gamma.roundings + 2);
template <class Number>
[[nodiscard, gnu::always_inline]] constexpr Number bound_of_conflict(const Number& m,
                                                                     const Number& l,
                                                                     const Number& g,
                                                                     const Number& root) noexcept {
    return epsilon *
           (conflict_error_of_a * m * root + conflict_error_of_root * magnitude(l) * g * g);
}
[[nodiscard, gnu::always_inline]] inline Verdict in_circle_of_visible(const Site& i, const Site& j,
                                                                      const Site& k,
                                                                      const Site& q) noexcept {
    if (!filters::environment_is_default()) [[unlikely]]
        return Verdict::uncertain();
    const Site origin = filters::pinned(i);
    const Triple t(origin, filters::pinned(j), filters::pinned(k));
    const Difference c(filters::pinned(q), origin);
    if (!in_window(t.j.l, t.k.l, t.jk.l, c.l)) [[unlikely]]
        return Verdict::uncertain();
    const Conflict conflict(t, c);
    const double root = root_of_positive(conflict.gamma);
    const double difference = conflict.a - conflict.l * root;
    const double g = Conflict::root_of_gamma_size(t);
    const double m = Conflict::size_of_a(t, c);
    const double bound = bound_of_conflict(m, conflict.l, g, root);
    if (!(magnitude(difference) * root > bound)) [[unlikely]]
        return Verdict::uncertain();
    const Verdict of_q = t.sign_of_q();
    if (!of_q.is_certain()) [[unlikely]]
        return of_q;
    return Verdict::certain(of_q.sign() * filters::sign_of_nonzero(difference));
}

/// The same for a q that may be hidden, which is no conflict.
[[nodiscard]] inline Verdict in_circle(const Site& i, const Site& j, const Site& k,
                                       const Site& q) noexcept {
    const Verdict verdict = in_circle_of_visible(i, j, k, q);
    if (!verdict.is_certain() || verdict.sign() < 0) return verdict;
    for (const Site* m : {&i, &j, &k}) {
        const Verdict hidden = hides(*m, q);
        if (!hidden.is_certain()) [[unlikely]]
            return hidden;
        if (hidden.sign() > 0) return Verdict::certain(-1);
    }
    return verdict;
}

/// T - √p X with T = z|u|² - s u·w and X = u x w.
template <class Number>
struct InfiniteConflictOf {
    Number t;
    Number cross;

    constexpr InfiniteConflictOf(const DifferenceOf<Number>& u,
                                 const DifferenceOf<Number>& w) noexcept
        : t(w.r * (u.x * u.x + u.y * u.y) - u.r * (u.x * w.x + u.y * w.y)),
          cross(u.x * w.y - u.y * w.x) {}
};
using InfiniteConflict = InfiniteConflictOf<double>;
inline constexpr InfiniteConflictOf<filters::RoundingCount> counted_infinite_conflict(
    counted_difference, counted_difference);
static_assert(counted_infinite_conflict.t.roundings == 7 &&
              counted_infinite_conflict.cross.roundings == 4);

/// The sign of T - √p X: T of 7 roundings of at most l_u² l_w, X of 4 roundings of at most l_u l_w,
/// p of 5 of at most l_u². As above, the root s of p is off by less than 7e l_u²/s, and with x for
/// what is computed of X the error, times s, is at most (7 + 4 + 3) e l_u² l_w s + 7e |x| l_u².
inline constexpr int infinite_error_of_t = 18;
inline constexpr int infinite_error_of_root = 10;
static_assert(infinite_error_of_t > counted_infinite_conflict.t.roundings +
                                        counted_infinite_conflict.cross.roundings + 3 &&
              infinite_error_of_root > counted_difference.p.roundings + 2);
template <class Number>
[[nodiscard, gnu::always_inline]] constexpr Number bound_of_infinite_conflict(
    const Number& l_u, const Number& l_w, const Number& cross, const Number& root) noexcept {
    const Number square = l_u * l_u;
    return epsilon * square *
           (infinite_error_of_t * l_w * root + infinite_error_of_root * magnitude(cross));
}
[[nodiscard]] inline Verdict in_circle_infinite(const Site& a, const Site& b,
                                                const Site& q) noexcept {
    if (!filters::environment_is_default()) [[unlikely]]
        return Verdict::uncertain();
    const Site origin = filters::pinned(a);
    const Difference u(filters::pinned(b), origin);
    const Difference w(filters::pinned(q), origin);
    if (!in_window(u.l, w.l)) [[unlikely]]
        return Verdict::uncertain();
    const InfiniteConflict conflict(u, w);
    const double root = root_of_positive(u.p);
    return sign((conflict.t - root * conflict.cross) * root,
                bound_of_infinite_conflict(u.l, w.l, conflict.cross, root));
}

/// The square of the distance of two points.
template <class Number>
[[nodiscard]] constexpr Number square_of_distance(const Point& p, const Site& m) noexcept {
    const Number x = Number(p.x) - Number(m.x);
    const Number y = Number(p.y) - Number(m.y);
    return x * x + y * y;
}
static_assert(square_of_distance<filters::RoundingCount>(Point{}, Site{}).roundings == 4);

/// A square of a distance takes 4 roundings, its root half of that and one more: at most 3e. Where
/// a square underflows, by 2^-1074 at most, the root is off by 2^-537; where it overflows, so does
/// the magnitude.
[[nodiscard]] inline additive::Distance distance(const Point& p, const Site& m) noexcept {
    const Site site = filters::pinned(m);
    const double to_centre = square_root(square_of_distance<double>(filters::pinned(p), site));
    return {to_centre, to_centre + 0x1p-440, site.r};
}

[[nodiscard]] inline Verdict nearer(const Point& p, const Site& a, const Site& b) noexcept {
    return additive::nearer(distance(p, a), distance(p, b));
}

/// The signs of the same numbers with no regard for errors, for the kernels that round; 0 where
/// they have to look closer.
namespace rounded {

template <class Number>
[[nodiscard]] inline Sign in_circle(const Site& i, const Site& j, const Site& k,
                                    const Site& q) noexcept {
    using Difference = DifferenceOf<Number>;
    const TripleOf<Number> t(i, j, k);
    const ConflictOf<Number> conflict(t, Difference(q, i));
    const Sign sign = sign_of(t.q) * sign_of(conflict.a - conflict.l * square_root(conflict.gamma));
    if (sign > 0)
        for (const Site* m : {&i, &j, &k}) {
            const Difference row(q, *m);
            if (row.r <= 0 && row.p <= 0) return -1;
        }
    return sign;
}

template <class Number>
[[nodiscard]] inline Sign in_circle_infinite(const Site& a, const Site& b, const Site& q) noexcept {
    using Difference = DifferenceOf<Number>;
    const Difference u(b, a);
    const InfiniteConflictOf<Number> conflict(u, Difference(q, a));
    return sign_of(conflict.t - square_root(u.p) * conflict.cross);
}

template <class Number>
[[nodiscard]] inline Sign exists_twice(const Site& i, const Site& j, const Site& k) noexcept {
    return TripleOf<Number>(i, j, k).q < 0 ? -1 : 0;
}

template <class Number>
[[nodiscard]] inline Sign nearer(const Point& p, const Site& a, const Site& b) noexcept {
    const auto distance = [&p](const Site& m) -> Number {
        return square_root(square_of_distance<Number>(p, m)) - Number(m.r);
    };
    return sign_of(distance(b) - distance(a));
}

}  // namespace rounded

}  // namespace signum::euclidean::filter

SIGNUM_IEEE_END
