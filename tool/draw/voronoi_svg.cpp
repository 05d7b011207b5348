#include "document.hpp"
#include "lines.hpp"
#include "numbers.hpp"
#include "shapes.hpp"
#include "sites.hpp"
#include "svg.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace signum {
namespace {

constexpr std::size_t tints = 6;
constexpr std::size_t most_tinted = 20'000;  // cells; of more none is

Index across(const Voronoi& voronoi, const VoronoiStep& step) {
    const VoronoiEdge& edge = voronoi.edges()[static_cast<std::size_t>(step.edge)];
    return step.forward ? edge.right : edge.left;
}

/// A tint for every cell, another one than its neighbours'. Cells make a planar map, of which every
/// part has one with at most five neighbours: taken out one after another, and tinted in the
/// opposite order, each finds one of six tints free.
std::vector<std::size_t> tints_of(const Voronoi& voronoi) {
    const std::size_t sites = voronoi.tessellation().sites().size();
    std::vector<std::size_t> left(sites);  // neighbours that are not taken out, once an edge
    std::vector<Index> order;
    std::vector<bool> taken(sites, false);
    const auto take_if_few = [&](std::size_t site) {
        if (taken[site] || left[site] >= tints) return;
        taken[site] = true;
        order.push_back(static_cast<Index>(site));
    };
    const auto neighbours = [&](std::size_t site) {
        std::vector<Index> result;
        for (const VoronoiStep& step : voronoi.cell(static_cast<Index>(site)))
            result.push_back(across(voronoi, step));
        std::ranges::sort(result);
        result.erase(std::unique(result.begin(), result.end()), result.end());
        return result;
    };
    for (std::size_t site = 0; site < sites; ++site) left[site] = neighbours(site).size();
    for (std::size_t site = 0; site < sites; ++site) take_if_few(site);
    for (std::size_t i = 0; i < order.size(); ++i)
        for (const Index v : neighbours(static_cast<std::size_t>(order[i]))) {
            --left[static_cast<std::size_t>(v)];
            take_if_few(static_cast<std::size_t>(v));
        }

    std::vector<std::size_t> tint(sites, tints);
    for (auto site = order.rbegin(); site != order.rend(); ++site) {
        std::array<bool, tints + 1> used{};
        for (const Index v : neighbours(static_cast<std::size_t>(*site)))
            used[tint[static_cast<std::size_t>(v)]] = true;
        // Not every search begins with the first tint, or it would be the most frequent by far.
        std::size_t next = static_cast<std::size_t>(*site) % tints;
        while (used[next]) next = (next + 1) % tints;
        tint[static_cast<std::size_t>(*site)] = next;
    }
    return tint;
}

void write_cells(SvgText& text, const ClippedVoronoi& clipped, const Frame& frame) {
    const Voronoi& voronoi = clipped.voronoi();
    const std::vector<std::size_t> tint = tints_of(voronoi);
    for (std::size_t site = 0; site < tint.size(); ++site) {
        if (voronoi.is_hidden(static_cast<Index>(site))) continue;
        const CellShape shape = clipped.cell(static_cast<Index>(site));
        if (shape.loops.empty()) continue;
        text.add(R"(<path class="tint tint{}" d=")", tint[site]);
        for (const auto& loop : shape.loops) {
            const Point start = frame.at(loop.front().from, voronoi.exponent());
            text.add("M{} {}", Px{start.x}, Px{start.y});
            for (const Conic& conic : loop)
                write_stretch(text, in_pixels(conic, voronoi.exponent(), frame));
            text.add("Z");
        }
        text.add("\"><title>{}</title></path>\n", site);
    }
}

/// How many cells the picture shows, roughly: a diagram has three times as many edges as cells.
std::size_t cells_in(const std::vector<Conic>& edges) {
    return 1 + edges.size() / 3;
}

/// How far sites are apart where they are spread evenly.
double spacing(std::size_t cells, const Frame& frame) {
    return std::sqrt(frame.width() * frame.height() / static_cast<double>(cells));
}

}  // namespace

void write_voronoi_svg(std::ostream& out, const Voronoi& voronoi, const std::optional<Box>& box,
                       int threads) {
    const SvgOptions options;
    const Tessellation& tessellation = voronoi.tessellation();
    const Frame frame =
        box ? Frame(*box, picture_width) : Frame(drawn_sites(tessellation), picture_width);
    const auto clipped = clipped_to(frame, voronoi, threads);
    const std::vector<Conic> edges = cell_edges(clipped, frame);
    const Pens pens(
        std::min(spacing(cells_in(edges), frame), 2 * median_length(edges, picture_width)));
    const DrawnSites sites(tessellation, frame, pens, options.site_limit);
    const Shapes& shapes = shapes_of(tessellation.metric());

    Legend legend(document_width, shapes.outline);
    sites.describe(legend);
    note_rounding(legend, frame);
    SvgText drawing;
    if (cells_in(edges) > most_tinted)
        legend.note("more than {} cells, drawn without tints", most_tinted);
    else if (clipped) {
        write_cells(drawing, *clipped, frame);
        legend.note("tints tell cells that meet apart and mean nothing else");
    }
    sites.write_outlines(drawing);
    write_lines(drawing, legend, "border", shapes.cells, edges, frame, options.line_limit);
    sites.write_dots(drawing);
    write_numbers(drawing, legend, sites, frame, pens, {edges});
    write_document(out,
                   fmt::format("{} Voronoi diagram of {} sites", name_of(tessellation.metric()),
                               tessellation.sites().size()),
                   frame, pens, legend, drawing);
}

}  // namespace signum
