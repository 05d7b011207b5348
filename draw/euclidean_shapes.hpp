#pragma once
/// The Euclidean metric drawn: cells bounded by arcs of hyperbolas.

#include <signum/draw/frame.hpp>
#include <signum/triangulation/tessellation.hpp>

#include <vector>

namespace signum::euclidean {

/// Arcs as chords that are nowhere more than a twentieth of a pixel off.
[[nodiscard]] std::vector<Segment> cell_edges(const Tessellation& tessellation, const Frame& frame);

}  // namespace signum::euclidean
