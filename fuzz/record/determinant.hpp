#pragma once
/// Determinants of two to four rows of integers.

#include <array>
#include <cstddef>

#include "integer.hpp"

namespace signum::fuzz {

/// Rows of places of numbers: nothing is copied.
template <std::size_t n>
using Matrix = std::array<std::array<const Integer*, n>, n>;

[[nodiscard]] inline Integer determinant(const Matrix<2>& m) {
    return minor(*m[0][0], *m[0][1], *m[1][0], *m[1][1]);
}
/// Of two rows, in two columns.
template <std::size_t n>
[[nodiscard]] Integer pair_minor(const Matrix<n>& m, std::size_t row, std::size_t a,
                                 std::size_t b) {
    return minor(*m[row][a], *m[row][b], *m[row + 1][a], *m[row + 1][b]);
}
[[nodiscard]] inline Integer determinant(const Matrix<3>& m) {
    Integer sum = *m[0][0] * pair_minor(m, 1, 1, 2);
    sum.subtract_product(*m[0][1], pair_minor(m, 1, 0, 2));
    sum.add_product(*m[0][2], pair_minor(m, 1, 0, 1));
    return sum;
}
/// Laplace: two rows against the two others.
[[nodiscard]] inline Integer determinant(const Matrix<4>& m) {
    Integer sum = pair_minor(m, 0, 0, 1) * pair_minor(m, 2, 2, 3);
    sum.subtract_product(pair_minor(m, 0, 0, 2), pair_minor(m, 2, 1, 3));
    sum.add_product(pair_minor(m, 0, 0, 3), pair_minor(m, 2, 1, 2));
    sum.add_product(pair_minor(m, 0, 1, 2), pair_minor(m, 2, 0, 3));
    sum.subtract_product(pair_minor(m, 0, 1, 3), pair_minor(m, 2, 0, 2));
    sum.add_product(pair_minor(m, 0, 2, 3), pair_minor(m, 2, 0, 1));
    return sum;
}

}  // namespace signum::fuzz
