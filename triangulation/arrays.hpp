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
    Index site;
    Index by;
    friend bool operator==(const Hidden&, const Hidden&) = default;
};

/// The tessellation as arrays: what files carry and what validate() judges, whoever made it.
struct TessellationArrays {
    Metric metric = Metric::power;
    WeightIs weight_is = WeightIs::radius;
    std::int64_t sites = 0;
    std::vector<Face> faces;
    std::vector<Face> neighbours;
    std::vector<Hidden> hidden;
    friend bool operator==(const TessellationArrays&, const TessellationArrays&) = default;
};

}  // namespace signum
