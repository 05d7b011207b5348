#pragma once
/// The power predicates in dyadic numbers: the last stage of the exact kernel, and the whole of the
/// multiprecision kernel that judges the others. Right for every finite double, in any environment.

#include "../../core/sign.hpp"
#include "../../core/site.hpp"
#include "weight.hpp"

namespace signum::power::multiprecision {

template <PowerSite S>
[[nodiscard]] Sign in_circle(const S& i, const S& j, const S& k, const S& q) noexcept;
template <PowerSite S>
[[nodiscard]] Sign in_segment(const S& a, const S& b, const S& q) noexcept;
template <PowerSite S>
[[nodiscard]] Sign nearer(Point p, const S& a, const S& b) noexcept;

}  // namespace signum::power::multiprecision
