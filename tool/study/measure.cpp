#include "measure.hpp"

#include <array>

#include "work.hpp"

namespace signum::study {

std::vector<Row> measure(const Cell& cell, const Pass& pass) {
    // In the order of the enumerators.
    constexpr std::array works = {measure_construction, measure_deletion,  measure_stage_cost,
                                  measure_first_error,  measure_margin,    measure_structures,
                                  measure_rounding,     measure_time_steps};
    std::vector<Row> rows;
    const double seconds =
        seconds_of([&] { rows = works[static_cast<std::size_t>(cell.work)](cell, pass); });
    rows.push_back({cell.setting, "study", std::string(end_of_cell), exactly(seconds)});
    return rows;
}

}  // namespace signum::study
