#include "compare_table.hpp"

#include <cstddef>
#include <cstdint>

#include <fmt/format.h>

namespace signum::cli {

void put_table(TextWriter& text, std::string_view kind, const std::array<ComparedRun, 2>& runs,
               bool counts_calls, const std::optional<study::Interval>& ratio,
               std::string_view answer) {
    const auto row = [&](std::string_view title, auto cell) {
        text.put(FMT_COMPILE("{:<24}{:>24}{:>24}\n"), title, cell(runs[0]), cell(runs[1]));
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
                               run.counts.percent(run.counts.*count));
        });
    };
    row("", [](const ComparedRun& run) { return run.arithmetic; });
    row("seconds, median", [](const ComparedRun& run) {
        return run.is_broken ? "broken" : fmt::format("{:.3g}", run.seconds.median);
    });
    row_of_built("  95 % interval", [](const ComparedRun& run) {
        return fmt::format("{:.3g} to {:.3g}", run.seconds.low, run.seconds.high);
    });
    if (counts_calls) {
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
    row_of_built(fmt::format("{}s", kind),
                 [](const ComparedRun& run) { return fmt::format("{}", run.counts.all); });
    judged("wrong", &Counts::wrong);
    judged("different", &Counts::different);
    text.put("\n");
    for (const ComparedRun& run : runs)
        if (run.is_broken) text.put(FMT_COMPILE("{} broke: {}\n"), run.arithmetic, run.broken);
    if (ratio)
        text.put(FMT_COMPILE("{} / {} time: {:.3g} ({:.3g} to {:.3g}, {} rounds)\n"),
                 runs[1].arithmetic, runs[0].arithmetic, ratio->median, ratio->low, ratio->high,
                 ratio->runs);
    text.put(FMT_COMPILE("{}\n"), answer);
}

}  // namespace signum::cli
