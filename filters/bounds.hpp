#pragma once
/// What the floating-point filters assume of the machine, and the small functions they share.

#include <bit>
#include <cstdint>

#include <signum/core/contract.hpp>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace signum::filters {

/// Largest relative error of one operation in any rounding mode; rounding to nearest has half of it.
inline constexpr double epsilon = 0x1p-52;

/// |value|; one instruction without <cmath>.
[[nodiscard]] inline double magnitude(double value) noexcept { return __builtin_fabs(value); }

/// The sign of a double that is not 0.
[[nodiscard]] inline int sign_of_nonzero(double value) noexcept {
    return static_cast<int>(std::bit_cast<std::int64_t>(value) >> 63) | 1;
}

/// a == b for finite doubles, also where the hardware reads denormals as zero.
[[nodiscard]] inline bool same_number(double a, double b) noexcept {
    const auto a_bits = std::bit_cast<std::uint64_t>(a);
    const auto b_bits = std::bit_cast<std::uint64_t>(b);
    return a_bits == b_bits || ((a_bits | b_bits) << 1) == 0;
}

/// Whether the thread computes as IEEE 754 prescribes by default: to nearest, denormals neither flushed
/// nor read as zero. Elsewhere overflow may stop at the largest double and a difference lose all its
/// bits, so that a filter declines and lets the colder stages change the environment. One addition of four
/// floats tells: 1 and -1 plus more than half a unit round away from 0 only to nearest, and the sum of two
/// denormals is not 0. The barrier keeps the compiler from folding it and from moving it across a change
/// of the control register.
[[nodiscard]] inline bool environment_is_default() noexcept {
#if defined(__SSE2__)
    __m128 terms = _mm_setr_ps(0x1.8p-24F, -0x1.8p-24F, 0x1p-140F, 0.0F);
    __asm__ volatile("" : "+x"(terms));
    const __m128 sums = _mm_add_ps(terms, _mm_setr_ps(1.0F, -1.0F, 0x1p-140F, 0.0F));
    const __m128 expected = _mm_setr_ps(1.0F + 0x1p-23F, -1.0F - 0x1p-23F, 0x1p-139F, 0.0F);
    return _mm_movemask_epi8(_mm_cmpeq_epi32(_mm_castps_si128(sums), _mm_castps_si128(expected))) ==
           0xFFFF;
#else
    volatile double up = 0x1.8p-53;
    volatile double down = -0x1.8p-53;
    volatile double denormal = 0x1p-1060;
    return up + 1.0 > 1.0 && down - 1.0 < -1.0 && denormal + denormal == 0x1p-1059;
#endif
}

}  // namespace signum::filters
