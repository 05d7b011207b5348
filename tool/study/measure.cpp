#include "measure.hpp"

#include <algorithm>
#include <array>
#include <random>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "../../triangulation/dynamic.hpp"

#include "contestants.hpp"
#include "margin.hpp"
#include "work.hpp"

namespace signum::study {

/// Sites one by one into a tessellation and out of it, beside building it at once.
std::vector<Row> measure_deletion(const Cell& cell, const Pass& pass) {
    const Metric metric = metric_named(cell.setting.metric).value();
    const std::vector<Site> sites = sites_of(cell.setting, 1);
    // Half the sites come and go, in no order; the other half is always there.
    const std::size_t half = sites.size() / 2;
    DynamicTessellation tessellation(metric);
    for (std::size_t i = half; i < sites.size(); ++i)
        static_cast<void>(tessellation.insert(sites[i]));
    std::vector<Index> handles(half);
    std::mt19937_64 random(1);
    const auto insert_all = [&] {
        for (std::size_t i = 0; i < half; ++i) handles[i] = tessellation.insert(sites[i]);
    };
    const auto erase_all = [&] {
        for (std::size_t i = half; i > 1; --i) std::swap(handles[i - 1], handles[random() % i]);
        for (const Index handle : handles) tessellation.erase(handle);
    };
    const auto ns = [](double seconds, std::size_t count) {
        return 1e9 * seconds / static_cast<double>(count);
    };
    // One round inserts and erases: these two do not run one without the other.
    double erased = 0.0;
    const std::vector<Contestant> contestants = {
        [&] {
            return ns(triangulate(sites, metric, {.threads = 1}).statistics().seconds,
                      sites.size());
        },
        [&] {
            const double inserted = seconds_of(insert_all);
            erased = seconds_of(erase_all);
            return ns(inserted, half);
        },
        [&] {
            if (erased == 0.0) {
                insert_all();
                erased = seconds_of(erase_all);
            }
            return ns(std::exchange(erased, 0.0), half);
        }};
    const Race race = race_of(contestants, cell, pass);
    std::vector<Row> rows;
    for (std::size_t i = 0; i < contestants.size(); ++i)
        rows.push_back({cell.setting, cell.contestants[i], "ns_per_site", race.seconds[i]});
    return rows;
}

/// How near to zero the determinants of exact tessellations come: the margin that an arithmetic
/// has.
std::vector<Row> measure_margin(const Cell& cell, const Pass& /*pass*/) {
    const Metric metric = metric_named(cell.setting.metric).value();
    const Margins margins = margins_of(triangulate(sites_of(cell.setting, 1), metric));
    std::vector<Row> rows;
    if (margins.edges == 0) return rows;
    const auto put = [&](const std::string& quantity, double value) {
        rows.push_back({cell.setting, "exact", quantity, exactly(value)});
    };
    const auto percent = [&](std::int64_t count) {
        return 100.0 * static_cast<double>(count) / static_cast<double>(margins.edges);
    };
    put("margin_ties", percent(margins.ties));
    for (std::size_t k = 0; k < margins.powers.size(); ++k)
        put(fmt::format("margin_1e-{}", k), percent(margins.powers[k]));
    if (margins.least) put("margin_least", *margins.least);
    return rows;
}

std::vector<Row> measure(const Cell& cell, const Pass& pass) {
    // In the order of the enumerators.
    constexpr std::array works = {measure_construction, measure_deletion,  measure_stage_cost,
                                  measure_first_error,  measure_margin,    measure_structures,
                                  measure_rounding,     measure_time_steps};
    std::vector<Row> rows;
    const double seconds =
        seconds_of([&] { rows = works[static_cast<std::size_t>(cell.work)](cell, pass); });
    rows.push_back({cell.setting, "study", std::string(end_of_cell), exactly(seconds)});
    return rows;
}

}  // namespace signum::study
