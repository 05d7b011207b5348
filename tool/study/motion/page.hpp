#pragma once
/// The page of the study of moving balls. What it says of numbers it computes from them.

#include <vector>

#include "../report.hpp"
#include "setting.hpp"

namespace signum::study {

/// Its figures are yet to be drawn.
[[nodiscard]] Page motion_page(const std::vector<MotionRow>& rows);

}  // namespace signum::study
