#pragma once
/// Figures as pages/NAME.toml describes them. For the sources of study/.
///
/// A [[figure]] has a name, a title, a text and a description. In its text, see filled(), an empty
/// line begins a new line, and its own keys are values. It is drawn where it has an x or
/// panels. Its keys, which each [[figure.panel]] and each curve of `more` may say anew:
///   like      an earlier figure, which says the rest
///   cells     which cells it is about: "experiment=sites time_step=0". Without it, those of the
///             experiment of its name
///   rows      which of their rows; a value that ends with * stands for any that begins so
///   panels    columns: each value that the cells have gets panels of its own, "packing size_ratio"
///             each pair. Numbers rise, words stand in the order of lists.COLUMN, metrics in that
///             of their table
///   series    the same for the curves of a panel; "distribution:four" takes all of lists.four
///   more      further curves, each with its name, `curve`
///   x         a column. "distribution:four" has a category for each name (`present`: those that
///             the cells have); "quantity" takes the number that stands for the * of rows
///   log       the logarithmic axes: "x", "y" or "xy". A linear axis of y begins at `y_least`, or 0
///   panel_title, series_title, x_label, y_label, uprights, zero
///             see Panel. In titles {COLUMN} is its value; without them, titles are the values, and
///             the label of x is its column
///   x_times, times, over
///             x is multiplied by x_times, y by times and divided by over
///   decades   an x stands for a power of ten: it is drawn in its middle
///   a_second  a y is what happened since the last x: it is drawn a unit of x
///   stacked   bars whose parts are the shares of the curves, in percent of all or of the quantity
///             `whole`
///   thesis    points that the thesis states; `thesis_of`: only in panels of this metric
///   words     what names are called

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
