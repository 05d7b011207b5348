#pragma once
/// The double nearest to a + b√c, for rationals. For sources only.

#include <bit>
#include <cmath>
#include <cstdint>

#include "../core/contract.hpp"
#include "multiprecision.hpp"

namespace signum::exact {

/// a + b√c rounded to the nearest double, halves to even; NaN where that would be an infinity.
/// Precondition: c > 0.
///
/// Why it ends: where the root is irrational, so is the number (b ≠ 0), and no irrational number
/// lies half way between two doubles, at 0 or at the doubles' end. So a narrow enough enclosure
/// contains none of these. Where the root is rational, the number is.
[[nodiscard]] inline double round_surd(const Rational& a, const Rational& b, const Rational& c) {
    SIGNUM_EXPECTS(c > 0);
    if (b.is_zero()) return round_to_double(a);
    // √c = √(numerator · denominator) / denominator
    const Integer denominator = boost::multiprecision::denominator(c);
    const Integer square = boost::multiprecision::numerator(c) * denominator;
    const Rational factor = b / denominator;
    Integer rest;
    const Integer root = sqrt(square, rest);
    if (rest.is_zero()) return round_to_double(Rational(a + factor * root));

    const auto same = [](double x, double y) {
        return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
    };
    for (unsigned bits = 128;; bits *= 2) {
        const Integer below = sqrt(Integer(square << (2 * bits)));
        const Rational unit = factor / (Integer(1) << bits);
        const Rational one = a + unit * below;
        const Rational other = one + unit;
        if (one.sign() != other.sign()) continue;
        const double rounded = round_to_double(one);
        if (same(rounded, round_to_double(other))) return rounded;
    }
}

}  // namespace signum::exact
