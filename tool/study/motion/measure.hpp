#pragma once
/// A cell of the plan of moving balls, measured once.

#include <vector>

#include "../measure.hpp"
#include "plan.hpp"

namespace signum::study {

/// Runs the cell once; the last row is end_of_cell. What does not change from pass to pass is
/// counted in the first. Quantities:
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
[[nodiscard]] std::vector<MotionRow> measure(const MotionCell& cell, const Pass& pass = {});

}  // namespace signum::study
