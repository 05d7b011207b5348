#pragma once
/// The balls of a call as integers: all numbers multiplied by one power of two, weights by its
/// square.

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "../../tool/generate/hard.hpp"
#include "integer.hpp"

namespace signum::fuzz {

using hard::Ball;
using hard::Kind;

/// significand · 2^exponent, the significand odd or 0.
struct Digits {
    std::int64_t significand;
    int exponent;
};
[[nodiscard]] inline Digits digits_of(double number) {
    const auto bits = std::bit_cast<std::uint64_t>(number);
    const auto field = static_cast<int>(bits >> 52 & 0x7FF);
    const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
    const std::uint64_t significand = field == 0 ? fraction : fraction | std::uint64_t{1} << 52;
    if (significand == 0) return {0, 0};
    const int zeros = std::countr_zero(significand);
    const auto odd = static_cast<std::int64_t>(significand >> zeros);
    return {number < 0 ? -odd : odd, (field == 0 ? 1 : field) - 1075 + zeros};
}

/// All numbers are multiples of 2^lowest below 2^(lowest + span).
struct Units {
    int lowest = 0;
    int span = 0;
};
template <std::size_t d, std::size_t n>
[[nodiscard]] Units units_of(const std::array<Ball<d>, n>& balls) {
    int lowest = std::numeric_limits<int>::max();
    int highest = std::numeric_limits<int>::min();
    const auto see = [&](double number) {
        const Digits digits = digits_of(number);
        if (digits.significand == 0) return;
        const std::uint64_t size = static_cast<std::uint64_t>(
            digits.significand < 0 ? -digits.significand : digits.significand);
        lowest = std::min(lowest, digits.exponent);
        highest = std::max(highest, digits.exponent + static_cast<int>(std::bit_width(size)));
    };
    for (const Ball<d>& ball : balls) {
        for (const double x : ball.centre) see(x);
        see(ball.size);
    }
    if (lowest > highest) return {};
    return {lowest, highest - lowest};
}

/// A ball in units of 2^exponent.
template <std::size_t d>
struct Exact {
    std::array<Integer, d> centre;
    Integer size;
};

/// n balls in their common units. Of the weights kind the size is one in the square of the unit; of
/// others a length.
template <std::size_t d, std::size_t n>
struct Scaled {
    std::array<Exact<d>, n> balls;
    int span = 0;  ///< all lengths are below 2^span

    Scaled(Kind kind, const std::array<Ball<d>, n>& given) {
        std::array<Digits, n * d> places;
        std::array<Digits, n> sizes;
        int lowest = std::numeric_limits<int>::max();
        int highest = std::numeric_limits<int>::min();
        const auto see = [&](double number, int degree) {
            const Digits digits = digits_of(number);
            if (digits.significand != 0) {
                const int end = digits.exponent + 54;
                // Rounded down, also of odd negative ones.
                lowest = std::min(lowest, digits.exponent >> (degree - 1));
                highest = std::max(highest, (end >> (degree - 1)) + 1);
            }
            return digits;
        };
        const int degree = kind == Kind::weights ? 2 : 1;
        for (std::size_t m = 0; m < n; ++m) {
            for (std::size_t k = 0; k < d; ++k) places[m * d + k] = see(given[m].centre[k], 1);
            sizes[m] = see(given[m].size, degree);
        }
        if (lowest > highest) return;  // all are 0
        span = highest - lowest;
        const auto integer = [&](const Digits& digits, int unit) {
            return digits.significand == 0
                       ? Integer()
                       : Integer(digits.significand,
                                 static_cast<std::uint64_t>(digits.exponent - unit));
        };
        for (std::size_t m = 0; m < n; ++m) {
            for (std::size_t k = 0; k < d; ++k)
                balls[m].centre[k] = integer(places[m * d + k], lowest);
            balls[m].size = integer(sizes[m], degree * lowest);
        }
    }
};

}  // namespace signum::fuzz
