#pragma once
/// How many trials a test has time for: all of them in a release build; fewer under the sanitizers
/// and without optimization, where what judges the library, rationals most of all, takes ten times
/// as long. `./test` runs both, so that no trial is lost.

namespace signum {

#if defined(__SANITIZE_ADDRESS__) || !defined(__OPTIMIZE__)
inline constexpr bool is_fast = false;
#else
inline constexpr bool is_fast = true;
#endif

/// For trials that are counted in multiples. SIGNUM_THOROUGH: a slow test of its own of the same
/// source.
#if defined(SIGNUM_THOROUGH)
inline constexpr int thoroughness = 80;
#else
inline constexpr int thoroughness = is_fast ? 8 : 1;
#endif

}  // namespace signum
