#pragma once
/// The tables of experiments: which sites or balls, and who works on them. A study is such a table,
/// cell by cell; nothing else decides what is measured.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "../../triangulation/tessellation.hpp"
#include "rows.hpp"
#include "timing.hpp"

namespace signum::study {

/// What is done with the sites or balls of a cell.
enum class Work : std::uint8_t {
    construction,  ///< contestants build the tessellation: times, wrong edges (cells), calls by
                   ///< stage
    deletion,      ///< sites go into a tessellation one by one, and come out again
    stage_cost,    ///< what a call costs that a stage decides
    first_error,   ///< the greatest perturbation at which inexact arithmetic errs
    margin,        ///< how near to zero the determinants come
    structures,    ///< structures propose the pairs of balls: times, events, checks
    rounding,      ///< exact and rounded arithmetic move balls: times, and what rounding does wrong
    time_steps     ///< strikes and energy as time goes on, of several seeds
};

struct Cell {
    Setting setting = {};
    Work work = Work::construction;
    int dimension = 2;                          ///< of the sites: of the plane, 3 in space
    std::vector<std::string> contestants = {};  ///< names of arithmetics, methods or structures
    std::size_t sets = 1;                       ///< of sites or balls, of seeds from 1
    /// How often it is measured. A machine is faster in one minute than in the next, which no
    /// interval knows that is taken within a second; so times are taken in passes over the whole
    /// plan, and what is told is the median of the passes' medians, and its interval.
    std::size_t passes = 1;
    Budget budget = {1, 21, 0.1};  ///< of one pass
    // Of balls alone.
    double simulated = 10.0;  ///< seconds of the shaker's time
    /// Slow structures end earlier.
    std::uint64_t most_strikes = std::numeric_limits<std::uint64_t>::max();
    double speed = 0.0;       ///< of the discs at the start, see shaker_of()
    double warming_up = 0.0;  ///< strikes a disc before anything is measured
};

/// What the study is asked for.
struct Scope {
    bool quick = false;
    std::vector<Metric> metrics = {all_metrics.begin(), all_metrics.end()};
    /// Cells of fewer or more sites, or balls, are left out.
    std::int64_t least_sites = 1;
    std::int64_t most_sites = std::numeric_limits<std::int64_t>::max();
};

/// The cells in the order in which they are measured: what is cheap and new to a reader first, so
/// that a study that is cut off has something of every figure.
[[nodiscard]] std::vector<Cell> plan(const Scope& scope);

/// The same in space: distributions of space, the power metric. Deletion and margins are not asked
/// about there.
[[nodiscard]] std::vector<Cell> plan_in_space(const Scope& scope);

/// That of balls that move: which shakers, and who runs them how far.
[[nodiscard]] std::vector<Cell> plan_motion(const Scope& scope);

/// Roughly how long a pass over a cell takes, the first one or a later one: for a progress bar.
[[nodiscard]] double expected_seconds(const Cell& cell, std::size_t pass);

}  // namespace signum::study
