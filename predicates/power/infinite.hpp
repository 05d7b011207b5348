#pragma once
/// in_circle in the power metric with one vertex at infinity.
///
/// Law: for the hull edge a -> b (all sites on its left, face (b, a, ∞)) site q conflicts where it
/// lies strictly right of a -> b. On the line through a and b the one-dimensional in_circle
/// decides: with t the coordinate along the line relative to q and h = |m-q|² - w_m + w_q, the sign
/// of (h_a t_b - h_b t_a) (t_b - t_a). Any coordinate that separates a and b serves as t.

#include "../../core/contract.hpp"
#include "../../core/sign.hpp"
#include "../../filters/tally.hpp"
#include "../ccw.hpp"
#include "in_circle.hpp"

SIGNUM_IEEE_BEGIN

namespace signum::power {

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

/// The formula. Any coordinate that separates a and b runs along their line.
/// Preconditions: finite numbers, centres of a and b differ, q on the line through them.
struct InSegment {
    static constexpr int window = 200;

    template <class Number, PowerSite S>
    [[nodiscard, gnu::always_inline]] static constexpr auto value(const S& a, const S& b,
                                                                  const S& q) noexcept {
        const auto determinant = along<Number>(
            a, b, q, [](const auto&... numbers) { return in_segment_determinant(numbers...); });
        return rises(a, b) ? determinant : -determinant;
    }
    template <PowerSite S>
    [[nodiscard]] static filters::Compared<double> bounded(const S& a, const S& b,
                                                           const S& q) noexcept {
        const auto [determinant, bound] = along<double>(
            a, b, q, [](const auto&... numbers) { return compared_in_segment(numbers...); });
        return {rises(a, b) ? determinant : -determinant, bound};
    }
    template <Arithmetic arithmetic, PowerSite S>
    [[nodiscard, gnu::pure]] static Decision behind(const S& a, const S& b, const S& q) noexcept;

 private:
    /// Of the rows of a and b, and of where they are along the line.
    template <class Number, PowerSite S, class Of>
    [[nodiscard, gnu::always_inline]] static constexpr auto along(const S& a, const S& b,
                                                                  const S& q, Of of) noexcept {
        const auto row_a = row<Number>(a, q);
        const auto row_b = row<Number>(b, q);
        return filters::same_number(a.x, b.x) ? of(row_a, row_b, row_a.y, row_b.y)
                                              : of(row_a, row_b, row_a.x, row_b.x);
    }
    /// Whether that rises from a to b.
    template <PowerSite S>
    [[nodiscard, gnu::always_inline]] static bool rises(const S& a, const S& b) noexcept {
        const Sign by_x = filters::compare_numbers(b.x, a.x);
        return (by_x != 0 ? by_x : filters::compare_numbers(b.y, a.y)) > 0;
    }
};

/// The one-dimensional in_circle on the line through a and b.
template <PowerSite S>
[[nodiscard]] inline Decision in_segment_decision(const S& a, const S& b, const S& q) noexcept {
    return predicates::decide<Arithmetic::exact, InSegment>(a, b, q);
}

}  // namespace signum::power

SIGNUM_IEEE_END
