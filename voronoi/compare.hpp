#pragma once
/// What another arithmetic made of the same sites: which edges of a tessellation are wrong, and
/// which are only not the canonical ones.
///
/// Laws:
///  1. An edge is valid where infinitely small changes of the radii (weights) show it, whichever
///     they are. That is where its sites, which differ, are both nearest to some point; and in the
///     Euclidean metric, where both touch a line that has all sites on one side. A chord between
///     cocircular sites is valid, and so is an edge of a site that only a tie hides.
///  2. An edge that is not valid is wrong. A valid one is different where the canonical
///     tessellation does not have it, or has it less often: two sites may share several edges.
///  3. The canonical tessellation itself has neither.

#include <cstdint>
#include <vector>

#include "../triangulation/tessellation.hpp"

namespace signum {

/// How the edges of a tessellation compare with those of the canonical one.
struct EdgeComparison {
    std::int64_t edges = 0;       ///< edges between sites of the compared tessellation
    std::vector<Edge> wrong;      ///< in no valid tessellation; sorted, as often as they are there
    std::vector<Edge> different;  ///< valid, but not the canonical choice; sorted likewise
};

/// Compares the edges between sites; those to infinity are not looked at. `canonical` is the exact
/// tessellation of the same sites in the same metric (std::invalid_argument where sites or metric
/// are not the same; that it is exact is the caller's word). Exact, and the same whatever the
/// number of threads (Options::threads). Expected O(n log n), and the time of
/// Tessellation::locate() for every edge in the power metric that joins two hidden sites.
[[nodiscard]] EdgeComparison compare_edges(const Tessellation& tessellation,
                                           const Tessellation& canonical, int threads = 0);

}  // namespace signum
