#pragma once
/// A call of signum compare, and what it answers, of the plane and of space: a table or JSON.

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "../../triangulation/tessellation.hpp"
#include "../io/text_writer.hpp"
#include "../study/timing.hpp"

#include "outputs.hpp"
#include "sites_call.hpp"

namespace signum::cli {

/// As it was typed. SitesCall::arithmetic is the one that is judged.
struct CompareCall : SitesCall, OutputsCall {
    std::string against = "exact";
    double seconds = 1.0;
    bool json = false;
};

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

/// The table, whose last line says whether these sites need exactness; JSON where it is asked for.
void put_report(TextWriter& text, const ComparedReport& report, bool as_json);

/// In space, cells in place of edges: writes table or JSON to standard output. Throws CallError
/// where the call asks for what there is in the plane alone.
void compare_in_space(const CompareCall& call, const InputSites& sites);

}  // namespace signum::cli
