#pragma once
/// Instructions that not every processor of a kind has: fused multiply-add, vectors of four
/// doubles.

// SIGNUM_NARROW: as on a processor that has none of them, for tests.
#if defined(__x86_64__) && !defined(SIGNUM_NARROW)
#define SIGNUM_HAS_WIDE
#endif

#if defined(SIGNUM_HAS_WIDE)
#define SIGNUM_WIDE [[gnu::target("avx2,fma")]]
#else
#define SIGNUM_WIDE
#endif

namespace signum {

/// Whether the processor at hand has them, though the compiler was not told so.
[[nodiscard, gnu::always_inline]] inline bool is_wide() noexcept {
#if defined(SIGNUM_HAS_WIDE)
    return __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0;
#else
    return false;
#endif
}

template <class Body>
SIGNUM_WIDE [[gnu::noinline]] auto run_wide(const Body& body) noexcept {
    return body();
}

/// The result of body(), which is compiled twice, with these instructions and without. Whatever it
/// calls, and itself, has to be inlined always, and it must tell the same either way: a fused
/// operation stands only where it is written (-ffp-contract=off).
template <class Body>
[[gnu::always_inline]] inline auto as_wide_as_possible(const Body& body) noexcept {
    return is_wide() ? run_wide(body) : body();
}

#undef SIGNUM_WIDE
#undef SIGNUM_HAS_WIDE

}  // namespace signum
