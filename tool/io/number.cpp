#include <algorithm>
#include <charconv>
#include <cmath>

#include "../../core/contract.hpp"
#include "errors.hpp"
#include "number.hpp"

namespace signum {
namespace {

bool is_hexadecimal_digit(char c) noexcept {
    return is_digit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
}

/// Whether digits, which std::from_chars found outside the range of a double, are above it (true)
/// or below: whether the first digit that is not 0 stands, with the exponent, before the point.
bool is_large(std::string_view digits, bool hexadecimal) noexcept {
    constexpr std::int64_t huge = std::int64_t{1} << 60;
    const std::size_t mark = digits.find_first_of(hexadecimal ? "pP" : "eE");
    const std::string_view mantissa = digits.substr(0, mark);
    const std::size_t point = std::min(mantissa.find('.'), mantissa.size());
    const std::size_t first = mantissa.find_first_not_of("0.");
    std::int64_t place = static_cast<std::int64_t>(point) - static_cast<std::int64_t>(first);
    if (hexadecimal) place *= 4;
    std::int64_t exponent = 0;
    if (mark != std::string_view::npos) {
        std::string_view text = digits.substr(mark + 1);
        const bool negative = text.starts_with('-');
        if (negative || text.starts_with('+')) text.remove_prefix(1);
        const auto result = std::from_chars(text.data(), text.data() + text.size(), exponent);
        if (result.ec != std::errc{} || exponent > huge) exponent = huge;
        if (negative) exponent = -exponent;
    }
    return place + exponent > 0;
}

}  // namespace

Number parse_number(std::string_view text) noexcept {
    constexpr Number word = {0.0, NumberFault::word};
    std::string_view digits = text;
    const bool negative = digits.starts_with('-');
    if (negative || digits.starts_with('+')) digits.remove_prefix(1);
    const bool hexadecimal = digits.starts_with("0x") || digits.starts_with("0X");
    if (hexadecimal) digits.remove_prefix(2);
    if (digits.empty() || digits.front() == '-') return word;
    if (hexadecimal && !is_hexadecimal_digit(digits.front()) && digits.front() != '.') return word;
    // libstdc++ 12 reads the exponent of a hexadecimal number as an integer with a sign of its own.
    if (digits.find("+-") != std::string_view::npos) return word;

    double value = 0.0;
    const char* end = digits.data() + digits.size();
    const auto result =
        std::from_chars(digits.data(), end, value,
                        hexadecimal ? std::chars_format::hex : std::chars_format::general);
    if (result.ptr != end || result.ec == std::errc::invalid_argument) return word;
    if (result.ec == std::errc::result_out_of_range) {
        if (is_large(digits, hexadecimal)) return {0.0, NumberFault::out_of_range};
        value = 0.0;
    }
    if (!std::isfinite(value)) return {0.0, NumberFault::not_finite};
    return {negative ? -value : value, NumberFault::none};
}

std::optional<std::uint64_t> parse_whole_number(std::string_view text) noexcept {
    std::uint64_t value = 0;
    const char* end = text.data() + text.size();
    const auto result = std::from_chars(text.data(), end, value);
    if (result.ec != std::errc{} || result.ptr != end) return std::nullopt;
    return value;
}

namespace {

bool is_number_but_for_a_comma(std::string_view text) {
    std::string pointed(text);
    const std::size_t comma = pointed.find(',');
    if (comma == std::string::npos) return false;
    pointed[comma] = '.';
    return parse_number(pointed).fault == NumberFault::none;
}

}  // namespace

std::string explain(NumberFault fault, std::string_view text) {
    SIGNUM_EXPECTS(fault != NumberFault::none);
    switch (fault) {
        case NumberFault::not_finite:
            return in_quotes(text) + " is not a finite number; write a finite one";
        case NumberFault::out_of_range:
            return in_quotes(text) +
                   " is beyond the range of a double; the largest is about 1.797e308";
        default:
            if (is_number_but_for_a_comma(text))
                return in_quotes(text) + " has a decimal comma; write a point in its place";
            return in_quotes(text) +
                   " is not a number; write a decimal or hexadecimal float, such as 1.5, -2e-3 or "
                   "0x1.8p-3";
    }
}

}  // namespace signum
