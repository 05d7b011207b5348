#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <span>

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

/// The same digits with e where Fortran writes D before the exponent; false where there is none.
bool put_e_for_d(std::string_view digits, std::span<char> copy) noexcept {
    const std::size_t mark = digits.find_first_of("dD");
    if (mark == std::string_view::npos || mark == 0 || digits.size() > copy.size()) return false;
    std::ranges::copy(digits, copy.begin());
    copy[mark] = 'e';
    return true;
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
    const auto read = [&](double& into) {
        return std::from_chars(digits.data(), digits.data() + digits.size(), into,
                               hexadecimal ? std::chars_format::hex : std::chars_format::general);
    };
    double value = 0.0;
    auto result = read(value);
    std::array<char, 64> copy;
    if (!hexadecimal && result.ptr != digits.data() + digits.size() &&
        (*result.ptr == 'd' || *result.ptr == 'D') && put_e_for_d(digits, copy)) {
        digits = {copy.data(), digits.size()};
        result = read(value);
    }
    const char* const end = digits.data() + digits.size();
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

/// Whether three digits each stand between separators of one kind, as in 1,234,567.8.
bool has_thousands(std::string_view text) {
    const std::size_t first = text.find_first_of(",.' _");
    if (first == std::string_view::npos || first == 0 || first > 4) return false;
    const char separator = text[first];
    std::size_t groups = 0;
    std::size_t at = first;
    while (at < text.size() && text[at] == separator) {
        if (at + 4 > text.size() || !std::ranges::all_of(text.substr(at + 1, 3), is_digit))
            return false;
        ++groups;
        at += 4;
    }
    // One group behind a point or a comma is a fraction.
    const bool has_fraction = at < text.size() && (text[at] == '.' || text[at] == ',');
    return groups > 0 && (at == text.size() || has_fraction) &&
           (groups > 1 || has_fraction || separator == '\'' || separator == '_');
}

}  // namespace

std::string explain(NumberFault fault, std::string_view text, char decimal) {
    SIGNUM_EXPECTS(fault != NumberFault::none);
    switch (fault) {
        case NumberFault::not_finite:
            return in_quotes(text) + " is not a finite number; write a finite one";
        case NumberFault::out_of_range:
            return in_quotes(text) +
                   " is beyond the range of a double; the largest is about 1.797e308";
        default:
            if (has_thousands(text))
                return in_quotes(text) + " has separators of thousands; write the digits alone";
            if (decimal != ',' && is_number_but_for_a_comma(text))
                return in_quotes(text) + " has a decimal comma; write a point in its place" +
                       (decimal == '.' ? ", or say --decimal ," : "");
            if (decimal == ',' && text.find('.') != std::string_view::npos)
                return in_quotes(text) + " has a point, and --decimal says that a comma is it";
            if (text.find("\xC2\xB0") != std::string_view::npos)
                return in_quotes(text) +
                       " is in degrees, minutes and seconds, which are not read; write degrees as "
                       "a decimal fraction";
            return in_quotes(text) +
                   " is not a number; write a decimal or hexadecimal float, such as 1.5, -2e-3 or "
                   "0x1.8p-3";
    }
}

}  // namespace signum
