#pragma once
/// The double nearest to a number of which only comparisons are known. For sources only.

#include <bit>
#include <cstdint>
#include <limits>
#include <numeric>

#include "dyadic.hpp"

namespace signum::exact {

/// The nearest double, halves to even; an infinity where that is beyond the doubles. compare(x) is
/// the sign of number - x, x a Dyadic; it is asked some 65 times.
///
/// Doubles in their order are consecutive integers, so that halving these finds two neighbours that
/// enclose the number. In their place infinity counts as 2^1024, which is where the next double
/// would be: so what lies half way beyond the largest one goes to infinity.
template <class Compare>
[[nodiscard]] double nearest_double(const Compare& compare) {
    const auto double_of = [](std::int64_t place) {
        return place < 0 ? -std::bit_cast<double>(-place) : std::bit_cast<double>(place);
    };
    constexpr auto beyond = std::bit_cast<std::int64_t>(std::numeric_limits<double>::infinity());
    const auto number_of = [&](std::int64_t place) {
        if (place == beyond) return Dyadic(Integer(1), 1024);
        if (place == -beyond) return Dyadic(Integer(-1), 1024);
        return Dyadic(double_of(place));
    };
    std::int64_t above = beyond;
    std::int64_t below = -beyond;
    if (compare(number_of(above)) >= 0) return double_of(above);
    if (compare(number_of(below)) < 0) return double_of(below);
    while (below + 1 != above) {
        const std::int64_t middle = std::midpoint(below, above);
        (compare(number_of(middle)) >= 0 ? below : above) = middle;
    }
    const Sign half = compare(Dyadic(0.5) * (number_of(below) + number_of(above)));
    return double_of(half < 0 || (half == 0 && below % 2 == 0) ? below : above);
}

}  // namespace signum::exact
