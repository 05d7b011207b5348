#pragma once
/// Linear equations in rationals, by elimination.

#include "linear_form.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace signum::oracle {

using RationalVector = std::vector<Rational>;

/// The points p + t_1 d_1 + ... + t_m d_m for all t; the directions d are independent.
struct Flat {
    RationalVector point;
    std::vector<RationalVector> directions;
};

/// All x with sum of row[k] x[k], k < unknowns, equal to row[unknowns], for every row; nothing
/// where there is none.
std::optional<Flat> solutions(std::vector<RationalVector> rows, std::size_t unknowns);

/// Of as many rows as columns.
Rational determinant(std::vector<RationalVector> rows);

}  // namespace signum::oracle
