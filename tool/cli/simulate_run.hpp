#pragma once
/// A run of signum simulate, from the state at its start to the summary.

#include <string>

#include "../io/motion_state.hpp"

#include "simulate_call.hpp"

namespace signum::cli {

/// Whether -o or a scene's record asks for what is made from frames. Throws CallError where -o says
/// what cannot be.
[[nodiscard]] bool wants_frames(const SimulateCall& call);

/// Where results go, as people are told: names of files, "the log to standard output". Throws as
/// wants_frames().
[[nodiscard]] std::string results_in_words(const SimulateCall& call);

/// Throws what keeps the call from being run, as run_simulation() would before it begins: its files
/// are opened, and nothing stays of them.
template <int D>
void check_simulation(const SimulateCall& call, const MotionState<D>& start);

/// Runs, records and says how it went. Throws CallError where the call does not fit the state, or
/// the clock ends the run, CheckFailure for a collapse, MachineError.
template <int D>
void run_simulation(const SimulateCall& call, const MotionState<D>& start);

}  // namespace signum::cli
