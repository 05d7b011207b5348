#pragma once
/// Which balls lie in another one. For sources only.

#include <vector>

#include "../../triangulation/arrays.hpp"
#include "set.hpp"

namespace signum::balls {

/// Those that are hidden, rising, each with the visible ball of the smallest number that hides it;
/// of equal balls the first is visible.
[[nodiscard]] std::vector<Hidden> hidden_balls(const BallSet& balls);

}  // namespace signum::balls
