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

// The library's sources define functions that these two files do not call.
#pragma GCC diagnostic ignored "-Wunused-function"
#if defined(__clang__)
// It does not tell that it may reassociate (-funsafe-math-optimizations): here it may not.
#pragma float_control(precise, on)
#pragma clang diagnostic ignored "-Wunused-const-variable"
#pragma clang diagnostic ignored "-Wunneeded-internal-declaration"
#endif
