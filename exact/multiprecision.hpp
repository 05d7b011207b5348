#pragma once
/// Rational numbers of any size, and the exact ways between them and doubles. For sources only:
/// no public header includes this one, for it pulls in Boost and, where the library is built with
/// it, GMP.
///
/// Laws:
///  1. to_rational is exact for every finite double, round_to_double is off by half a unit in the
///     last place at most, halves to even, denormals included and rounded once;
///  2. both compute with integers only: no rounding mode, no flushing of denormals, no global
///  state.

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>

#include "../core/sign.hpp"
#include "numbers.hpp"
#include "parts.hpp"

namespace signum::exact {

/// -1, 0 or +1.
[[nodiscard]] inline Sign sign(const Rational& value) {
    return value.sign();
}

/// The same number. (Rational's own conversion compares with 0.0 and loses denormals where they are
/// flushed.) Precondition: value is finite.
[[nodiscard]] inline Rational to_rational(double value) {
    const auto [significand, exponent, negative] = parts(value);
    Rational result = scaled(significand, exponent);
    if (negative) result.backend().negate();
    return result;
}

/// The nearest double, of two the even one; NaN where that would be an infinity. A number that
/// rounds to 0 keeps its sign.
[[nodiscard]] inline double round_to_double(const Rational& value) {
    constexpr std::uint64_t infinity = std::uint64_t{0x7FF} << 52;
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    if (value.is_zero()) return 0.0;

    // |value| = 2^place · (quotient + remainder / denominator), where the place is the least of a
    // double that leaves the quotient 53 bits. It is found at the first or second trial.
    Integer numerator = abs(boost::multiprecision::numerator(value));
    Integer denominator = boost::multiprecision::denominator(value);
    std::int64_t place =
        std::max<std::int64_t>(bits_of(numerator) - bits_of(denominator) - 53, -1074);
    if (place < 0) numerator <<= -place;
    if (place > 0) denominator <<= place;
    Integer quotient;
    Integer remainder;
    divide_qr(numerator, denominator, quotient, remainder);
    if (quotient >> 53 != 0) {
        ++place;
        denominator <<= 1;
        divide_qr(numerator, denominator, quotient, remainder);
    }
    if (place > 971) return nan;

    auto significand = quotient.convert_to<std::uint64_t>();
    const int half = Integer(2 * remainder).compare(denominator);
    if (half > 0 || (half == 0 && significand % 2 == 1)) ++significand;
    // A significand of 2^52 or more carries into the exponent: just so a denormal has none.
    const std::uint64_t bits = (static_cast<std::uint64_t>(place + 1074) << 52) + significand;
    if (bits >= infinity) return nan;
    return std::bit_cast<double>(bits | std::uint64_t{value.sign() < 0} << 63);
}

}  // namespace signum::exact
