#pragma once
/// ccw in exact numbers: in rationals the last stage of the exact kernel and the multiprecision
/// kernel's own, in dyadic numbers a judge's.

#include "../core/sign.hpp"
#include "../core/site.hpp"
#include "arithmetic.hpp"

namespace signum::multiprecision {

/// The orientation of three points, for all finite doubles, in any floating-point environment.
template <Arithmetic arithmetic = Arithmetic::multiprecision>
[[nodiscard]] Sign ccw(Point a, Point b, Point c) noexcept;

}  // namespace signum::multiprecision
