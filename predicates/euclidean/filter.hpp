#pragma once
/// The filters of the Euclidean predicates: the polynomials of polynomials.hpp in plain doubles,
/// each with a bound on its error. Under the tie rule as without it: what is certain is no tie.
///
/// The bounds. For two sites let (x, y, r) be their rounded difference and l = |x| + |y| + |r|.
/// Every polynomial here is bounded by products of such l: the products of the coordinates of two
/// rows add up to l_j l_k, and so do the three minors E together; p is at most l², E_xp and E_yp
/// and E_rp together at most l_j l_k (l_j + l_k). Where every operation commits a relative error of
/// at most e, a polynomial of at most n roundings on the way from input to result is off by at most
/// ((1+e)^n - 1) times this product (the lemma of filters/rounding_count.hpp). The counts are given
/// at each bound, checked below by machine; one to three units more pay for terms in e² and for the
/// roundings of the bound itself. To sum in another order, or to multiply out, adds no rounding on
/// any way.
///
/// The window. All l lie in [2^-120, 2^120] (sites that coincide are left to the exact stages). No
/// product has more than eight factors l: below 2^960 times a small number, nothing overflows.
/// Underflow costs a product at most 2^-1074, at a place where the l that bound it multiply to
/// 2^-960 or more: 2^-114 of the bound, and some hundred of them are nothing beside e.

#include <initializer_list>

#include "../../core/sign.hpp"
#include "../../core/site.hpp"
#include "../../filters/bounds.hpp"
#include "../../filters/rounding_count.hpp"
#include "../../filters/verdict.hpp"
#include "../additive.hpp"

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace signum::euclidean::filter {

using filters::epsilon;
using filters::magnitude;
using filters::Verdict;

/// A site relative to another.
template <class Number>
struct DifferenceOf {
    Number x;
    Number y;
    Number r;
    Number l;
    Number p;

    DifferenceOf(const Site& m, const Site& i) noexcept
        : x(Number(m.x) - Number(i.x)),
          y(Number(m.y) - Number(i.y)),
          r(Number(m.r) - Number(i.r)),
          l(magnitude(x) + magnitude(y) + magnitude(r)),
          p((x * x + y * y) - r * r) {}
};
using Difference = DifferenceOf<double>;

template <class... Size>
[[nodiscard]] inline bool in_window(double first, Size... others) noexcept {
    double least = first;
    double greatest = first;
    ((least = others < least ? others : least), ...);
    ((greatest = others > greatest ? others : greatest), ...);
    // An l that is not a number is not above the least and not below the greatest; the predicates
    // on finite sites make no other than inf - inf, of which inf itself is a summand: l is inf.
    return least >= 0x1p-120 && greatest <= 0x1p120;
}

/// NaN for a negative number, without a word to errno.
[[nodiscard]] inline double square_root(double value) noexcept {
#if defined(__SSE2__)
    const __m128d number = _mm_set_sd(value);
    return _mm_cvtsd_f64(_mm_sqrt_sd(number, number));
#else
    return __builtin_sqrt(value);
#endif
}
[[nodiscard]] inline float square_root(float value) noexcept {
#if defined(__SSE2__)
    return _mm_cvtss_f32(_mm_sqrt_ss(_mm_set_ss(value)));
#else
    return __builtin_sqrtf(value);
#endif
}

[[nodiscard]] inline Verdict sign(double value, double bound) noexcept {
    if (magnitude(value) > bound) [[likely]]
        return Verdict::certain(filters::sign_of_nonzero(value));
    return Verdict::uncertain();
}

// ---- the counts --------------------------------------------------------------------------------

namespace count {
using filters::RoundingCount;
inline constexpr RoundingCount d = filters::rounded_difference;
inline constexpr RoundingCount p = (d * d + d * d) - d * d;
inline constexpr RoundingCount e = d * d - d * d;
inline constexpr RoundingCount e_p = d * p - d * p;
inline constexpr RoundingCount q = (e * e + e * e) - e * e;
inline constexpr RoundingCount twice_ab = e_p * e + e_p * e;
inline constexpr RoundingCount gamma = p * p * p;
inline constexpr RoundingCount a = (d * twice_ab + d * twice_ab) + (d * twice_ab - p * q);
inline constexpr RoundingCount l = (d * e - d * e) + d * e;
static_assert(p.roundings == 5 && e.roundings == 4 && q.roundings == 11);
static_assert(twice_ab.roundings == 14 && gamma.roundings == 17);
static_assert(a.roundings == 19 && l.roundings == 8);
inline constexpr RoundingCount t = d * (d * d + d * d) - d * (d * d + d * d);
static_assert(t.roundings == 7);
inline constexpr RoundingCount middle = e * ((p - p) - p);
static_assert((middle * q - middle * q).roundings == 25);
}  // namespace count

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

    TripleOf(const Site& i, const Site& site_j, const Site& site_k) noexcept
        : j(site_j, i),
          k(site_k, i),
          jk(site_k, site_j),
          xy(j.x * k.y - j.y * k.x),
          xr(j.x * k.r - j.r * k.x),
          yr(j.y * k.r - j.r * k.y),
          q((xr * xr + yr * yr) - xy * xy),
          l_jk(j.l * k.l) {}

    [[nodiscard]] bool in_window() const noexcept { return filter::in_window(j.l, k.l, jk.l); }
    [[nodiscard]] Number xp() const noexcept { return j.x * k.p - j.p * k.x; }
    [[nodiscard]] Number yp() const noexcept { return j.y * k.p - j.p * k.y; }
    [[nodiscard]] Number rp() const noexcept { return j.r * k.p - j.p * k.r; }

    /// Whether no site hides another: +1 or -1.
    [[nodiscard]] Verdict apart() const noexcept;

    /// The sign of 2ab: 14 roundings of at most (l_j l_k)² (l_j + l_k).
    [[nodiscard]] Verdict sign_of_twice_ab() const noexcept {
        return sign(xp() * xr + yp() * yr, 17 * epsilon * (l_jk * l_jk) * (j.l + k.l));
    }
    /// The sign of Q: 11 roundings of at most (l_j l_k)².
    [[nodiscard]] Verdict sign_of_q() const noexcept {
        return sign(q, 13 * epsilon * (l_jk * l_jk));
    }
};
using Triple = TripleOf<double>;

