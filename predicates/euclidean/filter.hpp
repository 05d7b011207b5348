#pragma once
/// The filters of the Euclidean predicates: the polynomials of polynomials.hpp in plain doubles,
/// each with a bound on its error. Included by sources only, which the library compiles without
/// contraction and reassociation.
///
/// The bounds. For two sites let (x, y, r) be their rounded difference and l = |x| + |y| + |r|.
/// Every polynomial here is bounded by products of such l: the products of the coordinates of two
/// rows add up to l_j l_k, and so do the three minors E together; p is at most l², E_xp and E_yp
/// and E_rp together at most l_j l_k (l_j + l_k). Where every operation commits a relative error of
/// at most e, a polynomial of at most n roundings on the way from input to result is off by at most
/// ((1+e)^n - 1) times this product (the lemma of filters/rounding_count.hpp). The counts are given
/// at each bound, checked below by machine; one to three units more pay for terms in e² and for the
/// roundings of the bound itself.
///
/// The window. All l lie in [2^-150, 2^150] (sites that coincide are left to the exact stages). No
/// product has more than six factors l: below 2^900 times a small number, nothing overflows.
/// Underflow costs a product at most 2^-1074, at a place where the l that bound it multiply to
/// 2^-900 or more: 2^-174 of the bound, and some hundred of them less than 2^-160, nothing beside
/// e.

#include <algorithm>

#include <signum/core/sign.hpp>
#include <signum/core/site.hpp>
#include <signum/filters/bounds.hpp>
#include <signum/filters/rounding_count.hpp>
#include <signum/filters/verdict.hpp>

namespace signum::euclidean::filter {

using filters::epsilon;
using filters::magnitude;
using filters::Verdict;

/// A site relative to another.
struct Difference {
    double x;
    double y;
    double r;
    double l;
    double p;

    Difference(const Site& m, const Site& i) noexcept
        : x(m.x - i.x),
          y(m.y - i.y),
          r(m.r - i.r),
          l(magnitude(x) + magnitude(y) + magnitude(r)),
          p((x * x + y * y) - r * r) {}
};

template <class... Size>
[[nodiscard]] inline bool in_window(double first, Size... others) noexcept {
    double least = first;
    double greatest = first;
    ((least = others < least ? others : least), ...);
    ((greatest = others > greatest ? others : greatest), ...);
    // An l that is not a number is not above the least and not below the greatest; the predicates
    // on finite sites make no other than inf - inf, of which inf itself is a summand: l is inf.
    return least >= 0x1p-150 && greatest <= 0x1p150;
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
}  // namespace count

/// What i, j, k alone decide.
struct Triple {
    Difference j;
    Difference k;
    Difference jk;
    double xy;
    double xr;
    double yr;
    double q;
    double l_jk;  // l_j l_k

    Triple(const Site& i, const Site& site_j, const Site& site_k) noexcept
        : j(site_j, i),
          k(site_k, i),
          jk(site_k, site_j),
          xy(j.x * k.y - j.y * k.x),
          xr(j.x * k.r - j.r * k.x),
          yr(j.y * k.r - j.r * k.y),
          q((xr * xr + yr * yr) - xy * xy),
          l_jk(j.l * k.l) {}

    [[nodiscard]] bool in_window() const noexcept { return filter::in_window(j.l, k.l, jk.l); }
    [[nodiscard]] double xp() const noexcept { return j.x * k.p - j.p * k.x; }
    [[nodiscard]] double yp() const noexcept { return j.y * k.p - j.p * k.y; }
    [[nodiscard]] double rp() const noexcept { return j.r * k.p - j.p * k.r; }

