#pragma once
/// Power (regular) tessellations of space; for equal weights they are Delaunay's.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "../../core/index.hpp"
#include "../../core/site.hpp"
#include "../arrays.hpp"
#include "../metric.hpp"
#include "../options.hpp"

namespace signum {

/// Four vertices, or the four cells across from them; -1 is infinity. Of flat sites fewer vertices,
/// and then `no_vertex`.
using SpaceCell = std::array<Index, 4>;
/// No vertex: cells of flat sites have fewer than four.
inline constexpr Index no_vertex = -2;

/// A tessellation of space as plain arrays of indices.
///
/// Laws, where the centres span k dimensions:
///  1. A cell has k+1 vertices. Where k = 3 it turns positively (ccw is +1, with infinity in the
///     place of a centre beyond all others), its smallest number first and the next smallest
///     second; of flat sites the numbers rise. Cells are sorted. With those that have the vertex at
///     infinity they have no boundary.
///  2. neighbours[c][i] is the cell across from cells[c][i].
///  3. The arrays depend on the sites alone: not on insertion order, seed or threads.
struct SpaceTessellation {
    /// k: 3, or less of flat sites: 2 in a plane, 1 on a line, 0 in one place, -1 of none.
    int dimension = -1;
    std::int64_t sites = 0;             ///< how many, hidden ones included
    std::vector<SpaceCell> cells;       ///< law 1
    std::vector<SpaceCell> neighbours;  ///< law 2
    std::vector<Hidden> hidden;         ///< sorted by site
    friend bool operator==(const SpaceTessellation&, const SpaceTessellation&) = default;
};

/// The power tessellation of sites in space: points (Delaunay), sites that carry a weight, or
/// balls, whose weight is the square of the radius. Ties are decided by the rule of the plane
/// (falling weight, rising x, y, z, index), hidden sites are reported, flat sites are ordinary
/// input. Of the options arithmetic (exact or naive), seed, threads, stop and progress are looked
/// at; one thread builds flat sites, and sites of which each may have a neighbour anywhere, on a
/// sphere or around a giant. Throws std::invalid_argument, naming the site, for NaN or infinity,
/// for more than 2^28 sites, and for another arithmetic; Stopped where options.stop asks for it;
/// BrokenStructure where naive arithmetic led astray; std::length_error for more than 2^31 - 1
/// cells. Time: O(n log n) expected on sites spread at random, O(n²) in the worst case, which is
/// the size of the result. At most 400 bytes a site at the peak on sites spread at random, 420
/// where several threads work, the result included, which takes 217 of them.
[[nodiscard]] SpaceTessellation triangulate(std::span<const Point3> sites, Power metric = {},
                                            const Options& options = {});
/// The same of balls.
[[nodiscard]] SpaceTessellation triangulate(std::span<const Site3> sites, Power metric = {},
                                            const Options& options = {});
/// The same of sites with weights.
[[nodiscard]] SpaceTessellation triangulate(std::span<const power::Site3> sites, Power metric = {},
                                            const Options& options = {});

}  // namespace signum
