#pragma once
/// Grids: where all numbers are multiples of one power of two and near one another, doubles do not
/// round, and an exact zero is one without further question.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <initializer_list>

#include "../../core/strided_sites.hpp"

namespace signum::triangulation {

/// u⁴ of the greatest power of two u of which all coordinates are multiples, and of whose square
/// all weights are, but 2^240 at most; without `weighted` third numbers do not matter. 0 where the
/// extent of the sites is beyond 2^40 u, or u below 2^-240: knowing it is of no use then. O(n), and
/// nearly nothing for sites that lie on no grid.
[[nodiscard]] inline double fourth_power_of_grid_unit(const StridedSites& sites, bool weighted) {
    constexpr int far = 40;     // bits from the unit to the extent
    constexpr int range = 240;  // u⁴ is neither tiny nor huge
    int unit = range;           // exponents
    int extent = -range;
    // The exponent of a number's last bit that is set.
    const auto last_bit = [](double value) {
        const auto bits = std::bit_cast<std::uint64_t>(value);
        const auto fraction = bits & ((std::uint64_t{1} << 52) - 1);
        const auto exponent = static_cast<int>(bits >> 52 & 0x7FF);
        return (exponent == 0 ? -1074 : exponent - 1075) +
               std::countr_zero(exponent == 0 ? fraction : fraction | std::uint64_t{1} << 52);
    };
    for (std::size_t i = 0; i < sites.size(); ++i) {
        const Site site = sites[i];
        for (const double value : {site.x, site.y})
            if (value != 0.0) unit = std::min(unit, last_bit(value));
        if (weighted && site.r != 0.0) {
            const int bit = last_bit(site.r);
            unit = std::min(unit, sites.third_is_weight() ? bit >> 1 : bit);
        }
        for (const double from_first : {site.x - sites[0].x, site.y - sites[0].y})
            if (from_first != 0.0 && std::isfinite(from_first))
                extent = std::max(extent, std::ilogb(from_first));
        if (unit < -range || extent - unit > far) return 0.0;
    }
    return std::ldexp(1.0, 4 * unit);
}

}  // namespace signum::triangulation
