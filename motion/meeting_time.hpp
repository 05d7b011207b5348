#pragma once
/// When two balls meet, or a ball and an obstacle, for every kind of ball and of obstacle: exactly,
/// and in one stage. The simulation's fast path (meeting.hpp) has a ladder of stages for the
/// commonest kinds; where both have an answer, it is the same double.
///
/// The rule: each meeting has a gap F(t), above 0 where the two are apart and below 0 where they
/// overlap. They meet at the least t >= T, the latest own time, at which F(t) <= 0 and F is
/// strictly decreasing right after t. What is returned is the double nearest to it, halves to even,
/// which is not before T, a double itself; infinity stands for never.
///
/// Radii may grow: at time t the radius is r + q t, where t is counted from 0, not from the ball's
/// own time. All numbers are finite doubles and taken as exact ones.

#include "ball.hpp"
#include "meeting.hpp"
#include "obstacle.hpp"

namespace signum::motion {

template <int D>
/// A ball whose radius may change as time goes on.
struct GrowingBall : Ball<D> {
    /// q; the radius of Ball is r, that at time 0.
    double growth = 0.0;
};

/// Of two balls: F = |D|² - R², R the sum of the radii. In a periodic box it is the least over all
/// images of the other one. Meetings later than `until` are none; it costs time in proportion to
/// the box lengths that they fly until they meet, or until then. Throws std::invalid_argument where
/// a search in a periodic box might not end: until is infinite and radii do not grow.
template <int D>
[[nodiscard]] double meeting_time(const GrowingBall<D>& a, const GrowingBall<D>& b,
                                  const Effects<D>& effects, double until = infinity);

/// The same of one image: a.x - b.x less image · box lengths.
template <int D>
[[nodiscard]] double meeting_time(const GrowingBall<D>& a, const GrowingBall<D>& b,
                                  const Image<D>& image, const Effects<D>& effects);

template <int D>
/// Of a ball and a half space.
[[nodiscard]] double meeting_time(const GrowingBall<D>& ball, const HalfSpace<D>& wall,
                                  const Effects<D>& effects);

/// Of meetings from `since` on.
template <int D>
[[nodiscard]] double meeting_time(const GrowingBall<D>& ball, const Sphere<D>& wall,
                                  const Effects<D>& effects, double since = -infinity);

/// The same by one look, of a ball that meets the obstacle at some time near `about`; NaN where
/// that does not tell the double.
template <int D>
[[nodiscard]] double refined_meeting(const GrowingBall<D>& ball, const HalfSpace<D>& wall,
                                     const Effects<D>& effects, double about);
template <int D>
/// The same of a sphere.
[[nodiscard]] double refined_meeting(const GrowingBall<D>& ball, const Sphere<D>& wall,
                                     const Effects<D>& effects, double about);
/// The same of a segment.
[[nodiscard]] double refined_meeting(const GrowingBall<2>& ball, const Segment& wall,
                                     const Effects<2>& effects, double about);

/// Of the two sides and the two ends the first one that is met; a side counts where the centre's
/// foot at that rounded time is on the segment. Meetings from `since` on. Precondition: the two
/// ends are different.
[[nodiscard]] double meeting_time(const GrowingBall<2>& ball, const Segment& wall,
                                  const Effects<2>& effects, double since = -infinity);

}  // namespace signum::motion
