#include "spatial_order.hpp"

#include <array>
#include <bit>
#include <numeric>

#include "curve_order.hpp"

namespace signum::triangulation {

AlongCurve::AlongCurve(const StridedSites& sites, std::span<const Index> numbers,
                       std::uint64_t seed, const Workers& workers)
    : keys_(numbers.size()) {
    const InsertionRounds rounds(numbers.size(), seed);
    last_round_ = rounds.last();
    // The place takes as many bits as there are numbers, the curve the rest.
    constexpr int step = HilbertCurve<2>::bits_per_step;
    const int item_bits = static_cast<int>(std::bit_width(numbers.size())) + round_bits;
    const CurveKeys layout{item_bits, (64 - item_bits) / 2 / step * step};
    place_mask_ = (std::uint64_t{1} << item_bits) - 1;
    workers.each_range(numbers.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            keys_[i] = i << round_bits |
                       static_cast<std::uint64_t>(rounds.of(static_cast<std::size_t>(numbers[i])));
    });
    sort_along_curve<2>(
        keys_, layout,
        [&](std::size_t item) {
            constexpr std::size_t ahead = 24;
            const std::size_t i = item >> round_bits;
            if (i + ahead < numbers.size())
                sites.prefetch(static_cast<std::size_t>(numbers[i + ahead]));
            const Site site = sites[static_cast<std::size_t>(numbers[i])];
            return std::array{site.x, site.y};
        },
        workers);
}

LargeArray<Index> ranks_along_curve(const StridedSites& sites, const Workers& workers) {
    LargeArray<Index> numbers = counted<Index>(workers, sites.size());
    AlongCurve along(sites, numbers, 1, workers);
    workers.each_range(along.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) numbers[along.place(k)] = static_cast<Index>(k);
    });
    along.give_back(workers);
    return numbers;
}

void order_spatially(const StridedSites& sites, std::span<Index> numbers, std::uint64_t seed) {
    const Workers one(1);
    const LargeArray<Index> given(numbers.begin(), numbers.end());
    const AlongCurve along(sites, given, seed, one);
    static_cast<void>(deal(
        one, along.size(), along.rounds(), [&](std::size_t k) { return along.round(k); },
        [](std::size_t) {},
        [&](std::size_t k, std::size_t place) { numbers[place] = given[along.place(k)]; }));
}

LargeArray<Index> spatial_order(const StridedSites& sites, std::uint64_t seed) {
    LargeArray<Index> numbers(sites.size());
    std::iota(numbers.begin(), numbers.end(), 0);
    order_spatially(sites, numbers, seed);
    return numbers;
}

}  // namespace signum::triangulation
