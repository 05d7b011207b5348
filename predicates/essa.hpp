#pragma once
/// ccw by the exact sign of a sum (ESSA): the whole of the sum kernel, and what stands behind the
/// intervals of the interval kernel. Source: Gavrilova 1998, section 4.7.2.

#include "../core/site.hpp"
#include "../filters/tally.hpp"

namespace signum::essa {

/// The orientation of three points, in any floating-point environment; in rationals where a product
/// could over- or underflow. Precondition: finite coordinates.
[[nodiscard]] Decision ccw(Point a, Point b, Point c) noexcept;

}  // namespace signum::essa
