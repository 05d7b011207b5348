#pragma once
/// Determinants of a few rows in any arithmetic.

#include <array>
#include <bit>
#include <cstddef>

namespace signum::any_dimension {

template <class Number, std::size_t most>
using Matrix = std::array<std::array<Number, most>, most>;

/// The determinant of the first n rows and columns, without a division: of ever more rows the
/// minors in all sets of columns, n 2^(n-1) products in all. 1 where there is no row.
template <class Number, std::size_t most>
[[nodiscard]] constexpr Number determinant(const Matrix<Number, most>& rows, std::size_t n) {
    if (n == 0) return Number(1.0);
    std::array<Number, std::size_t{1} << most> minors{};
    for (std::size_t columns = 1; columns < std::size_t{1} << n; ++columns) {
        const auto row = static_cast<std::size_t>(std::popcount(columns)) - 1;
        Number sum{};
        // By its last row; of the last column the sign is positive.
        bool is_first = true;
        bool is_positive = true;
        for (std::size_t column = n; column-- > 0;) {
            const std::size_t bit = std::size_t{1} << column;
            if ((columns & bit) == 0) continue;
            const Number& entry = rows[row][column];
            if (row == 0) {
                sum = entry;
            } else if (is_first) {
                sum = entry * minors[columns ^ bit];
            } else {
                const Number term = entry * minors[columns ^ bit];
                sum = is_positive ? sum + term : sum - term;
            }
            is_first = false;
            is_positive = !is_positive;
        }
        minors[columns] = sum;
    }
    return minors[(std::size_t{1} << n) - 1];
}

}  // namespace signum::any_dimension
