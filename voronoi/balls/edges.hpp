#pragma once
/// The edges of the diagram of balls: the parts of curves between its vertices. For sources only.

#include "diagram.hpp"
#include "set.hpp"
#include "vertices.hpp"

namespace signum::balls {

/// Puts them into the diagram's arrays.
void find_edges(const BallSet& balls, const BallVertices& found, BallDiagram& result);

}  // namespace signum::balls
