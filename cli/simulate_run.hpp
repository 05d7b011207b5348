#pragma once
/// A run of signum simulate, from the state at its start to the summary.

#include <span>
#include <vector>

#include "../io/motion_state.hpp"

#include "simulate_call.hpp"

namespace signum::cli {

/// Those of -o, and what a scene records that they do not; the log goes to standard output where
/// there is neither. Throws CallError.
[[nodiscard]] std::vector<Target> all_targets(const SimulateCall& call);
/// Whether any of them is made from frames.
[[nodiscard]] bool has_frames(std::span<const Target> targets);

/// Runs, records and says how it went. Throws CallError where the call does not fit the state, or
/// the clock ends the run, CheckFailure for a collapse, MachineError.
template <int D>
void run_simulation(const SimulateCall& call, const MotionState<D>& start);

}  // namespace signum::cli
