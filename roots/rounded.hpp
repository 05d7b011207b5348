#pragma once
/// Approximations of polynomials whose coefficients are known exactly. For sources only.

#include <vector>

#include "../exact/polynomial.hpp"
#include "polynomial.hpp"

namespace signum::roots {

/// Integers times powers of two, the i-th times 2^(i step), to the relative precision of a double,
/// all of them times one power of two that brings the greatest near 1.
[[nodiscard]] Approximations rounded(const std::vector<exact::Integer>& c, int step);

/// p(t + s) in the powers of s, times some power of two.
[[nodiscard]] Approximations shifted(const exact::Polynomial& p, double t);

}  // namespace signum::roots
