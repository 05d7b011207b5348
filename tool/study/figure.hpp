#pragma once
/// A part of a report: a plot, or none, and what it says in plain words.

#include <string>

#include "plot.hpp"

namespace signum::study {

struct Figure {
    Plot plot;  ///< its name is that of the part; without panels nothing is drawn
    std::string title;
    std::string text;         ///< HTML
    std::string description;  ///< for who does not see it
};

}  // namespace signum::study
