#pragma once
/// What the floating-point filters assume of the machine, and the small functions they share.

#include <cstdint>

#include "environment.hpp"

namespace signum::filters {

/// Largest relative error of one operation in any rounding mode; rounding to nearest has half of
/// it.
inline constexpr double epsilon = 0x1p-52;

/// |value|; one instruction without <cmath>.
[[nodiscard]] constexpr double magnitude(double value) noexcept {
    return __builtin_fabs(value);
}
[[nodiscard]] constexpr float magnitude(float value) noexcept {
    return __builtin_fabsf(value);
}
[[nodiscard, gnu::always_inline]] inline Two magnitude(Two values) noexcept {
    using Bits = std::int64_t __attribute__((vector_size(16)));
    return (Two)((Bits)values & INT64_MAX);
}
[[nodiscard, gnu::always_inline]] inline Two max(Two a, Two b) noexcept {
    return a > b ? a : b;
}

/// Whether each of the values exceeds its bound; none that is NaN does.
[[nodiscard, gnu::always_inline]] inline bool all_exceed(Two values, Two bounds) noexcept {
#if defined(__SSE2__)
    return __builtin_ia32_movmskpd((Two)(values > bounds)) == 3;
#else
    return values[0] > bounds[0] && values[1] > bounds[1];
#endif
}

/// What a filter compares: a rounded number, and the bound on its error. The formulas of filters
/// make these of any type of number, so that what is proved of them (tests/structure/proofs) is
/// what is computed.
template <class Number>
struct Compared {
    Number value;
    Number bound;
};

/// The sign of a double that is not 0.
[[nodiscard]] inline int sign_of_nonzero(double value) noexcept {
    return static_cast<int>(__builtin_bit_cast(std::int64_t, value) >> 63) | 1;
}

/// a == b for finite doubles, also where the hardware reads denormals as zero.
[[nodiscard]] inline bool same_number(double a, double b) noexcept {
    const auto a_bits = __builtin_bit_cast(std::uint64_t, a);
    const auto b_bits = __builtin_bit_cast(std::uint64_t, b);
    return a_bits == b_bits || ((a_bits | b_bits) << 1) == 0;
}

/// The sign of a - b for finite doubles, also where the hardware reads denormals as zero: doubles
/// as integers of the same order, both zeros the same.
[[nodiscard]] inline int compare_numbers(double a, double b) noexcept {
    const auto place = [](double value) {
        const auto bits = __builtin_bit_cast(std::int64_t, value);
        return bits < 0 ? INT64_MIN - bits : bits;
    };
    return static_cast<int>(place(a) > place(b)) - static_cast<int>(place(a) < place(b));
}

}  // namespace signum::filters
