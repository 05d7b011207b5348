#pragma once
/// The cells of moving discs, of which a movie shows the borders.

#include <span>
#include <vector>

#include "../../voronoi/conic.hpp"
#include "../draw/movie.hpp"

namespace signum::cli {

/// The borders between the cells of the power diagram of discs, as far as they lie in a box;
/// `periodic`: the box lies beside itself without end, and discs have their centres in it. Throws
/// std::range_error where discs lie so far away that doubles cannot compute with the box beside
/// them. O(n log n) expected.
[[nodiscard]] std::vector<Movie::Border> borders_of_cells(std::span<const Site> discs,
                                                          const Box& box, bool periodic);

}  // namespace signum::cli
