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
#include "../study/timing.hpp"

#include "commands.hpp"
#include "compare_call.hpp"
#include "compare_space.hpp"
#include "compare_table.hpp"
#include "progress.hpp"

namespace signum::cli {
namespace {

/// What became of the sites in one arithmetic.
struct Run {
    Arithmetic arithmetic;
    std::optional<Tessellation> tessellation;  ///< nothing where the structure broke
    std::string broken;                        ///< ... and this is where
    EdgeComparison edges = {};
    study::Interval seconds = {};  ///< without runs where the structure broke

    [[nodiscard]] Counts counts() const {
        return {edges.edges, edges.wrong.size(), edges.different.size()};
    }
};

struct Report {
    std::array<Run, 2> runs;               ///< the one judged, and the one against it
    std::optional<study::Interval> ratio;  ///< of times, the second to the first
    study::Margins margins;

    [[nodiscard]] const Run& judged() const { return runs[0]; }
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

    /// With counters.
    [[nodiscard]] Run run(Arithmetic arithmetic, std::function<void(double)> progress) const {
        Run run = {arithmetic, std::nullopt, ""};
        try {
            run.tessellation = build(arithmetic, true, std::move(progress));
        } catch (const BrokenStructure& error) {
            run.broken = error.what();
        }
        return run;
    }

 private:
    const CompareCall& call_;
    const InputSites& sites_;
    Metric metric_;
};

/// Times of the runs that did not break, in turns.
void measure(Report& report, const Builder& builder, double seconds) {
    std::vector<study::Contestant> contestants;
    std::vector<Run*> contesting;
    for (Run& run : report.runs) {
        if (!run.tessellation) continue;
        contesting.push_back(&run);
        contestants.push_back([&builder, arithmetic = run.arithmetic] {
            return builder.build(arithmetic, false).statistics().seconds;
        });
    }
    study::Budget budget;
    budget.seconds = seconds;
    const study::Race race = study::race(contestants, budget);
    for (std::size_t i = 0; i < contesting.size(); ++i) contesting[i]->seconds = race.seconds[i];
    if (contesting.size() == 2) report.ratio = race.ratios[1];
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
        {Run{arithmetic_of(call.arithmetic), {}, ""}, Run{arithmetic_of(call.against), {}, ""}},
        {},
        {}};
    for (Run& run : report.runs) {
        run = builder.run(run.arithmetic, show);
        finished();
    }
    std::optional<Tessellation> apart;
    const Tessellation* canonical = nullptr;
    for (const Run& run : report.runs)
        if (run.arithmetic == Arithmetic::exact) canonical = &*run.tessellation;
    if (canonical == nullptr)
        canonical = &apart.emplace(builder.build(Arithmetic::exact, false, show));
    for (Run& run : report.runs)
        if (run.tessellation) run.edges = compare_edges(*run.tessellation, *canonical);
    report.margins = study::margins_of(*canonical);
    finished();
    measure(report, builder, call.seconds);
    return report;
}

// ---- words -------------------------------------------------------------------------------------

/// Whether these sites need exactness, in one sentence.
std::string answer(const Report& report) {
    const Run& run = report.judged();
    const std::string_view name = name_of(run.arithmetic);
    const auto& margins = report.margins;
    std::string near = margins.least ? fmt::format(
                                           "; the nearest that sites come to a tie "
                                           "without being one is {:.1e} of its terms",
                                           *margins.least)
                                     : "";
    if (margins.ties > 0)
        near += fmt::format("{} {} of {} edges are ties", margins.least ? ", and" : ";",
                            margins.ties, margins.edges);
    return run.tessellation ? answer_by(run.counts(), name, "edge", near)
                            : answer_of_broken(name, near);
}

}  // namespace