/// The sign of p, of 5 roundings of at most l².
[[nodiscard]] inline Verdict sign_of_power(const Difference& m) noexcept {
    return sign(m.p, 7 * epsilon * (m.l * m.l));
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
    return hides(Difference(q, m));
}

/// Whether a circle touches i, j, k counterclockwise: +1 or -1.
[[nodiscard]] inline Verdict exists(const Site& i, const Site& j, const Site& k) noexcept {
    if (!filters::environment_is_default()) [[unlikely]]
        return Verdict::uncertain();
    const Triple t(i, j, k);
    if (!t.in_window()) [[unlikely]]
        return Verdict::uncertain();
    const Verdict apart = t.apart();
    if (!apart.is_certain()) [[unlikely]]
        return apart;
    if (apart.sign() < 0) return apart;
    const Verdict of_q = t.sign_of_q();
    if (!of_q.is_certain()) [[unlikely]]
        return of_q;
    // C: 4 roundings of at most l_j l_k.
    if (of_q.sign() < 0) return sign(t.xy, 5 * epsilon * t.l_jk);
    return t.sign_of_twice_ab();
}

/// Whether a circle touches them counterclockwise and another one clockwise. Almost always Q < 0,
/// where the window is not asked for: E_xr² and so on underflow by less than 2^-1070 (1 + l_j l_k)
/// together, and where a product overflows the bound does.
[[nodiscard]] inline Verdict exists_twice(const Site& i, const Site& j, const Site& k) noexcept {
    const Triple t(i, j, k);
    const double bound = 13 * epsilon * (t.l_jk * t.l_jk) + (0x1p-1000 * t.l_jk + 0x1p-1000);
    if (!filters::environment_is_default()) [[unlikely]]
        return Verdict::uncertain();
    if (t.q < -bound) [[likely]]
        return Verdict::certain(-1);
    if (!(t.q > bound) || !t.in_window()) return Verdict::uncertain();
    const Verdict apart = t.apart();
    if (!apart.is_certain() || apart.sign() < 0) return apart;
    return t.sign_of_twice_ab();
}

