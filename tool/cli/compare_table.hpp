#pragma once
/// The table of signum compare, of the plane and of space.

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "../../triangulation/tessellation.hpp"
#include "../io/text_writer.hpp"
#include "../study/timing.hpp"

#include "compare_call.hpp"

namespace signum::cli {

/// What one arithmetic made of the sites: a column.
struct ComparedRun {
    std::string_view arithmetic;
    bool is_broken = false;  ///< and then there is neither a time nor a count
    std::string broken;      ///< where the structure broke
    study::Interval seconds = {};
    Counts counts = {};
    std::optional<Statistics> statistics;  ///< nothing where calls are not counted
};

/// `kind` is edge or cell; `ratio` of times is the second run's to the first one's; the answer
/// comes last. `counts_calls`: there are rows of statistics.
void put_table(TextWriter& text, std::string_view kind, const std::array<ComparedRun, 2>& runs,
               bool counts_calls, const std::optional<study::Interval>& ratio,
               std::string_view answer);

}  // namespace signum::cli
