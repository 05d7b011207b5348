#pragma once
/// What the filters behind the inlined ones compare: the rounded number, and the magnitude itself
/// for a bound. For sources only.

#include "../../filters/bounds.hpp"
#include "../../filters/rounding_count.hpp"
#include "edge.hpp"
#include "in_circle.hpp"
#include "infinite.hpp"

namespace signum::power {

/// The determinant with every operand replaced by its absolute value, every difference by a sum.
template <class Number>
[[nodiscard]] constexpr Number determinant_magnitude(const Row<Number>& a, const Row<Number>& b,
                                                     const Row<Number>& c) noexcept {
    using filters::magnitude;
    const auto absolute = [](const Row<Number>& row) {
        return Row<Number>{magnitude(row.x), magnitude(row.y), magnitude(row.weight)};
    };
    const Row<Number> i = absolute(a);
    const Row<Number> j = absolute(b);
    const Row<Number> k = absolute(c);
    return (i.x * i.x + i.y * i.y + i.weight) * (j.x * k.y + k.x * j.y) +
           (j.x * j.x + j.y * j.y + j.weight) * (k.x * i.y + i.x * k.y) +
           (k.x * k.x + k.y * k.y + k.weight) * (i.x * j.y + j.x * i.y);
}

/// Inside the window nothing under- or overflows; the same below.
template <class Number>
[[nodiscard]] constexpr filters::Compared<Number> compared_in_circle_finely(
    const Row<Number>& a, const Row<Number>& b, const Row<Number>& c) noexcept {
    return {in_circle_determinant(a, b, c), in_circle_error * determinant_magnitude(a, b, c)};
}

/// The error of the rounded determinant as a multiple of its magnitude: (1+e)^8 - 1 by the lemma,
/// one more e for second-order terms and the roundings of the bound.
inline constexpr double in_segment_error = 9 * filters::epsilon;
static_assert(in_segment_determinant(rounded_row, rounded_row, filters::rounded_difference,
                                     filters::rounded_difference)
                  .roundings == 8);

template <class Number>
[[nodiscard]] constexpr filters::Compared<Number> compared_in_segment(const Row<Number>& a,
                                                                      const Row<Number>& b,
                                                                      const Number& t_a,
                                                                      const Number& t_b) noexcept {
    using filters::magnitude;
    const Number a_square = a.x * a.x + a.y * a.y;
    const Number b_square = b.x * b.x + b.y * b.y;
    return {in_segment_determinant(a, b, t_a, t_b),
            in_segment_error * ((a_square + magnitude(a.weight)) * magnitude(t_b) +
                                (b_square + magnitude(b.weight)) * magnitude(t_a))};
}

/// The error of the rounded difference as a multiple of its magnitude: (1+e)^6 - 1 by the lemma,
/// one more e for second-order terms and the roundings of the bound.
inline constexpr double nearer_in_plane_error = 7 * filters::epsilon;
static_assert(nearer_difference<filters::RoundingCount>(Point{}, signum::Site{}, signum::Site{})
                  .roundings == 6);

template <class Number, PowerSite S>
[[nodiscard]] constexpr filters::Compared<Number> compared_nearer(const Point& p, const S& a,
                                                                  const S& b) noexcept {
    using filters::magnitude;
    const Number ax = Number(p.x) - Number(a.x);
    const Number ay = Number(p.y) - Number(a.y);
    const Number bx = Number(p.x) - Number(b.x);
    const Number by = Number(p.y) - Number(b.y);
    const Number size =
        (ax * ax + ay * ay) + (bx * bx + by * by) + magnitude(weight_difference<Number>(a, b));
    return {nearer_difference<Number>(p, a, b), nearer_in_plane_error * size};
}

}  // namespace signum::power
