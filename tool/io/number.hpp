#pragma once
/// Numbers as people write them, read to the nearest double (halves to even).
///
/// Laws:
///  1. [+-] decimal (1, 1.5, .5, 1e-3, 1D-3) or hexadecimal (0x1.8p-3) and nothing else, in any
///     locale.
///  2. A number too small for a double is read to the nearest one: a denormal or zero.
///  3. A number too large, infinity and NaN are faults.

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace signum {

constexpr bool is_digit(char c) noexcept {
    return c >= '0' && c <= '9';
}

/// Why a text is no number.
enum class NumberFault : std::uint8_t { none, word, not_finite, out_of_range };

/// A finite value, or a fault.
struct Number {
    double value = 0.0;
    NumberFault fault = NumberFault::none;
};

[[nodiscard]] Number parse_number(std::string_view text) noexcept;

/// Digits and nothing else, with a value that fits into 64 bits.
[[nodiscard]] std::optional<std::uint64_t> parse_whole_number(std::string_view text) noexcept;

/// What is wrong with the text, and what would be right, where numbers have that decimal point, or
/// none that somebody may choose. Precondition: fault != none.
[[nodiscard]] std::string explain(NumberFault fault, std::string_view text, char decimal = '\0');

/// Whether a finite number is larger than the largest float, or smaller than the smallest.
constexpr bool is_beyond_single(double value) noexcept {
    constexpr double largest = std::numeric_limits<float>::max();
    return value > largest || value < -largest;
}

}  // namespace signum
