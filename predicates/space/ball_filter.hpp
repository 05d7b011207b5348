#pragma once
/// The filters of the predicates of balls: the polynomials of formulas/balls.hpp in plain
/// doubles, each with a bound on its error. For sources only.
///
/// The bounds. For two balls let l be the sum of the magnitudes of their rounded differences in
/// centre and radius. Of the terms of the minors of d rows, p left out, each takes one number from
/// each row, and no two the same: the minors E are together at most n = Π l, those with p at most
/// n Σ l, since |p| <= l²; and with a row of q at most n l_q and n l_q (Σ l + l_q). Where every
/// operation commits a relative error of at most e, a polynomial of at most k roundings on the way
/// from input to result is off by at most ((1+e)^k - 1) times this (the lemma of
/// filters/rounding_count.hpp). The k are counted by machine; three more units, or so, pay for
/// terms in e² and for the roundings of the bound itself.
///
/// 4Γ is in space -(a² + b² + c² - 2ab - 2ac - 2bc), evaluated with 6bc at most, for products a, b,
/// c of the p of two opposite edges: at most (√a + √b + √c)^4, where √a stands for the product of
/// the two l. In the plane it is 4 l² l² l² at most. Let g be the root of this.
///
/// The window. All l lie in [2^-80, 2^80]; no product has more than twelve factors l, below 2^978
/// with all its constants: nothing overflows. Underflow costs a product at most 2^-1074, at a place
/// where up to eight l that bound it multiply to 2^-640 or more; nothing beside e. What is below
/// 2^-1000 at the end is uncertain.
///
/// No root is taken of a negative number: in the window no flag is raised but those of inexact and
/// tiny results.

#include <algorithm>
#include <array>
#include <cstddef>

#include "../../core/site.hpp"
#include "../../filters/bounds.hpp"
#include "../../filters/rounding_count.hpp"
#include "../../filters/verdict.hpp"
#include "../euclidean/filter.hpp"
#include "../formulas/balls.hpp"

SIGNUM_IEEE_BEGIN

namespace signum::euclidean::balls::filter {

using euclidean::filter::root_of_positive;
using filters::epsilon;
using filters::magnitude;
using filters::RoundingCount;
using filters::Verdict;

[[nodiscard, gnu::always_inline]] inline Ball<2, double> pinned(const Site& s) noexcept {
    const Site site = filters::pinned(s);
    return {site.x, site.y, site.r};
}
[[nodiscard, gnu::always_inline]] inline Ball<3, double> pinned(const Site3& s) noexcept {
    const Site3 site = filters::pinned(s);
    return {site.x, site.y, site.z, site.r};
}

/// How many roundings the polynomials commit at most.
template <std::size_t d>
struct Roundings {
    int p, e_r, q, b, four_gamma, a, l;

    constexpr Roundings() {
        const std::array<Ball<d, RoundingCount>, d + 1> balls{};
        const Tuple<d, RoundingCount> t(balls);
        const Row<d, RoundingCount>& row = t.rows[0];
        const WithQuery<d, RoundingCount> with_q(t.e, row);
        p = row[d + 1].roundings;
        e_r = t.e_r().roundings;
        q = t.q().roundings;
        b = t.b().roundings;
        const auto between = rows_between<d, RoundingCount>(balls);
        four_gamma = balls::four_gamma<d, RoundingCount>(t.rows, between).roundings;
        a = minus_a<RoundingCount, d, RoundingCount>(t, with_q).roundings;
        l = balls::l<d, RoundingCount>(with_q).roundings;
    }
};
template <std::size_t d>
inline constexpr Roundings<d> roundings;
static_assert(roundings<3>.p == 6 && roundings<3>.e_r == 8 && roundings<3>.q == 20 &&
              roundings<3>.b == 24 && roundings<3>.four_gamma == 32 && roundings<3>.a == 30 &&
              roundings<3>.l == 13);

/// l
template <std::size_t d>
[[nodiscard]] inline double size_of(const Row<d, double>& row) noexcept {
    double sum = magnitude(row[0]);
    for (std::size_t k = 1; k <= d; ++k) sum += magnitude(row[k]);
    return sum;
}

/// The l of the rows.
template <std::size_t d, std::size_t n>
[[nodiscard]] inline std::array<double, n> sizes_of(
    const std::array<Row<d, double>, n>& rows) noexcept {
    std::array<double, n> sizes;
    for (std::size_t m = 0; m < n; ++m) sizes[m] = size_of<d>(rows[m]);
    return sizes;
}

/// g, of the l of the rows to the first ball and those between the others.
[[nodiscard]] inline double root_of_gamma_size(const std::array<double, 2>& to,
                                               const std::array<double, 1>& between) noexcept {
    return 2.0 * to[0] * to[1] * between[0];
}
[[nodiscard]] inline double root_of_gamma_size(const std::array<double, 3>& to,
                                               const std::array<double, 3>& between) noexcept {
    const double sum = to[0] * between[2] + to[1] * between[1] + to[2] * between[0];
    return sum * sum;
}

/// Neither a NaN nor an infinity lies in the window: a sum of magnitudes is a NaN only where a
/// difference is, which those of finite doubles are not.
class Window {
 public:
    template <std::size_t n>
    [[gnu::always_inline]] void take(const std::array<double, n>& sizes) noexcept {
        for (const double size : sizes) {
            least_ = size < least_ ? size : least_;
            greatest_ = size > greatest_ ? size : greatest_;
        }
    }
    [[nodiscard]] bool holds_all() const noexcept {
        return least_ >= 0x1p-80 && greatest_ <= 0x1p80;
    }

