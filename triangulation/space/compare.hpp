#pragma once
/// What another arithmetic made of the same sites of space: which cells of a tessellation are
/// wrong, and which are only not the canonical ones.
///
/// Laws:
///  1. A cell between sites is valid where infinitely small changes of the weights show it,
///     whichever they are: where its centres span space and turn positively (of flat sites: span
///     what all centres span), and no site conflicts with its vertex; one that touches does not.
///  2. A cell that is not valid is wrong. A valid one is different where the canonical tessellation
///     does not have it, or has it less often.
///  3. The canonical tessellation itself has neither.

#include <cstdint>
#include <span>
#include <vector>

#include "triangulate.hpp"

namespace signum {

/// How the cells of a tessellation compare with those of the canonical one.
struct CellComparison {
    std::int64_t cells = 0;            ///< between sites of the compared tessellation
    std::vector<SpaceCell> wrong;      ///< in no valid tessellation; sorted
    std::vector<SpaceCell> different;  ///< valid, but not the canonical choice; sorted
};

/// Compares the cells between sites; infinite ones are not looked at. `canonical` is the exact
/// tessellation of the same sites (that it is is the caller's word). Exact, and the same whatever
/// the number of threads (Options::threads). O(n), and for each cell that the canonical
/// tessellation has not as much as there are cells around one of its sites; for one of hidden sites
/// alone O(n). Throws std::invalid_argument where one of the two is of another dimension or of
/// other sites, or names a site that there is not.
[[nodiscard]] CellComparison compare_cells(const SpaceTessellation& tessellation,
                                           const SpaceTessellation& canonical,
                                           std::span<const Point3> sites, int threads = 0);
/// The same of balls.
[[nodiscard]] CellComparison compare_cells(const SpaceTessellation& tessellation,
                                           const SpaceTessellation& canonical,
                                           std::span<const Site3> sites, int threads = 0);
/// The same of sites with weights.
[[nodiscard]] CellComparison compare_cells(const SpaceTessellation& tessellation,
                                           const SpaceTessellation& canonical,
                                           std::span<const power::Site3> sites, int threads = 0);

/// Of the facets between two finite cells of a canonical tessellation, how many are ties: the site
/// across touches the sphere. Exact, O(n). Throws, and takes threads, as compare_cells().
struct FacetTies {
    std::int64_t facets = 0;  ///< between two finite cells
    std::int64_t ties = 0;    ///< of them, those that the tie rule decided
};
/// Of points.
[[nodiscard]] FacetTies ties_of(const SpaceTessellation& canonical, std::span<const Point3> sites,
                                int threads = 0);
/// Of balls.
[[nodiscard]] FacetTies ties_of(const SpaceTessellation& canonical, std::span<const Site3> sites,
                                int threads = 0);
/// Of sites with weights.
[[nodiscard]] FacetTies ties_of(const SpaceTessellation& canonical,
                                std::span<const power::Site3> sites, int threads = 0);

}  // namespace signum
