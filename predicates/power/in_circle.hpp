#pragma once
/// in_circle in the power metric: does site q conflict with the vertex of i, j, k?
///
/// Law: for ccw(i,j,k) > 0 it is the sign of the 3x3 determinant of the rows
///     (x_m - x_q,  y_m - y_q,  (x_m - x_q)² + (y_m - y_q)² - (w_m - w_q)),   m = i, j, k:
/// +1 where q is nearer than the vertex's distance to i, j, k, 0 where it is as near.
/// Source: Gavrilova 1998, Theorem 4.4.1, translated to q.

#include <signum/core/contract.hpp>
#include <signum/core/sign.hpp>
#include <signum/filters/bounds.hpp>
#include <signum/filters/rounding_count.hpp>
#include <signum/filters/tally.hpp>
#include <signum/filters/verdict.hpp>
#include <signum/predicates/ccw.hpp>
#include <signum/predicates/power/weight.hpp>

namespace signum::power {

/// One row of the determinant: a site's centre relative to q, and its weight minus that of q.
template <class Number>
struct Row {
    Number x;
    Number y;
    Number weight;
};

/// The determinant for any type of number.
template <class Number>
[[nodiscard]] constexpr Number in_circle_determinant(const Row<Number>& i, const Row<Number>& j,
                                                     const Row<Number>& k) {
    return ((i.x * i.x + i.y * i.y) - i.weight) * (j.x * k.y - k.x * j.y) +
           ((j.x * j.x + j.y * j.y) - j.weight) * (k.x * i.y - i.x * k.y) +
           ((k.x * k.x + k.y * k.y) - k.weight) * (i.x * j.y - j.x * i.y);
}

template <PowerSite S>
[[nodiscard]] inline Row<double> row(const S& m, const S& q) noexcept {
    return {m.x - q.x, m.y - q.y, weight_difference(m, q)};
}

/// The error of the rounded determinant as a multiple of its magnitude: the lemma of
/// rounding_count.hpp gives (1+e)^12 - 1 < 12e(1 + 12e), and one more e pays for the second-order terms
/// and for the rounded magnitude and bound, together fewer than 30 roundings.
inline constexpr double in_circle_error = 13 * filters::epsilon;
inline constexpr Row<filters::RoundingCount> rounded_row{
    filters::rounded_difference, filters::rounded_difference, rounded_weight_difference};
static_assert(in_circle_determinant(rounded_row, rounded_row, rounded_row).roundings == 12);

/// Decides almost every call. Underflow: each product commits at most 2^-1074 more, so a minor at most
/// 2^-1073, a lifted height (weight included) 3·2^-1074, the determinant at most 2^-1068 (s + 1), where s
/// sums the magnitudes of the lifted heights and the products of coordinates, all below the sum of squares
/// and weights taken here. Overflow gives infinity or NaN in the bound, and the comparison fails.
template <PowerSite S>
[[nodiscard]] inline filters::Verdict in_circle_filter(const S& i, const S& j, const S& k,
                                                       const S& q) noexcept {
    using filters::magnitude;
    const Row<double> a = row(i, q);
    const Row<double> b = row(j, q);
    const Row<double> c = row(k, q);
    const double b_c = b.x * c.y;
    const double c_b = c.x * b.y;
    const double c_a = c.x * a.y;
    const double a_c = a.x * c.y;
    const double a_b = a.x * b.y;
    const double b_a = b.x * a.y;
    const double a_square = a.x * a.x + a.y * a.y;
    const double b_square = b.x * b.x + b.y * b.y;
    const double c_square = c.x * c.x + c.y * c.y;
    const double determinant = (a_square - a.weight) * (b_c - c_b) +
                               (b_square - b.weight) * (c_a - a_c) +
                               (c_square - c.weight) * (a_b - b_a);
    const double a_height = a_square + magnitude(a.weight);
    const double b_height = b_square + magnitude(b.weight);
    const double c_height = c_square + magnitude(c.weight);
    const double bound =
        in_circle_error * (a_height * (magnitude(b_c) + magnitude(c_b)) +
                           b_height * (magnitude(c_a) + magnitude(a_c)) +
                           c_height * (magnitude(a_b) + magnitude(b_a))) +
        0x1p-1000 * (a_height + b_height + c_height + 1.0);
    if (magnitude(determinant) > bound && filters::underflow_is_gradual()) [[likely]]
        return filters::Verdict::certain(filters::sign_of_nonzero(determinant));
    return filters::Verdict::uncertain();
}

/// The stages behind the filter, for the three kinds of sites.
[[nodiscard]] Decision in_circle_cold(const Point& i, const Point& j, const Point& k,
                                      const Point& q) noexcept;
[[nodiscard]] Decision in_circle_cold(const Site& i, const Site& j, const Site& k,
                                      const Site& q) noexcept;
[[nodiscard]] Decision in_circle_cold(const signum::Site& i, const signum::Site& j,
                                      const signum::Site& k, const signum::Site& q) noexcept;

/// The sign of in_circle with the stage that decided.
/// Preconditions: finite numbers, ccw(i,j,k) > 0.
template <PowerSite S>
[[nodiscard]] inline Decision in_circle_decision(const S& i, const S& j, const S& k,
                                                 const S& q) noexcept {
    SIGNUM_EXPECTS(ccw(centre(i), centre(j), centre(k)) > 0);
    const filters::Verdict verdict = in_circle_filter(i, j, k, q);
    if (verdict.is_certain()) [[likely]]
        return {verdict.sign(), Stage::filter};
    return in_circle_cold(i, j, k, q);
}

}  // namespace signum::power
