#pragma once
/// The edges that sites may have, whatever is made of ties: those of the oracle's tessellations for
/// all orders in which ties are decided.

#include "oracle.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
#include <set>
#include <utility>

namespace signum::oracle {

/// An oracle of some sites in some metric.
using TessellationOf = std::function<Tessellation(const Ranks&)>;

/// Edges between sites, the smaller number first.
using Edges = std::set<std::array<std::int32_t, 2>>;

inline void add_edges(const Tessellation& tessellation, Edges& edges) {
    for (const auto& face : tessellation.faces)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [a, b] = std::minmax(face[k], face[(k + 1) % 3]);
            if (a >= 0) edges.insert({a, b});
        }
}

/// By all orders of n sites.
inline Edges valid_edges(const TessellationOf& tessellation, std::size_t n) {
    Ranks ranks(n);
    std::iota(ranks.begin(), ranks.end(), std::size_t{0});
    Edges edges;
    do {
        add_edges(tessellation(ranks), edges);
    } while (std::next_permutation(ranks.begin(), ranks.end()));
    return edges;
}

/// The same where n is too large for all orders. An edge that some infinitely small radii show
/// stays where both its sites grow, for its sites are then nearer than before where they are as
/// near as each other; so it is enough to let each two sites come first, in either order.
inline Edges valid_edges_of_pairs(const TessellationOf& tessellation, std::size_t n) {
    Edges edges;
    for (std::size_t a = 0; a < n; ++a)
        for (std::size_t b = 0; b < n; ++b) {
            if (a == b) continue;
            Ranks ranks(n);
            std::size_t next = 2;
            for (std::size_t i = 0; i < n; ++i) ranks[i] = i == a ? 0 : i == b ? 1 : next++;
            add_edges(tessellation(ranks), edges);
        }
    return edges;
}

}  // namespace signum::oracle
