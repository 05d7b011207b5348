#pragma once
/// Power (regular) tessellations in one to six dimensions, one text for all of them; for equal
/// weights they are Delaunay's. Exact, and made to be right rather than fast: in space
/// triangulation/space/triangulate.hpp gives the same arrays in a fraction of the time, in the
/// plane triangulation/triangulate.hpp the same faces.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "../../core/index.hpp"
#include "../arrays.hpp"
#include "../options.hpp"
#include "../space/triangulate.hpp"

namespace signum {

namespace power {

/// A site of D dimensions that carries its weight w: distance |p-c|² - w.
template <int D>
struct SiteOf {
    /// Its coordinates.
    std::array<double, static_cast<std::size_t>(D)> centre{};
    double w = 0.0;  ///< the weight
    friend bool operator==(const SiteOf&, const SiteOf&) = default;
};

}  // namespace power

/// D+1 vertices, or the cells across from them; -1 is infinity. Of flat sites fewer, and then
/// `no_vertex`.
template <int D>
using CellOf = std::array<Index, static_cast<std::size_t>(D) + 1>;

/// A tessellation in D dimensions as plain arrays of indices.
///
/// Laws, where the centres span k dimensions:
///  1. A cell has k+1 vertices v_0, ..., v_k, and their numbers rise. Where k = D it turns
///     positively (det[v_i - v_0] > 0, with infinity in the place of a centre beyond all others),
///     and for that the last two are exchanged where they need be. Cells are sorted. With those
///     that have the vertex at infinity they have no boundary.
///  2. neighbours[c][i] is the cell across from cells[c][i].
///  3. The arrays depend on the sites alone: not on insertion order or seed.
/// Where D = 3 they are those of a SpaceTessellation.
template <int D>
struct TessellationOf {
    /// k: D, or less of flat sites, 0 in one place, -1 of none.
    int dimension = -1;
    std::int64_t sites = 0;             ///< how many, hidden ones included
    std::vector<CellOf<D>> cells;       ///< sorted
    std::vector<CellOf<D>> neighbours;  ///< neighbours[c][i] is across from cells[c][i]
    std::vector<Hidden> hidden;         ///< sorted by site
    friend bool operator==(const TessellationOf&, const TessellationOf&) = default;
};

/// The power tessellation of sites in D = 1, ..., 6 dimensions. Ties are decided by the rule of the
/// plane (falling weight, rising coordinates from the first to the last, index), hidden sites are
/// reported, flat sites are ordinary input. Of the options seed, stop and progress are looked at.
/// Throws std::invalid_argument, naming the site, for NaN or infinity, and for an arithmetic that
/// is not the exact one; std::length_error for more than 2^31 cells; Stopped where options.stop
/// asks for it. Time: that of the cells which come and go, of which n sites have O(n^⌈D/2⌉) at
/// most, and random ones a number in proportion to n that grows quickly with D.
template <int D>
[[nodiscard]] TessellationOf<D> triangulate(std::span<const power::SiteOf<D>> sites,
                                            const Options& options = {});

}  // namespace signum
