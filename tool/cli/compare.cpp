/// signum compare: what another arithmetic makes of the same sites, edge by edge, and what it
/// costs.

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "../../triangulation/triangulate.hpp"
#include "../../voronoi/compare.hpp"
#include "../draw/svg.hpp"
#include "../io/output_file.hpp"
#include "../io/text_writer.hpp"
#include "../study/margin.hpp"

#include "commands.hpp"
#include "compare_report.hpp"
#include "progress.hpp"

namespace signum::cli {
namespace {

/// The answer, and what the picture is drawn of: nothing where the structure broke.
struct Report : ComparedReport {
    std::array<std::optional<Tessellation>, 2> built = {};
    std::array<EdgeComparison, 2> edges = {};
};

class Builder {
 public:
    Builder(const CompareCall& call, const InputSites& sites)
        : call_(call), sites_(sites), metric_(metric_of(call.metric)) {}

    /// Throws BrokenStructure.
    [[nodiscard]] Tessellation build(Arithmetic arithmetic, bool count,
                                     std::function<void(double)> progress = {}) const {
        Options options;
        options.arithmetic = arithmetic;
        options.seed = call_.seed;
        options.count = count;
        options.progress = std::move(progress);
        try {
            return triangulate(strided_view(sites_.file.sites, sites_.third), metric_, options);
        } catch (const std::invalid_argument& error) {
            throw CallError(error.what());
        }
    }

 private:
    const CompareCall& call_;
    const InputSites& sites_;
    Metric metric_;
};

/// How near the sites come to ties.
std::string nearness(const study::Margins& margins) {
    std::string near;
    if (margins.least)
        near = fmt::format(
            "; the nearest that sites come to a tie without being one is {:.1e} of its terms",
            *margins.least);
    if (margins.ties > 0)
        near += fmt::format("{} {} of {} edges are ties", margins.least ? ", and" : ";",
                            margins.ties, margins.edges);
    return near;
}

Report compare(const CompareCall& call, const InputSites& sites) {
    std::optional<Progress> bar;
    if (!call.quiet) bar.emplace();
    double done = 0.0;
    const auto show = [&](double share) {
        if (bar) bar->show((done + share) / 4.0);
    };
    const auto finished = [&] {
        done += 1.0;
        show(0.0);
    };

    const Builder builder(call, sites);
    Report report = {
        {"edge", {{{arithmetic_of(call.arithmetic)}, {arithmetic_of(call.against)}}}, true}};
    for (std::size_t i = 0; i < 2; ++i) {
        ComparedRun& run = report.runs[i];
        try {
            report.built[i] = builder.build(run.arithmetic, true, show);
            run.statistics = report.built[i]->statistics();
        } catch (const BrokenStructure& error) {
            run.is_broken = true;
            run.broken = error.what();
        }
        finished();
    }
    std::optional<Tessellation> apart;
    const Tessellation* canonical = nullptr;
    for (std::size_t i = 0; i < 2; ++i)
        if (report.runs[i].arithmetic == Arithmetic::exact) canonical = &*report.built[i];
    if (canonical == nullptr)
        canonical = &apart.emplace(builder.build(Arithmetic::exact, false, show));
    for (std::size_t i = 0; i < 2; ++i) {
        if (!report.built[i]) continue;
        const EdgeComparison& edges = report.edges[i] = compare_edges(*report.built[i], *canonical);
        report.runs[i].counts = {edges.edges, edges.wrong.size(), edges.different.size()};
    }
    const study::Margins margins = study::margins_of(*canonical);
    report.near = nearness(margins);
    report.margins =
        fmt::format("{{\"edges\": {}, \"ties\": {}, \"least\": {}}}", margins.edges, margins.ties,
                    margins.least ? number_or_null(*margins.least) : "null");
    finished();
    time_runs(report, call.seconds, [&](Arithmetic arithmetic) {
        return builder.build(arithmetic, false).statistics().seconds;
    });
    return report;
}

constexpr std::array<Format, 1> compare_formats = {
    {{"svg", "the judged tessellation, wrong edges thick"}}};

// ---- the call ----------------------------------------------------------------------------------

void run(const CompareCall& call) {
    if (arithmetic_of(call.arithmetic) == arithmetic_of(call.against))
        throw CallError(
            fmt::format("--arithmetic and --against are both {}; name two", call.against));
    // Without -o and --format nothing is drawn.
    std::vector<Target> targets;
    if (!call.outputs.empty() || !call.format.empty())
        targets = targets_of(call, call.input, compare_formats);
    const bool is_drawn_there = std::ranges::count(targets, "-", &Target::path) > 0;
    if (call.json && is_drawn_there) {
        throw CallError(
            "--json and the picture would both go to standard output; give the picture a file, as "
            "in -o wrong.svg");
    }
    const InputSites sites = read_input(call);
    if (sites.file.dimension == 3) return compare_in_space(call, sites);
    for (const std::string& arithmetic : {call.arithmetic, call.against})
        check_reach(call.input, sites.file, arithmetic);
    const Outputs outputs(targets);
    const Report report = compare(call, sites);
    DescriptorStream out(is_drawn_there ? 2 : 1,
                         is_drawn_there ? "standard error" : "standard output");
    TextWriter text(out);
    put_report(text, report, call.json);
    text.flush();
    out.flush();
    if (targets.empty()) return;
    const auto& [judged, other] = report.built;
    if (!judged)
        throw CheckFailure(
            fmt::format("{} arithmetic broke the structure, so that there is "
                        "nothing to draw; nothing is written",
                        call.arithmetic));
    outputs.write(
        {{"svg", [&](std::ostream& picture) {
              write_svg(picture, *judged,
                        {.wrong = report.edges[0].wrong, .different = report.edges[0].different});
          }}});
    if (!call.quiet) say("{}", written(targets));
}

}  // namespace

void add_compare(CLI::App& tool) {
    auto call = std::make_shared<CompareCall>();
    call->arithmetic = name_of(Arithmetic::naive);
    CLI::App* command = tool.add_subcommand(
        "compare", "Says what rounded arithmetic gets wrong, and what exactness costs");
    add_sites(*command, *call);
    add_space(*command, *call);
    command
        ->add_option("--arithmetic", call->arithmetic,
                     "The one that is judged, a name that triangulate\n--arithmetic knows")
        ->transform(name_of_arithmetic())
        ->type_name("NAME")
        ->capture_default_str();
    command->add_option("--against", call->against, "The one whose time it is compared with")
        ->transform(name_of_arithmetic())
        ->type_name("NAME")
        ->capture_default_str();
    command->add_option("--seconds", call->seconds, "For the timing, three rounds at least")
        ->check(number_from(0.0, 86400.0))
        ->type_name("T")
        ->capture_default_str();
    command->add_flag("--json", call->json, "The same as JSON");
    add_outputs(*command, *call, compare_formats,
                "the table goes to standard error then. Without it\nnothing is drawn");
    command->footer(
        "An edge is wrong when no tessellation of the sites, however ties are decided,\n"
        "has it, and different when it is not the canonical choice; a run that lost its\n"
        "structure is broken. In space cells are judged, in naive and exact arithmetic\n"
        "alone, and nothing is drawn.\n\n"
        "Examples:\n"
        "  signum compare sites.txt --metric power -o wrong.svg\n"
        "  signum compare sites.txt --arithmetic naive --against multiprecision --json\n"
        "  signum compare atoms.pdb --metric power");
    command->callback([call] { run(*call); });
}

}  // namespace signum::cli
