/// Contestants build the tessellations of the same sites. In the first pass each builds every set
/// once, and edges and calls are counted; in all they race.

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "../voronoi/compare.hpp"

#include "contestants.hpp"
#include "work.hpp"

namespace signum::study {
namespace {

/// Sums over the sets.
struct Counts {
    std::size_t sets = 0;
    std::size_t broken = 0;
    double edges = 0.0;
    double wrong = 0.0;
    double different = 0.0;
    Interval wrong_percent;
    Interval different_percent;
    Interval either_percent;
    double hidden = 0.0;
    Statistics calls;
};

/// The share of all sets together, and the least and greatest of a set.
void add_share(Interval& interval, double part, double all) {
    const double percent = all > 0.0 ? 100.0 * part / all : 0.0;
    interval.low = interval.runs == 0 ? percent : std::min(interval.low, percent);
    interval.high = std::max(interval.high, percent);
    ++interval.runs;
}

void add(Counts& counts, const Tessellation& tessellation, const EdgeComparison& comparison) {
    const auto wrong = static_cast<double>(comparison.wrong.size());
    const auto different = static_cast<double>(comparison.different.size());
    const auto edges = static_cast<double>(comparison.edges);
    counts.edges += edges;
    counts.wrong += wrong;
    counts.different += different;
    add_share(counts.wrong_percent, wrong, edges);
    add_share(counts.different_percent, different, edges);
    add_share(counts.either_percent, wrong + different, edges);
    counts.hidden += static_cast<double>(tessellation.hidden().size());
    const Statistics& calls = tessellation.statistics();
    for (const Counter& counter : counters) counts.calls.*counter.count += calls.*counter.count;
}

/// Of one contestant, without the times.
std::vector<Row> rows_of(const Cell& cell, const std::string& name, Counts counts) {
    std::vector<Row> rows;
    const auto put = [&](const std::string& quantity, const Interval& value) {
        rows.push_back({cell.setting, name, quantity, value});
    };
    put(std::string(broken_percent),
        exactly(100.0 * static_cast<double>(counts.broken) / static_cast<double>(cell.sets)));
    const auto whole = static_cast<double>(counts.sets);
    if (whole == 0.0) return rows;
    put("edges", exactly(counts.edges / whole));
    const double percent = counts.edges > 0.0 ? 100.0 / counts.edges : 0.0;
    counts.wrong_percent.median = percent * counts.wrong;
    counts.different_percent.median = percent * counts.different;
    counts.either_percent.median = percent * (counts.wrong + counts.different);
    put("wrong_percent", counts.wrong_percent);
    put("different_percent", counts.different_percent);
    put("wrong_or_different_percent", counts.either_percent);
    const auto put_mean = [&](const char* quantity, auto sum) {
        put(quantity, exactly(static_cast<double>(sum) / whole));
    };
    put_mean("hidden", counts.hidden);
    put_mean("ccw", counts.calls.ccw);
    put_mean("in_circle", counts.calls.in_circle);
    put_mean("calls_filter", counts.calls.filtered);
    put_mean("calls_refine", counts.calls.refined);
    put_mean("calls_exact", counts.calls.exact);
    put_mean("calls_essa", counts.calls.essa);
    put_mean("calls_multiprecision", counts.calls.multiprecision);
    put_mean("ties", counts.calls.ties);
    put_mean("swaps", counts.calls.flips);
    put_mean("events", counts.calls.events);
    return rows;
}

}  // namespace

std::vector<Row> measure_construction(const Cell& cell, const Pass& pass) {
    const Metric metric = metric_named(cell.setting.metric).value();
    std::vector<std::pair<std::string, Options>> builders;
    for (const std::string& name : cell.contestants)
        if (const auto options = options_named(name)) builders.emplace_back(name, *options);

    const bool counts_too = pass.number == 1;
    std::vector<Counts> counts(builders.size());
    std::vector<std::vector<Site>> sets;  // those that the first contestant builds
    std::vector<std::size_t> broken_of_these(builders.size(), 0);
    for (std::size_t seed = 1; seed <= cell.sets; ++seed) {
        std::vector<Site> sites = sites_of(cell.setting, seed);
        std::optional<Tessellation> canonical;
        if (counts_too) canonical = triangulate(sites, metric);
        bool first_breaks = false;
        for (std::size_t i = 0; i < builders.size() && pass.breaks; ++i) {
            Options options = builders[i].second;
            options.count = true;
            try {
                const Tessellation tessellation = triangulate(sites, metric, options);
                if (!counts_too) continue;
                add(counts[i], tessellation, compare_edges(tessellation, *canonical));
                ++counts[i].sets;
            } catch (const BrokenStructure&) {
                ++counts[i].broken;
                if (i == 0) first_breaks = true;
                if (!first_breaks) ++broken_of_these[i];
            }
        }
        if (!first_breaks) sets.push_back(std::move(sites));
    }

    std::vector<Row> rows;
    std::vector<Contestant> racing;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < builders.size(); ++i) {
        if (counts_too) {
            const auto more = rows_of(cell, builders[i].first, counts[i]);
            rows.insert(rows.end(), more.begin(), more.end());
        }
        if (sets.empty() || broken_of_these[i] > 0) continue;
        names.push_back(builders[i].first);
        racing.emplace_back([&sets, metric, options = builders[i].second] {
            constexpr double long_enough = 1e-3;  // for the clock
            double seconds = 0.0;
            std::size_t built = 0;
            while (seconds < long_enough) {
                for (const auto& sites : sets)
                    seconds += triangulate(sites, metric, options).statistics().seconds;
                built += sets.size();
            }
            return seconds / static_cast<double>(built);
        });
    }
    if (racing.size() < 2) return rows;
    const Race race = race_of(racing, cell, pass);
    for (std::size_t i = 0; i < names.size(); ++i) {
        rows.push_back({cell.setting, names[i], "seconds", race.seconds[i]});
        rows.push_back({cell.setting, names[i], "ratio", race.ratios[i]});
    }
    return rows;
}

}  // namespace signum::study