/// The sign of C_k e_k Q_q - C_q e_q Q_k: 25 roundings. C and Q are at most l_j l_k and its square,
/// e = p_ij - p_ik - p_jk is at most l_j² + l_k² + l_jk².
[[nodiscard]] inline Verdict precedes(const Site& i, const Site& j, const Site& q,
                                      const Site& k) noexcept {
    if (!filters::environment_is_default()) [[unlikely]]
        return Verdict::uncertain();
    const Triple first(i, j, q);
    const Triple second(i, j, k);
    if (!in_window(first.j.l, first.k.l, first.jk.l, second.k.l, second.jk.l)) [[unlikely]]
        return Verdict::uncertain();
    // Twice the middle of a part, and a bound of its magnitude.
    const auto middle = [](const Triple& t) { return t.xy * ((t.j.p - t.k.p) - t.jk.p); };
    const auto size = [](const Triple& t) {
        return t.l_jk * (t.j.l * t.j.l + t.k.l * t.k.l + t.jk.l * t.jk.l);
    };
    // Neither Q may be 0.
    const Verdict of_first = first.sign_of_q();
    const Verdict of_second = second.sign_of_q();
    if (!of_first.is_certain() || !of_second.is_certain()) [[unlikely]]
        return Verdict::uncertain();
    return sign(
        middle(second) * first.q - middle(first) * second.q,
        29 * epsilon *
            (size(second) * (first.l_jk * first.l_jk) + size(first) * (second.l_jk * second.l_jk)));
}

/// A - L √Γ, where A is put in the order of q's row:
///     A = x_q (E_xy E_yp - E_xr E_rp) - y_q (E_xy E_xp + E_yr E_rp) + r_q [2ab] - p_q Q.
template <class Number>
struct ConflictOf {
    Number l;
    Number root;
    Number difference;

    /// For the row of q relative to i.
    ConflictOf(const TripleOf<Number>& t, const DifferenceOf<Number>& c) noexcept
        : l((c.x * t.yr - c.y * t.xr) + c.r * t.xy), root(square_root(t.j.p * t.k.p * t.jk.p)) {
        const Number xp = t.xp();
        const Number yp = t.yp();
        const Number rp = t.rp();
        const Number a = (c.x * (t.xy * yp - t.xr * rp) - c.y * (t.xy * xp + t.yr * rp)) +
                         (c.r * (xp * t.xr + yp * t.yr) - c.p * t.q);
        difference = a - l * root;
    }
};
using Conflict = ConflictOf<double>;

/// The sign of Q (A - L √Γ). The magnitude of A is at most m = l_q (l_j l_k)² (l_j + l_k + l_q),
/// that of L at most t = l_j l_k l_q, that of Γ at most g² for g = l_j l_k l_jk. The errors:
///     A      19e m
///     L       8e t
///     Γ      17e g², so that the root s of the rounded Γ, as |√a - √b| <= |a - b| / √a, is off by
///            18e g²/s and by its own rounding, e s <= e (1+18e) g²/s: together less than 20e g²/s
///     A - L s    19e m + 8e t s + |L| 20e g²/s, and 2e (|A| + |L| s) for product and difference.
/// Now s <= g(1+9e), and t g <= m since l_jk <= l_j + l_k; so that all is at most
/// (19 + 8 + 2 + 2) e m + 20e |L| g²/s, and some second-order terms. Where s is 0 or not a number
/// neither is the bound smaller than anything.
[[nodiscard]] inline Verdict in_circle_of_visible(const Site& i, const Site& j, const Site& k,
                                                  const Site& q) noexcept {
    if (!filters::environment_is_default()) [[unlikely]]
        return Verdict::uncertain();
    const Triple t(i, j, k);
    const Difference c(q, i);
    if (!in_window(t.j.l, t.k.l, t.jk.l, c.l)) [[unlikely]]
        return Verdict::uncertain();
    const Conflict conflict(t, c);
    const double difference = conflict.difference;
    const double g = t.l_jk * t.jk.l;
    const double m = c.l * (t.l_jk * t.l_jk) * (t.j.l + t.k.l + c.l);
    const double bound = epsilon * (34 * m + 22 * magnitude(conflict.l) * g * (g / conflict.root));
    if (!(magnitude(difference) > bound)) [[unlikely]]
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
        const Verdict hidden = hides(Difference(q, *m));
        if (!hidden.is_certain()) [[unlikely]]
            return hidden;
        if (hidden.sign() > 0) return Verdict::certain(-1);
    }
    return verdict;
}

