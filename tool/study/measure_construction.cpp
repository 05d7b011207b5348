/// What is done with sites in the plane and in space alike: contestants build the tessellations of
/// the same sites, and err, or do not. In the first pass each builds every set once, and edges (in
/// space cells) and calls are counted; in all they race.

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "../../triangulation/space/compare.hpp"
#include "../../triangulation/space/triangulate.hpp"
#include "../../voronoi/compare.hpp"

#include "contestants.hpp"
#include "work.hpp"

namespace signum::study {
namespace {

struct Plane {
    using Sites = std::vector<Site>;
    using Result = Tessellation;
    static constexpr std::string_view parts = "edges";
    static constexpr auto all_parts = &EdgeComparison::edges;

    static Sites sites(const Setting& setting, std::size_t seed) { return sites_of(setting, seed); }
    static Result build(const Sites& sites, Metric metric, const Options& options = {}) {
        return triangulate(sites, metric, options);
    }
    static double seconds(const Sites& sites, Metric metric, const Options& options) {
        return triangulate(sites, metric, options).statistics().seconds;
    }
    static EdgeComparison compare(const Result& result, const Result& canonical, const Sites&) {
        return compare_edges(result, canonical);
    }
    static std::size_t hidden(const Result& result) { return result.hidden().size(); }
    static const Statistics* calls(const Result& result) { return &result.statistics(); }
};

/// There is one metric yet, and calls are not counted.
struct Space {
    using Sites = std::vector<Site3>;
    using Result = SpaceTessellation;
    static constexpr std::string_view parts = "cells";
    static constexpr auto all_parts = &CellComparison::cells;

    static Sites sites(const Setting& setting, std::size_t seed) {
        return sites_in_space_of(setting, seed);
    }
    static Result build(const Sites& sites, Metric, const Options& options = {}) {
        return triangulate(std::span<const Site3>(sites), Power{}, options);
    }
    static double seconds(const Sites& sites, Metric metric, const Options& options) {
        return seconds_of([&] { static_cast<void>(build(sites, metric, options)); });
    }
    static CellComparison compare(const Result& result, const Result& canonical,
                                  const Sites& sites) {
        return compare_cells(result, canonical, std::span<const Site3>(sites));
    }
    static std::size_t hidden(const Result& result) { return result.hidden.size(); }
    static const Statistics* calls(const Result&) { return nullptr; }
};

// ---- construction ------------------------------------------------------------------------------

constexpr std::array shares = {"wrong_percent", "different_percent", "wrong_or_different_percent"};

/// Sums over the sets.
struct Counts {
    std::size_t sets = 0;
    std::size_t broken = 0;
    double parts = 0.0;  ///< edges, in space cells
    double hidden = 0.0;
    std::array<double, shares.size()> sums = {};
    std::array<Interval, shares.size()> percents = {};  ///< the least and greatest of a set
    std::optional<Statistics> calls;                    ///< where they are counted

    void add(std::int64_t all_parts, std::size_t wrong, std::size_t different,
             std::size_t hidden_sites, const Statistics* statistics) {
        const auto all = static_cast<double>(all_parts);
        const std::array found = {static_cast<double>(wrong), static_cast<double>(different),
                                  static_cast<double>(wrong + different)};
        for (std::size_t k = 0; k < shares.size(); ++k) {
            const double percent = all > 0.0 ? 100.0 * found[k] / all : 0.0;
            sums[k] += found[k];
            percents[k].low = sets == 0 ? percent : std::min(percents[k].low, percent);
            percents[k].high = std::max(percents[k].high, percent);
            ++percents[k].runs;
        }
        ++sets;
        parts += all;
        hidden += static_cast<double>(hidden_sites);
        if (!statistics) return;
        if (!calls) calls.emplace();
        for (const Counter& counter : counters) *calls.*counter.count += statistics->*counter.count;
    }
};

/// Of one contestant, without the times.
void put_counts(std::vector<Row>& rows, const Cell& cell, const std::string& name,
                std::string_view parts, const Counts& counts) {
    const auto put = [&](std::string_view quantity, const Interval& value) {
        rows.push_back({cell.setting, name, std::string(quantity), value});
    };
    put(broken_percent,
        exactly(100.0 * static_cast<double>(counts.broken) / static_cast<double>(cell.sets)));
    if (counts.sets == 0) return;
    const auto put_mean = [&](std::string_view quantity, auto sum) {
        put(quantity, exactly(static_cast<double>(sum) / static_cast<double>(counts.sets)));
    };
    put_mean(parts, counts.parts);
    const double percent = counts.parts > 0.0 ? 100.0 / counts.parts : 0.0;
    for (std::size_t k = 0; k < shares.size(); ++k) {
        Interval share = counts.percents[k];
        share.median = percent * counts.sums[k];
        put(shares[k], share);
    }
    put_mean("hidden", counts.hidden);
    if (!counts.calls) return;
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
                const auto found = World::compare(tessellation, *canonical, sites);
                counts[i].add(found.*World::all_parts, found.wrong.size(), found.different.size(),
                              World::hidden(tessellation), World::calls(tessellation));
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
        if (counts_too) put_counts(rows, cell, builders[i].first, World::parts, counts[i]);
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

// ---- the first error ---------------------------------------------------------------------------

/// Whether the arithmetic gives a wrong edge (cell), or breaks, on any of the sets.
template <class World>
bool errs(const Cell& cell, const Options& options, int exponent) {
    Setting setting = cell.setting;
    setting.perturbation = std::pow(10.0, exponent);
    const Metric metric = metric_named(setting.metric).value();
    for (std::size_t seed = 1; seed <= cell.sets; ++seed) {
        const auto sites = World::sites(setting, seed);
        try {
            const auto tessellation = World::build(sites, metric, options);
            const auto canonical = World::build(sites, metric);
            if (!World::compare(tessellation, canonical, sites).wrong.empty()) return true;
        } catch (const BrokenStructure&) {
            return true;
        }
    }
    return false;
}

constexpr int greatest = 2;
constexpr int least = -17;  // moves no site that is not near an axis

template <class World>
std::vector<Row> first_errors(const Cell& cell) {
    std::vector<Row> rows;
    for (const std::string& name : cell.contestants) {
        const auto options = options_named(name);
        if (!options) continue;
        int bad = least;
        int good = greatest + 1;
        if (!errs<World>(cell, *options, bad)) good = bad;
        while (good - bad > 1) {
            const int middle = bad + (good - bad) / 2;
            (errs<World>(cell, *options, middle) ? bad : good) = middle;
        }
        Interval value = exactly(0.0);
        if (good > bad) value = {std::pow(10.0, bad), std::pow(10.0, bad), std::pow(10.0, good), 1};
        rows.push_back({cell.setting, name, "first_error", value});
    }
    return rows;
}

}  // namespace

std::vector<Row> measure_construction(const Cell& cell, const Pass& pass) {
    return cell.dimension == 3 ? constructions<Space>(cell, pass)
                               : constructions<Plane>(cell, pass);
}

/// From which perturbation on inexact arithmetic errs: by bisection over the powers of ten.
std::vector<Row> measure_first_error(const Cell& cell, const Pass& /*pass*/) {
    return cell.dimension == 3 ? first_errors<Space>(cell) : first_errors<Plane>(cell);
}

}  // namespace signum::study
