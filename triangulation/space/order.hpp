#pragma once
/// The order of insertion: random rounds, each along a Hilbert curve of space. As
/// triangulation/structure/spatial_order.hpp, which is that of the plane.

#include <array>
#include <cstdint>
#include <functional>
#include <span>

#include "../../core/index.hpp"
#include "../../core/large_array.hpp"
#include "../../core/site.hpp"

namespace signum::spatial {

/// A permutation of 0 … sites-1; `place(i)` is where site i lies. Deterministic; O(n log n).
[[nodiscard]] LargeArray<Index> insertion_order(std::size_t sites,
                                                const std::function<Point3(Index)>& place,
                                                std::uint64_t seed);
/// The same for some of the sites, given by their numbers, which are put into that order.
void put_in_insertion_order(std::span<Index> sites, const std::function<Point3(Index)>& place,
                            std::uint64_t seed);

}  // namespace signum::spatial
