#pragma once
/// Brute force for the edges of the Voronoi diagram of balls in space, |p-c| - r. The spheres that
/// touch three balls from outside have their centres on a branch of a hyperbola, a parabola or an
/// ellipse, whose parts may be several edges, or none; on an ellipse there may be one without an
/// end.

#include "balls_space.hpp"
#include "space_ball.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace signum::oracle {

struct BallEdge {
    /// The visible balls that all spheres of the curve touch, rising numbers: three of them, or
    /// more.
    std::vector<std::int32_t> balls;
    /// How many open arcs of the curve there are, as long as can be, whose spheres no other visible
    /// ball touches or conflicts with. Every end of one is a vertex or at infinity.
    int arcs = 0;
    int ends_at_infinity = 0;
    /// The one arc is a whole ellipse and has no ends.
    bool is_closed = false;
    /// Of each open arc the spheres at its two ends, in any order; none where that is at infinity.
    std::vector<std::array<std::optional<TouchingSphere<3>>, 2>> ends = {};
    /// The ends apart.
    friend bool operator==(const BallEdge& a, const BallEdge& b) {
        return a.balls == b.balls && a.arcs == b.arcs && a.ends_at_infinity == b.ends_at_infinity &&
               a.is_closed == b.is_closed;
    }
};

/// Of every curve that has arcs, sorted by their balls.
std::vector<BallEdge> ball_edges(std::span<const SpaceBall<3>> balls);

}  // namespace signum::oracle
