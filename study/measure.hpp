#pragma once
/// A cell of the plan, measured.

#include <vector>

#include <signum/study/plan.hpp>
#include <signum/study/rows.hpp>

namespace signum::study {

/// Runs the cell; the last row is end_of_cell. Quantities:
///   seconds, ratio          a construction of one set; its time to the first contestant's
///   broken_percent          sets on which inexact arithmetic lost its way; the others count below
///   edges, wrong_percent, different_percent, wrong_or_different_percent
///                           see compare_edges(); of all sets, the least and greatest of one
///   ccw, in_circle, ties, swaps, events, hidden, calls_STAGE    means over the sets
///   ns_per_site             deletion
///   ns_per_call             by stage
///   first_error             the greatest power of ten that errs as a perturbation; 0 where none
///   does determinants_1eN        the share whose distance from zero, relative, is in [10^N,
///   10^(N+1))
[[nodiscard]] std::vector<Row> measure(const Cell& cell);

}  // namespace signum::study
