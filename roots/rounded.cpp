#include "rounded.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>

namespace signum::roots {

using exact::Dyadic;
using exact::Integer;

Approximations rounded(const std::vector<Integer>& c, int step) {
    Approximations result;
    result.degree = static_cast<int>(c.size()) - 1;
    std::array<double, most_degree + 1> fraction{};
    std::array<std::int64_t, most_degree + 1> exponent{};
    std::int64_t most = std::numeric_limits<std::int64_t>::min();
    for (std::size_t i = 0; i < c.size(); ++i) {
        if (c[i].is_zero()) continue;
        const exact::LeadingDigits digits = exact::leading_digits(c[i]);
        fraction[i] = digits.fraction;
        exponent[i] = digits.exponent + static_cast<std::int64_t>(i) * step;
        most = std::max(most, exponent[i]);
    }
    for (std::size_t i = 0; i < c.size(); ++i) {
        if (c[i].is_zero()) continue;
        const std::int64_t place = exponent[i] - most;
        // Below the range it is 0 with an error. Digits are cut off: less than 2^-52 of the number.
        if (place < -900) {
            result.c[i] = {0.0, 0x1p-900};
        } else {
            const double value =
                fraction[i] * std::bit_cast<double>(static_cast<std::uint64_t>(place + 1023) << 52);
            result.c[i] = {value, filters::epsilon * filters::magnitude(value)};
        }
    }
    return result;
}

/// With t = m / 2^k it is, times 2^(kn), sum c_i 2^(k(n-i)) (m + w)^i, w = 2^k s: in integers, by
/// Horner's rule again and again.
Approximations shifted(const exact::Polynomial& p, double t) {
    const Dyadic number(t);
    Integer m = number.significand();
    if (number.exponent() > 0) m <<= number.exponent();
    const int k = std::max(-number.exponent(), 0);
    std::vector<Integer> c = p.coefficients();
    const std::size_t n = c.size() - 1;
    for (std::size_t i = 0; i < n; ++i) c[i] <<= k * static_cast<int>(n - i);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = n; j-- > i;) c[j] += m * c[j + 1];
    return rounded(c, k);
}

}  // namespace signum::roots
