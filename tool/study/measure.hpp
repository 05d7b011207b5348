#pragma once
/// A cell of the plan, measured once.

#include <vector>

#include "plan.hpp"
#include "rows.hpp"

namespace signum::study {

/// Which time it is.
struct Pass {
    std::size_t number = 1;  ///< from 1
    /// In a later pass: whether an earlier one found a set on which a contestant broke.
    bool breaks = true;
};

/// Runs the cell once; the last row is end_of_cell. What does not change from pass to pass is
/// counted in the first. Quantities:
///   seconds, ratio          a construction of one set; its time to the first contestant's, where
///                           that builds any
///   broken_percent          sets on which inexact arithmetic lost its way; the others count below
///   edges, in space cells, wrong_percent, different_percent, wrong_or_different_percent
///                           see compare_edges(), compare_cells(); of all sets, the least and
///                           greatest of one
///   ccw, in_circle, ties, swaps, events, hidden, calls_STAGE    means over the sets
///   ns_per_site             deletion
///   ns_per_call             by stage; in space with calls_STAGE and ties of the same calls, as a
///                           construction counts none
///   ns_per_call_forced      rationals, on calls that do not need them
///   first_error             the greatest power of ten that errs as a perturbation; 0 where none
///   does determinants_1eN        the share whose distance from zero, relative, is in [10^N,
///   10^(N+1))
[[nodiscard]] std::vector<Row> measure(const Cell& cell, const Pass& pass = {});

}  // namespace signum::study
