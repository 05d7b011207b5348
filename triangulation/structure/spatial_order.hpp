#pragma once
/// The order of insertion: random rounds, each along a Hilbert curve.
///
/// Each round holds about seven eighths of the sites that the rounds before it leave (biased
/// randomized insertion order, Amenta, Choi and Rote 2003): randomness keeps the expected work at
/// O(n log n) for any input, the curve keeps successive sites close, so that walks are short and
/// memory is warm. The result of a triangulation does not depend on it.

#include <cstddef>
#include <cstdint>
#include <span>

#include "../../core/index.hpp"
#include "../../core/insertion_rounds.hpp"
#include "../../core/large_array.hpp"
#include "../../core/parallel.hpp"
#include "../../core/strided_sites.hpp"

namespace signum::triangulation {

/// Some of the sites, given by their numbers, along the curve, and in which round each is inserted.
class AlongCurve {
 public:
    /// Nothing is copied. Ties go to who was given first. O(n log n), by the workers.
    AlongCurve(const StridedSites& sites, std::span<const Index> numbers, std::uint64_t seed,
               const Workers& workers);

    /// Nothing is asked any more.
    void give_back(const Workers& workers) { signum::give_back(workers, keys_); }

    [[nodiscard]] std::size_t size() const noexcept { return keys_.size(); }
    /// Where the k-th one along the curve stands among the numbers.
    [[nodiscard]] std::size_t place(std::size_t k) const noexcept {
        return (keys_[k] & place_mask_) >> round_bits;
    }
    /// The k-th one's round.
    [[nodiscard]] std::size_t round(std::size_t k) const noexcept {
        return keys_[k] & ((std::size_t{1} << round_bits) - 1);
    }
    /// How many there are.
    [[nodiscard]] std::size_t rounds() const noexcept {
        return static_cast<std::size_t>(last_round_) + 1;
    }

 private:
    static constexpr int round_bits = 4;

    /// From high bits to low: the place on the curve, that among the numbers, the round.
    LargeArray<std::uint64_t> keys_;
    std::uint64_t place_mask_ = 0;
    int last_round_ = 0;
};

/// The place along the curve of every site, of those at one place the first one first.
[[nodiscard]] LargeArray<Index> ranks_along_curve(const StridedSites& sites,
                                                  const Workers& workers);

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
