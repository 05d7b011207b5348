#pragma once
/// Where a simulation stands, as a JSON file from which it goes on. An effect that is off is not in
/// it. Version 2; version 1, which is read as well, had a box, gravity and restitution alone.

#include <iosfwd>
#include <string>

#include "../../motion/simulation.hpp"

namespace signum {

/// A state and the effects that it is of.
template <int D>
struct MotionState {
    motion::State<D> state;
    motion::Effects<D> effects;
};

template <int D>
void write_motion_state(std::ostream& out, const MotionState<D>& state);

/// 2 or 3. Throws InputError where the file is no state, MachineError.
[[nodiscard]] int dimension_of_motion_state(const std::string& path);
/// Reads what write_motion_state() wrote, every double the same. Throws InputError, MachineError.
template <int D>
[[nodiscard]] MotionState<D> read_motion_state(const std::string& path);
/// The same, and throws InputError where the state cannot be.
template <int D>
[[nodiscard]] MotionState<D> checked_motion_state(const std::string& path);

}  // namespace signum
