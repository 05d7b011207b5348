#pragma once
/// Radii that grow, to make dense starts from loose ones (Lubachevsky, Stillinger 1990). Flights
/// and strikes of growing balls are those of meeting.hpp and strike.hpp.

#include <cmath>

#include "../../exact/dyadic.hpp"
#include "../ball.hpp"

namespace signum::motion {

/// What a ball's radius has become at a time: the double nearest to it that is not larger, so that
/// balls that touch do not overlap.
template <int D>
[[nodiscard]] double grown_at(const Ball<D>& ball, double t, const Effects<D>& effects) {
    using exact::Dyadic;
    const double rate = growth_of(ball, effects);
    const double about = ball.radius + rate * t;
    const Dyadic exactly = Dyadic(ball.radius) + Dyadic(rate) * Dyadic(t);
    double grown = std::nextafter(about, INFINITY);
    while ((Dyadic(grown) - exactly).sign() > 0) grown = std::nextafter(grown, 0.0);
    return grown;
}

}  // namespace signum::motion
