#include "spatial_order.hpp"

#include <array>
#include <bit>
#include <numeric>

#include "../../core/curve_order.hpp"
#include "../../core/insertion_rounds.hpp"

namespace signum::triangulation {

void order_spatially(const StridedSites& sites, std::span<Index> numbers, std::uint64_t seed) {
    const InsertionRounds rounds(numbers.size(), seed);
    const LargeArray<Index> given(numbers.begin(), numbers.end());
    // The number's place takes as many bits as there are numbers, the round four, the curve the
    // rest.
    constexpr int step = HilbertCurve<2>::bits_per_step;
    const int place_bits = static_cast<int>(std::bit_width(numbers.size()));
    const CurveKeys layout{place_bits, (60 - place_bits) / 2 / step * step};
    LargeArray<std::uint64_t> keys(numbers.size());
    for (std::size_t i = 0; i < keys.size(); ++i)
        keys[i] =
            static_cast<std::uint64_t>(rounds.of(static_cast<std::size_t>(given[i]))) << 60 | i;
    sort_along_curve<2>({keys.data(), keys.size()}, layout, [&](std::size_t i) {
        constexpr std::size_t ahead = 24;
        if (i + ahead < given.size()) sites.prefetch(static_cast<std::size_t>(given[i + ahead]));
        const Site site = sites[static_cast<std::size_t>(given[i])];
        return std::array{site.x, site.y};
    });
    for (std::size_t i = 0; i < keys.size(); ++i) numbers[i] = given[layout.item(keys[i])];
}

LargeArray<Index> spatial_order(const StridedSites& sites, std::uint64_t seed) {
    LargeArray<Index> numbers(sites.size());
    std::iota(numbers.begin(), numbers.end(), 0);
    order_spatially(sites, numbers, seed);
    return numbers;
}

}  // namespace signum::triangulation
