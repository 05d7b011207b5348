#pragma once
/// The floating-point environments in which a program may call a predicate.

#include <cfenv>
#include <string>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace signum {

/// 0 to 3: the rounding modes; 4 to 7: the same with denormals flushed and read as zero.
#if defined(__SSE2__)
inline constexpr int environments = 8;
#else
inline constexpr int environments = 4;
#endif

inline void enter(int environment) {
    constexpr int modes[] = {FE_TONEAREST, FE_DOWNWARD, FE_UPWARD, FE_TOWARDZERO};
    std::fesetround(modes[environment % 4]);
#if defined(__SSE2__)
    if (environment >= 4) _mm_setcsr(_mm_getcsr() | 0x8040U);
#endif
}

inline void leave() {
#if defined(__SSE2__)
    _mm_setcsr(0x1F80);
#endif
    std::fesetround(FE_TONEAREST);
}

/// function(), with nothing of it outside the environment.
template <class Function>
[[gnu::noinline]] auto within(int environment, const Function& function) {
    enter(environment);
    asm volatile("" : : : "memory");
    auto result = function();
    asm volatile("" : "+m"(result) : : "memory");
    leave();
    return result;
}

inline std::string name_of_environment(int environment) {
    constexpr const char* modes[] = {"to nearest", "downward", "upward", "toward zero"};
    return std::string(modes[environment % 4]) + (environment >= 4 ? ", denormals flushed" : "");
}

}  // namespace signum
