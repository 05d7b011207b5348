#pragma once
/// Power tessellations whose centres all lie on one line: the lower hull of the lifted sites.

#include <algorithm>
#include <span>
#include <vector>

#include "../../core/index.hpp"
#include "../../core/site.hpp"
#include "../structure/topology.hpp"

namespace signum::triangulation {

/// The visible sites in their order along the line; hidden_by of the others becomes a site that
/// hides them. Sites with equal centres count as collinear. O(n log n).
template <class Kernel>
[[nodiscard]] std::vector<Index> visible_on_line(Kernel& kernel, std::size_t sites,
                                                 std::span<Index> hidden_by) {
    std::vector<Index> along(sites);
    for (std::size_t i = 0; i < sites; ++i) along[i] = static_cast<Index>(i);
    std::sort(along.begin(), along.end(), [&](Index a, Index b) {
        const Point p = kernel.centre(a);
        const Point q = kernel.centre(b);
        return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : kernel.precedes(a, b);
    });

    std::vector<Index> chain;
    for (const Index site : along) {
        if (!chain.empty() && kernel.centre(chain.back()) == kernel.centre(site)) {
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
