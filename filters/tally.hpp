#pragma once
/// Stages of a predicate, and the count of calls that each decided. Counting is a policy of the
/// kernel: NoTally compiles to nothing, Tally counts.

#include <cstdint>

#include "../core/sign.hpp"

namespace signum {

/// The stages from the cheapest to the dearest; see ARCHITECTURE.md.
enum class Stage : std::uint8_t {
    filter,         ///< a rounded number and a bound on its error, or an interval
    refine,         ///< the same in double-doubles
    exact,          ///< expansions, integers, sums that commit no rounding
    essa,           ///< the exact sign of a sum: sign_of_sum
    multiprecision  ///< rationals, dyadic or not
};
inline constexpr int stage_count = 5;

/// The name of a stage, as the tool prints it.
[[nodiscard]] constexpr const char* name_of(Stage stage) noexcept {
    constexpr const char* names[] = {"filter", "refine", "exact", "essa", "multiprecision"};
    return names[static_cast<int>(stage)];
}

/// A sign and the stage that decided it.
struct Decision {
    Sign sign;
    Stage stage;
    bool tied = false;  ///< an exact zero was met that the tie rule resolved
};

}  // namespace signum

namespace signum::filters {

/// Counts calls by predicate and by the stage that decided. Ties are exact zeros that the tie rule
/// resolved.
struct Tally {
    std::uint64_t ccw = 0;
    std::uint64_t in_circle = 0;
    std::uint64_t nearer = 0;
    std::uint64_t stages[stage_count] = {};
    std::uint64_t ties = 0;

    void count_ccw() noexcept { ++ccw; }
    void count_in_circle() noexcept { ++in_circle; }
    void count_nearer() noexcept { ++nearer; }
    void count_stage(Stage stage) noexcept { ++stages[static_cast<int>(stage)]; }
    void count_tie() noexcept { ++ties; }
};

/// Counts nothing, costs nothing.
struct NoTally {
    static void count_ccw() noexcept {}
    static void count_in_circle() noexcept {}
    static void count_nearer() noexcept {}
    static void count_stage(Stage) noexcept {}
    static void count_tie() noexcept {}
};

}  // namespace signum::filters
