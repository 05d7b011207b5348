#pragma once
/// What the floating-point filters assume of the machine, and the small functions they share.

#include <bit>
#include <cstdint>
#include <limits>

#include "../core/contract.hpp"

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace signum::filters {

/// Largest relative error of one operation in any rounding mode; rounding to nearest has half of
/// it.
inline constexpr double epsilon = 0x1p-52;

/// |value|; one instruction without <cmath>.
[[nodiscard]] inline double magnitude(double value) noexcept {
    return __builtin_fabs(value);
}
[[nodiscard]] inline float magnitude(float value) noexcept {
    return __builtin_fabsf(value);
}

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

/// The sign of a - b for finite doubles, also where the hardware reads denormals as zero: doubles
/// as integers of the same order, both zeros the same.
[[nodiscard]] inline int compare_numbers(double a, double b) noexcept {
    const auto place = [](double value) {
        const auto bits = std::bit_cast<std::int64_t>(value);
        return bits < 0 ? std::numeric_limits<std::int64_t>::min() - bits : bits;
    };
    return static_cast<int>(place(a) > place(b)) - static_cast<int>(place(a) < place(b));
}

/// What environment_is_default() adds. Never written, yet not const: the compiler must suppose that
/// any call that it cannot see through may change it, and so neither folds the additions nor keeps
/// their results across the call that changes the environment. Out of a loop without such a call it
/// takes them, and there they cost nothing.
alignas(16) extern float environment_witness[4];

/// Whether the thread computes as IEEE 754 prescribes by default: to nearest, denormals neither
/// flushed nor read as zero. Elsewhere overflow may stop at the largest double and a difference
/// lose all its bits, so that a filter declines and lets the colder stages change the environment.
/// One addition of four floats tells: 1 and -1 plus more than half a unit round away from 0 only to
/// nearest, and the sum of two denormals is not 0.
[[nodiscard]] inline bool environment_is_default() noexcept {
    const auto& w = environment_witness;
#if defined(__SSE2__)
    const __m128 sums = _mm_add_ps(_mm_load_ps(w), _mm_setr_ps(1.0F, -1.0F, 0x1p-140F, 0.0F));
    const __m128 expected = _mm_setr_ps(1.0F + 0x1p-23F, -1.0F - 0x1p-23F, 0x1p-139F, 0.0F);
    return _mm_movemask_epi8(_mm_cmpeq_epi32(_mm_castps_si128(sums), _mm_castps_si128(expected))) ==
           0xFFFF;
#else
    return w[0] + 1.0F > 1.0F && w[1] - 1.0F < -1.0F && w[2] + 0x1p-140F != 0.0F;
#endif
}

}  // namespace signum::filters
