#include "compare_report.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

#include <fmt/format.h>

#include "../io/output_file.hpp"
#include "../io/text_writer.hpp"

namespace signum::cli {
namespace {

double percent(std::size_t part, const Counts& counts) {
    return counts.all == 0 ? 0.0
                           : 100.0 * static_cast<double>(part) / static_cast<double>(counts.all);
}

/// Whether these sites need exactness, in one sentence.
std::string answer(const ComparedReport& report) {
    const ComparedRun& run = report.runs[0];
    const auto& [all, wrong, different] = run.counts;
    const std::string_view arithmetic = name_of(run.arithmetic);
    if (run.is_broken)
        return fmt::format("These sites need exactness: in {} arithmetic the structure broke{}.",
                           arithmetic, report.near);
    if (wrong > 0)
        return fmt::format(
            "These sites need exactness: {} arithmetic got {} of {} {}s wrong ({:.2g} %){}.",
            arithmetic, wrong, all, report.kind, percent(wrong, run.counts), report.near);
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

}  // namespace

void time_runs(ComparedReport& report, double seconds, const TimedBuild& build) {
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

void put_report(const ComparedReport& report, bool as_json, bool to_errors) {
    DescriptorStream out(to_errors ? 2 : 1, to_errors ? "standard error" : "standard output");
    TextWriter text(out);
    if (as_json)
        put_json(text, report);
    else
        put_table(text, report);
    text.flush();
    out.flush();
}

}  // namespace signum::cli
