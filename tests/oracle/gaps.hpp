#pragma once
/// Brute force for who is near whom among balls in flight: every pair, every image that may matter,
/// in rationals. The gap of two balls is |x_a - x_b| - (r_a + r_b).

#include <optional>
#include <vector>

#include "linear_form.hpp"
#include "motion.hpp"

namespace signum::oracle::motion {

struct Near {
    double time;  // rounded
    int a, b;     // a < b
    double gap;   // at that time, rounded
    bool operator==(const Near&) const = default;
};

/// The closest pair, of equal ones that with the smaller numbers; of a ball, or of all.
/// In a periodic box that of the nearest images.
std::optional<Near> closest(const std::vector<Ball>& balls, const World& world, double time,
                            std::optional<int> of = {});

/// From each time on, right after which another pair is the closest one, which one; from `from`,
/// and before `to`. Strikes are not looked for.
std::vector<Near> closest_list(const std::vector<Ball>& balls, const World& world, double from,
                               double to);

}  // namespace signum::oracle::motion
