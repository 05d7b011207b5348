#pragma once
/// The power predicates by the exact sign of a sum (ESSA): the whole of the sum kernel, and what
/// stands behind the intervals of the interval kernel. Right for all finite doubles, in any
/// environment: in dyadic numbers where a product could over- or underflow.
/// Source: Gavrilova 1998, section 4.7.2.

#include "../../core/site.hpp"
#include "../../filters/tally.hpp"
#include "weight.hpp"

namespace signum::power::essa {

/// Preconditions as of power::in_circle, in_segment_decision and nearer.
template <PowerSite S>
[[nodiscard]] Decision in_circle(const S& i, const S& j, const S& k, const S& q) noexcept;
template <PowerSite S>
[[nodiscard]] Decision in_segment(const S& a, const S& b, const S& q) noexcept;
template <PowerSite S>
[[nodiscard]] Decision nearer(Point p, const S& a, const S& b) noexcept;

}  // namespace signum::power::essa
