/// Sites one by one into a tessellation and out of it, beside building it at once.

#include <algorithm>
#include <functional>
#include <random>
#include <utility>

#include "../../triangulation/dynamic.hpp"

#include "contestants.hpp"
#include "work.hpp"

namespace signum::study {

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
        [&] { return ns(triangulate(sites, metric).statistics().seconds, sites.size()); },
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

}  // namespace signum::study
