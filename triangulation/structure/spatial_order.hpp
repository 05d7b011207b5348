#pragma once
/// The order of insertion: random rounds, each along a Hilbert curve.
///
/// Each round holds about seven eighths of the sites that the rounds before it leave (biased
/// randomized insertion order, Amenta, Choi and Rote 2003): randomness keeps the expected work at
/// O(n log n) for any input, the curve keeps successive sites close, so that walks are short and
/// memory is warm. The result of a triangulation does not depend on it.

#include <cstdint>
#include <span>

#include "../../core/index.hpp"
#include "../../core/large_array.hpp"
#include "../../core/strided_sites.hpp"

namespace signum::triangulation {

/// A permutation of 0 … sites.size()-1. Clusters of any depth keep the locality of the curve: cells
/// that hold many sites are ordered again on a scale of their own. Deterministic; O(n log n).
/// Preconditions: finite coordinates, at most max_sites.
[[nodiscard]] LargeArray<Index> spatial_order(const StridedSites& sites, std::uint64_t seed);
/// The same for some of the sites, given by their numbers, which are put into that order.
void order_spatially(const StridedSites& sites, std::span<Index> numbers, std::uint64_t seed);

/// The sites of an array, of any kind.
template <class S>
[[nodiscard]] StridedSites view_of(std::span<S> sites) noexcept {
    if (sites.empty()) return {};
    return {sites.size(), sizeof(S), &sites.front().x, &sites.front().y};
}

}  // namespace signum::triangulation
