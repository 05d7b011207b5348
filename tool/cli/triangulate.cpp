/// signum triangulate: from a file of sites to files of the tessellation.

#include <algorithm>
#include <array>
#include <iterator>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "../../triangulation/triangulate.hpp"
#include "../../triangulation/validate.hpp"
#include "../draw/svg.hpp"
#include "../io/write_csv.hpp"
#include "../io/write_json.hpp"
#include "../io/write_nodes.hpp"
#include "../io/write_obj.hpp"
#include "../io/write_ply.hpp"
#include "../io/write_vtk.hpp"

#include "clip.hpp"
#include "commands.hpp"
#include "formats.hpp"
#include "outputs.hpp"
#include "progress.hpp"
#include "triangulate_call.hpp"
#include "triangulate_space.hpp"

namespace signum::cli {
namespace {

Method method_of(const std::string& name, Metric metric) {
    const Method method =
        *std::ranges::find_if(all_methods, [&](Method each) { return name_of(each) == name; });
    if (builds(method, metric)) return method;
    std::vector<std::string_view> built;
    for (const Metric other : all_metrics) {
        if (builds(method, other)) built.push_back(name_of(other));
    }
    throw CallError(
        fmt::format("--method {} builds only {}, and this is --metric {}; leave --method out, or "
                    "add --metric {}",
                    name, fmt::join(built, " and "), name_of(metric), built.back()));
}

/// Options that one format alone heeds.
void require_formats_for_options(const TriangulateCall& call, std::span<const Target> targets) {
    if (call.vertices && !is_written(targets, "json"))
        throw CallError("--vertices goes into JSON alone; add -o FILE.json");
    if (!call.clip.empty() && !is_picture_written(targets))
        throw CallError("--clip is what a picture shows; add -o FILE.svg");
}

/// The edges between sites that the Delaunay triangulation of the centres does not have.
std::vector<Edge> flipped_edges(const Tessellation& tessellation) {
    std::vector<Point> centres;
    for (const Site& site : tessellation.sites()) centres.push_back({site.x, site.y});
    const std::vector<Edge> before = triangulate(centres, Power{}).edges();
    std::vector<Edge> flipped;
    std::ranges::set_difference(tessellation.edges(), before, std::back_inserter(flipped));
    std::erase_if(flipped, [](const Edge& edge) { return edge[0] == infinite; });
    return flipped;
}

void summarize(const Tessellation& tessellation, std::span<const Target> targets) {
    const auto faces = tessellation.faces();
    const std::size_t sites = tessellation.sites().size();
    const std::size_t hidden = tessellation.hidden().size();
    const auto infinite_faces = std::count_if(faces.begin(), faces.end(),
                                              [](const Face& face) { return face[0] == infinite; });
    const bool weighted = tessellation.weight_is() == WeightIs::weight;
    say("sites    {}{}\n", sites, weighted ? ", the third number a weight" : "");
    say("visible  {}\n", sites - hidden);
    say("hidden   {}\n", hidden);
    say("faces    {}, {} of them infinite\n", faces.size(), infinite_faces);
    if (tessellation.statistics().flips > 0) say("flips    {}\n", tessellation.statistics().flips);
    if (tessellation.statistics().events > 0)
        say("events   {}\n", tessellation.statistics().events);
    say("seconds  {:.3g}\n", tessellation.statistics().seconds);
    say("{}", written(targets));
}

void summarize_statistics(const Statistics& s) {
    say("calls    {} ccw, {} in_circle, {} nearer, {} others\n", s.ccw, s.in_circle, s.nearer,
        s.others);
    say("decided  {} by the filter, {} refined, {} exactly, {} by ESSA, {} in multiprecision\n",
        s.filtered, s.refined, s.exact, s.essa, s.multiprecision);
    say("ties     {}, decided by the tie rule\n", s.ties);
}

/// Judges the tessellation from scratch. An exact one must be the canonical one, too.
Validation check(const TriangulateCall& call, const Tessellation& tessellation) {
    const Validation result = validate_with_progress(
        tessellation.arrays(), strided_view(tessellation.sites(), tessellation.weight_is()),
        call.quiet);
    if (!result.valid || (!result.canonical && is_exact(arithmetic_of(call.arithmetic)))) {
        throw CheckFailure(words_of_failed_check(result));
    }
    return result;
}

void run(const TriangulateCall& call) {
    const Method method = method_of(call.method, metric_of(call.metric));
    if (method == Method::flips && arithmetic_of(call.arithmetic) != Arithmetic::exact) {
        throw CallError(
            fmt::format("--method flips has exact arithmetic alone; leave --arithmetic {} out",
                        call.arithmetic));
    }
    const std::vector<Target> targets = targets_of(call, call.input, triangulate_formats);
    require_formats_for_options(call, targets);
    const std::optional<Box> clip = box_of(call.clip, targets);
    const InputSites sites = read_input(call);
    if (sites.file.dimension == 3) return triangulate_in_space(call, sites, targets);
    require_formats_of(Dimension::two, targets, triangulate_formats, call.input);
    const Outputs outputs(targets);
    const Tessellation tessellation = construct(call, sites, method);
    if (clip) require_fit(*clip, Voronoi(tessellation));
    // Before anything is written: what fails its check is not left under the name asked for.
    std::optional<Validation> checked;
    if (call.check) checked = check(call, tessellation);
    outputs.write({{"svg",
                    [&](std::ostream& out) {
                        const std::vector<Edge> flipped = method == Method::flips
                                                              ? flipped_edges(tessellation)
                                                              : std::vector<Edge>{};
                        write_svg(out, tessellation, {.box = clip, .flipped = flipped});
                    }},
                   {"csv", [&](std::ostream& out) { write_csv(out, tessellation); }},
                   {"obj", [&](std::ostream& out) { write_obj(out, tessellation); }},
                   {"ply", [&](std::ostream& out) { write_ply(out, tessellation); }},
                   {"vtk", [&](std::ostream& out) { write_vtk(out, vtk_grid(tessellation)); }},
                   {"vtp", [&](std::ostream& out) { write_vtp(out, vtk_grid(tessellation)); }},
                   {"node", [&](std::ostream& out) { write_node(out, tessellation.sites()); }},
                   {"ele", [&](std::ostream& out) { write_ele(out, tessellation); }},
                   {"neigh", [&](std::ostream& out) { write_neigh(out, tessellation); }},
                   {"json", [&](std::ostream& out) {
                        write_json(out, tessellation, {call.vertices, call.statistics});
                    }}});
    if (!call.quiet) {
        summarize(tessellation, targets);
        hint_at_space(call, sites.file, tessellation.hidden().size());
        if (call.statistics) summarize_statistics(tessellation.statistics());
        if (checked) say("check    valid, {}canonical\n", checked->canonical ? "" : "not ");
    }
}

}  // namespace

void add_triangulate(CLI::App& tool) {
    auto call = std::make_shared<TriangulateCall>();
    CLI::App* command = tool.add_subcommand("triangulate", "Computes the tessellation of sites");
    add_sites(*command, *call);
    add_space(*command, *call);
    command
        ->add_option("--method", call->method,
                     "incremental: site by site; flips: from Delaunay's\n"
                     "triangulation, power metric only; sweep: a line\n"
                     "over the plane, manhattan and supremum only; the\nresult is the same")
        ->transform(one_of({"incremental", "flips", "sweep"}))
        ->type_name("NAME")
        ->capture_default_str();
    command
        ->add_option("--arithmetic", call->arithmetic,
                     "What decides signs. The first four never err:\n"
                     "exact           a filter, then ever dearer stages\n"
                     "interval        intervals, then the exact sign of a sum\n"
                     "sum             the exact sign of a sum alone (ESSA)\n"
                     "multiprecision  rationals alone\n"
                     "naive           doubles, which round\n"
                     "single          floats, which round\n"
                     "In space exact and naive alone.")
        ->transform(name_of_arithmetic())
        ->type_name("NAME")
        ->capture_default_str();
    add_outputs(*command, *call, triangulate_formats, "without it the result goes there, as JSON");
    add_clip(*command, call->clip,
             "The box that a picture shows. Default: all sites\nwith some room around them");
    command->add_flag("--vertices", call->vertices,
                      "Adds centre and distance of every finite face,\nin space cell, to the JSON");
    command->add_flag("--stats", call->statistics,
                      "Adds counters and time to the JSON and to the\nsummary");
    command->add_flag("--check", call->check,
                      "Judges the result from scratch before it is\nwritten; where it is wrong, "
                      "exit 1 and nothing\nis written");
    command->footer(
        "Examples:\n"
        "  signum triangulate sites.txt --metric power -o out.json -o out.svg --check\n"
        "  signum triangulate sites.txt --metric supremum --stats -o squares.svg\n"
        "  signum triangulate sites.txt --clip 0 0 10 10 -o part.svg\n"
        "  signum triangulate balls.txt --dimension 3 --metric power -o grid.vtu\n"
        "  signum triangulate sites.node -o sites.ele -o sites.neigh -o picture.pdf");
    command->callback([call] { run(*call); });
}

}  // namespace signum::cli
