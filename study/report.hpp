#pragma once
/// The report: a page that needs nothing beside it, for who has never heard of any of this.

#include <string>
#include <utility>
#include <vector>

#include "figures.hpp"
#include "picture.hpp"

namespace signum::study {

/// What a study is: shown at the end of its report.
struct Account {
    std::string version;
    std::string command;  ///< that makes it again
    std::vector<std::pair<std::string, std::string>> machine;
    std::size_t measured = 0;  ///< passes over cells
    std::size_t planned = 0;   ///< of so many
    double seconds = 0.0;      ///< of measuring
};

struct DrawnFigure {
    Figure figure;
    std::string svg;  ///< see inline_svg()
};

[[nodiscard]] std::string html_report(const Account& account, const Picture& picture,
                                      const std::vector<DrawnFigure>& figures,
                                      const std::vector<Beside>& thesis);

}  // namespace signum::study
