/// signum voronoi: from a file of sites to files of the diagram.

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "../../triangulation/space/vertices.hpp"
#include "../../voronoi/balls/diagram.hpp"
#include "../../voronoi/clip.hpp"
#include "../../voronoi/space/cells.hpp"
#include "../../voronoi/space/polyhedra.hpp"
#include "../draw/svg.hpp"
#include "../io/write_space_cells.hpp"
#include "../io/write_voronoi.hpp"

#include "clip.hpp"
#include "commands.hpp"
#include "formats.hpp"
#include "progress.hpp"
#include "sites_call.hpp"

namespace signum::cli {
namespace {

/// The call as it was typed.
struct VoronoiCall : SitesCall, OutputsCall {
    std::vector<double> clip;
    std::optional<double> tolerance;
    bool merge = false;
    bool carry = false;
};

// ---- power cells in space ----------------------------------------------------------------------

/// Options and formats that are of the plane alone.
void refuse_what_is_planar(const VoronoiCall& call, std::span<const Target> targets) {
    constexpr std::string_view what = "cells in space";
    if (call.tolerance) refuse_option(call, "--tolerance", what, "have no arcs");
    if (call.merge) refuse_option(call, "--merge", what, "have vertices one by one alone");
    if (call.carry) refuse_option(call, "--carry", what, "have tables of measures alone");
    require_formats_of(Dimension::three, targets, voronoi_formats, call.input);
}

struct CellsInSpace {
    SpaceCells measured;
    std::vector<SpacePolyhedron> polyhedra;  ///< none where nobody asked for them
};

/// Throws CallError where doubles cannot compute with the box.
CellsInSpace cells_in(const Box3& box, const SpaceTessellation& tessellation,
                      const InputSites& sites, bool asks_for_polyhedra, int threads) {
    std::vector<Index> all;
    if (asks_for_polyhedra)
        for (Index site = 0; site < static_cast<Index>(tessellation.sites); ++site)
            all.push_back(site);
    try {
        return with_sites_in_space(sites, [&](auto those) -> CellsInSpace {
            return {space_cells(tessellation, those, box, threads),
                    space_polyhedra(tessellation, those, box, all)};
        });
    } catch (const std::invalid_argument& error) {
        throw CallError(fmt::format(
            "the box {} {} {} {} {} {}: {}; cut the cells to another one "
            "with --clip",
            box.low.x, box.low.y, box.low.z, box.high.x, box.high.y, box.high.z, error.what()));
    }
}

void summarize(const SpaceTessellation& tessellation, const SpaceCells& cells, WeightIs third,
               std::span<const Target> targets) {
    const std::size_t hidden = tessellation.hidden.size();
    const auto unbounded = std::ranges::count(unbounded_cells(tessellation), true);
    const auto finite = std::ranges::count_if(
        tessellation.cells, [](const SpaceCell& cell) { return cell[0] != infinite; });
    const auto inner = std::ranges::count_if(
        cells.faces, [](const SpaceFace& face) { return !is_box_side(face.beyond); });
    double volume = 0.0;
    for (const SpaceMeasure& measure : cells.measures) volume += measure.volume;
    const Point3& low = cells.box.low;
    const Point3& high = cells.box.high;
    say_sites_in_space(tessellation.sites, third);
    say("cells    {}, {} of them unbounded\n", cells.measures.size() - hidden, unbounded);
    say("hidden   {}\n", hidden);
    say("vertices {}\n", tessellation.dimension == 3 ? finite : 0);
    say("faces    {} between two cells\n", inner / 2);
    say("box      {:.6g} {:.6g} {:.6g} {:.6g} {:.6g} {:.6g}\n", low.x, low.y, low.z, high.x, high.y,
        high.z);
    say("volume   {:.6g}, of the box {:.6g}\n", volume,
        (high.x - low.x) * (high.y - low.y) * (high.z - low.z));
    say("{}", written(targets));
}

void voronoi_in_space(const VoronoiCall& call, const InputSites& sites,
                      std::span<const Target> targets) {
    refuse_what_is_planar(call, targets);
    require_numbers(call.clip, 6, call.input);
    const std::optional<Box3> clip = box_in_space_of(call.clip);
    const Outputs outputs(targets);
    const SpaceTessellation tessellation = construct_in_space(call, sites);
    const bool asks_for_polyhedra =
        is_written(targets, "vtk") || is_written(targets, "vtu") || is_picture_written(targets);
    const CellsInSpace found = cells_in(clip ? *clip : default_box(sites.file.in_space),
                                        tessellation, sites, asks_for_polyhedra, call.threads);
    const SpaceCells& cells = found.measured;
    std::vector<SpaceVertex> diagram;
    if (is_written(targets, "json")) {
        diagram = with_sites_in_space(
            sites, [&](auto those) { return vertices(tessellation, those, call.threads); });
    }
    outputs.write(
        {{"csv", [&](std::ostream& out) { write_space_cells_csv(out, cells); }},
         {"svg",
          [&](std::ostream& out) {
              write_space_cells_svg(out, sites.file.in_space, cells, found.polyhedra);
          }},
         {"vtk", [&](std::ostream& out) { write_vtk(out, vtk_grid(cells, found.polyhedra)); }},
         {"vtu", [&](std::ostream& out) { write_vtu(out, vtk_grid(cells, found.polyhedra)); }},
         {"json", [&](std::ostream& out) {
              write_space_cells_json(out, cells, tessellation, sites.third, diagram);
          }}});
    if (!call.quiet) summarize(tessellation, cells, sites.third, targets);
}

// ---- balls -------------------------------------------------------------------------------------

/// Options and formats that are of other diagrams: cells of balls are not computed.
void refuse_what_is_not_of_balls(const VoronoiCall& call, std::span<const Target> targets) {
    constexpr std::string_view what = "the diagram of balls";
    if (!call.clip.empty())
        refuse_option(call, "--clip", what,
                      "has vertices and edges alone, which are written whole");
    if (call.tolerance) refuse_option(call, "--tolerance", what, "has no polygons");
    if (call.merge) refuse_option(call, "--merge", what, "has one vertex a sphere anyway");
    if (call.carry) refuse_option(call, "--carry", what, "has tables of vertices alone");
    for (const Target& target : targets) {
        if (target.format == "json" || target.format == "csv") continue;
        throw CallError(
            fmt::format("{}: the diagram of balls, as those of {} are, is written as json or csv; "
                        "name one of them",
                        target.format, call.input));
    }
}

BallDiagram diagram_of(const VoronoiCall& call, const InputSites& sites) {
    return with_progress(call.quiet, [&](const std::function<void(double)>& show) {
        Options options;
        options.progress = show;
        options.threads = call.threads;
        try {
            return ball_diagram(sites.file.in_space, options);
        } catch (const std::invalid_argument& error) {
            throw CallError(error.what());
        }
    });
}

void summarize(const BallDiagram& diagram, std::span<const Target> targets) {
    const auto count_ends = [&](Index end) {
        return std::ranges::count_if(diagram.ends, [end](const std::array<Index, 2>& ends) {
            return ends[0] == end || ends[1] == end;
        });
    };
    const auto hidden = static_cast<std::int64_t>(diagram.hidden.size());
    say_sites_in_space(diagram.balls, WeightIs::radius);
    say("diagram  of balls, euclidean: vertices and edges; --metric power measures cells\n");
    say("cells    {}\n", diagram.balls - hidden);
    say("hidden   {}\n", hidden);
    say("vertices {}\n", diagram.vertices.size());
    say("edges    {}, {} of them infinite, {} closed\n", diagram.edges.size(), count_ends(infinite),
        count_ends(no_end));
    say("{}", written(targets));
}

void voronoi_of_balls(const VoronoiCall& call, const InputSites& sites,
                      std::span<const Target> targets) {
    refuse_what_is_not_of_balls(call, targets);
    const Outputs outputs(targets);
    const BallDiagram diagram = diagram_of(call, sites);
    outputs.write({{"csv", [&](std::ostream& out) { write_csv(out, diagram); }},
                   {"json", [&](std::ostream& out) { write_json(out, diagram); }}});
    if (!call.quiet) summarize(diagram, targets);
}

// ---- sites in the plane, and the call ----------------------------------------------------------

void summarize(const Voronoi& voronoi, std::span<const Target> targets) {
    const std::size_t sites = voronoi.tessellation().sites().size();
    const std::size_t hidden = voronoi.tessellation().hidden().size();
    std::size_t unbounded = 0;
    for (std::size_t i = 0; i < sites; ++i)
        unbounded += static_cast<std::size_t>(voronoi.is_unbounded(static_cast<Index>(i)));
    say("sites    {}\n", sites);
    say("cells    {}, {} of them unbounded\n", sites - hidden, unbounded);
    say("hidden   {}\n", hidden);
    say("vertices {}\n", voronoi.vertices().size());
    say("edges    {}\n", voronoi.edges().size());
    say("{}", written(targets));
}

/// Of longitudes and latitudes, all of which are on the globe, no cell reaches beyond it.
Box on_globe(const Box& box, const SitesFile& file) {
    constexpr Box globe = {-180, -90, 180, 90};
    const bool are_on_it =
        file.are_degrees && std::ranges::all_of(file.sites, [&](const Site& site) {
            return std::abs(site.x) <= globe.x1 && std::abs(site.y) <= globe.y1;
        });
    if (!are_on_it) return box;
    return {std::max(box.x0, globe.x0), std::max(box.y0, globe.y0), std::min(box.x1, globe.x1),
            std::min(box.y1, globe.y1)};
}

void run(VoronoiCall& call) {
    const std::vector<Target> targets = targets_of(call, call.input, voronoi_formats);
    if (call.carry && !is_written(targets, "csv"))
        throw CallError(
            "--carry is for tables, and GeoJSON has the columns anyway; add -o FILE.csv");
    call.attributes = call.carry || is_written(targets, "geojson");
    if (call.tolerance && !(*call.tolerance > 0))
        throw CallError("--tolerance: give a number above 0");
    const InputSites sites = read_input(call);
    if (sites.file.dimension == 3) {
        return traits_of(metric_of(call.metric)).edges_are_straight
                   ? voronoi_in_space(call, sites, targets)
                   : voronoi_of_balls(call, sites, targets);
    }
    require_formats_of(Dimension::two, targets, voronoi_formats, call.input);
    require_numbers(call.clip, 4, call.input);
    const std::optional<Box> clip = box_of(call.clip, targets);
    const Outputs outputs(targets);
    const Voronoi diagram(construct(call, sites), {.merge = call.merge, .threads = call.threads});

    const Box box = clip.value_or(
        on_globe(default_box(diagram.tessellation().sites(), diagram.exponent()), sites.file));
    const bool is_used =
        clip ||
        std::ranges::any_of(std::array<std::string_view, 5>{"geojson", "csv", "wkt", "vtk", "vtp"},
                            [&](std::string_view format) { return is_written(targets, format); });
    if (is_used) require_fit(box, diagram);
    const double longer = std::max(box.x1 / 2 - box.x0 / 2, box.y1 / 2 - box.y0 / 2);
    const double tolerance = call.tolerance.value_or(default_tolerance(box));
    if (tolerance < longer * 2e-9) {
        throw CallError(
            fmt::format("--tolerance {}: below a billionth of the box's longer side polygons would "
                        "have more points than anybody wants; give at least {:.3g}",
                        tolerance, longer * 2e-9));
    }
    std::optional<ClippedVoronoi> cells;  // cut once, for all that want them
    const auto clipped = [&]() -> const ClippedVoronoi& {
        return cells ? *cells : cells.emplace(diagram, box, Lengths::of_the_plane, call.threads);
    };
    // Tables have the attributes of the sites on request.
    std::span<const Attribute> carried;
    if (call.carry) carried = sites.file.attributes;
    outputs.write(
        {{"json",
          [&](std::ostream& out) {
              const Box cut = clip.value_or(no_box);
              write_voronoi_json(
                  out, ClippedVoronoi(diagram, cut, Lengths::of_the_plane, call.threads), cut);
          }},
         {"svg", [&](std::ostream& out) { write_voronoi_svg(out, diagram, clip, call.threads); }},
         {"geojson",
          [&](std::ostream& out) {
              write_voronoi_geojson(out, clipped(), box, tolerance, sites.file.attributes);
          }},
         {"wkt", [&](std::ostream& out) { write_voronoi_wkt(out, clipped(), tolerance); }},
         {"vtk", [&](std::ostream& out) { write_vtk(out, vtk_grid(clipped(), tolerance)); }},
         {"vtp", [&](std::ostream& out) { write_vtp(out, vtk_grid(clipped(), tolerance)); }},
         {"csv",
          [&](std::ostream& out) { write_voronoi_csv(out, clipped(), tolerance, carried); }}});
    if (!call.quiet) {
        summarize(diagram, targets);
        hint_at_space(call, sites.file, diagram.tessellation().hidden().size());
    }
}

}  // namespace

void add_voronoi(CLI::App& tool) {
    auto call = std::make_shared<VoronoiCall>();
    call->metrics_in_space = {Metric::power, Metric::euclidean};
    CLI::App* command =
        tool.add_subcommand("voronoi", "Computes the diagram of sites: vertices, edges, cells");
    add_sites(*command, *call);
    add_space(*command, *call);
    add_clip(*command, call->clip,
             "The box that cells are cut to. Default: JSON has\n"
             "them whole; tables and GeoJSON cut them to the\n"
             "smallest box around all centres and a tenth more,\n"
             "pictures to what they show. In space that box cuts\n"
             "them all",
             true);
    add_checked(*command, "--tolerance", call->tolerance, "T", finite_number(),
                "How far the polygons of tables and GeoJSON may be\n"
                "from the arcs they stand for. Default: the longer\n"
                "side of the box / 10000");
    command->add_flag("--carry", call->carry,
                      "A table of cells in the plane has the other named\n"
                      "columns of FILE, too, as GeoJSON has them");
    command->add_flag("--merge", call->merge,
                      "One vertex where several faces have the same\n"
                      "circle, without edges of no length");
    add_outputs(*command, *call, voronoi_formats, "without it the result goes there, as JSON");
    command->footer(
        "Examples:\n"
        "  signum voronoi sites.txt -o cells.svg -o cells.geojson\n"
        "  signum voronoi cities.csv -o cells.geojson -o cells.pdf\n"
        "  signum voronoi sites.txt --metric power --clip 0 0 100 100 -o areas.csv\n"
        "  signum voronoi protein.pdb --metric power -o volumes.csv -o cells.vtu\n"
        "  signum voronoi balls.xyz --metric euclidean -o diagram.json -o vertices.csv");
    command->callback([call] { run(*call); });
}

}  // namespace signum::cli
