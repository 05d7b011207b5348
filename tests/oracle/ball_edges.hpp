#pragma once
/// Brute force for the edges of the Voronoi diagram of balls in space, |p-c| - r. The spheres that
/// touch three balls from outside have their centres on a branch of a hyperbola, a parabola or an
/// ellipse, whose parts may be several edges, or none; on an ellipse there may be one without an
/// end.

#include "space_ball.hpp"

#include <cstdint>
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
    friend bool operator==(const BallEdge&, const BallEdge&) = default;
};

/// Of every curve that has arcs, sorted by their balls.
std::vector<BallEdge> ball_edges(std::span<const SpaceBall<3>> balls);

}  // namespace signum::oracle
