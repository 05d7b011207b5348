#pragma once
/// Results as rows: what was measured at, who was measured, and a number with its interval. A row
/// is a line of a table, so that a study grows line by line, and goes on where it stopped.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "timing.hpp"

namespace signum::study {

/// The sites of a cell, and what is asked of them. The names are those of the command line.
struct Setting {
    std::string experiment;
    std::string metric;
    std::string distribution;
    std::int64_t sites = 0;
    double perturbation = 0.0;
    double radius_from = 0.0;
    double radius_to = 0.0;

    static constexpr std::array<std::string_view, 7> columns = {
        "experiment",   "metric",      "distribution", "sites",
        "perturbation", "radius_from", "radius_to"};
    /// What stands in the columns, to be read or written.
    template <class Self>
    [[nodiscard]] static auto fields(Self& self) {
        return std::tie(self.experiment, self.metric, self.distribution, self.sites,
                        self.perturbation, self.radius_from, self.radius_to);
    }
    friend bool operator==(const Setting&, const Setting&) = default;
};

/// Of a study whose cells are told by a type with `columns` and `fields`: Setting, MotionSetting.
template <class At>
struct RowOf {
    At setting;
    std::string contestant;  ///< an arithmetic, a method, a stage
    std::string quantity;    ///< what value is; its unit where it has one
    Interval value;
};
using Row = RowOf<Setting>;

/// The quantity of the row that ends a pass over a cell: the seconds that it took, all in all.
inline constexpr std::string_view end_of_cell = "cell_seconds";

/// That of a construction: the share of the sets on which inexact arithmetic lost its way.
inline constexpr std::string_view broken_percent = "broken_percent";

/// The first line of the table.
template <class At = Setting>
[[nodiscard]] std::string csv_header();
/// A row, with its end of line; numbers read back as the same doubles.
template <class At>
[[nodiscard]] std::string csv_line(const RowOf<At>& row);
/// What tells one cell from all others.
template <class At>
[[nodiscard]] std::string key_of(const At& setting) {
    return csv_line(RowOf<At>{setting, "", "", {}});
}

/// The passes over cells that a table holds completely.
template <class At>
struct TableOf {
    std::vector<RowOf<At>> rows;
    std::size_t bytes = 0;  ///< where the last complete pass over a cell ends
};

/// Reads a table, whose end may be missing: what follows the last complete pass over a cell is
/// left out.
/// Throws std::invalid_argument, with the number of the line, where a whole line is no row.
template <class At = Setting>
[[nodiscard]] TableOf<At> read_csv(std::string_view text);

/// What the passes say together, in the order in which quantities first come: the median of their
/// medians, with its interval; for end_of_cell the sum. What was measured once stays as it is.
template <class At>
[[nodiscard]] std::vector<RowOf<At>> combined(const std::vector<RowOf<At>>& passes);

/// Rows as JSON objects in an array.
template <class At>
[[nodiscard]] std::string json_array(const std::vector<RowOf<At>>& rows);

}  // namespace signum::study
