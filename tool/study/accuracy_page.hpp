#pragma once
/// The page of the study of tessellations: what accuracy costs.

#include <vector>

#include "figures.hpp"
#include "picture.hpp"
#include "report.hpp"

namespace signum::study {

/// Its figures are yet to be drawn.
[[nodiscard]] Page accuracy_page(const std::vector<Row>& rows, const Picture& picture);

}  // namespace signum::study
