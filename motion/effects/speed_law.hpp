#pragma once
/// Restitution that depends on the speed of approach.

#include "../effects.hpp"

namespace signum::motion {

/// max(0, 1 - (1 - e) (v / speed)^power), v >= 0 the speed along the normal. The power is rounded
/// to the nearest double, so that all machines tell the same.
[[nodiscard]] double restitution_at(const SpeedLaw& law, double restitution, double v);

}  // namespace signum::motion
