#pragma once
/// The kinds of work of a cell, a source each. For the sources of study/motion/.

#include <cmath>
#include <map>
#include <vector>

#include "../work.hpp"
#include "measure.hpp"
#include "shaker.hpp"

namespace signum::study {

[[nodiscard]] std::vector<MotionRow> measure_structures(const MotionCell& cell, const Pass& pass);
[[nodiscard]] std::vector<MotionRow> measure_rounding(const MotionCell& cell, const Pass& pass);
[[nodiscard]] std::vector<MotionRow> measure_time_steps(const MotionCell& cell);

/// The shaker of a cell when measuring begins. Made once a program: what is dense takes minutes.
[[nodiscard]] const Shaker& shaker_for(const MotionCell& cell);

}  // namespace signum::study
