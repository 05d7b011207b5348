#if __cplusplus < 201703L
#error "signum needs C++17: compile with -std=c++17"
#endif
#if !defined(__GNUC__)
#error \
    "signum needs GCC or Clang (on Windows MinGW or clang), for it tells their optimizers what must not move"
#endif
#if !defined(__SSE2__) && (defined(__i386__) || defined(__x86_64__))
#error "signum needs SSE2: compile with -msse2 -mfpmath=sse"
#endif
#if defined(__SSE2__)
#include <immintrin.h>
#else
#include <cfenv>
#endif

// What is here for all of signum is not all asked for here.
#pragma GCC diagnostic ignored "-Wunused-function"
#if defined(__clang__)
#pragma clang diagnostic ignored "-Wunused-const-variable"
#pragma clang diagnostic ignored "-Wunneeded-internal-declaration"
#endif
