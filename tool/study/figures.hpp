#pragma once
/// From rows to figures: which numbers are drawn against which, and what they say in plain words.

#include <string>
#include <vector>

#include "figure.hpp"
#include "rows.hpp"

namespace signum::study {

/// The figures of which there are rows, in the order in which they are to be read.
[[nodiscard]] std::vector<Figure> figures(const std::vector<Row>& rows);

/// A number of the thesis's text, and ours.
struct Beside {
    std::string what;
    std::string thesis;
    std::string here;
};

/// Those of which there are rows.
[[nodiscard]] std::vector<Beside> beside_the_thesis(const std::vector<Row>& rows);

}  // namespace signum::study
