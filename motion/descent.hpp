#pragma once
/// The rule of meetings for a gap that is a polynomial. For sources only.

#include "../exact/polynomial.hpp"

namespace signum::motion {

/// The double nearest to the least t >= start at which gap(t) <= 0 and the gap falls right after t;
/// infinity where there is none.
[[nodiscard]] double first_descent(const exact::Polynomial& gap, double start);

}  // namespace signum::motion
