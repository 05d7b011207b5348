#pragma once
/// From where to walk to a place about which nothing is known.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "../../core/index.hpp"
#include "../structure/topology.hpp"

namespace signum::triangulation {

/// A face from which it is not far: that of the nearest of some 2n^(1/3) sites, or a given one if
/// a corner of it is nearer. From there a walk takes O(n^(1/3)) steps on uniform sites (Mücke,
/// Saias and Zhu 1999), from a face anywhere O(n^(1/2)), and O(n) where sites lie on curves.
///
/// face_of is -1 for those that have none; distance(site) is that from the place, roughly and in
/// any measure.
template <class Distance>
[[nodiscard]] Index near_face(const Topology& topology, std::span<const Index> face_of, Index given,
                              const Distance& distance) {
    Index best = given;
    double least = std::numeric_limits<double>::infinity();
    for (const Index v : topology.vertices(given))
        if (v != infinite) least = std::min(least, distance(v));
    const std::uint64_t sites = face_of.size();
    const auto samples = static_cast<std::uint64_t>(2.0 * std::cbrt(static_cast<double>(sites)));
    for (std::uint64_t i = 0; i < samples; ++i) {
        // Multiples of the golden section are spread evenly.
        const std::uint64_t fraction = i * 0x9E37'79B9'7F4A'7C15U >> 32;
        const std::uint64_t v = fraction * sites >> 32;
        if (face_of[v] < 0) continue;
        const double d = distance(static_cast<Index>(v));
        if (d < least) {
            least = d;
            best = face_of[v];
        }
    }
    return best;
}

}  // namespace signum::triangulation
