#pragma once
/// The floating-point environment of a filter, and the operands that enter it.
///
/// A bound holds for operands that are doubles, and for arithmetic that is done in one environment.
/// An inlined filter has neither by itself: to a compiler an operand may be the sum or the product
/// that the caller computed it by, to be taken apart or fused into the filter's first subtraction;
/// and an addition is an addition, whatever the rounding mode, so that one done before fesetround
/// may serve after it. So every filter takes its operands through pinned().
///
/// Laws:
///  1. A pinned operand is the double itself: to the compiler a number of unknown origin.
///  2. What is computed from a pinned operand is computed after every call before it that may
///     write memory: an empty asm makes the operand out of itself and of `environment_witness`,
///     which such a call may have changed. What changes the environment is such a call, or an
///     intrinsic that compilers take for one.
///  3. What decides a branch is computed before the calls behind the branch. A filter's verdict is
///     a branch, for a colder stage stands behind it.
/// So what a filter computes between two changes of the environment stays there, the test of the
/// environment included. It costs nothing: no instruction comes of the asm, and the test leaves a
/// loop that contains no such call.

#include "../core/contract.hpp"
#include "../core/site.hpp"

SIGNUM_IEEE_BEGIN

namespace signum::filters {

/// Never written, yet not const: the compiler must suppose that any call that it cannot see through
/// may change it.
alignas(16) extern float environment_witness[4];

/// Whether the thread computes as IEEE 754 prescribes by default: to nearest, denormals neither
/// flushed nor read as zero. Elsewhere overflow may stop at the largest double and a difference
/// lose all its bits, so that a filter declines and lets the colder stages change the environment.
/// One addition of four floats tells: 1 and -1 plus more than half a unit round away from 0 only to
/// nearest, and the sum of two denormals is not 0.
[[nodiscard]] inline bool environment_is_default() noexcept {
    const auto& w = environment_witness;
#if defined(__SSE2__)
    // By the compilers' own words: <emmintrin.h> takes a fifth of the time that a header may take.
    using Floats = float __attribute__((vector_size(16), may_alias));
    using Flags = int __attribute__((vector_size(16)));
    const Floats sums = *reinterpret_cast<const Floats*>(&w) + Floats{1.0F, -1.0F, 0x1p-140F, 0.0F};
    const Floats expected = {1.0F + 0x1p-23F, -1.0F - 0x1p-23F, 0x1p-139F, 0.0F};
    return __builtin_ia32_movmskps((Floats)((Flags)sums == (Flags)expected)) == 0xF;
#else
    return w[0] + 1.0F > 1.0F && w[1] - 1.0F < -1.0F && w[2] + 0x1p-140F != 0.0F;
#endif
}

// A register for a double, if the compiler is told which.
#if defined(__SSE2__)
#define SIGNUM_REGISTER "+x"
#elif defined(__aarch64__)
#define SIGNUM_REGISTER "+w"
#else
#define SIGNUM_REGISTER "+m"
#endif

/// The operand, of unknown origin: law 1 alone, for one that meets none but pinned ones. Two
/// questions about the same double may share it, and a loop that asks about one keeps it.
[[nodiscard, gnu::always_inline]] inline double opaque(double operand) noexcept {
    asm("" : SIGNUM_REGISTER(operand));
    return operand;
}

/// The operand, of unknown origin and of this moment.
[[nodiscard, gnu::always_inline]] inline double pinned(double operand) noexcept {
    asm("" : SIGNUM_REGISTER(operand) : "m"(environment_witness));
    return operand;
}

/// Two doubles at once: an operation on them is that operation on each, and one instruction where
/// processors have it.
using Two = double __attribute__((vector_size(16)));
[[nodiscard, gnu::always_inline]] inline Two pinned(Two operand) noexcept {
    asm("" : SIGNUM_REGISTER(operand) : "m"(environment_witness));
    return operand;
}

#undef SIGNUM_REGISTER

[[nodiscard, gnu::always_inline]] inline Point pinned(const Point& p) noexcept {
    return {pinned(p.x), pinned(p.y)};
}
[[nodiscard, gnu::always_inline]] inline Site pinned(const Site& s) noexcept {
    return {pinned(s.x), pinned(s.y), pinned(s.r)};
}
[[nodiscard, gnu::always_inline]] inline power::Site pinned(const power::Site& s) noexcept {
    return {pinned(s.x), pinned(s.y), pinned(s.w)};
}
[[nodiscard, gnu::always_inline]] inline Point3 pinned(const Point3& p) noexcept {
    return {pinned(p.x), pinned(p.y), pinned(p.z)};
}
[[nodiscard, gnu::always_inline]] inline Site3 pinned(const Site3& s) noexcept {
    return {pinned(s.x), pinned(s.y), pinned(s.z), pinned(s.r)};
}
[[nodiscard, gnu::always_inline]] inline power::Site3 pinned(const power::Site3& s) noexcept {
    return {pinned(s.x), pinned(s.y), pinned(s.z), pinned(s.w)};
}

}  // namespace signum::filters

SIGNUM_IEEE_END
