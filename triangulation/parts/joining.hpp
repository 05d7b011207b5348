#pragma once
/// What constructions in parts share, of the plane and of space: the boxes of the parts, and the
/// order in which these are joined.

#include <array>
#include <cstddef>
#include <vector>

#include "../../core/parallel.hpp"
#include "../../exact/floating_environment.hpp"
#include "../structure/watch.hpp"
#include "plan.hpp"

namespace signum::triangulation {

/// The boxes of all nodes of a plan, from those of the leaves: box_of(leaf).
template <std::size_t D, class BoxOf>
[[nodiscard]] std::vector<Box<D>> boxes_of(const Plan& plan, const Workers& workers,
                                           const BoxOf& box_of) {
    std::vector<Box<D>> boxes(2 * plan.leaves() - 1);
    workers.each(plan.leaves(), [&](std::size_t leaf) {
        const exact::IeeeEnvironment environment;
        boxes[plan.cuts.size() + leaf] = box_of(leaf);
    });
    for (std::size_t k = boxes.size(); --k > 0;) boxes[(k - 1) / 2].include(boxes[k]);
    return boxes;
}

/// The part of node k, `level` cuts below the root: leaf(number) of a leaf, join(the parts below
/// and above the cut, k) elsewhere, on whatever thread is free.
template <class Part, class Leaf, class Join>
[[nodiscard]] Part built(const Plan& plan, const Workers& workers, const Watch& watch,
                         const Leaf& leaf, const Join& join, std::size_t k = 0, int level = 0) {
    std::array<Part, 2> parts;
    if (level < plan.levels)
        workers.each(2, [&](std::size_t side) {
            parts[side] =
                built<Part>(plan, workers, watch, leaf, join, 2 * k + 1 + side, level + 1);
        });
    Part result;
    watch.guard([&] {
        const exact::IeeeEnvironment environment;
        result = level < plan.levels ? join(parts, k) : leaf(k - plan.cuts.size());
    });
    return result;
}

}  // namespace signum::triangulation
