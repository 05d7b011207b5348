/// signum triangulate: from a file of sites to files of the tessellation.

#include <algorithm>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "../draw/svg.hpp"
#include "../io/write_csv.hpp"
#include "../io/write_json.hpp"
#include "../io/write_obj.hpp"
#include "../triangulation/triangulate.hpp"
#include "../triangulation/validate.hpp"

#include "clip.hpp"
#include "commands.hpp"
#include "outputs.hpp"
#include "sites_call.hpp"

namespace signum::cli {
namespace {

/// The call as it was typed.
struct Call : SitesCall {
    std::string method = "incremental";
    std::vector<double> clip;
    std::vector<std::string> outputs;
    bool vertices = false;
    bool check = false;
};

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

bool is_written(const Call& call, std::string_view ending) {
    return std::ranges::any_of(call.outputs,
                               [&](const std::string& path) { return ending_of(path) == ending; });
}

/// Options that one kind of file alone heeds.
void require_files_for_options(const Call& call) {
    if (call.vertices && !call.outputs.empty() && !is_written(call, ".json"))
        throw CallError("--vertices goes into JSON alone; add -o FILE.json");
    if (!call.clip.empty() && !is_written(call, ".svg"))
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

void write(std::ostream& out, const std::string& ending, const Tessellation& tessellation,
           const JsonOptions& options, const std::optional<Box>& clip, Method method) {
    if (ending == ".svg") {
        const std::vector<Edge> flipped =
            method == Method::flips ? flipped_edges(tessellation) : std::vector<Edge>{};
        write_svg(out, tessellation, {.box = clip, .flipped = flipped});
    } else if (ending == ".csv") {
        write_csv(out, tessellation);
    } else if (ending == ".obj") {
        write_obj(out, tessellation);
    } else {
        write_json(out, tessellation, options);
    }
}

void summarize(const Tessellation& tessellation, const std::vector<std::string>& outputs) {
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
    if (!outputs.empty()) say("written  {}\n", fmt::join(outputs, ", "));
}

void summarize_statistics(const Statistics& s) {
    say("calls    {} ccw, {} in_circle, {} ties\n", s.ccw, s.in_circle, s.ties);
    say("decided  {} by the filter, {} refined, {} by ESSA, {} in multiprecision\n", s.filtered,
        s.refined, s.essa, s.multiprecision);
}

/// Judges the tessellation from scratch. An exact one must be the canonical one, too.
void check(const Call& call, const Tessellation& tessellation) {
    const Validation result = validate(
        tessellation.arrays(), strided_view(tessellation.sites(), tessellation.weight_is()));
    if (!result.valid) {
        throw CheckFailure(fmt::format("--check: not valid: {}", result.message));
    }
    if (!result.canonical && is_exact(arithmetic_of(call.arithmetic))) {
        throw CheckFailure(fmt::format("--check: valid, not canonical: {}", result.message));
    }
    if (call.quiet) return;
    say("check    valid, {}canonical\n", result.canonical ? "" : "not ");
}

void run(const Call& call) {
    const Method method = method_of(call.method, metric_of(call.metric));
    if (method == Method::flips && arithmetic_of(call.arithmetic) != Arithmetic::exact) {
        throw CallError(
            fmt::format("--method flips has exact arithmetic alone; leave --arithmetic {} out",
                        call.arithmetic));
    }
    check_outputs(call.outputs, call.input, {".json", ".svg", ".csv", ".obj"});
    require_files_for_options(call);
    const std::optional<Box> clip = box_of(call.clip, call.outputs);
    const InputSites sites = read_input(call);
    const Outputs outputs(call.outputs);
    const Tessellation tessellation = construct(call, sites, method);
    if (clip) require_fit(*clip, Voronoi(tessellation));
    outputs.write(
        [&](std::ostream& out, const std::string& ending) {
            write(out, ending, tessellation, {call.vertices, call.statistics}, clip, method);
        },
        ".json");
    if (!call.quiet) {
        summarize(tessellation, call.outputs);
        if (call.statistics) summarize_statistics(tessellation.statistics());
    }
    if (call.check) check(call, tessellation);
}

}  // namespace

void add_triangulate(CLI::App& tool) {
    auto call = std::make_shared<Call>();
    CLI::App* command = tool.add_subcommand("triangulate", "Computes the tessellation of sites");
    add_sites(*command, *call);
    command
        ->add_option("--method", call->method,
                     "incremental: site by site; flips: from Delaunay's\n"
                     "triangulation, power metric only; sweep: a line\n"
                     "over the plane, manhattan and supremum only; the\nresult is the same")
        ->check(one_of({"incremental", "flips", "sweep"}))
        ->type_name("NAME")
        ->capture_default_str();
    command
        ->add_option("--arithmetic", call->arithmetic,
                     "What decides signs. The first four never err:\n"
                     "exact           a filter, then ever dearer stages\n"
                     "interval        intervals, then the exact stage at once\n"
                     "sum             the exact stage alone\n"
                     "multiprecision  rationals alone\n"
                     "naive           doubles, which round\n"
                     "single          floats, which round")
        ->check(name_of_arithmetic())
        ->type_name("NAME")
        ->capture_default_str();
    add_output(*command, call->outputs,
               ".json  faces, neighbours, hidden sites\n"
               ".svg   a picture\n"
               ".csv   a table a,b,c of faces, -1 is infinity\n"
               ".obj   a mesh of the finite faces\n");
    add_clip(*command, call->clip,
             "The box that a picture shows. Default: all sites\nwith some room around them");
    command->add_flag("--vertices", call->vertices,
                      "Adds centre and distance of every finite face\nto the JSON");
    command->add_flag("--stats", call->statistics,
                      "Adds counters and time to the JSON and to the\nsummary");
    command->add_flag(
        "--check", call->check,
        "Judges the result from scratch, in exact\narithmetic; exit 1 when it is wrong");
    command->footer(
        "Examples:\n"
        "  signum triangulate sites.txt --metric power -o out.json -o out.svg --check\n"
        "  signum triangulate sites.txt --metric supremum --stats -o squares.svg\n"
        "  signum triangulate sites.txt --clip 0 0 10 10 -o part.svg");
    command->callback([call] { run(*call); });
}

}  // namespace signum::cli