/// T - √p X with T = z|u|² - s u·w and X = u x w.
template <class Number>
struct InfiniteConflictOf {
    Number root;
    Number cross;
    Number difference;

    InfiniteConflictOf(const DifferenceOf<Number>& u, const DifferenceOf<Number>& w) noexcept
        : root(square_root(u.p)),
          cross(u.x * w.y - u.y * w.x),
          difference((w.r * (u.x * u.x + u.y * u.y) - u.r * (u.x * w.x + u.y * w.y)) -
                     root * cross) {}
};
using InfiniteConflict = InfiniteConflictOf<double>;

/// The sign of T - √p X: T of 7 roundings of at most l_u² l_w, X of 4 roundings of at most l_u l_w.
/// As above the root s of p is off by less than 8e l_u²/s, and s <= l_u(1+3e): (7 + 4 + 4)e l_u²
/// l_w + 8e |X| l_u²/s.
[[nodiscard]] inline Verdict in_circle_infinite(const Site& a, const Site& b,
                                                const Site& q) noexcept {
    if (!filters::environment_is_default()) [[unlikely]]
        return Verdict::uncertain();
    const Difference u(b, a);
    const Difference w(q, a);
    if (!in_window(u.l, w.l)) [[unlikely]]
        return Verdict::uncertain();
    const InfiniteConflict conflict(u, w);
    const double bound = epsilon * (18 * (u.l * u.l * w.l) +
                                    10 * magnitude(conflict.cross) * u.l * (u.l / conflict.root));
    return sign(conflict.difference, bound);
}

/// A square of a distance takes 4 roundings, its root half of that and one more: at most 3e. Where
/// a square underflows, by 2^-1074 at most, the root is off by 2^-537; where it overflows, so does
/// the magnitude.
[[nodiscard]] inline additive::Distance distance(const Point& p, const Site& m) noexcept {
    const double x = p.x - m.x;
    const double y = p.y - m.y;
    const double to_centre = square_root(x * x + y * y);
    return {to_centre, to_centre + 0x1p-440, m.r};
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
    const Sign sign = sign_of(t.q) * sign_of(ConflictOf<Number>(t, Difference(q, i)).difference);
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
    return sign_of(InfiniteConflictOf<Number>(Difference(b, a), Difference(q, a)).difference);
}

template <class Number>
[[nodiscard]] inline Sign exists_twice(const Site& i, const Site& j, const Site& k) noexcept {
    return TripleOf<Number>(i, j, k).q < 0 ? -1 : 0;
}

template <class Number>
[[nodiscard]] inline Sign nearer(const Point& p, const Site& a, const Site& b) noexcept {
    const auto distance = [&p](const Site& m) -> Number {
        const Number x = Number(p.x) - Number(m.x);
        const Number y = Number(p.y) - Number(m.y);
        return square_root(x * x + y * y) - Number(m.r);
    };
    return sign_of(distance(b) - distance(a));
}

}  // namespace rounded

}  // namespace signum::euclidean::filter
