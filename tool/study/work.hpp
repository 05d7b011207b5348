#pragma once
/// The kinds of work of a cell, a source each. For the sources of study/.

#include <chrono>
#include <vector>

#include "measure.hpp"
#include "plan.hpp"
#include "rows.hpp"

namespace signum::study {

[[nodiscard]] std::vector<Row> measure_construction(const Cell& cell, const Pass& pass);
[[nodiscard]] std::vector<Row> measure_deletion(const Cell& cell, const Pass& pass);
[[nodiscard]] std::vector<Row> measure_stage_cost(const Cell& cell, const Pass& pass);
[[nodiscard]] std::vector<Row> measure_first_error(const Cell& cell);
[[nodiscard]] std::vector<Row> measure_margin(const Cell& cell);

/// A number that is not measured, but counted.
[[nodiscard]] inline Interval exactly(double value) {
    return {value, value, value, 1};
}

/// The contestants take turns, from pass to pass in another order.
template <class AnyCell>
[[nodiscard]] Race race_of(const std::vector<Contestant>& contestants, const AnyCell& cell,
                           const Pass& pass) {
    return race(contestants, cell.budget, pass.number % 2 == 0);
}

/// The seconds that a piece of work takes.
template <class F>
[[nodiscard]] double seconds_of(const F& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace signum::study
