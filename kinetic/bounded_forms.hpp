#pragma once
/// The two determinants that nearly all questions are about, approximately: in plain doubles, with
/// bounds on the errors of all coefficients that take less work than their values. For sources
/// only.
///
/// What is relative to the last site carries its own error, as it may have cancelled. Let all of it
/// be known to a relative error of h, weights to 4 epsilon, and let the determinant's formula
/// round k times (counted by machine). With P_i(s) = X_i + V_i s, where X_i is the larger one of
/// |x| and |y| and V_i of their velocities, and the weight's size W_i,
///     |cross(i, j)| <= 2 P_i P_j,    |height(i)| <= 2 P_i² + W_i,
/// coefficient by coefficient, in the sense of the formula with all signs positive. So an error is
/// at most ((1 + epsilon)^(k + 4) (1 + h)^4 - 1) times the coefficient of
///     sum over i of (2 P_i² + W_i) · 2 P_j P_k,
/// which is less than (4.1 h + 1.01 (k + 4) epsilon) times it as long as h < 2^-10. A site at rest
/// has V = 0, so that a coefficient that is exactly 0 is known to be.
///
/// Underflow: where sizes are 0 or within 2^±200 (weights: 2^±400) what a product of two numbers
/// loses, 2^-1074, is, times the other factors, below 2^-600, and nothing beside an epsilon of any
/// of these coefficients that is not 0: these are above 2^-810.

#include <algorithm>
#include <optional>

#include "../filters/bounds.hpp"
#include "../filters/rounding_count.hpp"
#include "../roots/approximation.hpp"
#include "forms.hpp"

SIGNUM_IEEE_BEGIN

namespace signum::kinetic {

using roots::Approximation;

namespace bounded {

inline constexpr int roundings_of_determinant = [] {
    const Relative<filters::RoundingCount> any;
    int most = 0;
    for (const auto& c : determinant(any, any, any).c) most = std::max(most, c.roundings);
    return most;
}();
inline constexpr int roundings_of_cross = [] {
    const Relative<filters::RoundingCount> any;
    int most = 0;
    for (const auto& c : cross(any, any).c) most = std::max(most, c.roundings);
    return most;
}();

/// A site relative to another one in doubles, their sizes, and how well all of it is known.
struct Rounded {
    Relative<double> values;
    PolynomialIn<double, 1> size;  ///< P
    double weight_size = 0.0;
    double error = 0.0;  ///< h
    bool is_usable = true;

    Rounded(const Placed<Approximation>& m, const Placed<Approximation>& q) {
        const Relative<Approximation> of(m, q);
        for (std::size_t k = 0; k < 2; ++k) {
            values.x.c[k] = of.x.c[k].value;
            values.y.c[k] = of.y.c[k].value;
            size.c[k] = std::max(of.x.c[k].size(), of.y.c[k].size());
            take(size.c[k], std::max(of.x.c[k].error, of.y.c[k].error), 0x1p200);
        }
        values.weight.c[0] = of.weight.c[0].value;
        weight_size = of.weight.c[0].size();
        // A square that has underflown is not 0.
        is_usable &= of.weight.c[0].is_zero() || (weight_size > 0x1p-400 && weight_size < 0x1p400);
    }
    void take(double of_size, double of_error, double most) noexcept {
        if (of_size == 0.0 && of_error == 0.0) return;
        is_usable &= of_size > 1.0 / most && of_size < most;
        error = std::max(error, of_error / of_size);
    }
    /// 2 P² + W.
    [[nodiscard]] PolynomialIn<double, 2> height_size() const {
        const double a = 2.0 * size.c[0];
        const double b = 2.0 * size.c[1];
        return {{a * size.c[0] + weight_size, 2.0 * a * size.c[1], b * size.c[1]}};
    }
};
/// 2 P Q.
[[nodiscard]] inline PolynomialIn<double, 2> cross_size(const Rounded& p, const Rounded& q) {
    const double a = 2.0 * p.size.c[0];
    const double b = 2.0 * p.size.c[1];
    return {{a * q.size.c[0], a * q.size.c[1] + b * q.size.c[0], b * q.size.c[1]}};
}

template <int N>
[[nodiscard]] std::optional<PolynomialIn<Approximation, 4>> with_errors(
    const PolynomialIn<double, N>& value, const PolynomialIn<double, N>& size, double error,
    int roundings) {
    if (!(error < 0x1p-10)) return std::nullopt;
    const double factor = 4.1 * error + 1.01 * (roundings + 4) * filters::epsilon;
    PolynomialIn<Approximation, 4> result;
    for (std::size_t i = 0; i <= N; ++i) result.c[i] = {value.c[i], factor * size.c[i]};
    return result;
}

}  // namespace bounded

/// As in_circle<Approximation>; nothing where sizes are too different, or out of range.
[[nodiscard]] inline std::optional<PolynomialIn<Approximation, 4>> bounded_in_circle(
    const MovingSite& a, const MovingSite& b, const MovingSite& c, const MovingSite& q,
    const Frame& at) {
    using namespace bounded;
    const Placed<Approximation> last(q, at);
    const Rounded i({a, at}, last);
    const Rounded j({b, at}, last);
    const Rounded k({c, at}, last);
    if (!(i.is_usable && j.is_usable && k.is_usable)) return std::nullopt;
    return with_errors(determinant(i.values, j.values, k.values),
                       (i.height_size() * cross_size(j, k) + j.height_size() * cross_size(k, i)) +
                           k.height_size() * cross_size(i, j),
                       std::max({i.error, j.error, k.error}), roundings_of_determinant);
}

/// As orientation<Approximation>.
[[nodiscard]] inline std::optional<PolynomialIn<Approximation, 4>> bounded_orientation(
    const MovingSite& a, const MovingSite& b, const MovingSite& q, const Frame& at) {
    using namespace bounded;
    const Placed<Approximation> last(q, at);
    const Rounded i({a, at}, last);
    const Rounded j({b, at}, last);
    if (!(i.is_usable && j.is_usable)) return std::nullopt;
    return with_errors(cross(i.values, j.values), cross_size(i, j), std::max(i.error, j.error),
                       roundings_of_cross);
}

}  // namespace signum::kinetic

SIGNUM_IEEE_END
