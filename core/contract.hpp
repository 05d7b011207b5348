#pragma once
/// Contracts: what a caller promises, checked in debug builds and free in release builds.

#include <cassert>

#define SIGNUM_EXPECTS(condition) assert(condition)

// What a compiler says of itself: that sums may be taken in another order, that there are no
// infinities, that intermediate results are wider than a double, that constants are floats.
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || \
    (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0)
#error \
    "signum needs IEEE arithmetic: compile without -ffast-math, -funsafe-math-optimizations, -fassociative-math and -ffinite-math-only"
#endif
#if defined(__FLT_EVAL_METHOD__) && __FLT_EVAL_METHOD__ != 0 && __FLT_EVAL_METHOD__ != 16
#error \
    "signum needs IEEE arithmetic: compile without -funsafe-math-optimizations and -fassociative-math, on x86 with -mfpmath=sse"
#endif
static_assert(0x1p-1000 > 0.0,
              "signum needs IEEE arithmetic: compile without -fsingle-precision-constant");

/// Clang compiles what stands between these two, outside all namespaces, as it is written. Some of
/// its versions take sums in another order without a macro that tells, but here they do as they are
/// told.
#if defined(__clang__)
#define SIGNUM_IEEE_BEGIN                                                \
    _Pragma("float_control(push)") _Pragma("float_control(precise, on)") \
        _Pragma("clang fp contract(off)")
#define SIGNUM_IEEE_END _Pragma("float_control(pop)")
#else
#define SIGNUM_IEEE_BEGIN
#define SIGNUM_IEEE_END
#endif
