/// signum triangulate: from a file of sites to files of the tessellation.

#include <algorithm>
#include <array>
#include <chrono>
#include <iterator>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "../../triangulation/space/triangulate.hpp"
#include "../../triangulation/space/vertices.hpp"
#include "../../triangulation/triangulate.hpp"
#include "../../triangulation/validate.hpp"
#include "../draw/svg.hpp"
#include "../io/names.hpp"
#include "../io/write_sites.hpp"
#include "../io/write_tessellation.hpp"
#include "../study/timing.hpp"

#include "clip.hpp"
#include "commands.hpp"
#include "formats.hpp"
#include "outputs.hpp"
#include "progress.hpp"
#include "sites_call.hpp"
#include "within_memory.hpp"

namespace signum::cli {
namespace {

/// The call as it was typed.
struct TriangulateCall : SitesCall, OutputsCall, MemoryCall {
    std::string method = "incremental";
    std::string order = "index";
    std::vector<double> clip;
    bool vertices = false;
    bool check = false;
};

Method method_of(const std::string& name, Metric metric) {
    const Method method = named(all_methods, name).value();
    if (builds(method, metric)) return method;
    std::vector<std::string_view> built;
    for (const Metric other : all_metrics)
        if (builds(method, other)) built.push_back(name_of(other));
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
std::vector<Edge> flipped_edges(const Tessellation& tessellation, int threads) {
    std::vector<Point> centres;
    for (const Site& site : tessellation.sites()) centres.push_back({site.x, site.y});
    const std::vector<Edge> before = triangulate(centres, Power{}, {.threads = threads}).edges();
    std::vector<Edge> flipped;
    std::ranges::set_difference(tessellation.edges(), before, std::back_inserter(flipped));
    std::erase_if(flipped, [](const Edge& edge) { return edge[0] == infinite; });
    return flipped;
}

/// Throws where a tessellation that was judged from scratch is not what it must be: an exact one
/// must be the canonical one, too.
Validation checked(const TriangulateCall& call, Validation result) {
    if (result.valid && (result.canonical || !is_exact(arithmetic_of(call.arithmetic))))
        return result;
    throw CheckFailure(
        fmt::format("--check: {}: {}; nothing is written, without --check it would be",
                    result.valid ? "valid, not canonical" : "not valid", result.message));
}

/// `cells` are faces or, in space, cells; `kind` is what they are called, as wide as other lines.
template <class Cells>
void say_counts(std::size_t sites, std::size_t hidden, std::string_view kind, const Cells& cells) {
    say("visible  {}\n", sites - hidden);
    say("hidden   {}\n", hidden);
    say("{}    {}, {} of them infinite\n", kind, cells.size(),
        std::ranges::count_if(cells, [](const auto& each) { return each[0] == infinite; }));
}

void say_check(const std::optional<Validation>& checked) {
    if (checked) say("check    valid, {}canonical\n", checked->canonical ? "" : "not ");
}

void summarize(const Tessellation& tessellation, std::span<const Target> targets) {
    const Statistics& statistics = tessellation.statistics();
    const std::size_t sites = tessellation.sites().size();
    const bool weighted = tessellation.weight_is() == WeightIs::weight;
    say("sites    {}{}\n", sites, weighted ? ", the third number a weight" : "");
    say_counts(sites, tessellation.hidden().size(), "faces", tessellation.faces());
    if (statistics.flips > 0) say("flips    {}\n", statistics.flips);
    if (statistics.events > 0) say("events   {}\n", statistics.events);
    say("seconds  {:.3g}\n", statistics.seconds);
    say("{}", written(targets));
}

void summarize(const SpaceTessellation& tessellation, double seconds, WeightIs third,
               std::span<const Target> targets) {
    say_sites_in_space(tessellation.sites, third);
    constexpr std::string_view spans[] = {"in one place", "on a line", "in a plane"};
    if (tessellation.dimension < 3) say("flat     all lie {}\n", spans[tessellation.dimension]);
    say_counts(static_cast<std::size_t>(tessellation.sites), tessellation.hidden.size(), "cells",
               tessellation.cells);
    say("seconds  {:.3g}\n", seconds);
    say("{}", written(targets));
}

void summarize_statistics(const Statistics& s) {
    say("calls    {} ccw, {} in_circle, {} nearer, {} others\n", s.ccw, s.in_circle, s.nearer,
        s.others);
    say("decided  {} by the filter, {} refined, {} exactly, {} by ESSA, {} in multiprecision\n",
        s.filtered, s.refined, s.exact, s.essa, s.multiprecision);
    say("ties     {}, decided by the tie rule\n", s.ties);
}

/// Options that are heeded in the plane alone.
void refuse_options_of_the_plane(const TriangulateCall& call) {
    constexpr std::string_view what = "sites in space";
    if (call.method != name_of(Method::incremental))
        refuse_option(call, "--method " + call.method, what, "have the method incremental alone");
    if (call.order != name_of(Order::index))
        refuse_option(call, "--order " + call.order, what, "have cells, which stand by index");
    check_arithmetic_in_space(call, "--arithmetic", call.arithmetic);
    if (!call.clip.empty())
        refuse_option(call, "--clip", what, "have pictures of all of them alone");
}

void triangulate_in_space(const TriangulateCall& call, const InputSites& sites,
                          std::span<const Target> targets) {
    refuse_options_of_the_plane(call);
    require_formats_of(Dimension::three, targets, triangulate_formats, call.input);
    const Outputs outputs(targets);
    const auto start = std::chrono::steady_clock::now();
    const SpaceTessellation tessellation = construct_in_space(call, sites);
    Statistics statistics;  // of the time alone: nothing is counted
    statistics.seconds = study::seconds_since(start);
    const std::vector<Site3>& balls = sites.file.in_space;
    std::vector<SpaceVertex> diagram;
    if (call.vertices) {
        diagram = with_sites_in_space(
            sites, [&](auto those) { return vertices(tessellation, those, call.threads); });
    }
    // Before anything is written: what fails its check is not left under the name asked for.
    std::optional<Validation> validation;
    if (call.check) {
        validation = checked(call, with_sites_in_space(sites, [&](auto those) {
                                 return validate_with_progress(tessellation, those, call.quiet,
                                                               call.threads);
                             }));
    }
    const auto grid = [&] { return vtk_grid(tessellation, balls, sites.third); };
    const int first = sites.file.first_number;
    outputs.write(
        {{"svg", [&](std::ostream& out) { write_svg(out, tessellation, balls, sites.third); }},
         {"csv", [&](std::ostream& out) { write_csv(out, tessellation); }},
         {"npy", [&](std::ostream& out) { write_npy(out, tessellation); }},
         {"i32", [&](std::ostream& out) { write_i32(out, tessellation); }},
         {"obj", [&](std::ostream& out) { write_obj(out, tessellation, balls); }},
         {"vtk", [&](std::ostream& out) { write_vtk(out, grid()); }},
         {"vtu", [&](std::ostream& out) { write_vtu(out, grid()); }},
         {"ply", [&](std::ostream& out) { write_ply(out, balls, sites.third); }},
         {"node", [&](std::ostream& out) { write_sites(out, balls, SitesFormat::node, first); }},
         {"ele", [&](std::ostream& out) { write_ele(out, tessellation, first); }},
         {"neigh", [&](std::ostream& out) { write_neigh(out, tessellation, first); }},
         {"json", [&](std::ostream& out) {
              write_json(out, tessellation, metric_of(call.metric), sites.third,
                         call.statistics ? std::optional(statistics) : std::nullopt, diagram);
          }}});
    if (call.quiet) return;
    summarize(tessellation, statistics.seconds, sites.third, targets);
    say_check(validation);
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
    if (!call.memory.empty()) {
        if (method != Method::incremental || call.arithmetic != name_of(Arithmetic::exact) ||
            call.order != name_of(Order::index) || call.check || call.statistics)
            throw CallError(
                "--memory goes with the exact insertion, the order index, and neither --check nor "
                "--stats; leave --method, --arithmetic, --order, --check and --stats out");
        return triangulate_within(call, call, targets);
    }
    if (call.resume)
        throw CallError(
            "--resume goes with --memory, as in --memory 4G; add it, or leave --resume out");
    const InputSites sites = read_input(call);
    if (sites.file.dimension == 3) return triangulate_in_space(call, sites, targets);
    require_formats_of(Dimension::two, targets, triangulate_formats, call.input);
    const Outputs outputs(targets);
    const Tessellation tessellation =
        construct(call, sites, method, named(all_orders, call.order).value());
    if (clip) require_fit(*clip, Voronoi(tessellation, {.threads = call.threads}));
    // Before anything is written: what fails its check is not left under the name asked for.
    std::optional<Validation> validation;
    if (call.check) {
        validation = checked(call, validate_with_progress(
                                       tessellation.arrays(),
                                       strided_view(tessellation.sites(), tessellation.weight_is()),
                                       call.quiet, call.threads));
    }
    const int first = sites.file.first_number;
    outputs.write(
        {{"svg",
          [&](std::ostream& out) {
              const std::vector<Edge> flipped = method == Method::flips
                                                    ? flipped_edges(tessellation, call.threads)
                                                    : std::vector<Edge>{};
              write_svg(out, tessellation,
                        {.box = clip, .flipped = flipped, .threads = call.threads});
          }},
         {"csv", [&](std::ostream& out) { write_csv(out, tessellation); }},
         {"npy", [&](std::ostream& out) { write_npy(out, tessellation); }},
         {"i32", [&](std::ostream& out) { write_i32(out, tessellation); }},
         {"obj", [&](std::ostream& out) { write_obj(out, tessellation); }},
         {"ply", [&](std::ostream& out) { write_ply(out, tessellation); }},
         {"vtk", [&](std::ostream& out) { write_vtk(out, vtk_grid(tessellation)); }},
         {"vtp", [&](std::ostream& out) { write_vtp(out, vtk_grid(tessellation)); }},
         {"node",
          [&](std::ostream& out) {
              write_sites(out, tessellation.sites(), SitesFormat::node, first);
          }},
         {"ele", [&](std::ostream& out) { write_ele(out, tessellation, first); }},
         {"neigh", [&](std::ostream& out) { write_neigh(out, tessellation, first); }},
         {"json", [&](std::ostream& out) {
              write_json(out, tessellation, {call.vertices, call.statistics, call.threads});
          }}});
    if (call.quiet) return;
    summarize(tessellation, targets);
    hint_at_space(call, sites.file, tessellation.hidden().size());
    if (call.statistics) summarize_statistics(tessellation.statistics());
    say_check(validation);
}

}  // namespace

void add_triangulate(CLI::App& tool) {
    auto call = std::make_shared<TriangulateCall>();
    CLI::App* command = tool.add_subcommand("triangulate", "Computes the tessellation of sites");
    add_sites(*command, *call);
    add_space(*command, *call);
    add_checked(*command, "--method", call->method, "NAME", one_of(names_of(all_methods)),
                "incremental: site by site; flips: from Delaunay's\n"
                "triangulation, power metric only; sweep: a line\n"
                "over the plane, manhattan and supremum only; the\nresult is the same")
        ->capture_default_str();
    add_checked(*command, "--order", call->order, "NAME", one_of(names_of(all_orders)),
                "Of the faces, and of the sites in each: index, by\n"
                "the numbers of the sites; curve, by their places\n"
                "along a curve, so that near ones stand together.\n"
                "Either depends on the sites alone. Of the plane;\n"
                "JSON keeps index")
        ->capture_default_str();
    add_checked(*command, "--arithmetic", call->arithmetic, "NAME", name_of_arithmetic(),
                "What decides signs. The first four never err:\n"
                "exact           a filter, then ever dearer stages\n"
                "interval        intervals, then the exact sign of a sum\n"
                "sum             the exact sign of a sum alone (ESSA)\n"
                "multiprecision  rationals alone\n"
                "naive           doubles, which round\n"
                "single          floats, which round\n"
                "In space exact and naive alone.")
        ->capture_default_str();
    add_memory(*command, *call);
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
        "  signum triangulate sites.npy --memory 4G -o faces.npy\n"
        "  signum triangulate sites.npy --memory 4G -o faces.npy --resume\n"
        "  signum triangulate sites.node -o sites.ele -o sites.neigh -o picture.pdf");
    command->callback([call] { run(*call); });
}

}  // namespace signum::cli
