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

/// (h_a t_b - h_b t_a), for any type of number; the caller multiplies by the sign of t_b - t_a.
template <class Number>
[[nodiscard]] constexpr Number in_segment_determinant(const Row<Number>& a, const Row<Number>& b,
                                                      const Number& t_a, const Number& t_b) {
    return ((a.x * a.x + a.y * a.y) - a.weight) * t_b - ((b.x * b.x + b.y * b.y) - b.weight) * t_a;
}

/// The one-dimensional in_circle on the line through a and b.
/// Preconditions: finite numbers, centres of a and b differ, q on the line through them.
[[nodiscard]] Decision in_segment_decision(const Point& a, const Point& b, const Point& q) noexcept;
[[nodiscard]] Decision in_segment_decision(const Site& a, const Site& b, const Site& q) noexcept;
[[nodiscard]] Decision in_segment_decision(const signum::Site& a, const signum::Site& b,
                                           const signum::Site& q) noexcept;

}  // namespace signum::power

SIGNUM_IEEE_END
