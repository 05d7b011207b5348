/// Contestants build the tessellations of the same sites. In the first pass each builds every set
/// once, and edges (in space cells) and calls are counted; in all they race.

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "worlds.hpp"

namespace signum::study {
namespace {

/// Sums over the sets.
struct Counts {
    std::size_t sets = 0;
    std::size_t broken = 0;
    double parts = 0.0;  ///< edges, in space cells
    double wrong = 0.0;
    double different = 0.0;
    Interval wrong_percent;
    Interval different_percent;
    Interval either_percent;
    double hidden = 0.0;
    std::optional<Statistics> calls;  ///< where they are counted
};

/// The share of all sets together, and the least and greatest of a set.
void add_share(Interval& interval, double part, double all) {
    const double percent = all > 0.0 ? 100.0 * part / all : 0.0;
    interval.low = interval.runs == 0 ? percent : std::min(interval.low, percent);
    interval.high = std::max(interval.high, percent);
    ++interval.runs;
}

void add(Counts& counts, const Difference& difference, std::size_t hidden,
         const Statistics* calls) {
    const auto& [parts, wrong, different] = difference;
    counts.parts += parts;
    counts.wrong += wrong;
    counts.different += different;
    add_share(counts.wrong_percent, wrong, parts);
    add_share(counts.different_percent, different, parts);
    add_share(counts.either_percent, wrong + different, parts);
    counts.hidden += static_cast<double>(hidden);
    if (!calls) return;
    if (!counts.calls) counts.calls.emplace();
    for (const Counter& counter : counters) *counts.calls.*counter.count += calls->*counter.count;
}

/// Of one contestant, without the times.
std::vector<Row> rows_of(const Cell& cell, const std::string& name, std::string_view parts,
                         Counts counts) {
    std::vector<Row> rows;
    const auto put = [&](const std::string& quantity, const Interval& value) {
        rows.push_back({cell.setting, name, quantity, value});
    };
    put(std::string(broken_percent),
        exactly(100.0 * static_cast<double>(counts.broken) / static_cast<double>(cell.sets)));
    const auto whole = static_cast<double>(counts.sets);
    if (whole == 0.0) return rows;
    put(std::string(parts), exactly(counts.parts / whole));
    const double percent = counts.parts > 0.0 ? 100.0 / counts.parts : 0.0;
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
    if (!counts.calls) return rows;
    const Statistics& calls = *counts.calls;
    put_mean("ccw", calls.ccw);
    put_mean("in_circle", calls.in_circle);
    put_mean("calls_filter", calls.filtered);
    put_mean("calls_refine", calls.refined);
    put_mean("calls_exact", calls.exact);
    put_mean("calls_essa", calls.essa);
    put_mean("calls_multiprecision", calls.multiprecision);
    put_mean("ties", calls.ties);
    put_mean("swaps", calls.flips);
    put_mean("events", calls.events);
    return rows;
}

template <class World>
std::vector<Row> constructions(const Cell& cell, const Pass& pass) {
    const Metric metric = metric_named(cell.setting.metric).value();
    std::vector<std::pair<std::string, Options>> builders;
    for (const std::string& name : cell.contestants)
        if (const auto options = options_named(name)) builders.emplace_back(name, *options);

    const bool counts_too = pass.number == 1;
    std::vector<Counts> counts(builders.size());
    std::vector<typename World::Sites> sets;  // those that the first contestant builds
    std::vector<typename World::Sites> broken_sets;
    std::vector<std::size_t> broken_of_these(builders.size(), 0);
    for (std::size_t seed = 1; seed <= cell.sets; ++seed) {
        auto sites = World::sites(cell.setting, seed);
        std::optional<typename World::Result> canonical;
        if (counts_too) canonical = World::build(sites, metric);
        bool first_breaks = false;
        for (std::size_t i = 0; i < builders.size() && pass.breaks; ++i) {
            Options options = builders[i].second;
            options.count = true;
            try {
                const auto tessellation = World::build(sites, metric, options);
                if (!counts_too) continue;
                add(counts[i], World::difference(tessellation, *canonical, sites),
                    World::hidden(tessellation), World::calls(tessellation));
                ++counts[i].sets;
            } catch (const BrokenStructure&) {
                ++counts[i].broken;
                if (i == 0) first_breaks = true;
                if (!first_breaks) ++broken_of_these[i];
            }
        }
        (first_breaks ? broken_sets : sets).push_back(std::move(sites));
    }
    // Where it builds none, the others are timed without it.
    const bool is_alone = sets.empty();
    if (is_alone) sets = std::move(broken_sets);

    std::vector<Row> rows;
    std::vector<Contestant> racing;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < builders.size(); ++i) {
        if (counts_too) {
            const auto more = rows_of(cell, builders[i].first, World::parts, counts[i]);
            rows.insert(rows.end(), more.begin(), more.end());
        }
        if ((is_alone ? counts[i].broken : broken_of_these[i]) > 0) continue;
        names.push_back(builders[i].first);
        racing.emplace_back([&sets, metric, options = builders[i].second] {
            constexpr double long_enough = 1e-3;  // for the clock
            double seconds = 0.0;
            std::size_t built = 0;
            while (seconds < long_enough) {
                for (const auto& sites : sets) seconds += World::seconds(sites, metric, options);
                built += sets.size();
            }
            return seconds / static_cast<double>(built);
        });
    }
    if (racing.empty() || (racing.size() < 2 && !is_alone)) return rows;
    const Race race = race_of(racing, cell, pass);
    for (std::size_t i = 0; i < names.size(); ++i) {
        rows.push_back({cell.setting, names[i], "seconds", race.seconds[i]});
        if (!is_alone) rows.push_back({cell.setting, names[i], "ratio", race.ratios[i]});
    }
    return rows;
}

}  // namespace

std::vector<Row> measure_construction(const Cell& cell, const Pass& pass) {
    return cell.dimension == 3 ? constructions<Space>(cell, pass)
                               : constructions<Plane>(cell, pass);
}

}  // namespace signum::study
