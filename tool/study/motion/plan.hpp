#pragma once
/// The table of experiments with balls that move: which shakers, and who runs them how far.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "../timing.hpp"
#include "setting.hpp"

namespace signum::study {

/// What is done with the balls of a cell.
enum class MotionWork : std::uint8_t {
    structures,  ///< structures propose the pairs: times, events, checks
    accuracy,    ///< exact and rounded arithmetic: times, and what rounding does wrong
    time_steps   ///< strikes and energy as time goes on, of several seeds
};

struct MotionCell {
    MotionSetting setting;
    MotionWork work = MotionWork::structures;
    std::vector<std::string> contestants;  ///< names of structures, or of arithmetics
    double simulated = 10.0;               ///< seconds of the shaker's time
    /// Slow structures end earlier.
    std::uint64_t most_strikes = std::numeric_limits<std::uint64_t>::max();
    double speed = 0.0;            ///< of the discs at the start, see shaker_of()
    double warming_up = 0.0;       ///< strikes a disc before anything is measured
    std::size_t seeds = 1;         ///< 1, 2, ...
    std::size_t passes = 1;        ///< see Cell
    Budget budget = {1, 21, 0.1};  ///< of one pass
};

/// What the study is asked for.
struct MotionScope {
    bool quick = false;
    /// Cells of fewer or more balls are left out.
    std::int64_t least_balls = 1;
    std::int64_t most_balls = std::numeric_limits<std::int64_t>::max();
};

/// The cells in the order in which they are measured.
[[nodiscard]] std::vector<MotionCell> plan_motion(const MotionScope& scope);

/// Roughly how long a pass over a cell takes, the first one or a later one: for a progress bar.
[[nodiscard]] double expected_seconds(const MotionCell& cell, std::size_t pass);

}  // namespace signum::study
