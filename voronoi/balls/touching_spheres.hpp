#pragma once
/// The spheres that touch four balls from outside, and the circles that touch three discs: the
/// problem of Apollonius, for the metric |x-c| - r.
///
/// A sphere with centre c and radius rho touches ball i from outside where |c - c_i| = rho + r_i >=
/// 0. Radii of balls may be negative, and rho may: only rho + r_i is a distance. So a sphere may
/// touch a ball from inside where this has a negative radius.
///
/// Laws:
///  1. the balls are any, and how many spheres touch them is told exactly: infinitely many only
///     where balls are equal, touch one another from inside in one point, have their centres on a
///     line or, of equal radii, on a circle, and the like. Two spheres differ in orientation; where
///     two roots coincide there is one;
///  2. every number is rounded once, to the nearest double, halves to even; an infinity where it
///     lies beyond the doubles;
///  3. the same in every floating-point environment.

#include <array>
#include <cstdint>
#include <span>

#include "../../core/sign.hpp"
#include "../../core/site.hpp"

namespace signum {

/// How many spheres touch.
enum class SphereCount : std::uint8_t { none, one, two, infinitely_many };

/// A sphere (circle) as a site: its centre and its radius.
template <class S>
struct TouchingSphere {
    S sphere;  ///< centre and radius, each number rounded once
    /// How the points of contact turn, in the order of the balls: +1 where ccw of them is positive,
    /// -1 where it is negative, 0 where they lie in one plane (on one line), or where one of the
    /// balls is a point at the centre.
    Sign orientation = 0;
};

template <class S>
/// The spheres that touch, two at most.
struct TouchingSpheres {
    SphereCount count = SphereCount::none;  ///< how many
    /// Of one sphere the first, of two the first with the orientation +1 and the second with -1; no
    /// other is looked at.
    std::array<TouchingSphere<S>, 2> spheres = {};
};

/// Throws std::invalid_argument where the balls are not four (the discs not three), and, naming the
/// ball, for NaN or infinity.
[[nodiscard]] TouchingSpheres<Site3> touching_spheres(std::span<const Site3> four);
/// In the plane: the circles that touch three discs.
[[nodiscard]] TouchingSpheres<Site> touching_spheres(std::span<const Site> three);

}  // namespace signum
