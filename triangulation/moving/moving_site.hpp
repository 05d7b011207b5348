#pragma once
/// Sites that move on straight lines, or all fall alike.

namespace signum {

/// At time t its centre is (x, y) + (vx, vy)·(t - time), and in a fall g·(t - time)²/2 more; all
/// numbers are doubles and are taken as exact ones. In the power metric r stands for the weight r².
struct MovingSite {
    double x = 0.0;     ///< the first coordinate of the centre at its time
    double y = 0.0;     ///< the second
    double vx = 0.0;    ///< the first coordinate of the velocity
    double vy = 0.0;    ///< the second
    double r = 0.0;     ///< the radius, whose square is the weight
    double time = 0.0;  ///< its own
    friend bool operator==(const MovingSite&, const MovingSite&) = default;
};

/// By how much the velocities of all sites grow in a unit of time.
struct Fall {
    double x = 0.0;  ///< the first coordinate of g
    double y = 0.0;  ///< the second
    friend bool operator==(const Fall&, const Fall&) = default;
};

}  // namespace signum
