#pragma once
/// The report: a page that needs nothing beside it, for who has never heard of any of this.

#include <string>
#include <utility>
#include <vector>

#include "figure.hpp"

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
    std::string svg;  ///< see inline_svg(); empty where there is nothing to draw
};

/// What is peculiar to a study. Texts are HTML.
struct Page {
    std::string title;
    std::string introduction;
    std::vector<DrawnFigure> figures;
    std::string glossary;
};

[[nodiscard]] std::string html_report(const Page& page, const Account& account);

}  // namespace signum::study
