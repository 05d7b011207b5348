#pragma once
/// Numbers with a bound on their error whose exponents go far beyond those of doubles, for products
/// of several raw doubles. For sources only.

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "bounds.hpp"
#include "verdict.hpp"

namespace signum::filters {

/// A rounded number and how far it may be off.
///
/// Laws, with u = 2^-52:
///  1. An operation rounds by u of its result at most: to the 64 bits of a long double in any mode,
///     and where a system has its registers round to the 53 of a double. The bound adds that to
///     what the operands were off. Its own few roundings are paid by `slack`.
///  2. Where long doubles have 15 bits of exponent, as on x86 and most 64-bit systems, nothing
///     overflows up to the 15th power of a double, nor underflows. Where they are no more than
///     doubles, an overflow makes number or bound infinite or NaN, and `underflow` covers what the
///     product and three products of its bound lose below the least normal number.
struct Wide {
    long double value;
    long double error;

    static constexpr long double u = 0x1p-52L;
    static constexpr long double slack = 1 + 0x1p-40L;
    static constexpr long double underflow = 4 * std::numeric_limits<long double>::min();

    [[nodiscard]] static long double size(long double number) noexcept {
        return number < 0 ? -number : number;
    }
    Wide(long double number, long double bound) noexcept : value(number), error(bound) {}
    /// The number itself.
    explicit Wide(double number) noexcept : value(number), error(0) {}

    /// Certainly above 0.
    [[nodiscard]] bool is_positive() const noexcept { return value > error; }
    [[nodiscard]] Verdict sign() const noexcept {
        if (is_positive()) return Verdict::certain(1);
        return -value > error ? Verdict::certain(-1) : Verdict::uncertain();
    }

    friend Wide operator-(const Wide& a) noexcept { return {-a.value, a.error}; }
    friend Wide operator+(const Wide& a, const Wide& b) noexcept {
        const long double value = a.value + b.value;
        return {value, slack * (a.error + b.error + u * size(value))};
    }
    friend Wide operator-(const Wide& a, const Wide& b) noexcept { return a + -b; }
    friend Wide operator*(const Wide& a, const Wide& b) noexcept {
        const long double value = a.value * b.value;
        return {value, slack * (size(a.value) * b.error + size(b.value) * a.error +
                                a.error * b.error + u * size(value)) +
                           underflow};
    }
};

/// Brings the site of the least coordinates to the place where determinants of differences have
/// their origin; -1 where that turns the sign of a determinant, and else +1.
///
/// Why: differences to a far site lose what tells the others apart, and raw doubles are of all
/// sizes at once. Every other site has a coordinate no smaller than all of this one.
template <class S, std::size_t n>
[[nodiscard]] int base_on_least(std::array<const S*, n>& sites, std::size_t origin) noexcept {
    const auto reach = [](const S* site) {
        double largest = std::max(magnitude(site->x), magnitude(site->y));
        if constexpr (requires { site->z; }) largest = std::max(largest, magnitude(site->z));
        return largest;
    };
    const auto least = std::min_element(
        sites.begin(), sites.end(), [&](const S* a, const S* b) { return reach(a) < reach(b); });
    if (*least == sites[origin]) return 1;
    std::swap(*least, sites[origin]);
    return -1;
}

}  // namespace signum::filters
