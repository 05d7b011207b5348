#pragma once
/// The pages of the studies. What a page says, and what its figures draw against what, is a table:
/// pages/NAME.toml. What it says of numbers is computed from the rows.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "plot.hpp"
#include "rows.hpp"
#include "template.hpp"

namespace signum::study {

/// A part of a page: a plot, or none, and what it says in plain words.
struct Figure {
    Plot plot;  ///< its name is that of the part; without panels nothing is drawn
    std::string title;
    std::string text;         ///< HTML
    std::string description;  ///< for who does not see it
    std::string svg;          ///< see inline_svg(); empty as long as it is not drawn
};

/// Texts are HTML.
struct Page {
    std::string title;
    std::string introduction;
    std::vector<Figure> figures;
    std::string glossary;
};

/// Of the study of the "plane", of "space" or of "motion". Its figures are those of which there are
/// rows, in the order in which they are to be read, yet to be drawn. `values`: what goes into the
/// introduction.
[[nodiscard]] Page page_of(std::string_view study, const std::vector<Row>& rows,
                           const Values& values = {});

/// What goes wrong, as a picture for the page of the plane: the tessellation of sites on a circle
/// as single precision makes it, its wrong edges thick. The address of the `picture`, and how many
/// `sites`, `edges` and `wrong` edges it has.
[[nodiscard]] Values wrong_picture();

/// What the times of a study belong to. Names and values, to be shown in this order: processor, its
/// number of cores, memory, system, compiler.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> describe_machine();

/// What a study is: shown at the end of its report.
struct Account {
    std::string version;
    std::string command;  ///< that makes it again
    std::vector<std::pair<std::string, std::string>> machine;
    std::size_t measured = 0;  ///< passes over cells
    std::size_t planned = 0;   ///< of so many
    double seconds = 0.0;      ///< of measuring
};

/// A page that needs nothing beside it, for who has never heard of any of this.
[[nodiscard]] std::string html_report(const Page& page, const Account& account);

}  // namespace signum::study
