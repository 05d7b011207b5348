#include <signum/draw/document.hpp>
#include <signum/draw/lines.hpp>
#include <signum/draw/shapes.hpp>
#include <signum/draw/sites.hpp>
#include <signum/draw/voronoi_svg.hpp>

#include <array>
#include <cmath>
#include <vector>

namespace signum {
namespace {

constexpr std::size_t tints = 6;

/// A tint for every cell, another one than its neighbours' as far as the tints reach: the first
/// that none of those has that were tinted before.
std::vector<std::size_t> tints_of(const Voronoi& voronoi) {
    const std::size_t sites = voronoi.tessellation().sites().size();
    std::vector<std::size_t> tint(sites, tints);
    for (std::size_t site = 0; site < sites; ++site) {
        std::array<bool, tints + 1> taken{};
        for (const VoronoiStep& step : voronoi.cell(static_cast<Index>(site))) {
            const VoronoiEdge& edge = voronoi.edges()[static_cast<std::size_t>(step.edge)];
            taken[tint[static_cast<std::size_t>(step.forward ? edge.right : edge.left)]] = true;
        }
        // Not every search begins with the first tint, or it would be the most frequent by far.
        for (std::size_t turn = 0; turn < tints && tint[site] == tints; ++turn)
            if (const std::size_t next = (site + turn) % tints; !taken[next]) tint[site] = next;
        if (tint[site] == tints) tint[site] = site % tints;
    }
    return tint;
}

void write_cells(SvgText& text, const Voronoi& voronoi, const Frame& frame) {
    const auto clipped = clipped_to(frame, voronoi);
    if (!clipped) return;
    const std::vector<std::size_t> tint = tints_of(voronoi);
    for (std::size_t site = 0; site < tint.size(); ++site) {
        if (voronoi.is_hidden(static_cast<Index>(site))) continue;
        const CellShape shape = clipped->cell(static_cast<Index>(site));
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

/// How far sites are apart where they are spread evenly.
double spacing(const Voronoi& voronoi, const Frame& frame) {
    const auto sites = static_cast<double>(voronoi.tessellation().sites().size());
    return std::sqrt(frame.width() * frame.height() / (1 + sites));
}

}  // namespace

void write_voronoi_svg(std::ostream& out, const Voronoi& voronoi, const std::optional<Box>& box,
                       const VoronoiSvgOptions& options) {
    const Tessellation& tessellation = voronoi.tessellation();
    const Frame frame =
        box ? Frame(*box, picture_width) : Frame(drawn_sites(tessellation), picture_width);
    const std::vector<Conic> edges = cell_edges(voronoi, frame);
    const Pens pens(std::min(spacing(voronoi, frame), 2 * median_length(edges, picture_width)));
    const DrawnSites sites(tessellation, frame, pens, options.site_limit);
    const Shapes& shapes = shapes_of(tessellation.metric());

    Legend legend(frame.width(), shapes.outline);
    sites.describe(legend);
    SvgText drawing;
    const std::size_t cells = tessellation.sites().size() - tessellation.hidden().size();
    if (cells <= options.cell_limit)
        write_cells(drawing, voronoi, frame);
    else
        legend.note("cells: more than {}, drawn without tints", options.cell_limit);
    sites.write_outlines(drawing);
    write_lines(drawing, legend, "border", shapes.cells, edges, frame, options.line_limit);
    sites.write_dots(drawing);
    write_document(out,
                   fmt::format("{} Voronoi diagram of {} sites", name_of(tessellation.metric()),
                               tessellation.sites().size()),
                   frame, pens, legend, drawing);
}

}  // namespace signum
