#include "expansion.hpp"

#include <cmath>

namespace signum::exact::terms {

/// The pass is FAST-EXPANSION-SUM, which alone does not keep law 3: from 2^-100 -
/// 0x1.fffffffffffffp-46 and 2^-100 + 0x1.fep-91 + 0x1.0ed7a4c3d1ep-46 it makes -2^-99 and
/// 0x1.1f01p-82, which are adjacent; and terms added up again and again could come to overlap. So
/// what it leaves is summed once more, from below, at the same time.
///
/// Proof. 1. The lows and the last high do not overlap. After some additions, let all terms still
/// to come be multiples of 2^c, c as large as possible, and x the next term of the expansion that
/// has the bit 2^c, say e: |x| <= 2^(c+53) - 2^c. By law 3 the terms of e so far add up to less
/// than 2^(c-1). Let y, with last bit 2^d, be the latest term of f; those before it add up to less
/// than 2^(d-1). |y| <= |x|, and if d >= c even |y| <= 2^(c+53) - 2^d. In both cases all terms so
/// far add up to less than 2^(c+53). So |high| <= 2^(c+53), and |low| is at most 2^(c-1), half the
/// last bit of what is still to come, and at most half the last place of high.
/// 2. Of terms that do not overlap, carry is at most the last bit of the next. What quick_two_sum
/// then leaves behind is at most half the last place of carry, which is even if it is just half,
/// and 2^-54 times the last bit of the next: adjacent to neither.
int sum(std::span<const double> e, std::span<const double> f, double* h) noexcept {
    int size = 0;
    double high = 0.0;
    double carry = 0.0;
    const auto append = [&](double term) {
        h[size] = term;
        size += static_cast<int>(term != 0.0);
    };
    const auto compress = [&](double term) {
        const TwoTerms next = quick_two_sum(term, carry);
        append(next.low);
        carry = next.high;
    };
    const auto add = [&](double term) {
        const TwoTerms next = two_sum(high, term);
        compress(next.low);
        high = next.high;
    };
    std::size_t i = 0;
    std::size_t j = 0;
    while (i < e.size() && j < f.size()) {
        const bool from_e = std::fabs(e[i]) < std::fabs(f[j]);
        add(from_e ? e[i] : f[j]);
        i += static_cast<std::size_t>(from_e);
        j += static_cast<std::size_t>(!from_e);
    }
    while (i < e.size()) add(e[i++]);
    while (j < f.size()) add(f[j++]);
    compress(high);
    append(carry);
    return size;
}

}  // namespace signum::exact::terms
