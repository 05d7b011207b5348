#pragma once
/// Results as rows: what was measured at, who was measured, and a number with its interval. A row
/// is a line of a table, so that a study grows line by line, and goes on where it stopped.

#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "timing.hpp"

namespace signum::study {

/// The sites or balls of a cell, and what is asked of them.
struct Setting {
    std::string experiment = {};
    // Of sites. The names are those of the command line.
    std::string metric = {};
    std::string distribution = {};
    std::int64_t count = 0;  ///< of sites, or of balls
    double perturbation = 0.0;
    double radius_from = 0.0;
    double radius_to = 0.0;
    // Of discs in a box that shakes.
    double size_ratio = 1.0;  ///< the largest radius to the smallest
    double packing = 0.0;     ///< the share of the box that balls fill
    double time_step = 0.0;   ///< in seconds; 0: from event to event

    friend auto operator<=>(const Setting&, const Setting&) = default;
};

struct Row {
    Setting setting;
    std::string contestant;  ///< an arithmetic, a method, a stage, a structure
    std::string quantity;    ///< what value is; its unit where it has one
    Interval value;
};

/// What a table is of: that says which columns it has.
enum class Of : std::uint8_t { sites, balls };

/// The quantity of the row that ends a pass over a cell: the seconds that it took, all in all.
inline constexpr std::string_view end_of_cell = "cell_seconds";

/// That of a construction: the share of the sets on which inexact arithmetic lost its way.
inline constexpr std::string_view broken_percent = "broken_percent";

/// What stands in its columns, by their names.
[[nodiscard]] std::map<std::string, std::string> columns_of(const Row& row, Of of);

/// The first line of the table.
[[nodiscard]] std::string csv_header(Of of = Of::sites);
/// A row, with its end of line; numbers read back as the same doubles.
[[nodiscard]] std::string csv_line(const Row& row, Of of = Of::sites);

/// The passes over cells that a table holds completely.
struct Table {
    std::vector<Row> rows;
    std::size_t bytes = 0;  ///< where the last complete pass over a cell ends
};

/// Reads a table, whose end may be missing: what follows the last complete pass over a cell is
/// left out.
/// Throws std::invalid_argument, with the number of the line, where a whole line is no row.
[[nodiscard]] Table read_csv(std::string_view text, Of of = Of::sites);

/// What the passes say together, in the order in which quantities first come: the median of their
/// medians, with its interval; for end_of_cell the sum. What was measured once stays as it is.
[[nodiscard]] std::vector<Row> combined(const std::vector<Row>& passes);

/// Rows as JSON objects in an array.
[[nodiscard]] std::string json_array(const std::vector<Row>& rows, Of of);

}  // namespace signum::study
