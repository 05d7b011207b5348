#pragma once
/// Contracts: what a caller promises, checked in debug builds and free in release builds.

#include <cassert>

#define SIGNUM_EXPECTS(condition) assert(condition)

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0)
#error "signum needs IEEE arithmetic: compile without -ffast-math and -ffinite-math-only"
#endif
#if defined(__FLT_EVAL_METHOD__) && __FLT_EVAL_METHOD__ != 0 && __FLT_EVAL_METHOD__ != 16
#error "signum needs double arithmetic without excess precision: on x86 compile with -mfpmath=sse"
#endif
