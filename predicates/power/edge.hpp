#pragma once
/// Comparing two sites along nothing but a point: which of them is nearer in the power metric.

#include "../../core/sign.hpp"
#include "../../core/site.hpp"
#include "../../filters/tally.hpp"
#include "weight.hpp"

SIGNUM_IEEE_BEGIN

namespace signum::power {

/// +1 where the point p is nearer to a than to b, 0 where both are as near, -1 otherwise: the sign
/// of (|p-b|² - w_b) - (|p-a|² - w_a). Exact. Precondition: finite numbers.
[[nodiscard]] Decision nearer_decision(Point p, const Point& a, const Point& b) noexcept;
[[nodiscard]] Decision nearer_decision(Point p, const Site& a, const Site& b) noexcept;
[[nodiscard]] Decision nearer_decision(Point p, const signum::Site& a,
                                       const signum::Site& b) noexcept;

/// The same number in any arithmetic.
template <class Number, PowerSite S>
[[nodiscard]] constexpr Number nearer_difference(Point p, const S& a, const S& b) noexcept {
    const auto square = [&p](const S& s) {
        const Number x = Number(p.x) - Number(s.x);
        const Number y = Number(p.y) - Number(s.y);
        return x * x + y * y;
    };
    return (square(b) - square(a)) + weight_difference<Number>(a, b);
}

}  // namespace signum::power

SIGNUM_IEEE_END
