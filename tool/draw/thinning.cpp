#include "thinning.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace signum {

double smallest_drawn(std::span<const double> sizes, std::size_t limit, double step) {
    if (sizes.size() <= limit) return 0.0;
    std::vector<double> falling(sizes.begin(), sizes.end());
    const auto first_too_many = falling.begin() + static_cast<std::ptrdiff_t>(limit);
    std::nth_element(falling.begin(), first_too_many, falling.end(), std::greater<>());
    // Rounding up hides the last digits in which sizes that should be equal may differ.
    return (std::floor(*first_too_many / step + 1e-6) + 1) * step;
}

}  // namespace signum
