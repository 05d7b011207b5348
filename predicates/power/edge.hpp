#pragma once
/// Comparing two sites along nothing but a point: which of them is nearer in the power metric.

#include <signum/core/sign.hpp>
#include <signum/core/site.hpp>
#include <signum/filters/tally.hpp>
#include <signum/predicates/power/weight.hpp>

namespace signum::power {

/// +1 where the point p is nearer to a than to b, 0 where both are as near, -1 otherwise: the sign
/// of
/// (|p-b|² - w_b) - (|p-a|² - w_a). Exact. Precondition: finite numbers.
[[nodiscard]] Decision nearer_decision(Point p, const Point& a, const Point& b) noexcept;
[[nodiscard]] Decision nearer_decision(Point p, const Site& a, const Site& b) noexcept;
[[nodiscard]] Decision nearer_decision(Point p, const signum::Site& a,
                                       const signum::Site& b) noexcept;

}  // namespace signum::power