 private:
    double least_ = 1.0;
    double greatest_ = 1.0;
};

[[nodiscard]] inline Verdict sign(double value, double bound) noexcept {
    if (magnitude(value) > bound) [[likely]]
        return Verdict::certain(filters::sign_of_nonzero(value));
    return Verdict::uncertain();
}

/// The sign of p.
template <std::size_t d>
[[nodiscard]] inline Verdict sign_of_power(const Row<d, double>& row, double size) noexcept {
    return sign(row[d + 1], (roundings<d>.p + 2) * epsilon * (size * size));
}

/// Whether i hides q, from q's row relative to i: +1 or -1.
template <std::size_t d>
[[nodiscard]] inline Verdict hides(const Row<d, double>& q, double size) noexcept {
    // To nearest no difference underflows, so that its sign is that of r_q - r_i.
    if (q[d] > 0.0) return Verdict::certain(-1);
    if (!(size >= 0x1p-80 && size <= 0x1p80)) [[unlikely]]
        return Verdict::uncertain();
    const Verdict of_power = sign_of_power<d>(q, size);
    return of_power.is_certain() ? Verdict::certain(-of_power.sign()) : of_power;
}
template <std::size_t d, class S>
[[nodiscard]] inline Verdict hides(const S& i, const S& q) noexcept {
    if (!filters::environment_is_default()) [[unlikely]]
        return Verdict::uncertain();
    const Row<d, double> row = balls::row<d, double>(pinned(q), pinned(i));
    return hides<d>(row, size_of<d>(row));
}

/// Whether a sphere touches the balls, its points of contact positively oriented: +1 or -1.
template <std::size_t d, class... S>
[[nodiscard, gnu::flatten]] inline Verdict exists(const S&... sites) noexcept {
    constexpr const Roundings<d>& counted = roundings<d>;
    if (!filters::environment_is_default()) [[unlikely]]
        return Verdict::uncertain();
    const std::array<Ball<d, double>, d + 1> balls{pinned(sites)...};
    const Tuple<d, double> t(balls);
    const auto between = rows_between<d, double>(balls);
    const auto sizes = sizes_of<d>(t.rows);
    const auto sizes_between = sizes_of<d>(between);
    Window window;
    window.take(sizes);
    window.take(sizes_between);
    if (!window.holds_all()) [[unlikely]]
        return Verdict::uncertain();

    bool apart = true;
    bool certain = true;
    for (std::size_t m = 0; m < d; ++m) {
        certain &= sign_of_power<d>(t.rows[m], sizes[m]).is_certain();
        apart &= t.rows[m][d + 1] > 0.0;
    }
    if (!certain) [[unlikely]]
        return Verdict::uncertain();
    if (!apart) return Verdict::certain(-1);

    const double g = root_of_gamma_size(sizes, sizes_between);
    const Verdict of_gamma =
        sign(four_gamma<d, double>(t.rows, between), (counted.four_gamma + 3) * epsilon * (g * g));
    if (!of_gamma.is_certain() || of_gamma.sign() < 0) return of_gamma;
    double n = sizes[0];
    double sum = sizes[0];
    for (std::size_t m = 1; m < d; ++m) {
        n *= sizes[m];
        sum += sizes[m];
    }
    const Verdict of_q = sign(t.q(), (counted.q + 3) * epsilon * (n * n));
    if (!of_q.is_certain()) [[unlikely]]
        return of_q;
    if (of_q.sign() < 0) return sign(t.e_r(), (counted.e_r + 2) * epsilon * n);
    return sign(t.b(), (counted.b + 3) * epsilon * (n * n * sum));
}

/// The sign of Q (2A - L √4Γ), and whether q is hidden. Let s be the rounded root of the rounded
/// 4Γ, m = n² l_q (Σ l + l_q) and t = n l_q. The errors, k being the counted roundings:
///     2A         2 k_A e m, for twice a number commits no rounding
///     L          k_L e t
///     √4Γ        as |√a - √b| <= |a - b| / √a, by k_Γ e g² / s and the root's own rounding, e s,
///                together less than (k_Γ + 2) e g² / s, since s <= g (1 + k_Γ e); the root itself
///                is at most s + √(k_Γ e) g, less than s + 2^-23 g
///     L s        |L| (k_Γ + 2) e g² / s + k_L e t (s + 2^-23 g)
/// and 2e (2m + t s) at most for the product and the difference. All is compared times s, without a
/// division: where s is 0, nothing is certain.
template <std::size_t d, class S, class... Others>
[[nodiscard, gnu::flatten]] inline Verdict in_sphere(const S& query,
                                                     const Others&... sites) noexcept {
    constexpr const Roundings<d>& counted = roundings<d>;
    static_assert(counted.four_gamma <= 32);  // of √(k_Γ e) < 2^-23
    if (!filters::environment_is_default()) [[unlikely]]
        return Verdict::uncertain();
    const std::array<Ball<d, double>, d + 1> balls{pinned(sites)...};
    const Tuple<d, double> t(balls);
    const auto between = rows_between<d, double>(balls);
    const Row<d, double> q = balls::row<d, double>(pinned(query), balls[0]);
    const WithQuery<d, double> with_q(t.e, q);

    const auto sizes = sizes_of<d>(t.rows);
    const auto sizes_between = sizes_of<d>(between);
    const double size = size_of<d>(q);
    Window window;
    window.take(sizes);
    window.take(sizes_between);
    window.take(std::array{size});
    if (!window.holds_all()) [[unlikely]]
        return Verdict::uncertain();

    double n = sizes[0];
    double sum = sizes[0];
    for (std::size_t m = 1; m < d; ++m) {
        n *= sizes[m];
        sum += sizes[m];
    }
    const double g = root_of_gamma_size(sizes, sizes_between);
    const double root = root_of_positive(four_gamma<d, double>(t.rows, between));
    const double a = -minus_a<double, d, double>(t, with_q);
    const double l = balls::l<d, double>(with_q);
    const double difference = (a + a) - l * root;
    const double of_a = (2 * counted.a + 8) * ((n * n) * (size * (sum + size)));
    const double of_l = (counted.l + 5) * (n * size) * (root + 0x1p-23 * g);
    const double of_root = (counted.four_gamma + 5) * magnitude(l) * (g * g);
    const double bound = epsilon * (root * (of_a + of_l) + of_root) + 0x1p-1000;
    if (!(magnitude(difference) * root > bound)) [[unlikely]]
        return Verdict::uncertain();
    const Verdict of_q = sign(t.q(), (counted.q + 3) * epsilon * (n * n));
    if (!of_q.is_certain()) [[unlikely]]
        return of_q;
    if (of_q.sign() != filters::sign_of_nonzero(difference)) return Verdict::certain(-1);
    const Verdict hidden = hides<d>(q, size);
    return hidden.is_certain() ? Verdict::certain(-hidden.sign()) : hidden;
}

}  // namespace signum::euclidean::balls::filter

SIGNUM_IEEE_END
