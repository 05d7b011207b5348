/// signum compare: what another arithmetic makes of the same sites, edge by edge, in space cell by
/// cell, and what it costs.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "../../triangulation/space/compare.hpp"
#include "../../triangulation/space/validate.hpp"
#include "../../triangulation/triangulate.hpp"
#include "../../triangulation/validate.hpp"
#include "../../voronoi/compare.hpp"
#include "../draw/svg.hpp"
#include "../io/output_file.hpp"
#include "../io/text_writer.hpp"
#include "../study/margin.hpp"
#include "../study/timing.hpp"

#include "commands.hpp"
#include "outputs.hpp"
#include "progress.hpp"
#include "sites_call.hpp"

namespace signum::cli {
namespace {

/// As it was typed. SitesCall::arithmetic is the one that is judged.
struct CompareCall : SitesCall, OutputsCall {
    std::string against = "exact";
    double seconds = 1.0;
    bool json = false;
};

// ---- what is answered, of the plane and of space -----------------------------------------------

/// How many edges (in space cells) of a tessellation there are, and how they were judged.
struct Counts {
    std::int64_t all = 0;
    std::size_t wrong = 0;
    std::size_t different = 0;
};

/// What one arithmetic made of the sites.
struct ComparedRun {
    Arithmetic arithmetic;
    bool is_broken = false;   ///< and then there is neither a time nor a count
    std::string broken = {};  ///< where the structure broke
    /// What validate() says of a result no edge of which is wrong: others may be missing.
    std::string invalid = {};
    study::Interval seconds = {};
    Counts counts = {};
    std::optional<Statistics> statistics = {};  ///< nothing where calls are not counted
};

struct ComparedReport {
    std::string_view kind;                      ///< what is judged: edge or cell
    std::array<ComparedRun, 2> runs;            ///< the one judged, and the one against it
    bool counts_calls = false;                  ///< runs that did not break have statistics
    std::optional<study::Interval> ratio = {};  ///< of times, the second to the first
    std::string margins = {};                   ///< JSON
    /// How near the sites are to ties, with its comma or semicolon.
    std::string near = {};
};

double percent(std::size_t part, const Counts& counts) {
    return counts.all == 0 ? 0.0
                           : 100.0 * static_cast<double>(part) / static_cast<double>(counts.all);
}

/// Whether these sites need exactness, in one sentence.
std::string answer(const ComparedReport& report) {
    // Exact arithmetic errs nowhere: the other one tells.
    const ComparedRun& run = report.runs[is_exact(report.runs[0].arithmetic) ? 1 : 0];
    if (is_exact(run.arithmetic))
        return "Both arithmetics are exact: whether these sites need exactness naive or single "
               "arithmetic tells.";
    const auto& [all, wrong, different] = run.counts;
    const std::string_view arithmetic = name_of(run.arithmetic);
    if (run.is_broken)
        return fmt::format("These sites need exactness: in {} arithmetic the structure broke{}.",
                           arithmetic, report.near);
    if (wrong > 0) {
        const double share_of_all = percent(wrong, run.counts);
        const std::string share = share_of_all < 99.5 ? fmt::format("{:.2g}", share_of_all)
                                                      : fmt::format("{:.0f}", share_of_all);
        return fmt::format(
            "These sites need exactness: {} arithmetic got {} of {} {}s wrong ({} %){}.",
            arithmetic, wrong, all, report.kind, share, report.near);
    }
    if (!run.invalid.empty())
        return fmt::format(
            "These sites need exactness: {} arithmetic got no {} of {} wrong, but others are "
            "missing, or sites ({}){}.",
            arithmetic, report.kind, all, run.invalid, report.near);
    if (different > 0)
        return fmt::format(
            "These sites need exactness only for a result that does not depend on their order: {} "
            "arithmetic got no {} wrong, and {} of {} otherwise than the tie rule{}.",
            arithmetic, report.kind, different, all, report.near);
    return fmt::format("These sites do not need exactness: {} arithmetic got no {} of {} wrong{}.",
                       arithmetic, report.kind, all, report.near);
}

void put_table(TextWriter& text, const ComparedReport& report) {
    const auto row = [&](std::string_view title, auto cell) {
        text.put(FMT_COMPILE("{:<24}{:>24}{:>24}\n"), title, cell(report.runs[0]),
                 cell(report.runs[1]));
    };
    // Empty where the structure broke.
    const auto row_of_built = [&](std::string_view title, auto cell) {
        row(title, [&](const ComparedRun& run) { return run.is_broken ? "" : cell(run); });
    };
    const auto calls = [&](std::string_view title, std::uint64_t Statistics::*count) {
        row_of_built(title, [&](const ComparedRun& run) {
            return run.statistics ? fmt::format("{}", (*run.statistics).*count) : "";
        });
    };
    const auto judged = [&](std::string_view title, std::size_t Counts::*count) {
        row_of_built(title, [&](const ComparedRun& run) {
            return fmt::format("{} ({:.3g} %)", run.counts.*count,
                               percent(run.counts.*count, run.counts));
        });
    };
    row("", [](const ComparedRun& run) { return name_of(run.arithmetic); });
    row("seconds, median", [](const ComparedRun& run) {
        return run.is_broken ? "broken" : fmt::format("{:.3g}", run.seconds.median);
    });
    row_of_built("  95 % interval", [](const ComparedRun& run) {
        return fmt::format("{:.3g} to {:.3g}", run.seconds.low, run.seconds.high);
    });
    if (report.counts_calls) {
        calls("ccw", &Statistics::ccw);
        calls("in_circle", &Statistics::in_circle);
        calls("nearer", &Statistics::nearer);
        calls("others", &Statistics::others);
        calls("by the filter", &Statistics::filtered);
        calls("refined", &Statistics::refined);
        calls("exactly", &Statistics::exact);
        calls("by ESSA", &Statistics::essa);
        calls("in multiprecision", &Statistics::multiprecision);
        calls("ties", &Statistics::ties);
    }
    row_of_built(fmt::format("{}s", report.kind),
                 [](const ComparedRun& run) { return fmt::format("{}", run.counts.all); });
    judged("wrong", &Counts::wrong);
    judged("different", &Counts::different);
    text.put("\n");
    for (const ComparedRun& run : report.runs)
        if (run.is_broken)
            text.put(FMT_COMPILE("{} broke: {}\n"), name_of(run.arithmetic), run.broken);
    if (report.ratio)
        text.put(FMT_COMPILE("{} / {} time: {:.3g} ({:.3g} to {:.3g}, {} rounds)\n"),
                 name_of(report.runs[1].arithmetic), name_of(report.runs[0].arithmetic),
                 report.ratio->median, report.ratio->low, report.ratio->high, report.ratio->runs);
    text.put(FMT_COMPILE("{}\n"), answer(report));
}

/// Words without quotation marks of their own.
std::string quoted_or_null(const std::string& words) {
    return words.empty() ? "null" : fmt::format("\"{}\"", words);
}

std::string counts_of(const ComparedRun& run, std::string_view kind) {
    if (run.is_broken)
        return fmt::format("\"{}s\": null, \"wrong\": null, \"different\": null", kind);
    return fmt::format("\"{}s\": {}, \"wrong\": {}, \"different\": {}", kind, run.counts.all,
                       run.counts.wrong, run.counts.different);
}

void put_json(TextWriter& text, const ComparedReport& report) {
    const ComparedRun& judged = report.runs[0];
    text.put(FMT_COMPILE("{{{}, \"broken\": {}, \"ratio\": {}"), counts_of(judged, report.kind),
             quoted_or_null(judged.broken),
             report.ratio ? number_or_null(report.ratio->median) : "null");
    text.put(FMT_COMPILE(",\n\"margins\": {},\n\"answer\": {}"), report.margins,
             quoted_or_null(answer(report)));
    for (const ComparedRun& run : report.runs) {
        text.put(FMT_COMPILE(",\n\"{}\": {{{}, \"broken\": {}"), name_of(run.arithmetic),
                 counts_of(run, report.kind), quoted_or_null(run.broken));
        if (!run.is_broken)
            text.put(FMT_COMPILE(", \"seconds\": {}, \"seconds_low\": {}, \"seconds_high\": "
                                 "{}, \"rounds\": {}"),
                     number_or_null(run.seconds.median), number_or_null(run.seconds.low),
                     number_or_null(run.seconds.high), run.seconds.runs);
        if (run.statistics)
            for (const Counter& counter : counters)
                text.put(FMT_COMPILE(", \"{}\": {}"), counter.name,
                         (*run.statistics).*counter.count);
        text.put("}");
    }
    text.put("}\n");
}

/// Times of the runs that did not break, in turns; `build` builds with an arithmetic, and says how
/// many seconds it took.
void time_runs(ComparedReport& report, double seconds,
               const std::function<double(Arithmetic)>& build) {
    std::vector<study::Contestant> contestants;
    std::vector<ComparedRun*> contesting;
    for (ComparedRun& run : report.runs) {
        if (run.is_broken) continue;
        contesting.push_back(&run);
        contestants.push_back([&build, arithmetic = run.arithmetic] { return build(arithmetic); });
    }
    study::Budget budget;
    budget.seconds = seconds;
    const study::Race race = study::race(contestants, budget);
    for (std::size_t i = 0; i < contesting.size(); ++i) contesting[i]->seconds = race.seconds[i];
    if (contesting.size() == 2) report.ratio = race.ratios[1];
}

/// The table, whose last line says whether these sites need exactness, or JSON; to standard output,
/// or to standard error.
void put_report(const ComparedReport& report, bool as_json, bool to_errors = false) {
    DescriptorStream out(to_errors ? 2 : 1, to_errors ? "standard error" : "standard output");
    TextWriter text(out);
    if (as_json)
        put_json(text, report);
    else
        put_table(text, report);
    text.flush();
    out.flush();
}

// ---- what is compared --------------------------------------------------------------------------

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

/// What is built of sites in the plane, and judged edge by edge.
struct Edges {
    using Result = Tessellation;
    using Comparison = EdgeComparison;
    static constexpr std::string_view kind = "edge";
    static constexpr auto all = &EdgeComparison::edges;
    static constexpr bool counts_calls = true;

