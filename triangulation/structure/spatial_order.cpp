#include "spatial_order.hpp"

#include <array>
#include <bit>

#include "../../core/curve_order.hpp"
#include "../../core/insertion_rounds.hpp"

namespace signum::triangulation {

LargeArray<Index> spatial_order(const StridedSites& sites, std::uint64_t seed) {
    const InsertionRounds rounds(sites.size(), seed);
    // The site takes as many bits as the number of sites asks, the round four, the curve the rest.
    constexpr int step = HilbertCurve<2>::bits_per_step;
    const int site_bits = static_cast<int>(std::bit_width(sites.size()));
    const CurveKeys layout{site_bits, (60 - site_bits) / 2 / step * step};
    LargeArray<std::uint64_t> keys(sites.size());
    for (std::size_t i = 0; i < keys.size(); ++i)
        keys[i] = static_cast<std::uint64_t>(rounds.of(i)) << 60 | i;
    sort_along_curve<2>({keys.data(), keys.size()}, layout, [&](std::size_t i) {
        const Site site = sites[i];
        return std::array{site.x, site.y};
    });

    LargeArray<Index> result(keys.size());
    for (std::size_t i = 0; i < keys.size(); ++i)
        result[i] = static_cast<Index>(layout.item(keys[i]));
    return result;
}

}  // namespace signum::triangulation
