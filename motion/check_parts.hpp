#pragma once
/// Whether the parts of a state fit together. For sources only.

#include "simulation.hpp"

namespace signum::motion {

/// As check(), but for the window of numbers and for room in the box: what tells who is near needs
/// neither.
template <int D>
void check_parts(const State<D>& state, const Effects<D>& effects);

}  // namespace signum::motion
