#pragma once
/// The page of the study of tessellations in space: what accuracy costs there.

#include <vector>

#include "report.hpp"
#include "rows.hpp"

namespace signum::study {

/// The figures of which there are rows, in the order in which they are to be read.
[[nodiscard]] std::vector<Figure> space_figures(const std::vector<Row>& rows);

/// Its figures are yet to be drawn.
[[nodiscard]] Page space_page(const std::vector<Row>& rows);

}  // namespace signum::study
