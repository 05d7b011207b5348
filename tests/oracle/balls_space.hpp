#pragma once
/// Brute force for the Euclidean metric with additive weights, |p-c| - r, in the plane and in
/// space (D = 2, 3): the spheres that touch D + 1 balls, by linear elimination and one quadratic
/// equation, in rationals. No rule for ties: what is degenerate is told as it is.
///
/// A sphere (c, rho) touches a ball (c_i, r_i) from outside where |c - c_i| = rho + r_i. Radii of
/// balls may be negative, and so may rho; rho + r_i is a distance and never is.

#include "space_ball.hpp"
#include "surd.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace signum::oracle {

/// All its numbers have the same g, but for those that are rational.
template <int D>
struct TouchingSphere {
    std::array<Surd, static_cast<std::size_t>(D)> c{};
    Surd rho;
    /// Of the directions (c_i - c) / |c_i - c| to the points of contact, in the order of the balls:
    /// the sign of det[direction_i, 1], which is that of det[direction_i - direction_0] in the
    /// plane (1 is counterclockwise) and its opposite in space. 0 where one of them is none, c_i =
    /// c.
    int orientation = 0;
};

enum class SphereCount { none, one, two, infinitely_many };

template <int D>
struct TouchingSpheres {
    SphereCount count = SphereCount::none;
    /// As many as that; none where there are infinitely many. Two are oriented one positively, the
    /// other negatively, and come in this order.
    std::vector<TouchingSphere<D>> spheres;
};

/// The spheres that touch all of the balls from outside. These may be any, equal ones too. Where
/// two roots coincide there is one sphere, and its orientation is 0.
template <int D>
TouchingSpheres<D> touching_spheres(const BallTuple<D>& balls);

/// The sign of |c - c_q| - r_q - rho: -1 where q is nearer to c than the sphere's balls and
/// conflicts with it, 0 where it touches, 1 where it does neither.
template <int D>
int side(const TouchingSphere<D>& sphere, const SpaceBall<D>& q);

/// Whether ball j contains ball i, |c_i - c_j| <= r_j - r_i. Equal balls do.
template <int D>
bool contains(const SpaceBall<D>& j, const SpaceBall<D>& i);

/// For every ball whether another one contains it; of equal balls the first is not hidden by the
/// others.
template <int D>
std::vector<bool> hidden_balls(std::span<const SpaceBall<D>> balls);

/// A vertex of the Voronoi diagram.
template <int D>
struct BallVertex {
    /// The visible balls that its sphere touches, rising numbers: D + 1 of them, or more.
    std::vector<std::int32_t> balls;
    /// Oriented by the first D + 1 of these, in the order of words, that finitely many spheres
    /// touch.
    TouchingSphere<D> sphere;
};

/// All vertices, sorted by their balls: the spheres that touch D + 1 visible balls (of which no
/// infinitely many do) and that no ball conflicts with, each once. Two vertices may have the same
/// balls: then the one whose sphere is positively oriented comes first.
///
/// D + 1 balls that infinitely many spheres touch are passed over. Of a sphere that has no others
/// the centre lies on an edge, not in its end.
template <int D>
std::vector<BallVertex<D>> ball_vertices(std::span<const SpaceBall<D>> balls);

}  // namespace signum::oracle
