#pragma once
/// Figures as pages/NAME.toml describes them. For the sources of study/.
///
/// A [[figure]] has a name, a title, a text and a description. It draws where it has an x:
///   cells        which cells it is about, as "experiment=sites time_step=0"
///   rows         which of their rows; a value that ends with * is any that begins so
///   panels       columns of which each value has panels of its own, as "packing size_ratio": the
///                values that its cells have. A [[figure.panel]] is one of these panels; what it
///                does not say the figure does
///   series       the same for the curves of a panel; "distribution:four" are the names of a list.
///                [[figure.more]] are further curves, whose name is `curve`
///   x            a column; "distribution:eight" makes categories of the names of a list
///   (`present`:
///                of those that its cells have), "quantity" takes the number behind the * of rows
///   like         an earlier figure, which says the rest
///   panel_title, x_label, y_label, y_least, y_most, log ("x", "y", "xy"), uprights, zero    of a
///   panel.
///                {column} in a title is its value, {Column} the same with a capital
///   x_times, times, over    by which x and y are multiplied, y divided
///   decades      x is in the middle of a power of ten
///   a_second     y is counted in the time between two x
///   stacked      parts of bars: shares, in percent, of all series or of the quantity `whole`
///   thesis       points that it states; `thesis_of` is the metric whose panels have them
///   words        what names are called

#include <optional>

#include <toml++/toml.h>

#include "page.hpp"

namespace signum::study {

/// What pages/NAME.toml says.
[[nodiscard]] const toml::table& page_table(std::string_view name);

/// A row by the names of its columns.
struct Record {
    Values columns;
    Interval value;
};
using Records = std::map<std::string, std::vector<Record>>;  ///< by experiment

/// None where a value of its text is not there, or nothing is to be drawn.
[[nodiscard]] std::optional<Figure> figure_of(const toml::table& page, const toml::table& figure,
                                              const Records& records, const Values& values);

/// A table within another one: what it does not say the other one does; its cells and rows are
/// fewer.
[[nodiscard]] toml::table within(const toml::table& outer, const toml::table& inner);

/// Those of which `filter`, which names an experiment ("experiment=sites sites=100"), is true.
[[nodiscard]] std::vector<const Record*> that_fit(const Records& records, std::string_view filter);

}  // namespace signum::study