    /// The sign of Q: 11 roundings of at most (l_j l_k)².
    [[nodiscard]] Verdict sign_of_q() const noexcept {
        return sign(q, 13 * epsilon * (l_jk * l_jk));
    }
};

/// The sign of p, of 5 roundings of at most l².
[[nodiscard]] inline Verdict sign_of_power(const Difference& m) noexcept {
    return sign(m.p, 7 * epsilon * (m.l * m.l));
}

/// +1 where m hides q, -1 where it does not, in the default environment. Equal sites are out of the
/// window, so that the tie rule changes no certain answer.
[[nodiscard]] inline Verdict hides(const Site& m, const Site& q) noexcept {
    if (q.r > m.r) return Verdict::certain(-1);
    const Difference row(q, m);
    if (!in_window(row.l)) [[unlikely]]
        return Verdict::uncertain();
    const Verdict of_power = sign_of_power(row);
    return of_power.is_certain() ? Verdict::certain(-of_power.sign()) : of_power;
}

/// Whether a circle touches i, j, k counterclockwise: +1 or -1; under the tie rule as without it,
/// for an answer is certain only where neither Q nor a p is 0.
[[nodiscard]] inline Verdict exists(const Site& i, const Site& j, const Site& k) noexcept {
    if (!filters::environment_is_default()) [[unlikely]]
        return Verdict::uncertain();
    const Triple t(i, j, k);
    if (!t.in_window()) [[unlikely]]
        return Verdict::uncertain();
    for (const Difference* m : {&t.j, &t.k, &t.jk}) {
        const Verdict of_power = sign_of_power(*m);
        if (!of_power.is_certain()) [[unlikely]]
            return of_power;
        if (of_power.sign() < 0) return of_power;
    }
    const Verdict of_q = t.sign_of_q();
    if (!of_q.is_certain()) [[unlikely]]
        return of_q;
    // C: 4 roundings of at most l_j l_k.
    if (of_q.sign() < 0) return sign(t.xy, 5 * epsilon * t.l_jk);
    // 2ab: 14 roundings of at most (l_j l_k)² (l_j + l_k).
    const double twice_ab = t.xp() * t.xr + t.yp() * t.yr;
    return sign(twice_ab, 17 * epsilon * (t.l_jk * t.l_jk) * (t.j.l + t.k.l));
}

/// The sign of Q (A - L √Γ), where A is put in the order of q's row:
///     A = x_q (E_xy E_yp - E_xr E_rp) - y_q (E_xy E_xp + E_yr E_rp) + r_q [2ab] - p_q Q.
/// The magnitude of A is at most m = l_q (l_j l_k)² (l_j + l_k + l_q), that of L at most
/// t = l_j l_k l_q, that of Γ at most g² for g = l_j l_k l_jk. The errors:
///     A      19e m
///     L       8e t
///     Γ      17e g², so that the root s of the rounded Γ, as |√a - √b| <= |a - b| / √a, is off by
///            18e g²/s and by its own rounding, e s <= e (1+18e) g²/s: together less than 20e g²/s
///     A - L s    19e m + 8e t s + |L| 20e g²/s, and 2e (|A| + |L| s) for product and difference.
/// Now s <= g(1+9e), and t g <= m since l_jk <= l_j + l_k; so that all is at most
/// (19 + 8 + 2 + 2) e m + 20e |L| g²/s, and some second-order terms. Where s is 0 or not a number
/// neither is the bound smaller than anything.
[[nodiscard]] inline Verdict in_circle(const Site& i, const Site& j, const Site& k,
                                       const Site& q) noexcept {
    if (!filters::environment_is_default()) [[unlikely]]
        return Verdict::uncertain();
    const Triple t(i, j, k);
    const Difference c(q, i);
    if (!in_window(t.j.l, t.k.l, t.jk.l, c.l)) [[unlikely]]
        return Verdict::uncertain();
    const double root = __builtin_sqrt(t.j.p * t.k.p * t.jk.p);
    const double xp = t.xp();
    const double yp = t.yp();
    const double rp = t.rp();
    const double l = (c.x * t.yr - c.y * t.xr) + c.r * t.xy;
    const double a = (c.x * (t.xy * yp - t.xr * rp) - c.y * (t.xy * xp + t.yr * rp)) +
                     (c.r * (xp * t.xr + yp * t.yr) - c.p * t.q);
    const double difference = a - l * root;
    const double g = t.l_jk * t.jk.l;
    const double m = c.l * (t.l_jk * t.l_jk) * (t.j.l + t.k.l + c.l);
    const double bound = epsilon * (34 * m + 22 * magnitude(l) * g * (g / root));
    if (!(magnitude(difference) > bound)) [[unlikely]]
        return Verdict::uncertain();
    const Verdict of_q = t.sign_of_q();
    if (!of_q.is_certain()) [[unlikely]]
        return of_q;
    return Verdict::certain(of_q.sign() * filters::sign_of_nonzero(difference));
}

/// The same under the tie rule, where q may be hidden, which is no conflict. Q is not 0 where the
/// filter is certain, and so the circle exists without the tie rule as well.
[[nodiscard]] inline Verdict in_circle_perturbed(const Site& i, const Site& j, const Site& k,
                                                 const Site& q) noexcept {
    const Verdict verdict = in_circle(i, j, k, q);
    if (!verdict.is_certain() || verdict.sign() < 0) return verdict;
    for (const Site* m : {&i, &j, &k}) {
        const Verdict hidden = hides(*m, q);
        if (!hidden.is_certain()) [[unlikely]]
            return hidden;
        if (hidden.sign() > 0) return Verdict::certain(-1);
    }
    return verdict;
}

/// The sign of T - √p X with T = z|u|² - s u·w, of 7 roundings of at most l_u² l_w, and X = u x w,
/// of 4 roundings of at most l_u l_w. As above the root s of p is off by less than 8e l_u²/s, and
/// s <= l_u(1+3e): (7 + 4 + 4)e l_u² l_w + 8e |X| l_u²/s.
[[nodiscard]] inline Verdict in_circle_infinite(const Site& a, const Site& b,
                                                const Site& q) noexcept {
    if (!filters::environment_is_default()) [[unlikely]]
        return Verdict::uncertain();
    const Difference u(b, a);
    const Difference w(q, a);
    if (!in_window(u.l, w.l)) [[unlikely]]
        return Verdict::uncertain();
    const double root = __builtin_sqrt(u.p);
    const double cross = u.x * w.y - u.y * w.x;
    const double rational = w.r * (u.x * u.x + u.y * u.y) - u.r * (u.x * w.x + u.y * w.y);
    const double bound =
        epsilon * (18 * (u.l * u.l * w.l) + 10 * magnitude(cross) * u.l * (u.l / root));
    return sign(rational - root * cross, bound);
}

/// |p-b| - |p-a| + r_a - r_b. A square of a distance takes 4 roundings, its root half of that and
/// one more: at most 3e of the distance; two further ones for the sums, one for the radii. Where a
/// square underflows, by 2^-1074 at most, the root is off by 2^-537; where it overflows, so does
/// the bound.
[[nodiscard]] inline Verdict nearer(const Point& p, const Site& a, const Site& b) noexcept {
    if (!filters::environment_is_default()) [[unlikely]]
        return Verdict::uncertain();
    const auto distance = [&p](const Site& s) {
        const double x = p.x - s.x;
        const double y = p.y - s.y;
        return __builtin_sqrt(x * x + y * y);
    };
    const double to_a = distance(a);
    const double to_b = distance(b);
    const double radii = a.r - b.r;
    return sign((to_b - to_a) + radii, 7 * epsilon * (to_a + to_b + magnitude(radii)) + 0x1p-500);
}

}  // namespace signum::euclidean::filter