std::string answer_by(const Counts& counts, std::string_view arithmetic, std::string_view kind,
                      std::string_view near) {
    if (counts.wrong > 0)
        return fmt::format(
            "These sites need exactness: {} arithmetic got {} of {} {}s wrong ({:.2g} %){}.",
            arithmetic, counts.wrong, counts.all, kind, counts.percent(counts.wrong), near);
    if (counts.different > 0)
        return fmt::format(
            "These sites need exactness only for a result that does not depend on their order: {} "
            "arithmetic got no {} wrong, and {} of {} otherwise than the tie rule{}.",
            arithmetic, kind, counts.different, counts.all, near);
    return fmt::format("These sites do not need exactness: {} arithmetic got no {} of {} wrong{}.",
                       arithmetic, kind, counts.all, near);
}

std::string answer_of_broken(std::string_view arithmetic, std::string_view near) {
    return fmt::format("These sites need exactness: in {} arithmetic the structure broke{}.",
                       arithmetic, near);
}

namespace {

void put_edge_table(TextWriter& text, const Report& report) {
    const auto compared = [](const Run& run) -> ComparedRun {
        if (!run.tessellation) return {name_of(run.arithmetic), true, run.broken, {}, {}, {}};
        return {name_of(run.arithmetic),       false, "", run.seconds, run.counts(),
                run.tessellation->statistics()};
    };
    put_table(text, "edge", {compared(report.runs[0]), compared(report.runs[1])}, true,
              report.ratio, answer(report));
}

// ---- JSON --------------------------------------------------------------------------------------

std::string edge_counts(const Run& run) {
    if (!run.tessellation) return "\"edges\": null, \"wrong\": null, \"different\": null";
    return fmt::format("\"edges\": {}, \"wrong\": {}, \"different\": {}", run.edges.edges,
                       run.edges.wrong.size(), run.edges.different.size());
}

void put_run(TextWriter& text, const Run& run) {
    text.put(FMT_COMPILE(",\n\"{}\": {{{}, \"broken\": {}"), name_of(run.arithmetic),
             edge_counts(run), quoted_or_null(run.broken));
    if (run.tessellation) {
        const Statistics& s = run.tessellation->statistics();
        text.put(FMT_COMPILE(", \"seconds\": {}, \"seconds_low\": {}, \"seconds_high\": {}, "
                             "\"rounds\": {}"),
                 number_or_null(run.seconds.median), number_or_null(run.seconds.low),
                 number_or_null(run.seconds.high), run.seconds.runs);
        for (const Counter& counter : counters)
            text.put(FMT_COMPILE(", \"{}\": {}"), counter.name, s.*counter.count);
    }
    text.put("}");
}

void put_json(TextWriter& text, const Report& report) {
    const Run& run = report.judged();
    text.put(FMT_COMPILE("{{{}, \"broken\": {}, \"ratio\": {}"), edge_counts(run),
             quoted_or_null(run.broken),
             report.ratio ? number_or_null(report.ratio->median) : "null");
    text.put(FMT_COMPILE(",\n\"margins\": {{\"edges\": {}, \"ties\": {}, \"least\": {}}}"),
             report.margins.edges, report.margins.ties,
             report.margins.least ? number_or_null(*report.margins.least) : "null");
    text.put(FMT_COMPILE(",\n\"answer\": {}"), quoted_or_null(answer(report)));
    for (const Run& each : report.runs) put_run(text, each);
    text.put("}\n");
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
    if (call.json) {
        put_json(text, report);
    } else {
        put_edge_table(text, report);
    }
    text.flush();
    out.flush();
    if (targets.empty()) return;
    const Run& judged = report.judged();
    if (!judged.tessellation)
        throw CheckFailure(
            fmt::format("{} arithmetic broke the structure, so that there is "
                        "nothing to draw; nothing is written",
                        call.arithmetic));
    outputs.write({{"svg", [&](std::ostream& picture) {
                        write_svg(
                            picture, *judged.tessellation,
                            {.wrong = judged.edges.wrong, .different = judged.edges.different});
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
