#include "borders.hpp"

#include <algorithm>
#include <stdexcept>

#include "../../triangulation/triangulate.hpp"
#include "../../voronoi/clip.hpp"

namespace signum::cli {
namespace {

/// Discs, and of each copy the number of its disc.
struct Copies {
    std::vector<Site> sites;
    std::vector<std::size_t> numbers;

    void add(const Site& site, std::size_t number) {
        sites.push_back(site);
        numbers.push_back(number);
    }
};

/// Discs with their copies around a box, which suffice for what lies in it: of the copies of a disc
/// the nearest one to a point is the one whose cell may contain it, for their weights are equal,
/// and it is within half a side of the point along each axis.
Copies with_copies(std::span<const Site> discs, const Box& box) {
    const double width = box.x1 - box.x0;
    const double height = box.y1 - box.y0;
    Copies copies;
    for (std::size_t i = 0; i < discs.size(); ++i) {
        for (const double dx : {0.0, -width, width}) {
            for (const double dy : {0.0, -height, height}) {
                const Site copy = {discs[i].x + dx, discs[i].y + dy, discs[i].r};
                if (box.x0 - width / 2 <= copy.x && copy.x <= box.x1 + width / 2 &&
                    box.y0 - height / 2 <= copy.y && copy.y <= box.y1 + height / 2)
                    copies.add(copy, i);
            }
        }
    }
    return copies;
}

}  // namespace

std::vector<Movie::Border> borders_of_cells(std::span<const Site> discs, const Box& box,
                                            bool periodic) {
    constexpr const char* too_far =
        "--show cells: discs lie too far away for their cells to be drawn";
    if (!std::ranges::all_of(discs, [](const Site& disc) { return are_finite(disc); }))
        throw std::range_error(too_far);
    Copies copies;
    if (periodic) {
        copies = with_copies(discs, box);
    } else {
        for (std::size_t i = 0; i < discs.size(); ++i) copies.add(discs[i], i);
    }
    const Voronoi diagram = voronoi(triangulate(copies.sites, Power{}));
    if (!fits(box, diagram)) throw std::range_error(too_far);
    const ClippedVoronoi cells(diagram, box);
    std::vector<Movie::Border> borders;
    for (std::size_t e = 0; e < diagram.edges().size(); ++e) {
        const VoronoiEdge& edge = diagram.edges()[e];
        const auto [a, b] = std::minmax(copies.numbers[static_cast<std::size_t>(edge.left)],
                                        copies.numbers[static_cast<std::size_t>(edge.right)]);
        for (const Conic& part : cells.edge(static_cast<Index>(e)))
            borders.push_back({a, b, {part.from.x, part.from.y}, {part.to.x, part.to.y}});
    }
    return borders;
}

}  // namespace signum::cli
