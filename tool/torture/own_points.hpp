#pragma once
/// Somebody's own points: where a plugin is to be right, whatever else it does.

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "../../core/index.hpp"
#include "../../core/site.hpp"

namespace signum::torture {

/// Points, and those that lie beside one another: the sites of two faces (cells) of their Delaunay
/// triangulation that have an edge (facet) in common, those of the first face before the last one.
struct OwnPoints {
    std::size_t dimension = 2;
    std::vector<std::array<double, 3>> points;
    std::vector<std::array<Index, 5>> beside;
};
/// Of finite coordinates; radii are not looked at. O(n log n).
[[nodiscard]] OwnPoints own_points(std::span<const Site> sites);
[[nodiscard]] OwnPoints own_points(std::span<const Site3> sites);

}  // namespace signum::torture
