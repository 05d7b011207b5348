#include "speed_law.hpp"

#include <algorithm>

#include "../../exact/elementary.hpp"

namespace signum::motion {

double restitution_at(const SpeedLaw& law, double restitution, double v) {
    if (restitution == 1.0) return 1.0;  // also where the power is no double
    const double factor = exact::power(v / law.speed, law.power);
    return std::max(0.0, 1.0 - (1.0 - restitution) * factor);
}

}  // namespace signum::motion
