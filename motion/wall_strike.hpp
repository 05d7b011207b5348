#pragma once
/// What a strike against a wall does, whatever its form. For sources only.
///
/// At the rounded time t the wall faces the ball with a normal n of any length and recedes along it
/// at the speed w = n·u, u its velocity. Of these, which are exact numbers, the law
///
///     v' = v + ((1+e) (w - n·v) / n·n + (1+e) q / √(n·n)) n
///
/// is exact, q the rate at which the ball's radius grows, and each component of v' the double
/// nearest to it; halves to even, a zero is +0. The speed of a wall that shakes is first rounded
/// to the nearest double.

#include <optional>

#include "../exact/dyadic.hpp"
#include "ball.hpp"
#include "shaking_wall.hpp"
#include "strike.hpp"

namespace signum::motion {

template <int D>
struct Facing {
    PerAxis<exact::Dyadic, D> normal;  ///< towards the ball
    exact::Dyadic speed;               ///< w
};

/// How a wall faces a ball that is at its own time. Of a segment: from the nearest point of it, and
/// from its line against the ball's velocity where the centre lies on it.
template <int D>
[[nodiscard]] Facing<D> facing(const Ball<D>& ball, const ShakingWall& wall);
template <int D>
[[nodiscard]] Facing<D> facing(const Ball<D>& ball, const HalfSpace<D>& wall);
template <int D>
[[nodiscard]] Facing<D> facing(const Ball<D>& ball, const Sphere<D>& wall);
[[nodiscard]] Facing<2> facing(const Ball<2>& ball, const Segment& wall);

/// Of a side of the box at rest.
template <int D>
[[nodiscard]] Facing<D> facing_side(Wall wall);

/// Whether F (obstacle.hpp, shaking_wall.hpp) bends down at the ball's own time: of F'' and what
/// follows the first that is not 0 is below 0. Exactly, but for the place and the speed of a wall
/// that shakes, which are rounded. Of a segment: of its line, or of its
/// end that is nearest.
template <int D>
[[nodiscard]] bool bends_down(const Ball<D>& ball, const ShakingWall& wall,
                              const Vector<D>& gravity, double growth);
template <int D>
[[nodiscard]] bool bends_down(const Ball<D>& ball, const HalfSpace<D>& wall,
                              const Vector<D>& gravity, double growth);
template <int D>
[[nodiscard]] bool bends_down(const Ball<D>& ball, const Sphere<D>& wall, const Vector<D>& gravity,
                              double growth);
[[nodiscard]] bool bends_down(const Ball<2>& ball, const Segment& wall, const Vector<2>& gravity,
                              double growth);

/// The normal's direction, rounded.
template <int D>
[[nodiscard]] Vector<D> unit_normal(const Facing<D>& wall);

/// Changes the velocity, or says that it is no strike.
template <int D>
[[nodiscard]] Exchange strike(Ball<D>& ball, const Facing<D>& wall, double mass, double restitution,
                              double growth);
/// Speed of approach along the unit normal, rounded; not above 0 where it recedes.
template <int D>
[[nodiscard]] double approach_of(const Ball<D>& ball, const Facing<D>& wall, double growth);

/// Whether the ball has stayed in place since a time (strike.hpp), exactly.
template <int D>
[[nodiscard]] bool stayed_in_place_exactly(const Ball<D>& ball, const Facing<D>& wall,
                                           double growth, double before);

}  // namespace signum::motion
