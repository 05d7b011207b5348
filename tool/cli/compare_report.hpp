#pragma once
/// What signum compare answers, of the plane and of space: a table or JSON.

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "../../triangulation/options.hpp"
#include "../../triangulation/tessellation.hpp"
#include "../study/timing.hpp"

namespace signum::cli {

/// How many edges (in space cells) of a tessellation there are, and how they were judged.
struct Counts {
    std::int64_t all = 0;
    std::size_t wrong = 0;
    std::size_t different = 0;
};

/// What one arithmetic made of the sites.
struct ComparedRun {
    Arithmetic arithmetic;
    bool is_broken = false;   ///< and then there is neither a time nor a count
    std::string broken = {};  ///< where the structure broke
    study::Interval seconds = {};
    Counts counts = {};
    std::optional<Statistics> statistics = {};  ///< nothing where calls are not counted
};

struct ComparedReport {
    std::string_view kind;                      ///< what is judged: edge or cell
    std::array<ComparedRun, 2> runs;            ///< the one judged, and the one against it
    bool counts_calls = false;                  ///< runs that did not break have statistics
    std::optional<study::Interval> ratio = {};  ///< of times, the second to the first
    std::string margins = {};                   ///< JSON
    /// How near the sites are to ties, with its comma or semicolon.
    std::string near = {};
};

/// Builds with the arithmetic of a run, and says how many seconds it took.
using TimedBuild = std::function<double(Arithmetic)>;
/// Times of the runs that did not break, in turns.
void time_runs(ComparedReport& report, double seconds, const TimedBuild& build);

/// The table, whose last line says whether these sites need exactness, or JSON; to standard output,
/// or to standard error.
void put_report(const ComparedReport& report, bool as_json, bool to_errors = false);

}  // namespace signum::cli
