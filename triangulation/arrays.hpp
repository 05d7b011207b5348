#pragma once
/// A tessellation as plain arrays of indices.
///
/// Laws:
///  1. n >= 2 visible sites have 2n-2 faces; with the vertex at infinity they tile the sphere.
///  2. A face is a counterclockwise triple of sites, -1 being infinity, rotated so that the
///     smallest number comes first; faces are sorted. One visible site has no face.
///  3. neighbours[f][k] is the face across the edge opposite faces[f][k].
///  4. The arrays depend on the sites alone: not on insertion order, method or seed.

#include <array>
#include <cstdint>
#include <vector>

#include "../core/index.hpp"
#include "metric.hpp"

namespace signum {

/// Three vertices counterclockwise, or the three faces across from them.
using Face = std::array<Index, 3>;

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
    std::int64_t sites = 0;                 ///< how many, hidden ones included
    std::vector<Face> faces;                ///< counterclockwise, the smallest number first, sorted
    std::vector<Face> neighbours;           ///< neighbours[f][k] is across from faces[f][k]
    std::vector<Hidden> hidden;             ///< sorted by site
    friend bool operator==(const TessellationArrays&, const TessellationArrays&) = default;
};

}  // namespace signum
