#pragma once
/// The signs of determinants in exact numbers: in integers by Bareiss's elimination for a
/// construction, in dyadic numbers by minors for a judge, so that neither can repeat an error of
/// the other's.

#include <array>
#include <cstddef>

#include "../../exact/dyadic.hpp"
#include "../../exact/multiprecision.hpp"
#include "determinant.hpp"

namespace signum::any_dimension {

/// Of dyadic numbers, which are rationals here. Elimination without fractions (Bareiss 1968): every
/// division leaves no remainder, for what it yields is a minor.
template <std::size_t most>
[[nodiscard]] Sign sign_of_determinant(const Matrix<exact::Rational, most>& rows, std::size_t n) {
    using exact::Integer;
    Matrix<Integer, most> m;
    for (std::size_t i = 0; i < n; ++i) {
        // A row times a power of two, which is positive.
        Integer scale = 1;
        for (std::size_t k = 0; k < n; ++k)
            if (const Integer each = denominator(rows[i][k]); each > scale) scale = each;
        for (std::size_t k = 0; k < n; ++k)
            m[i][k] = numerator(rows[i][k]) * (scale / denominator(rows[i][k]));
    }
    Sign turn = 1;
    Integer previous = 1;
    for (std::size_t step = 0; step < n; ++step) {
        std::size_t pivot = step;
        while (pivot < n && m[pivot][step].is_zero()) ++pivot;
        if (pivot == n) return 0;
        if (pivot != step) {
            std::swap(m[pivot], m[step]);
            turn = -turn;
        }
        for (std::size_t i = step + 1; i < n; ++i)
            for (std::size_t k = step + 1; k < n; ++k)
                m[i][k] = (m[i][k] * m[step][step] - m[i][step] * m[step][k]) / previous;
        previous = m[step][step];
    }
    return turn * previous.sign();
}

template <std::size_t most>
[[nodiscard]] Sign sign_of_determinant(const Matrix<exact::Dyadic, most>& rows, std::size_t n) {
    return determinant(rows, n).sign();
}

}  // namespace signum::any_dimension
