#include "front.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace signum::rectangular {

bool sums_are_exact(const StridedSites& sites) noexcept {
    // The exponents of the lowest bit that is set anywhere, and of a bound of all numbers.
    int lowest = 2048;
    int bound = 0;
    for (std::size_t i = 0; i < sites.size(); ++i) {
        const Site site = sites[i];
        for (const double number : {site.x, site.y, site.r}) {
            const auto bits = std::bit_cast<std::uint64_t>(number) << 1;
            if (bits == 0) continue;
            const auto exponent = static_cast<int>(bits >> 53);
            const std::uint64_t fraction = (bits & ((std::uint64_t{1} << 53) - 1)) >> 1 |
                                           static_cast<std::uint64_t>(exponent != 0) << 52;
            const int unit = std::max(exponent, 1);
            lowest = std::min(lowest, unit + std::countr_zero(fraction));
            bound = std::max(bound, unit + static_cast<int>(std::bit_width(fraction)));
        }
    }
    // Eight forms of three numbers each, below 2^5 times the greatest.
    return bound + 5 - lowest <= 53 && bound < 2000;
}

}  // namespace signum::rectangular
