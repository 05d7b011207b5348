/// signum voronoi: from a file of sites to files of the diagram.

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "../draw/voronoi_svg.hpp"
#include "../io/write_voronoi.hpp"
#include "../voronoi/clip.hpp"

#include "commands.hpp"
#include "outputs.hpp"
#include "sites_call.hpp"

namespace signum::cli {
namespace {

/// The call as it was typed.
struct Call : SitesCall {
    std::vector<double> clip;
    std::optional<double> tolerance;
    std::vector<std::string> outputs;
    bool merge = false;
};

std::optional<Box> box_of(const std::vector<double>& clip) {
    if (clip.empty()) return std::nullopt;
    const Box box = {clip[0], clip[1], clip[2], clip[3]};
    for (const double side : clip)
        if (!std::isfinite(side)) throw CallError("--clip: its four numbers are to be finite");
    if (!(box.x0 < box.x1 && box.y0 < box.y1)) {
        throw CallError(
            fmt::format("--clip {} {} {} {}: the lower left corner comes first, x0 < x1 and "
                        "y0 < y1",
                        box.x0, box.y0, box.x1, box.y1));
    }
    return box;
}

/// Throws CallError where doubles cannot compute with the box that an output is cut to.
void check_box(const Call& call, const Box& box, const Voronoi& diagram) {
    const bool is_used =
        !call.clip.empty() || std::ranges::any_of(call.outputs, [](const std::string& path) {
            return ending_of(path) == ".geojson" || ending_of(path) == ".csv";
        });
    if (is_used && !fits(box, diagram))
        throw CallError(
            fmt::format("the box {} {} {} {} is too large or too small beside the coordinates and "
                        "radii of the sites; cut the cells to another one with --clip",
                        box.x0, box.y0, box.x1, box.y1));
}

/// A picture is some hundred pixels wide.
void check_picture(const Call& call, const std::optional<Box>& clip) {
    constexpr double slimmest = 1e-3;
    const bool is_drawn =
        std::any_of(call.outputs.begin(), call.outputs.end(),
                    [](const std::string& path) { return ending_of(path) == ".svg"; });
    if (!clip || !is_drawn) return;
    const auto [shorter, longer] =
        std::minmax({clip->x1 / 2 - clip->x0 / 2, clip->y1 / 2 - clip->y0 / 2});
    if (shorter < slimmest * longer) {
        throw CallError(
            "--clip: a picture of a box more than a thousand times as long as wide shows nothing; "
            "give another box, or leave the .svg out");
    }
}

void summarize(const Voronoi& voronoi, const std::vector<std::string>& outputs) {
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
    if (!outputs.empty()) say("written  {}\n", fmt::join(outputs, ", "));
}

void run(const Call& call) {
    check_outputs(call.outputs, call.input, {".json", ".svg", ".geojson", ".csv"});
    const std::optional<Box> clip = box_of(call.clip);
    if (call.tolerance && !(*call.tolerance > 0 && std::isfinite(*call.tolerance)))
        throw CallError("--tolerance: it is to be above 0 and finite");
    check_picture(call, clip);
    const InputSites sites = read_input(call);
    const Outputs outputs(call.outputs);
    const Voronoi diagram(construct(call, sites), {call.merge});

    const Box box = clip.value_or(default_box(diagram.tessellation().sites()));
    check_box(call, box, diagram);
    const double longer = std::max(box.x1 / 2 - box.x0 / 2, box.y1 / 2 - box.y0 / 2);
    const double tolerance = call.tolerance.value_or(longer / 5'000);
    if (tolerance < longer * 2e-9) {
        throw CallError(
            fmt::format("--tolerance {}: below a billionth of the box's longer side polygons would "
                        "have more points than anybody wants; give at least {:.3g}",
                        tolerance, longer * 2e-9));
    }
    outputs.write(
        [&](std::ostream& out, const std::string& ending) {
            if (ending == ".json") {
                const Box cut = clip.value_or(no_box);
                write_voronoi_json(out, ClippedVoronoi(diagram, cut), cut);
            } else if (ending == ".svg") {
                write_voronoi_svg(out, diagram, clip);
            } else if (ending == ".geojson") {
                write_voronoi_geojson(out, ClippedVoronoi(diagram, box), box, tolerance);
            } else {
                write_voronoi_csv(out, ClippedVoronoi(diagram, box), tolerance);
            }
        },
        ".json");
    if (!call.quiet) summarize(diagram, call.outputs);
}

}  // namespace

void add_voronoi(CLI::App& tool) {
    auto call = std::make_shared<Call>();
    CLI::App* command =
        tool.add_subcommand("voronoi", "Computes the diagram of sites: vertices, edges, cells");
    add_sites(*command, *call);
    command
        ->add_option("--clip", call->clip,
                     "The box that cells are cut to. Default: JSON has\n"
                     "them whole; tables and GeoJSON cut them to the\n"
                     "smallest box around all centres and a tenth more,\n"
                     "pictures to what they show")
        ->type_name("X0 Y0 X1 Y1")
        ->expected(4);
    command
        ->add_option("--tolerance", call->tolerance,
                     "How far the polygons of tables and GeoJSON may be\n"
                     "from the arcs they stand for. Default: the longer\n"
                     "side of the box / 10000")
        ->type_name("T");
    command->add_flag("--merge", call->merge,
                      "One vertex where several faces have the same\n"
                      "circle, without edges of no length");
    add_output(*command, call->outputs,
               ".json     vertices, edges with their curves,\n"
               "          cells with their measures\n"
               ".svg      a picture with true arcs\n"
               ".geojson  the cells as polygons\n"
               ".csv      the cells as a table, polygons as WKT\n");
    command->footer(
        "Examples:\n"
        "  signum voronoi sites.txt -o cells.svg -o cells.geojson\n"
        "  signum voronoi sites.txt --metric power --clip 0 0 100 100 -o areas.csv");
    command->callback([call] { run(*call); });
}

}  // namespace signum::cli
