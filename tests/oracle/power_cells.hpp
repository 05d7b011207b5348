#pragma once
/// The power cells of space in a box, in rationals, from the definition: all half-spaces between
/// all pairs of sites, all points in which three planes meet. O(n^5): for a few sites.

#include <array>
#include <cstdint>
#include <vector>

#include <gmpxx.h>

namespace signum::oracle {

struct WeighedPoint {
    std::array<mpq_class, 3> x;
    mpq_class weight;
};

struct CellFace {
    /// Whose planes hold it: sites, or sides of the box from -1 to -6. Of more than one where
    /// planes coincide.
    std::vector<std::int32_t> beyond;
    double area;  ///< the root of the exact square
};

struct PowerCell {
    mpq_class volume;
    std::vector<CellFace> faces;  ///< those with an area
};

/// Sites at one place must not have one weight.
[[nodiscard]] std::vector<PowerCell> power_cells(const std::vector<WeighedPoint>& sites,
                                                 const std::array<mpq_class, 3>& low,
                                                 const std::array<mpq_class, 3>& high);

}  // namespace signum::oracle
