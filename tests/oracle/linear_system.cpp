#include "linear_system.hpp"

#include <utility>

namespace signum::oracle {
namespace {

/// row -= factor * other
void subtract(RationalVector& row, const Rational& factor, const RationalVector& other) {
    if (factor.is_zero()) return;
    for (std::size_t k = 0; k < row.size(); ++k) row[k] -= factor * other[k];
}

}  // namespace

std::optional<Flat> solutions(std::vector<RationalVector> rows, std::size_t unknowns) {
    // Column after column is 1 in one row, its pivot, and 0 in the others; columns that are 0 in
    // all rows without a pivot are free.
    std::vector<std::size_t> pivots, free;
    for (std::size_t column = 0; column < unknowns; ++column) {
        const std::size_t top = pivots.size();
        std::size_t found = top;
        while (found < rows.size() && rows[found][column].is_zero()) ++found;
        if (found == rows.size()) {
            free.push_back(column);
            continue;
        }
        std::swap(rows[top], rows[found]);
        const Rational pivot = rows[top][column];
        for (Rational& number : rows[top]) number /= pivot;
        for (std::size_t i = 0; i < rows.size(); ++i)
            if (i != top) subtract(rows[i], Rational(rows[i][column]), rows[top]);
        pivots.push_back(column);
    }
    for (std::size_t i = pivots.size(); i < rows.size(); ++i)
        if (!rows[i][unknowns].is_zero()) return std::nullopt;

    Flat flat{RationalVector(unknowns, 0), {}};
    for (std::size_t i = 0; i < pivots.size(); ++i) flat.point[pivots[i]] = rows[i][unknowns];
    for (const std::size_t column : free) {
        RationalVector direction(unknowns, 0);
        direction[column] = 1;
        for (std::size_t i = 0; i < pivots.size(); ++i) direction[pivots[i]] = -rows[i][column];
        flat.directions.push_back(std::move(direction));
    }
    return flat;
}

Rational determinant(std::vector<RationalVector> rows) {
    Rational product = 1;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        std::size_t pivot = i;
        while (pivot < rows.size() && rows[pivot][i].is_zero()) ++pivot;
        if (pivot == rows.size()) return 0;
        if (pivot != i) std::swap(rows[pivot], rows[i]), product = -product;
        product *= rows[i][i];
        for (std::size_t j = i + 1; j < rows.size(); ++j)
            subtract(rows[j], rows[j][i] / rows[i][i], rows[i]);
    }
    return product;
}

}  // namespace signum::oracle
