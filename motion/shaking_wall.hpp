#pragma once
/// When a ball meets a side of the box that shakes, by the rule of meeting_time.hpp.

#include "ball.hpp"
#include "meeting_time.hpp"

namespace signum::motion {

/// A wall across one axis, at level + amplitude · sin(frequency · t + phase): a floor or, with an
/// odd number, a ceiling. F = x - (level + …) - (r + q t), for a ceiling with the first two
/// exchanged.
struct ShakingWall {
    Wall wall = 0;           ///< 2 · axis, 1 more for a ceiling
    double level = 0.0;      ///< where it is at rest
    double amplitude = 0.0;  ///< how far it shakes
    double frequency = 0.0;  ///< in radians per unit of time
    double phase = 0.0;      ///< at t = 0, in radians
};

/// The meeting time, of meetings from the ball's own time and `since` on. Throws std::domain_error
/// where 2048 bits do not tell it, as may be where numbers are a thousand binades apart.
template <int D>
[[nodiscard]] double meeting_time(const GrowingBall<D>& ball, const ShakingWall& wall,
                                  const Effects<D>& effects, double since = -infinity);

/// The same by one look, of a ball that meets the wall at some time near `about`; NaN where that
/// does not tell the double.
template <int D>
[[nodiscard]] double refined_meeting(const GrowingBall<D>& ball, const ShakingWall& wall,
                                     const Effects<D>& effects, double about);

/// How fast the wall moves along the axis, amplitude · frequency · cos(frequency · t + phase): the
/// nearest double. Throws as meeting_time does.
[[nodiscard]] double speed_at(const ShakingWall& wall, double t);
/// How far it is from its level, amplitude · sin(frequency · t + phase), in the same way.
[[nodiscard]] double shift_at(const ShakingWall& wall, double t);

}  // namespace signum::motion
