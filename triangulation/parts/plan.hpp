#pragma once
/// Sites in parts: a tree of cuts along the axes, made from a sample.

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "../../core/index.hpp"
#include "../../core/large_array.hpp"
#include "../../core/parallel.hpp"
#include "../../core/strided_sites.hpp"

namespace signum::triangulation {

/// A line that cuts a part in two: sites whose coordinate is less lie below it, the others above.
struct Cut {
    std::size_t axis = 0;
    double at = 0.0;
};

/// The parts of a plan are the nodes of a complete binary tree, from the root, 0, to the leaves;
/// those below and above the cut of node k are 2k+1 and 2k+2.
struct Plan {
    int levels = 0;                   ///< of cuts; there are 2^levels leaves
    std::vector<Cut> cuts;            ///< of the nodes that are no leaves
    std::vector<std::size_t> begins;  ///< of each leaf's sites in `numbers`, and the end
    LargeArray<Index> numbers;        ///< of the sites in the input, leaf by leaf

    [[nodiscard]] std::size_t leaves() const noexcept { return std::size_t{1} << levels; }
};

/// How many levels of cuts give these workers enough to do: several leaves each, for they do not
/// take the same time, and none that is done before others have begun; 0 for one worker.
[[nodiscard]] int levels_for(std::size_t sites, const Workers& workers) noexcept;

/// A plan of that many levels. Leaves hold about as many sites each, unless many lie on a cut, and
/// each of them is in the order of insertion (spatial_order.hpp). O(n log n), by the workers.
/// Precondition: 16 levels at most.
[[nodiscard]] Plan make_plan(const StridedSites& sites, int levels, std::uint64_t seed,
                             const Workers& workers);

}  // namespace signum::triangulation
