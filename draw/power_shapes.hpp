#pragma once
/// The power metric drawn: discs, and cells bounded by straight lines.

#include <signum/draw/frame.hpp>
#include <signum/triangulation/tessellation.hpp>

#include <vector>

namespace signum::power {

[[nodiscard]] double drawn_radius(const signum::Site& site, WeightIs weight_is);
[[nodiscard]] std::vector<Segment> cell_edges(const Tessellation& tessellation, const Frame& frame);

}  // namespace signum::power
