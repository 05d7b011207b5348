#pragma once
/// The supremum and Manhattan metrics drawn: cells bounded by polylines. Where the points at equal
/// distance from two sites fill a region, the line is the one that the tie rule tends to.

#include <signum/draw/frame.hpp>
#include <signum/triangulation/tessellation.hpp>

#include <vector>

namespace signum::rectangular {

[[nodiscard]] std::vector<Segment> cell_edges(const Tessellation& tessellation, const Frame& frame);

}  // namespace signum::rectangular
