#include "picture.hpp"

#include <sstream>

#include "../../voronoi/compare.hpp"
#include "../draw/svg.hpp"

#include "contestants.hpp"

namespace signum::study {

Picture wrong_picture() {
    const Setting setting = {"", "power", "circle", 60, 0.0, 0.0, 0.0};
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
            return {svg.str(), setting.sites, comparison.edges, std::ssize(comparison.wrong)};
        } catch (const BrokenStructure&) {
            continue;  // there are no edges to show
        }
    }
    return {};
}

}  // namespace signum::study
