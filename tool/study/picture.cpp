#include "picture.hpp"

#include <sstream>

#include <fmt/format.h>

#include "../../voronoi/compare.hpp"
#include "../draw/svg.hpp"

#include "contestants.hpp"

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

}  // namespace signum::study
