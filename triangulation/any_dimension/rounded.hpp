#pragma once
/// The filter of any dimension: determinants in doubles, and what their error can come to.
///
/// A determinant of n columns has n! terms at most, each at most the product of the columns'
/// largest numbers; and so have its minors. By the lemma of filters/rounding_count.hpp it is in
/// error by less than (roundings + 2) e times that: one e more pays for the terms in e², another
/// one for the roundings of the bound itself.
///
/// Underflow: where the largest offset of every column is from 2^-100 to 2^100, a product loses at
/// most 2^-1074 times what else stands in its term, and the bound has, of up to six offsets and a
/// height, at least 2^-52 2^-800 times that. Overflow: below 2^1000 none is near.
///
/// Where no operation rounds a zero is proven, too: all numbers on the way are multiples of a power
/// of the unit, a power of two of which the sites' numbers are multiples (weights of its square),
/// and below 2^53 times it.

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "../../exact/parts.hpp"
#include "../../filters/rounding_count.hpp"
#include "../../filters/verdict.hpp"
#include "determinant.hpp"
#include "sites.hpp"

namespace signum::any_dimension {

/// A determinant in doubles, and the largest numbers of its columns, rounded.
template <std::size_t most>
struct RoundedDeterminant {
    Matrix<double, most> rows{};
    std::array<double, most> largest{};
    std::size_t size = 0;

    void set(std::size_t row, std::size_t column, double value) noexcept {
        rows[row][column] = value;
        largest[column] = std::max(largest[column], filters::magnitude(value));
    }
};

/// The unit that all sites' numbers are multiples of.
class Unit {
 public:
    template <class S>
    explicit Unit(std::span<const S> sites) noexcept {
        int lowest = none;
        for (const S& site : sites) {
            for (std::size_t axis = 0; axis < dimension_of<S>; ++axis)
                lowest = std::min(lowest, last_bit(coordinate(site, axis)));
            const int of_weight = last_bit(power::weight_key(site));
            if constexpr (requires { site.w; })
                lowest = std::min(lowest, (of_weight - (of_weight & 1)) / 2);
            else
                lowest = std::min(lowest, of_weight);
        }
        if (lowest < -100 || lowest > 100) return;
        for (int degree = 0; degree <= most_degree; ++degree)
            exact_below_[static_cast<std::size_t>(degree)] = std::ldexp(1.0, 53 + degree * lowest);
    }
    /// Sums of products of so many offsets, of which a weight counts as two, are exact if the terms
    /// come to less.
    [[nodiscard]] double exact_below(std::size_t degree) const noexcept {
        return exact_below_[degree];
    }

 private:
    static constexpr int none = 2000;
    static constexpr int most_degree = 8;

    /// The exponent of the last bit that is set; large for 0.
    [[nodiscard]] static int last_bit(double number) noexcept {
        const exact::Parts parts = exact::parts(number);
        return parts.significand == 0 ? none : parts.exponent;
    }

    std::array<double, most_degree + 1> exact_below_{};
};

/// The roundings of a determinant of offsets, and of one whose last column are heights in D
/// dimensions.
template <std::size_t most, int D>
[[nodiscard]] constexpr int roundings(std::size_t size, bool has_heights) {
    using filters::RoundingCount;
    Matrix<RoundingCount, most> rows{};
    for (auto& row : rows) row.fill(filters::rounded_difference);
    if (has_heights) {
        const power::SiteOf<D> site;
        // (r - s)(r + s), the weight of most roundings, is three.
        const RoundingCount of_height =
            max(height<RoundingCount>(site, site), RoundingCount::of(3)) + RoundingCount(0.0);
        for (auto& row : rows) row[size - 1] = of_height;
    }
    return determinant(rows, size).roundings;
}
template <std::size_t most, int D, bool has_heights>
inline constexpr auto rounding_table = [] {
    std::array<int, most + 1> table{};
    for (std::size_t size = 1; size <= most; ++size)
        table[size] = roundings<most, D>(size, has_heights);
    return table;
}();
inline constexpr std::array<double, 8> factorials = {1, 1, 2, 6, 24, 120, 720, 5040};

/// The sign, where the filter knows it. Heights, if it has them, are the last column. `further`:
/// the roundings of a number that is more than a difference, beyond one.
template <int D, bool has_heights, std::size_t most>
[[nodiscard]] filters::Verdict rounded_sign(const RoundedDeterminant<most>& of, const Unit& unit,
                                            int further = 0) noexcept {
    static_assert(most < factorials.size() && D + 2 <= 8);
    const std::size_t n = of.size;
    const std::size_t offsets = has_heights ? n - 1 : n;
    double product = factorials[n];
    bool is_in_window = true;
    for (std::size_t column = 0; column < n; ++column) {
        const double largest = of.largest[column];
        // Differences of doubles are 0 only where they are.
        if (column < offsets && largest == 0.0) return filters::Verdict::certain(0);
        is_in_window &= column >= offsets || (largest >= 0x1p-100 && largest <= 0x1p100);
        product *= largest;
    }
    if (!is_in_window || !(product < 0x1p1000)) return filters::Verdict::uncertain();
    const double value = determinant(of.rows, n);
    const double error = (rounding_table<most, D, has_heights>[n] + further + 2) * filters::epsilon;
    if (filters::magnitude(value) > error * product)
        return filters::Verdict::certain(filters::sign_of_nonzero(value));
    // Where radii overflow, a height may be none, which no comparison sees.
    if (value == value && product < unit.exact_below(has_heights ? n + 1 : n))
        return filters::Verdict::certain(sign_of(value));
    return filters::Verdict::uncertain();
}

}  // namespace signum::any_dimension
