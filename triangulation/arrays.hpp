#pragma once
/// A tessellation as plain arrays of indices.
///
/// Laws:
///  1. n >= 2 visible sites have 2n-2 faces; with the vertex at infinity they tile the sphere.
///  2. A face is a counterclockwise triple of sites, -1 being infinity, rotated so that infinity or
///     else the site that comes first in the order of the arrays comes first; faces are sorted by
///     that order, those at infinity first. One visible site has no face.
///  3. neighbours[f][k] is the face across the edge opposite faces[f][k].
///  4. The arrays depend on the sites alone: not on insertion order, method or seed.

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "../core/index.hpp"
#include "metric.hpp"

namespace signum {

/// Three vertices counterclockwise, or the three faces across from them.
using Face = std::array<Index, 3>;

/// In which order faces stand. Either depends on the sites alone.
enum class Order : std::uint8_t {
    index,  ///< by the numbers of their sites
    /// By the places of their sites along a Hilbert curve. Sites that share a cell of the finest
    /// grid that the curve is followed on, 64 at most unless they lie in one place, by their
    /// numbers.
    curve
};

/// In the order of their enumerators.
inline constexpr std::array all_orders = {Order::index, Order::curve};

/// The name by which the tool knows it.
[[nodiscard]] constexpr std::string_view name_of(Order order) noexcept {
    constexpr std::string_view names[] = {"index", "curve"};
    return names[static_cast<int>(order)];
}

/// An edge of the tessellation; -1 is infinity.
using Edge = std::array<Index, 2>;

/// A site whose cell is empty, and the visible site nearest to its centre.
struct Hidden {
    Index site;  ///< the hidden one
    Index by;    ///< the visible one that is nearest to its centre
    friend bool operator==(const Hidden&, const Hidden&) = default;
};

/// The tessellation as arrays: what files carry and what validate() judges, whoever made it.
struct TessellationArrays {
    Metric metric = Metric::power;          ///< of the distance
    WeightIs weight_is = WeightIs::radius;  ///< what third numbers are
    Order order = Order::index;             ///< of the faces
    std::int64_t sites = 0;                 ///< how many, hidden ones included
    std::vector<Face> faces;                ///< counterclockwise, from the first in order; sorted
    std::vector<Face> neighbours;           ///< neighbours[f][k] is across from faces[f][k]
    std::vector<Hidden> hidden;             ///< sorted by site
    friend bool operator==(const TessellationArrays&, const TessellationArrays&) = default;
};

/// The same tessellation with its faces in the order of index. O(n log n).
[[nodiscard]] TessellationArrays ordered_by_index(const TessellationArrays& arrays);

}  // namespace signum
