/// signum voronoi: from a file of sites to files of the diagram.

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "../../voronoi/clip.hpp"
#include "../draw/voronoi_svg.hpp"
#include "../io/write_voronoi.hpp"

#include "clip.hpp"
#include "commands.hpp"
#include "formats.hpp"
#include "voronoi_balls.hpp"
#include "voronoi_call.hpp"
#include "voronoi_space.hpp"

namespace signum::cli {
namespace {

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

/// Tables have the attributes of the sites on request.
std::span<const Attribute> carried_to_tables(const VoronoiCall& call, const InputSites& sites) {
    if (!call.carry) return {};
    return sites.file.attributes;
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
    const Voronoi diagram(construct(call, sites), {call.merge});

    const Box box = clip.value_or(default_box(diagram.tessellation().sites(), diagram.exponent()));
    const bool is_used =
        clip ||
        std::ranges::any_of(std::array<std::string_view, 5>{"geojson", "csv", "wkt", "vtk", "vtp"},
                            [&](std::string_view format) { return is_written(targets, format); });
    if (is_used) require_fit(box, diagram);
    const double longer = std::max(box.x1 / 2 - box.x0 / 2, box.y1 / 2 - box.y0 / 2);
    const double tolerance = call.tolerance.value_or(
        std::max(longer / 5'000, std::numeric_limits<double>::denorm_min()));
    if (tolerance < longer * 2e-9) {
        throw CallError(
            fmt::format("--tolerance {}: below a billionth of the box's longer side polygons would "
                        "have more points than anybody wants; give at least {:.3g}",
                        tolerance, longer * 2e-9));
    }
    std::optional<ClippedVoronoi> cells;  // cut once, for all that want them
    const auto clipped = [&]() -> const ClippedVoronoi& {
        return cells ? *cells : cells.emplace(diagram, box);
    };
    outputs.write(
        {{"json",
          [&](std::ostream& out) {
              const Box cut = clip.value_or(no_box);
              write_voronoi_json(out, ClippedVoronoi(diagram, cut), cut);
          }},
         {"svg", [&](std::ostream& out) { write_voronoi_svg(out, diagram, clip); }},
         {"geojson",
          [&](std::ostream& out) {
              write_voronoi_geojson(out, clipped(), box, tolerance, sites.file.attributes);
          }},
         {"wkt", [&](std::ostream& out) { write_voronoi_wkt(out, clipped(), tolerance); }},
         {"vtk", [&](std::ostream& out) { write_vtk(out, vtk_grid(clipped(), tolerance)); }},
         {"vtp", [&](std::ostream& out) { write_vtp(out, vtk_grid(clipped(), tolerance)); }},
         {"csv", [&](std::ostream& out) {
              write_voronoi_csv(out, clipped(), tolerance, carried_to_tables(call, sites));
          }}});
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
    add_clip_in_space(*command, call->clip,
                      "The box that cells are cut to. Default: JSON has\n"
                      "them whole; tables and GeoJSON cut them to the\n"
                      "smallest box around all centres and a tenth more,\n"
                      "pictures to what they show. In space that box cuts\n"
                      "them all");
    command
        ->add_option("--tolerance", call->tolerance,
                     "How far the polygons of tables and GeoJSON may be\n"
                     "from the arcs they stand for. Default: the longer\n"
                     "side of the box / 10000")
        ->check(finite_number())
        ->type_name("T");
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