    StridedSites sites;
    Metric metric;

    [[nodiscard]] Tessellation build(const Options& options) const {
        return triangulate(sites, metric, options);
    }
    [[nodiscard]] double seconds(const Options& options) const {
        return build(options).statistics().seconds;
    }
    [[nodiscard]] EdgeComparison compare(const Tessellation& tessellation,
                                         const Tessellation& canonical, int threads) const {
        return compare_edges(tessellation, canonical, threads);
    }
    [[nodiscard]] Validation validate(const Tessellation& tessellation, int threads) const {
        return signum::validate(tessellation.arrays(), sites, {.threads = threads});
    }
    void tell_margins(ComparedReport& report, const Tessellation& canonical, int threads) const {
        const study::Margins margins = study::margins_of(canonical, threads);
        report.near = nearness(margins);
        report.margins =
            fmt::format("{{\"edges\": {}, \"ties\": {}, \"least\": {}}}", margins.edges,
                        margins.ties, margins.least ? number_or_null(*margins.least) : "null");
    }
};

/// The same of sites in space, cell by cell.
template <class S>
struct Cells {
    using Result = SpaceTessellation;
    using Comparison = CellComparison;
    static constexpr std::string_view kind = "cell";
    static constexpr auto all = &CellComparison::cells;
    static constexpr bool counts_calls = false;

