#pragma once
/// in_sphere in double-doubles: where they hold it, their rows, the error. For sources only.

#include "../../exact/expansion.hpp"
#include "../../filters/double_double.hpp"
#include "in_sphere.hpp"

namespace signum::power {

using filters::DoubleDouble;

/// Whether terms of degree up to 5 in this number neither over- nor underflow, a weight counting as
/// degree 2; those of its error terms included, for it is a multiple of 2^-202.
[[nodiscard]] inline bool in_window(double number, int degree = 1) noexcept {
    return exact::window::contains(number, 150 * degree);
}
template <PowerSite3 S>
[[nodiscard]] inline bool in_window(const S& s) noexcept {
    bool weight = true;
    if constexpr (requires { s.r; }) weight = in_window(s.r);
    if constexpr (requires { s.w; }) weight = in_window(s.w, 2);
    return weight && in_window(s.x) && in_window(s.y) && in_window(s.z);
}

/// The error of the determinant in double-doubles as a multiple of its magnitude: the lemma of
/// rounding_count.hpp; twice that covers the magnitude, rounded in doubles.
inline constexpr double refined_in_sphere_error = 24 * filters::double_double_epsilon;
inline constexpr LiftedRow<filters::RoundingCount> refined_row{
    {filters::RoundingCount(), filters::RoundingCount(), filters::RoundingCount()},
    filters::RoundingCount::of(1)};
static_assert(in_sphere_determinant(refined_row, refined_row, refined_row, refined_row).roundings <=
              12);
static_assert(refined_in_sphere_error >= 2 * 12 * filters::double_double_epsilon);

template <PowerSite3 S>
[[nodiscard, gnu::always_inline]] inline LiftedRow<DoubleDouble> double_double_row(
    const S& m, const S& q) noexcept {
    LiftedRow<DoubleDouble> row{
        {filters::exact_difference(m.x, q.x), filters::exact_difference(m.y, q.y),
         filters::exact_difference(m.z, q.z)},
        {0.0, 0.0}};
    if constexpr (requires { m.w; }) row.weight = filters::exact_difference(m.w, q.w);
    if constexpr (requires { m.r; })
        row.weight = filters::exact_difference(m.r, q.r) * filters::exact_sum(m.r, q.r);
    return row;
}

}  // namespace signum::power
