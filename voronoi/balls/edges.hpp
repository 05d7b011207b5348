#pragma once
/// The edges of the diagram of balls: the parts of curves between its vertices. For sources only.

#include <array>
#include <vector>

#include "../../core/index.hpp"
#include "diagram.hpp"
#include "set.hpp"
#include "vertices.hpp"

namespace signum::balls {

/// In the order of the arrays of BallDiagram.
struct BallEdges {
    BallLists balls;
    std::vector<std::array<Index, 2>> ends;
};

[[nodiscard]] BallEdges find_edges(const BallSet& balls, const BallVertices& found);

}  // namespace signum::balls
