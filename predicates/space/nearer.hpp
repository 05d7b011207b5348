#pragma once
/// Comparing two sites along nothing but a point of space: which of them is nearer in the power
/// metric.

#include "../../filters/tally.hpp"
#include "in_sphere.hpp"

SIGNUM_IEEE_BEGIN

namespace signum::power {

/// +1 where the point p is nearer to a than to b, 0 where both are as near, -1 otherwise: the sign
/// of (|p-b|² - w_b) - (|p-a|² - w_a). Exact. Precondition: finite numbers.
[[nodiscard]] Decision nearer_decision(const Point3& p, const Point3& a, const Point3& b) noexcept;
[[nodiscard]] Decision nearer_decision(const Point3& p, const Site3& a, const Site3& b) noexcept;
[[nodiscard]] Decision nearer_decision(const Point3& p, const signum::Site3& a,
                                       const signum::Site3& b) noexcept;

/// The same number in any arithmetic.
template <class Number, PowerSite3 S>
[[nodiscard]] constexpr Number nearer_difference(const Point3& p, const S& a, const S& b) noexcept {
    const auto square = [&p](const S& s) {
        const Number x = Number(p.x) - Number(s.x);
        const Number y = Number(p.y) - Number(s.y);
        const Number z = Number(p.z) - Number(s.z);
        return x * x + y * y + z * z;
    };
    return (square(b) - square(a)) + weight_difference<Number>(a, b);
}

}  // namespace signum::power

SIGNUM_IEEE_END
