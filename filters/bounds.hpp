#pragma once
/// What the floating-point filters assume of the machine, and the small functions they share.

#include <bit>
#include <cstdint>

#include <signum/core/contract.hpp>

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

/// Whether denormals are neither flushed nor read as zero, so that sums and differences keep their
/// relative error however small they are. One addition; the barrier keeps the compiler from folding it and
/// from moving it across a change of the control register.
[[nodiscard]] inline bool underflow_is_gradual() noexcept {
    double denormal = 0x1p-1060;
#if defined(__x86_64__)
    __asm__ volatile("" : "+x"(denormal));
#else
    __asm__ volatile("" : "+w"(denormal));
#endif
    return std::bit_cast<std::uint64_t>(denormal + denormal) != 0;
}

}  // namespace signum::filters
