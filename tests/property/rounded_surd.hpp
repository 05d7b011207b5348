#pragma once
/// Rounding of the oracle's numbers a + b√g, for tests of what the library rounds.

#include <algorithm>
#include <cmath>
#include <limits>

#include "../oracle/surd.hpp"

namespace signum {

/// Whether x is the double nearest to the number, halves to even, an infinity beyond them.
inline bool is_rounded(double x, const oracle::Surd& number) {
    using oracle::Rational;
    using oracle::Surd;
    constexpr double largest = std::numeric_limits<double>::max();
    // The next double after the largest would be 2^1024.
    const auto at = [&](double value) -> Rational {
        if (std::isfinite(value)) return oracle::exactly(value);
        const Rational beyond = 2 * oracle::exactly(0x1p1023);
        return value > 0 ? beyond : Rational(-beyond);
    };
    const double inner = std::isinf(x) ? std::copysign(largest, x) : x;
    const Rational below = (at(std::nextafter(inner, -HUGE_VAL)) + at(inner)) / 2;
    const Rational above = (at(inner) + at(std::nextafter(inner, HUGE_VAL))) / 2;
    if (std::isinf(x)) return x > 0 ? !(number < Surd(above)) : !(Surd(below) < number);
    int exponent = 0;
    const bool even =
        std::fmod(std::ldexp(std::frexp(x, &exponent), std::min(53, exponent + 1074)), 2) == 0;
    return even ? !(number < Surd(below)) && !(Surd(above) < number)
                : Surd(below) < number && number < Surd(above);
}

}  // namespace signum
