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
struct Call : SitesCall, OutputsCall {
    std::string method = "incremental";
    std::vector<double> clip;
    bool vertices = false;
    bool check = false;
};

Method method_of(const std::string& name, Metric metric) {
    if (name == name_of(Method::flips)) {
        if (metric == Metric::power) return Method::flips;
        throw CallError(
            fmt::format("--method flips: only the power metric is built by flips, and this is "
                        "--metric {}; leave --method out, or add --metric power",
                        name_of(metric)));
    }
    if (name == name_of(Method::sweep)) {
        if (metric == Metric::manhattan || metric == Metric::supremum) return Method::sweep;
        throw CallError(
            fmt::format("--method sweep: only the manhattan and supremum metrics are built by a "
                        "sweep, and this is --metric {}; leave --method out, or add --metric "
                        "supremum",
                        name_of(metric)));
    }
    return Method::incremental;
}

constexpr std::array<Format, 4> formats = {{{"json", "faces, neighbours, hidden sites"},
                                            {"svg", "a picture"},
                                            {"csv", "a table a,b,c of faces, -1 is infinity"},
                                            {"obj", "a mesh of the finite faces"}}};

/// Options that one format alone heeds.
void require_formats_for_options(const Call& call, std::span<const Target> targets) {
    if (call.vertices && !is_written(targets, "json"))
        throw CallError("--vertices goes into JSON alone; add -o FILE.json");
    if (!call.clip.empty() && !is_written(targets, "svg"))
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

void write(std::ostream& out, std::string_view format, const Tessellation& tessellation,
           const JsonOptions& options, const std::optional<Box>& clip, Method method) {
    if (format == "svg") {
        const std::vector<Edge> flipped =
            method == Method::flips ? flipped_edges(tessellation) : std::vector<Edge>{};
        write_svg(out, tessellation, {.box = clip, .flipped = flipped});
    } else if (format == "csv") {
        write_csv(out, tessellation);
    } else if (format == "obj") {
        write_obj(out, tessellation);
    } else {
        write_json(out, tessellation, options);
    }
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
    const std::vector<Target> targets = targets_of(call, call.input, formats);
    require_formats_for_options(call, targets);
    const std::optional<Box> clip = box_of(call.clip, targets);
    const InputSites sites = read_input(call);
    const Outputs outputs(targets);
    const Tessellation tessellation = construct(call, sites, method);
    if (clip) require_fit(*clip, Voronoi(tessellation));
    outputs.write([&](std::ostream& out, std::string_view format) {
        write(out, format, tessellation, {call.vertices, call.statistics}, clip, method);
    });
    if (!call.quiet) {
        summarize(tessellation, targets);
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
        ->transform(one_of({"incremental", "flips", "sweep"}))
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
        ->transform(name_of_arithmetic())
        ->type_name("NAME")
        ->capture_default_str();
    add_outputs(*command, *call, formats, "without it the result goes there, as JSON");
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
