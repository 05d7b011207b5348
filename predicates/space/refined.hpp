#pragma once
/// The error of in_sphere in double-doubles. For sources only.

#include "../../filters/double_double.hpp"
#include "in_sphere.hpp"

namespace signum::power {

/// The error of the determinant in double-doubles as a multiple of its magnitude: the lemma of
/// rounding_count.hpp; twice that covers the magnitude, rounded in doubles.
inline constexpr double refined_in_sphere_error = 24 * filters::double_double_epsilon;
inline constexpr LiftedRow<filters::RoundingCount> refined_row{
    {filters::RoundingCount(), filters::RoundingCount(), filters::RoundingCount()},
    filters::RoundingCount::of(1)};
static_assert(in_sphere_determinant(refined_row, refined_row, refined_row, refined_row).roundings <=
              12);
static_assert(refined_in_sphere_error >= 2 * 12 * filters::double_double_epsilon);

}  // namespace signum::power
