#include "speed_law.hpp"

#include <algorithm>

#include <mpfr.h>

namespace signum::motion {

double restitution_at(const SpeedLaw& law, double restitution, double v) {
    if (restitution == 1.0) return 1.0;  // also where the power is no double
    mpfr_t ratio;
    mpfr_t power;
    mpfr_inits2(53, ratio, power, nullptr);
    mpfr_set_d(ratio, v / law.speed, MPFR_RNDN);
    mpfr_set_d(power, law.power, MPFR_RNDN);
    mpfr_pow(ratio, ratio, power, MPFR_RNDN);
    const double factor = mpfr_get_d(ratio, MPFR_RNDN);
    mpfr_clears(ratio, power, nullptr);
    return std::max(0.0, 1.0 - (1.0 - restitution) * factor);
}

}  // namespace signum::motion
