#include "svg.hpp"
#include "document.hpp"
#include "lines.hpp"
#include "numbers.hpp"
#include "shapes.hpp"
#include "sites.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace signum {
namespace {

// The edges between centres, as far as the picture shows them. Two sites may share several edges,
// which stand one after another: one line will do.
std::vector<Conic> straight(std::span<const Edge> edges, const Tessellation& tessellation,
                            const Frame& frame) {
    constexpr double beyond = 20;  // pixels: no end of a line that goes on is seen
    const Box picture = {-beyond, -beyond, frame.width() + beyond, frame.height() + beyond};
    const auto centre = [&](Index i) {
        const Site& s = tessellation.sites()[static_cast<std::size_t>(i)];
        return frame.at({s.x, s.y});
    };
    std::vector<Conic> lines;
    Edge before = {infinite, infinite};
    for (const Edge& edge : edges) {
        const auto& [a, b] = edge;
        if (a == infinite || b == infinite || edge == std::exchange(before, edge)) continue;
        const Conic line = Conic::straight(centre(a), centre(b));
        for (const auto& [first, last] : parts_inside(line, picture))
            lines.push_back(line.part(first, last));
    }
    return lines;
}

// Where radii differ, an edge of an additive metric may bend around a site between its ends, and
// two sites may share several. Edges between equal sites are straight, and so are all in the power
// metric.
bool may_be_curved(const Tessellation& tessellation) {
    if (traits_of(tessellation.metric()).edges_are_straight) return false;
    const auto sites = tessellation.sites();
    const auto faces = tessellation.faces();
    const auto radius = [&](Index i) { return sites[static_cast<std::size_t>(i)].r; };
    return std::ranges::any_of(faces, [&](const Face& face) {
        return radius(face[1]) != radius(face[2]) ||
               (face[0] != infinite && radius(face[0]) != radius(face[1]));
    });
}

}  // namespace

void write_svg(std::ostream& out, const Tessellation& tessellation, const SvgOptions& options) {
    const Frame frame = options.box ? Frame(*options.box, picture_width)
                                    : Frame(drawn_sites(tessellation), picture_width);
    const std::vector<Conic> edges = straight(tessellation.edges(), tessellation, frame);
    const Pens pens(median_length(edges, picture_width));
    const DrawnSites sites(tessellation, frame, pens, options.site_limit);
    const Shapes& shapes = shapes_of(tessellation.metric());

    Legend legend(document_width, shapes.outline);
    sites.describe(legend);
    note_rounding(legend, frame);
    SvgText drawing;
    sites.write_outlines(drawing);
    const auto write = [&](std::string_view kind, std::string_view label,
                           std::span<const Conic> lines) {
        write_lines(drawing, legend, kind, label, lines, frame, options.line_limit);
    };
    const std::vector<Conic> cells =
        cell_edges(Voronoi(tessellation, {.threads = options.threads}), frame, options.threads);
    write("cell", shapes.cells, cells);
    write("edge", "tessellation", edges);
    write("flipped", "flipped edges", straight(options.flipped, tessellation, frame));
    write("different", "different edges", straight(options.different, tessellation, frame));
    write("wrong", "wrong edges", straight(options.wrong, tessellation, frame));
    sites.write_dots(drawing);
    write_numbers(drawing, legend, sites, frame, pens, {cells, edges});
    if (may_be_curved(tessellation))
        legend.note("edges are drawn straight; the true ones are curved and do not cross");
    write_document(out,
                   fmt::format("{} tessellation of {} sites", name_of(tessellation.metric()),
                               tessellation.sites().size()),
                   frame, pens, legend, drawing);
}

}  // namespace signum
