#include "compare_report.hpp"

#include <array>
#include <chrono>
#include <optional>
#include <stdexcept>

#include "../../triangulation/space/compare.hpp"
#include "../io/output_file.hpp"
#include "../io/text_writer.hpp"

#include "commands.hpp"
#include "progress.hpp"
#include "sites_call.hpp"

namespace signum::cli {
namespace {

template <class S>
ComparedReport compare_sites(const CompareCall& call, std::span<const S> sites) {
    std::optional<Progress> bar;
    if (!call.quiet) bar.emplace();
    double done = 0.0;
    const auto build = [&](Arithmetic arithmetic, bool shows) {
        Options options;
        options.arithmetic = arithmetic;
        options.seed = call.seed;
        if (shows && bar) options.progress = [&](double share) { bar->show((done + share) / 3.0); };
        try {
            return triangulate(sites, Power{}, options);
        } catch (const std::invalid_argument& error) {
            throw CallError(error.what());
        }
    };

    ComparedReport report = {"cell",
                             {{{arithmetic_of(call.arithmetic)}, {arithmetic_of(call.against)}}}};
    std::array<std::optional<SpaceTessellation>, 2> built;
    for (std::size_t i = 0; i < 2; ++i) {
        try {
            built[i] = build(report.runs[i].arithmetic, true);
        } catch (const BrokenStructure& error) {
            report.runs[i].is_broken = true;
            report.runs[i].broken = error.what();
        }
        done += 1.0;
    }
    // Of two arithmetics of space one is the exact one.
    const SpaceTessellation& canonical =
        *built[report.runs[0].arithmetic == Arithmetic::exact ? 0 : 1];
    for (std::size_t i = 0; i < 2; ++i) {
        if (!built[i]) continue;
        const CellComparison cells = compare_cells(*built[i], canonical, sites);
        report.runs[i].counts = {cells.cells, cells.wrong.size(), cells.different.size()};
    }
    const auto& [facets, ties] = ties_of(canonical, sites);
    report.margins = fmt::format("{{\"facets\": {}, \"ties\": {}}}", facets, ties);
    if (ties > 0) report.near = fmt::format("; {} of {} facets are ties", ties, facets);
    time_runs(report, call.seconds, [&](Arithmetic arithmetic) {
        using Clock = std::chrono::steady_clock;
        const Clock::time_point start = Clock::now();
        const SpaceTessellation timed = build(arithmetic, false);
        return std::chrono::duration<double>(Clock::now() - start).count();
    });
    return report;
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
    const ComparedReport report = with_sites_in_space(
        sites, [&]<class S>(std::span<const S> those) { return compare_sites<S>(call, those); });
    DescriptorStream out(1, "standard output");
    TextWriter text(out);
    put_report(text, report, call.json);
    text.flush();
    out.flush();
}

}  // namespace signum::cli
