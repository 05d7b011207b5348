#pragma once
/// Sites one after the other into a tessellation of their own.

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>

#include "../structure/watch.hpp"
#include "insert.hpp"

namespace signum::triangulation {

/// Moves three sites that are not collinear to the front, counterclockwise; false where there are
/// none.
template <class Kernel>
bool lead_with_triangle(Kernel& kernel, std::span<Index> sites) {
    std::size_t second = 1;
    while (second < sites.size() && kernel.centre(sites[second]) == kernel.centre(sites[0]))
        ++second;
    if (second >= sites.size()) return false;
    std::swap(sites[1], sites[second]);
    for (std::size_t third = 2; third < sites.size(); ++third) {
        const Sign side = kernel.ccw(sites[0], sites[1], sites[third]);
        if (side == 0) continue;
        std::swap(sites[2], sites[third]);
        if (side < 0) std::swap(sites[0], sites[1]);
        return true;
    }
    return false;
}

/// Moves the first site of the tie rule's order to the front: no other ever hides it.
template <class Kernel>
void lead_with_first(const Kernel& kernel, std::span<Index> sites) {
    const auto first =
        std::ranges::min_element(sites, {}, [&](Index i) { return kernel.site(i).rank; });
    if (first != sites.end()) std::swap(sites.front(), *first);
}

/// The tessellation of the sites, inserted in the order given but for those that lead, which move
/// to the front; hidden_by is as the insertion leaves it. False, and there are no faces, where the
/// sites lie on one line (power) or are hidden by one of them (the other metrics), which is then
/// the first.
template <class Kernel>
[[nodiscard]] bool insert_all(Topology& topology, Kernel& kernel, std::span<Index> hidden_by,
                              std::span<Index> sites, const Watch& watch) {
    Watch::Loop loop(watch);
    const auto insert = [&](Insertion<Kernel> insertion, std::size_t next) {
        for (; next < sites.size(); ++next) {
            insertion.insert(sites[next]);
            loop.step();
        }
        return true;
    };
    if constexpr (Kernel::is_straight) {
        if (!lead_with_triangle(kernel, sites)) return false;
        return insert({topology, kernel, hidden_by, sites[0], sites[1], sites[2]}, 3);
    } else {
        lead_with_first(kernel, sites);
        std::size_t second = 1;
        for (; second < sites.size() && kernel.hides(sites[0], sites[second]); ++second)
            hidden_by[static_cast<std::size_t>(sites[second])] = sites[0];
        if (second >= sites.size()) return false;
        return insert({topology, kernel, hidden_by, sites[0], sites[second]}, second + 1);
    }
}

}  // namespace signum::triangulation
