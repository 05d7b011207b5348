#pragma once
/// The kinds of work of a cell, and what they share. For the sources of study/.

#include <string>
#include <vector>

#include "measure.hpp"

namespace signum::study {

using Measure = std::vector<Row>(const Cell& cell, const Pass& pass);
Measure measure_construction, measure_deletion, measure_stage_cost, measure_first_error,
    measure_margin, measure_structures, measure_rounding, measure_time_steps;

/// A number that is not measured, but counted.
[[nodiscard]] inline Interval exactly(double value) {
    return {value, value, value, 1};
}

/// The contestants take turns, from pass to pass in another order.
[[nodiscard]] inline Race race_of(const std::vector<Contestant>& contestants, const Cell& cell,
                                  const Pass& pass) {
    return race(contestants, cell.budget, pass.number % 2 == 0);
}

}  // namespace signum::study
