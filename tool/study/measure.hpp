#pragma once
/// A cell of a plan, measured once.

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
///   first_error             the greatest power of ten that errs as a perturbation; 0: none does
///   margin_1eN              the share whose distance from zero, relative, is in [10^N, 10^(N+1))
/// Of balls:
///   seconds                 of a run, with the making of the structure, whose share is
///   start_seconds; of a run that ends after some number of strikes without it
///   seconds_per_strike, ratio   the former by strikes; that to the first contestant's
///   strikes, own, checks, predictions   see motion::Counts
///   digest                  of all bits of the balls in the end
///   chooses_NAME            by contestant auto: 1, the structure that it is
///   first_other_strike, first_other_strike_time
///                           of rounded arithmetic: before which strike, counted from 0, and when
///                           its log tells another pair than the exact one; none where it does not
///   first_other_bits        before which strike its log is another one in any bit
///   overlap, wall_overlap   the deepest of ten times, in least radii
///   lost                    balls whose centre was then outside the box, at most
///   broken_percent          100 where arithmetic lost its way: the run ended by an error, or did
///                           not end
///   strikes_at_T, energy_at_T   means over seeds, low and high a standard deviation below and
///                           above: strikes in the tenth of the time that ends at T; energy then,
///                           height included, of a unit of mass
///   all_strikes, mean_energy    the same of the whole time, low and high a standard error off
[[nodiscard]] std::vector<Row> measure(const Cell& cell, const Pass& pass = {});

}  // namespace signum::study
