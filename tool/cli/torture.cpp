/// signum torture: judges anybody's predicates.

#include <algorithm>
#include <array>
#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "../torture/report.hpp"

#include "commands.hpp"
#include "outputs.hpp"
#include "progress.hpp"
#include "sites_call.hpp"

namespace signum::cli {
namespace {

constexpr std::array<Format, 3> report_formats = {
    {{"txt", "for people"}, {"json", "for programs"}, {"html", "a page with pictures"}}};

/// The call as it was typed.
struct TortureCall {
    std::string plugin;
    std::array<std::string, torture::functions> names;
    std::string init;
    std::string returns = "double";
    double seconds = 60.0;
    std::uint64_t seed = 1;
    std::vector<std::string> sites;
    bool json = false;
    bool quiet = false;
    OutputsCall outputs;
};

void run(const TortureCall& call) {
    OutputsCall where = call.outputs;
    if (call.json && where.format.empty()) where.format = "json";
    const std::vector<Target> targets = targets_of(where, call.plugin, report_formats);
    const Outputs outputs(targets);
    const torture::Plugin plugin(call.plugin, call.names, call.init, call.returns == "int");
    torture::Options options;
    options.seconds = call.seconds;
    options.seed = call.seed;
    for (const std::string& path : call.sites) {
        const SitesFile file =
            read_sites(path, {.dimension = std::nullopt, .input = input_of(path, "")});
        const torture::OwnPoints& own =
            options.own.emplace_back(file.dimension == 3 ? torture::own_points(file.in_space)
                                                         : torture::own_points(file.sites));
        if (std::ranges::none_of(torture::all_asked, [&](torture::Asked asked) {
                return plugin.has(asked) && torture::dimension_of(asked) == own.dimension;
            }))
            say("signum: {}: its points lie in {}, and {} has no function for them\n", path,
                own.dimension == 2 ? "the plane" : "space", call.plugin);
    }
    const torture::Report report{call.plugin, call.seconds,
                                 with_progress(call.quiet, [&](const auto& show) {
                                     options.progress = show;
                                     return torture::torture(plugin, options);
                                 })};
    outputs.write({{"txt", [&](std::ostream& out) { out << torture::in_words(report); }},
                   {"json", [&](std::ostream& out) { out << torture::as_json(report); }},
                   {"html", [&](std::ostream& out) { out << torture::as_page(report); }}});
    if (!report.is_faultless())
        throw CheckFailure(
            fmt::format("{}: signs are wrong, or calls did not come back", call.plugin));
}

}  // namespace

void add_torture(CLI::App& tool) {
    auto call = std::make_shared<TortureCall>();
    CLI::App* command = tool.add_subcommand(
        "torture", "Judges anybody's predicates: which signs are wrong, and where");
    command
        ->add_option(
            "PLUGIN", call->plugin,
            "A shared library with C functions orient2d, incircle,\norient3d, insphere, or "
            "some of them, as Shewchuk's:\nof pointers to the coordinates of each point")
        ->required()
        ->type_name("");
    for (const torture::Asked asked : torture::all_asked) {
        const std::string name(torture::name_of(asked));
        command
            ->add_option("--" + name, call->names[torture::place_of(asked)],
                         fmt::format("What {} is called in PLUGIN", name))
            ->type_name("NAME");
    }
    command
        ->add_option("--init", call->init,
                     "What is called before them; where it is there,\nexactinit, as Shewchuk's and "
                     "TetGen's want it")
        ->type_name("NAME");
    add_checked(*command, "--returns", call->returns, "TYPE", one_of({"double", "int"}),
                "What the functions return: double or int");
    add_checked(*command, "--seconds", call->seconds, "N", number_from(1.0, 1e6),
                "For how long the functions are asked");
    add_checked(*command, "--seed", call->seed, "N", whole_number(), "Other questions");
    command
        ->add_option("--sites", call->sites,
                     "Points of your own, in plane or space: the functions\nare asked of "
                     "neighbours among them, too; several files\nare allowed")
        ->type_name("FILE");
    add_outputs(*command, call->outputs, report_formats, "the report goes to standard output");
    command->add_flag("--json", call->json, "The same as --format json");
    command->add_flag("--quiet", call->quiet, "No progress on standard error");
    command->footer(
        "What positive means is found out: Shewchuk's convention, its opposite, or inside\n"
        "and outside whichever way the points turn. A call that crashes or takes longer\n"
        "than two seconds is reported, and the rest goes on. Exit 1 where anything is wrong.\n\n"
        "Example:\n"
        "  cc -O2 -shared -fPIC predicates.c -o mine.so\n"
        "  signum torture mine.so -o report.html\n"
        "  signum torture mine.so --sites crashed.txt --seconds 5");
    command->callback([call] { run(*call); });
}

}  // namespace signum::cli
