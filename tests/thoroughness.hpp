#pragma once
/// How many trials a test has time for: all of them in a release build; fewer without optimization
/// and under the sanitizers, the library's own included, where they take ten times as long.
/// `./test` runs both, so that no trial is lost.

#include <cstdint>
#include <cstdlib>

/// There where a library is, or the program, under the address sanitizer: known when it is linked.
extern "C" [[gnu::weak]] void __asan_init();

namespace signum {

inline const bool is_sanitized = &__asan_init != nullptr;
#if defined(__OPTIMIZE__)
inline const bool is_fast = !is_sanitized;
#else
inline const bool is_fast = false;
#endif

/// For trials that are counted in multiples. SIGNUM_THOROUGH: a slow test of its own of the same
/// source.
#if defined(SIGNUM_THOROUGH)
inline const int thoroughness = 80;
#else
inline const int thoroughness = is_fast ? 8 : 1;
#endif

/// A number that the environment names, such as that of trials on a machine with hours to spare.
inline std::uint64_t asked_for(const char* name, std::uint64_t otherwise) {
    const char* text = std::getenv(name);
    return text == nullptr ? otherwise : std::strtoull(text, nullptr, 10);
}

}  // namespace signum