    std::span<const S> sites;

    [[nodiscard]] SpaceTessellation build(const Options& options) const {
        return triangulate(sites, Power{}, options);
    }
    [[nodiscard]] double seconds(const Options& options) const {
        return study::seconds_of([&] { static_cast<void>(build(options)); });
    }
    [[nodiscard]] CellComparison compare(const SpaceTessellation& tessellation,
                                         const SpaceTessellation& canonical, int threads) const {
        return compare_cells(tessellation, canonical, sites, threads);
    }
    [[nodiscard]] Validation validate(const SpaceTessellation& tessellation, int threads) const {
        return signum::validate(tessellation, sites, {.threads = threads});
    }
    void tell_margins(ComparedReport& report, const SpaceTessellation& canonical,
                      int threads) const {
        const auto& [facets, ties] = ties_of(canonical, sites, threads);
        report.margins = fmt::format("{{\"facets\": {}, \"ties\": {}}}", facets, ties);
        if (ties > 0) report.near = fmt::format("; {} of {} facets are ties", ties, facets);
    }
};

/// The answer, and what the picture is drawn of: nothing where the structure broke.
template <class Parts>
struct Report : ComparedReport {
    std::array<std::optional<typename Parts::Result>, 2> built = {};
    std::array<typename Parts::Comparison, 2> comparisons = {};
};

template <class Parts>
Report<Parts> compare(const CompareCall& call, const Parts& parts) {
    Progress bar(call.quiet);
    double done = 0.0;
    const auto show = [&](double share) { bar.show((done + share) / 4.0); };
    const auto finished = [&] {
        done += 1.0;
        show(0.0);
    };
    const auto options_of = [&](Arithmetic arithmetic) {
        Options options;
        options.arithmetic = arithmetic;
        options.seed = call.seed;
        options.threads = call.threads;
        return options;
    };
    const auto build = [&](Arithmetic arithmetic, bool count) {
        Options options = options_of(arithmetic);
        options.count = count;
        options.progress = show;
        try {
            return parts.build(options);
        } catch (const std::invalid_argument& error) {
            throw CallError(error.what());
        }
    };

    Report<Parts> report = {{Parts::kind,
                             {{{arithmetic_of(call.arithmetic)}, {arithmetic_of(call.against)}}},
                             Parts::counts_calls}};
    for (std::size_t i = 0; i < 2; ++i) {
        ComparedRun& run = report.runs[i];
        try {
            report.built[i] = build(run.arithmetic, Parts::counts_calls);
            if constexpr (Parts::counts_calls) run.statistics = report.built[i]->statistics();
        } catch (const BrokenStructure& error) {
            run.is_broken = true;
            run.broken = error.what();
        }
        finished();
    }
    std::optional<typename Parts::Result> apart;
    const typename Parts::Result* canonical = nullptr;
    for (std::size_t i = 0; i < 2; ++i)
        if (report.runs[i].arithmetic == Arithmetic::exact) canonical = &*report.built[i];
    if (canonical == nullptr) canonical = &apart.emplace(build(Arithmetic::exact, false));

    for (std::size_t i = 0; i < 2; ++i) {
        if (!report.built[i]) continue;
        const auto& found = report.comparisons[i] =
            parts.compare(*report.built[i], *canonical, call.threads);
        report.runs[i].counts = {found.*Parts::all, found.wrong.size(), found.different.size()};
        if (!is_exact(report.runs[i].arithmetic) && found.wrong.empty())
            if (const Validation said = parts.validate(*report.built[i], call.threads); !said.valid)
                report.runs[i].invalid = said.message;
    }
    parts.tell_margins(report, *canonical, call.threads);
    finished();
    time_runs(report, call.seconds, [&](Arithmetic arithmetic) {
        Options options = options_of(arithmetic);
        options.threads = 1;  // what rounds has no more
        return parts.seconds(options);
    });
    return report;
}

/// Throws CallError where the call asks for what there is in the plane alone.
void compare_in_space(const CompareCall& call, const InputSites& sites) {
    if (!call.outputs.empty() || !call.format.empty()) {
        throw CallError(
            fmt::format("{}: pictures are of sites in the plane, and those of {} lie in space; "
                        "leave {} out",
                        call.outputs.empty() ? "--format" : "-o", call.input,
                        call.outputs.empty() ? "--format" : "-o"));
    }
    check_arithmetic_in_space(call, "--arithmetic", call.arithmetic);
    check_arithmetic_in_space(call, "--against", call.against);
    with_sites_in_space(sites, [&]<class S>(std::span<const S> those) {
        put_report(compare(call, Cells<S>{those}), call.json);
    });
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
    const auto report =
        compare(call, Edges{strided_view(sites.file.sites, sites.third), metric_of(call.metric)});
    put_report(report, call.json, is_drawn_there);

    if (targets.empty()) return;
    const auto& [judged, other] = report.built;
    if (!judged)
        throw CheckFailure(
            fmt::format("{} arithmetic broke the structure, so that there is "
                        "nothing to draw; nothing is written",
                        call.arithmetic));
    outputs.write({{"svg", [&, &judged = judged](std::ostream& picture) {
                        write_svg(picture, *judged,
                                  {.wrong = report.comparisons[0].wrong,
                                   .different = report.comparisons[0].different,
                                   .threads = call.threads});
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
    add_checked(*command, "--arithmetic", call->arithmetic, "NAME", name_of_arithmetic(),
                "The one that is judged, a name that triangulate\n--arithmetic knows")
        ->capture_default_str();
    add_checked(*command, "--against", call->against, "NAME", name_of_arithmetic(),
                "The one whose time it is compared with")
        ->capture_default_str();
    add_checked(*command, "--seconds", call->seconds, "T", number_from(0.0, 86400.0),
                "For the timing, three rounds at least")
        ->capture_default_str();
    command->add_flag("--json", call->json, "The same as JSON");
    add_outputs(*command, *call, compare_formats,
                "the table goes to standard error then. Without it\nnothing is drawn");
    command->footer(
        "An edge is wrong when no tessellation of the sites, however ties are decided,\n"
        "has it, and different when it is not the canonical choice; a run that lost its\n"
        "structure is broken. In space cells are judged, in naive and exact arithmetic\n"
        "alone, and nothing is drawn. Times are those of one thread.\n\n"
        "Examples:\n"
        "  signum compare sites.txt --metric power -o wrong.svg\n"
        "  signum compare sites.txt --arithmetic naive --against multiprecision --json\n"
        "  signum compare atoms.pdb --metric power");
    command->callback([call] { run(*call); });
}

}  // namespace signum::cli
