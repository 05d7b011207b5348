#pragma once
/// The questions that the edges of a tessellation stand for.

#include <array>
#include <vector>

#include "../triangulation/tessellation.hpp"

namespace signum::study {

/// For every edge between two finite faces of four sites the calls of in_circle that it answers:
/// the sites of one face, and the one across. O(n).
[[nodiscard]] std::vector<std::array<Index, 4>> inner_edges(const Tessellation& tessellation);

}  // namespace signum::study
