#pragma once
/// Double-doubles that carry a bound on their error: what decides the rounding of most numbers, so
/// that rationals need not. For sources only.

#include <cmath>
#include <limits>
#include <optional>

#include "bounds.hpp"
#include "double_double.hpp"
#include "verdict.hpp"

namespace signum::filters {

/// A number in double-double and a bound on its error.
///
/// Laws:
///  1. The bound covers the errors of the operands and those of the operation, 2^-102 relative
///     (double_double.hpp) and 2^-100 for a quotient and a root; its own roundings, far fewer than
///     100 along any path, are paid by the last factor of `slack`.
///  2. `underflow` covers what products lose under the denormals: one 2^-1075 for each of a
///     product's parts and each part of its bound.
///  3. Where something overflows, value or error is NaN or infinite, and nothing is rounded.
struct Bounded {
    DoubleDouble value;
    double error;

    static constexpr double slack = 0x1.01p0;
    static constexpr double underflow = 0x1p-1070;

    /// Of a double and of a double-double that are exact.
    [[nodiscard]] static Bounded exactly(double value) noexcept { return {{value, 0.0}, 0.0}; }
    [[nodiscard]] static Bounded exactly(const DoubleDouble& value) noexcept {
        return {value, 0.0};
    }

    [[nodiscard]] double size() const noexcept { return magnitude(value.high); }
    [[nodiscard]] Verdict sign() const noexcept {
        return size() * (1.0 - 0x1p-50) > error ? Verdict::certain(sign_of_nonzero(value.high))
                                                : Verdict::uncertain();
    }
    /// Certainly above 0.
    [[nodiscard]] bool is_positive() const noexcept {
        return value.high * (1.0 - 0x1p-50) - error > 0.0;
    }

    friend Bounded operator-(const Bounded& a) noexcept {
        return {{-a.value.high, -a.value.low}, a.error};
    }
    friend Bounded operator+(const Bounded& a, const Bounded& b) noexcept {
        return {a.value + b.value, slack * (a.error + b.error + 0x1p-102 * (a.size() + b.size()))};
    }
    friend Bounded operator-(const Bounded& a, const Bounded& b) noexcept { return a + -b; }
    friend Bounded operator*(const Bounded& a, const Bounded& b) noexcept {
        return {a.value * b.value, slack * (a.error * (b.size() + b.error) + a.size() * b.error +
                                            0x1p-102 * a.size() * b.size()) +
                                       underflow};
    }
    /// Infinite error where the divisor may be 0.
    friend Bounded operator/(const Bounded& a, const Bounded& b) noexcept {
        const double least = b.size() * (1.0 - 0x1p-50) - b.error;
        if (!(least > 0.0)) return {{0.0, 0.0}, std::numeric_limits<double>::infinity()};
        const double first = a.value.high / b.value.high;
        const DoubleDouble rest = a.value - DoubleDouble{first, 0.0} * b.value;
        const TwoTerms sum = two_sum(first, rest.high / b.value.high);
        const double quotient = magnitude(sum.high);
        return {{sum.high, sum.low},
                slack * ((a.error + underflow + quotient * b.error) / least + 0x1p-100 * quotient) +
                    underflow};
    }
    /// Infinite error where the number may be 0 or less. With s the rounded root of the high part,
    /// one step of Newton leaves (rest / 2s)² / 2s, and the rounding of a correction below
    /// 2^-52 s.
    friend Bounded sqrt(const Bounded& a) noexcept {
        const double least = a.value.high * (1.0 - 0x1p-50) - a.error;
        if (!(least > 0.0)) return {{0.0, 0.0}, std::numeric_limits<double>::infinity()};
        const double first = std::sqrt(a.value.high);
        const TwoTerms square = two_product(first, first);
        const double rest = ((a.value.high - square.high) - square.low) + a.value.low;
        const TwoTerms sum = two_sum(first, rest / (2.0 * first));
        return {{sum.high, sum.low},
                slack * ((a.error + underflow) / std::sqrt(least) + 0x1p-100 * sum.high)};
    }

    /// The double nearest to the number, if all that the bound allows rounds to the same.
    [[nodiscard]] std::optional<double> rounded() const noexcept {
        const double below = value.high + (value.low - 2.0 * error);
        const double above = value.high + (value.low + 2.0 * error);
        // The inner sums may err by an ulp of the tail, less than the error again unless that is 0.
        const double size = magnitude(below);
        const bool in_range = 0x1p-900 < size && size <= std::numeric_limits<double>::max();
        if (below != above || !(in_range || (below == 0.0 && error == 0.0))) return std::nullopt;
        return below;
    }
};

}  // namespace signum::filters
