#include "compare_space.hpp"

#include <array>
#include <chrono>
#include <optional>
#include <stdexcept>
#include <vector>

#include "../../triangulation/space/compare.hpp"
#include "../io/output_file.hpp"
#include "../io/text_writer.hpp"
#include "../study/timing.hpp"

#include "commands.hpp"
#include "compare_table.hpp"
#include "progress.hpp"
#include "space_sites.hpp"

namespace signum::cli {
namespace {

/// What became of the sites in one arithmetic.
struct SpaceRun {
    Arithmetic arithmetic;
    std::optional<SpaceTessellation> tessellation;  ///< nothing where the structure broke
    std::string broken;                             ///< ... and this is where
    Counts cells = {};
    study::Interval seconds = {};  ///< without runs where the structure broke
};

struct SpaceReport {
    std::array<SpaceRun, 2> runs;          ///< the one judged, and the one against it
    std::optional<study::Interval> ratio;  ///< of times, the second to the first
    FacetTies facets;

    [[nodiscard]] const SpaceRun& judged() const { return runs[0]; }
};

template <class S>
class Comparison {
 public:
    Comparison(const CompareCall& call, std::span<const S> sites) : call_(call), sites_(sites) {}

    [[nodiscard]] SpaceReport report() {
        if (!call_.quiet) bar_.emplace();
        SpaceReport report = {{SpaceRun{arithmetic_of(call_.arithmetic), {}, ""},
                               SpaceRun{arithmetic_of(call_.against), {}, ""}},
                              {},
                              {}};
        for (SpaceRun& run : report.runs) {
            try {
                run.tessellation = build(run.arithmetic, true);
            } catch (const BrokenStructure& error) {
                run.broken = error.what();
            }
            ++done_;
        }
        // Of two arithmetics of space one is the exact one.
        const std::size_t exact = report.runs[0].arithmetic == Arithmetic::exact ? 0 : 1;
        judge(report, *report.runs[exact].tessellation);
        measure(report);
        return report;
    }

 private:
    /// Throws BrokenStructure.
    [[nodiscard]] SpaceTessellation build(Arithmetic arithmetic, bool shows) {
        Options options;
        options.arithmetic = arithmetic;
        options.seed = call_.seed;
        if (shows && bar_) {
            options.progress = [this](double share) { bar_->show((done_ + share) / 3.0); };
        }
        try {
            return triangulate(sites_, Power{}, options);
        } catch (const std::invalid_argument& error) {
            throw CallError(error.what());
        }
    }

    void judge(SpaceReport& report, const SpaceTessellation& canonical) const {
        for (SpaceRun& run : report.runs) {
            if (!run.tessellation) continue;
            const CellComparison cells = compare_cells(*run.tessellation, canonical, sites_);
            run.cells = {cells.cells, cells.wrong.size(), cells.different.size()};
        }
        report.facets = ties_of(canonical, sites_);
    }

    /// Times of the runs that did not break, in turns.
    void measure(SpaceReport& report) {
        std::vector<study::Contestant> contestants;
        std::vector<SpaceRun*> contesting;
        for (SpaceRun& run : report.runs) {
            if (!run.tessellation) continue;
            contesting.push_back(&run);
            contestants.push_back([this, arithmetic = run.arithmetic] {
                using Clock = std::chrono::steady_clock;
                const Clock::time_point start = Clock::now();
                const SpaceTessellation built = build(arithmetic, false);
                return std::chrono::duration<double>(Clock::now() - start).count();
            });
        }
        study::Budget budget;
        budget.seconds = call_.seconds;
        const study::Race race = study::race(contestants, budget);
        for (std::size_t i = 0; i < contesting.size(); ++i)
            contesting[i]->seconds = race.seconds[i];
        if (contesting.size() == 2) report.ratio = race.ratios[1];
    }

    const CompareCall& call_;
    std::span<const S> sites_;
    std::optional<Progress> bar_;
    double done_ = 0.0;
};

std::string answer_by_cells(const SpaceReport& report) {
    const SpaceRun& run = report.judged();
    const std::string near =
        report.facets.ties > 0
            ? fmt::format("; {} of {} facets are ties", report.facets.ties, report.facets.facets)
            : "";
    return run.tessellation ? answer_by(run.cells, name_of(run.arithmetic), "cell", near)
                            : answer_of_broken(name_of(run.arithmetic), near);
}

void put_cell_table(TextWriter& text, const SpaceReport& report) {
    const auto compared = [](const SpaceRun& run) -> ComparedRun {
        return {name_of(run.arithmetic), !run.tessellation, run.broken, run.seconds, run.cells, {}};
    };
    put_table(text, "cell", {compared(report.runs[0]), compared(report.runs[1])}, false,
              report.ratio, answer_by_cells(report));
}

std::string cell_counts(const SpaceRun& run) {
    if (!run.tessellation) return "\"cells\": null, \"wrong\": null, \"different\": null";
    return fmt::format("\"cells\": {}, \"wrong\": {}, \"different\": {}", run.cells.all,
                       run.cells.wrong, run.cells.different);
}

void put_cell_json(TextWriter& text, const SpaceReport& report) {
    const SpaceRun& judged = report.judged();
    text.put(FMT_COMPILE("{{{}, \"broken\": {}, \"ratio\": {}"), cell_counts(judged),
             quoted_or_null(judged.broken),
             report.ratio ? number_or_null(report.ratio->median) : "null");
    text.put(FMT_COMPILE(",\n\"margins\": {{\"facets\": {}, \"ties\": {}}}"), report.facets.facets,
             report.facets.ties);
    text.put(FMT_COMPILE(",\n\"answer\": {}"), quoted_or_null(answer_by_cells(report)));
    for (const SpaceRun& run : report.runs) {
        text.put(FMT_COMPILE(",\n\"{}\": {{{}, \"broken\": {}"), name_of(run.arithmetic),
                 cell_counts(run), quoted_or_null(run.broken));
        if (run.tessellation) {
            text.put(FMT_COMPILE(", \"seconds\": {}, \"seconds_low\": {}, \"seconds_high\": "
                                 "{}, \"rounds\": {}"),
                     number_or_null(run.seconds.median), number_or_null(run.seconds.low),
                     number_or_null(run.seconds.high), run.seconds.runs);
        }
        text.put("}");
    }
    text.put("}\n");
}

}  // namespace

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
    const SpaceReport report = with_sites_in_space(sites, [&]<class S>(std::span<const S> those) {
        return Comparison<S>(call, those).report();
    });
    DescriptorStream out(1, "standard output");
    TextWriter text(out);
    if (call.json) {
        put_cell_json(text, report);
    } else {
        put_cell_table(text, report);
    }
    text.flush();
    out.flush();
}

}  // namespace signum::cli
