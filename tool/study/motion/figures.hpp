#pragma once
/// The parts of the page of moving balls, in the order in which they are to be read; those without
/// rows are left out. For the sources of study/motion/.

#include <vector>

#include "../figure.hpp"
#include "results.hpp"

namespace signum::study {

/// Structures beside the thesis's tables, and beyond them.
[[nodiscard]] std::vector<Figure> structure_figures(const MotionResults& results);
/// What accuracy costs, what goes wrong without it, and what time steps make of it.
[[nodiscard]] std::vector<Figure> exactness_figures(const MotionResults& results);

}  // namespace signum::study
