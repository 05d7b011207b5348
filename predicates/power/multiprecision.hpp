#pragma once
/// The power predicates in exact numbers: in rationals the last stage of the exact kernel and the
/// whole of the multiprecision kernel, in dyadic numbers a judge's. Right for every finite double,
/// in any environment.

#include "../../core/sign.hpp"
#include "../../core/site.hpp"
#include "../arithmetic.hpp"
#include "weight.hpp"

namespace signum::power::multiprecision {

template <Arithmetic arithmetic = Arithmetic::multiprecision, PowerSite S>
[[nodiscard]] Sign in_circle(const S& i, const S& j, const S& k, const S& q) noexcept;
template <Arithmetic arithmetic = Arithmetic::multiprecision, PowerSite S>
[[nodiscard]] Sign in_segment(const S& a, const S& b, const S& q) noexcept;
template <Arithmetic arithmetic = Arithmetic::multiprecision, PowerSite S>
[[nodiscard]] Sign nearer(Point p, const S& a, const S& b) noexcept;

}  // namespace signum::power::multiprecision
