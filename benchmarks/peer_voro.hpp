#pragma once
/// The radical tessellation of voro++, single cells without a structure among them, beside
/// space_cells().

#include <vector>

#include "../voronoi/space/cells.hpp"

namespace signum::benchmarks {

/// Cells with volumes, surfaces, centroids and faces in the unit cube, as voro++ computes them; the
/// centres lie there.
[[nodiscard]] SpaceCells cells_of_voro(const std::vector<Site3>& sites);

}  // namespace signum::benchmarks
