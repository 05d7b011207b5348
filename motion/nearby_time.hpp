#pragma once
/// The end of a Newton step that is told to the last bit or not at all.

#include <algorithm>
#include <limits>

#include "../core/error_free.hpp"

namespace signum::motion {

/// The double nearest to about + delta, or the start where that is later; a NaN if it is not the
/// same for all deltas that differ by at most the error.
[[nodiscard, gnu::always_inline]] inline double nearby_time(double about, double delta,
                                                            double error, double start) noexcept {
    const TwoTerms sum = two_sum(about, delta);
    const double time = sum.high + (sum.low - error);
    if (time != sum.high + (sum.low + error)) return std::numeric_limits<double>::quiet_NaN();
    return std::max(time, start);
}

}  // namespace signum::motion
