#include "page.hpp"

#include <algorithm>
#include <array>
#include <sstream>

#include <fmt/format.h>

#include "../../voronoi/compare.hpp"
#include "../draw/svg.hpp"
#include "motion/words.hpp"

#include "contestants.hpp"
#include "figures.hpp"

namespace signum::study {
namespace {

/// A picture as a part of the page, whose styles are its own.
std::string data_address(std::string_view svg) {
    std::string result = "data:image/svg+xml,";
    for (const char c : svg)
        if (std::string_view("%#\"<>\n").find(c) != std::string_view::npos)
            result += fmt::format("%{:02X}", static_cast<unsigned>(c));
        else
            result += c;
    return result;
}

/// The numbers that the thesis states in its text, and ours, where there are rows of them.
std::string beside_the_thesis(const toml::table& page, const Records& records) {
    std::string lines;
    const toml::array* const all = page["beside"].as_array();
    for (std::size_t i = 0; all && i < all->size(); ++i) {
        std::array<std::string, 4> text;  // what, the thesis, the rows and the format of ours
        for (std::size_t k = 0; k < text.size(); ++k)
            text[k] = (*all)[i].as_array()->get(k)->value_or("");
        const std::string cells = page["beside_cells"].value_or("");
        if (const auto found = that_fit(records, cells + " " + text[2]); !found.empty())
            lines += table_line({html_text(text[0]), html_text(text[1]),
                                 fmt::format(fmt::runtime(text[3]), found[0]->value.median)});
    }
    return lines;
}

/// The figure, where it is like an earlier one with what that one says.
toml::table with_model(const toml::array& figures, const toml::table& figure) {
    for (const toml::node& each : figures)
        if (figure.contains("like") && each.at_path("name") == figure["like"])
            return within(*each.as_table(), figure);
    return figure;
}

}  // namespace

Values wrong_picture() {
    const Setting setting = {"", "power", "circle", 60};
    Options options;
    options.arithmetic = Arithmetic::single;
    for (std::size_t seed = 1; seed < 100; ++seed) {
        const std::vector<Site> sites = sites_of(setting, seed);
        try {
            const Tessellation tessellation = triangulate(sites, Power{}, options);
            const EdgeComparison comparison =
                compare_edges(tessellation, triangulate(sites, Power{}));
            if (comparison.wrong.empty()) continue;
            std::ostringstream svg;
            write_svg(svg, tessellation, {.wrong = comparison.wrong});
            return {{"picture", data_address(svg.str())},
                    {"sites", std::to_string(setting.count)},
                    {"edges", std::to_string(comparison.edges)},
                    {"wrong", std::to_string(comparison.wrong.size())}};
        } catch (const BrokenStructure&) {
            continue;  // there are no edges to show
        }
    }
    return {};
}

Page page_of(std::string_view study, const std::vector<Row>& rows, const Values& values) {
    const toml::table& page = page_table(study);
    const bool is_motion = page.contains("thesis");
    std::vector<Row> all = rows;
    if (is_motion) std::ranges::copy(thesis_rows(page), std::back_inserter(all));
    Records records;
    for (const Row& row : all)
        records[row.setting.experiment].push_back(
            {columns_of(row, is_motion ? Of::balls : Of::sites), row.value});
    Page result;
    result.title = page["title"].value_or("");
    Values own = values;
    own["beside"] = beside_the_thesis(page, records);
    result.introduction = filled(page["introduction"].value_or(""), own).value();
    result.glossary = page["glossary"].value_or("");
    if (page.contains("words"))
        result.glossary = html_of(
            "glossary", {{"words", page["words"].value_or("")}, {"tie", page["tie"].value_or("")}});
    const toml::array& figures = *page["figure"].as_array();
    for (const toml::node& each : figures) {
        const toml::table figure = with_model(figures, *each.as_table());
        const std::string name = figure["name"].value_or("");
        if (auto drawn =
                figure_of(page, figure, records, is_motion ? words_of(name, page, all) : Values()))
            result.figures.push_back(std::move(*drawn));
    }
    return result;
}

std::string html_report(const Page& page, const Account& account) {
    std::string sections;
    for (const Figure& figure : page.figures)
        sections +=
            html_of("section", {{"name", figure.plot.name},
                                {"number", std::to_string(&figure - page.figures.data() + 1)},
                                {"title", figure.title},
                                {"text", figure.text},
                                {"svg", figure.svg}});
    std::string machine;
    for (const auto& [name, value] : account.machine)
        machine += table_line({html_text(name), html_text(value)}, "th");
    const bool is_whole = account.measured >= account.planned;
    return html_of(
        "report",
        {{"head", html_of("head", {{"title", html_text(page.title + ": a study by signum")}})},
         {"title", page.title},
         {"introduction", page.introduction},
         {"sections", sections},
         {"glossary", page.glossary},
         {"command", html_text(account.command)},
         {"version", html_text(account.version)},
         {"time", account.seconds < 120.0 ? fmt::format("{:.0f} seconds", account.seconds)
                                          : fmt::format("{:.0f} minutes", account.seconds / 60.0)},
         {"measured", is_whole ? "" : std::to_string(account.measured)},
         {"planned", std::to_string(account.planned)},
         {"machine", machine}});
}

}  // namespace signum::study
