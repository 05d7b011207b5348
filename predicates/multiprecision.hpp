#pragma once
/// ccw in dyadic numbers: the last stage of the exact kernel, and the multiprecision kernel's own.

#include "../core/sign.hpp"
#include "../core/site.hpp"

namespace signum::multiprecision {

/// The orientation of three points, for all finite doubles, in any floating-point environment.
[[nodiscard]] Sign ccw(Point a, Point b, Point c) noexcept;

}  // namespace signum::multiprecision
