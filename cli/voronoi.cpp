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

#include "clip.hpp"
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

/// Throws CallError where doubles cannot compute with the box that an output is cut to.
void check_box(const Call& call, const Box& box, const Voronoi& diagram) {
    const bool is_used =
        !call.clip.empty() || std::ranges::any_of(call.outputs, [](const std::string& path) {
            return ending_of(path) == ".geojson" || ending_of(path) == ".csv";
        });
    if (is_used) require_fit(box, diagram);
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
    const std::optional<Box> clip = box_of(call.clip, call.outputs);
    if (call.tolerance && !(*call.tolerance > 0 && std::isfinite(*call.tolerance)))
        throw CallError("--tolerance: it is to be above 0 and finite");
    const InputSites sites = read_input(call);
    const Outputs outputs(call.outputs);
    const Voronoi diagram(construct(call, sites), {call.merge});

    const Box box = clip.value_or(default_box(diagram.tessellation().sites(), diagram.exponent()));
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
    add_clip(*command, call->clip,
             "The box that cells are cut to. Default: JSON has\n"
             "them whole; tables and GeoJSON cut them to the\n"
             "smallest box around all centres and a tenth more,\n"
             "pictures to what they show");
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
