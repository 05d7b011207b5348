#pragma once
/// Power tessellations whose centres all lie on one line: the lower hull of the lifted sites.

#include <algorithm>
#include <numeric>
#include <span>
#include <vector>

#include "../../core/index.hpp"
#include "../../core/sign.hpp"
#include "../structure/topology.hpp"

namespace signum::triangulation {

/// The visible ones of sites in their order along the line, of equal centres the first in the tie
/// rule's order before the others; hidden_by of the rest becomes a site that hides them. O(n).
template <class Kernel>
[[nodiscard]] std::vector<Index> visible_in_order(Kernel& kernel, std::span<const Index> along,
                                                  std::span<Index> hidden_by) {
    std::vector<Index> chain;
    for (const Index site : along) {
        if (!chain.empty() && kernel.compare_along(chain.back(), site) == 0) {
            hidden_by[static_cast<std::size_t>(site)] = chain.back();
            continue;
        }
        while (chain.size() >= 2 &&
               !kernel.conflicts_on_line(chain[chain.size() - 2], site, chain.back())) {
            hidden_by[static_cast<std::size_t>(chain.back())] = site;
            chain.pop_back();
        }
        chain.push_back(site);
    }
    return chain;
}

/// Brings sites into their order along a line.
template <class Kernel>
void sort_along(Kernel& kernel, std::span<Index> sites) {
    std::sort(sites.begin(), sites.end(), [&](Index a, Index b) {
        if (a == b) return false;
        const Sign order = kernel.compare_along(a, b);
        return order != 0 ? order < 0 : kernel.precedes(a, b);
    });
}

/// The visible ones of all sites in their order along the line. Sites with equal centres count as
/// collinear. O(n log n).
template <class Kernel>
[[nodiscard]] std::vector<Index> visible_on_line(Kernel& kernel, std::size_t sites,
                                                 std::span<Index> hidden_by) {
    std::vector<Index> along(sites);
    std::iota(along.begin(), along.end(), 0);
    sort_along(kernel, along);
    return visible_in_order(kernel, along, hidden_by);
}

/// The tessellation of visible sites along a line: between neighbours a and b the two faces (a, b,
/// ∞) and (b, a, ∞); all of them meet at infinity.
inline void connect_line(Topology& topology, std::span<const Index> chain) {
    const auto pairs = static_cast<Index>(chain.size()) - 1;
    for (Index i = 0; i < pairs; ++i) {
        const Index a = chain[static_cast<std::size_t>(i)];
        const Index b = chain[static_cast<std::size_t>(i) + 1];
        topology.add_face(a, b, infinite);
        topology.add_face(b, a, infinite);
    }
    const auto above = [](Index i) { return Topology::first_edge(2 * i); };  // (a, b, ∞) of pair i
    const auto below = [](Index i) { return Topology::first_edge(2 * i + 1); };
    for (Index i = 0; i < pairs; ++i) {
        topology.glue(above(i), below(i));
        if (i == 0) continue;
        topology.glue(above(i) + 2, above(i - 1) + 1);
        topology.glue(below(i) + 1, below(i - 1) + 2);
    }
    if (pairs > 0) {
        topology.glue(above(0) + 2, below(0) + 1);
        topology.glue(above(pairs - 1) + 1, below(pairs - 1) + 2);
    }
}

}  // namespace signum::triangulation
