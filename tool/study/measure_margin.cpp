/// How near to zero the determinants of exact tessellations come: the margin that an arithmetic
/// has.

#include <string>

#include <fmt/format.h>

#include "margin.hpp"

#include "contestants.hpp"
#include "work.hpp"

namespace signum::study {

std::vector<Row> measure_margin(const Cell& cell, const Pass& /*pass*/) {
    const Metric metric = metric_named(cell.setting.metric).value();
    const Margins margins = margins_of(triangulate(sites_of(cell.setting, 1), metric));
    std::vector<Row> rows;
    const auto put = [&](const std::string& quantity, double value) {
        rows.push_back({cell.setting, "exact", quantity, exactly(value)});
    };
    if (margins.edges == 0) return rows;
    const auto percent = [&](std::int64_t count) {
        return 100.0 * static_cast<double>(count) / static_cast<double>(margins.edges);
    };
    put("margin_ties", percent(margins.ties));
    for (std::size_t k = 0; k < margins.powers.size(); ++k)
        put(fmt::format("margin_1e-{}", k), percent(margins.powers[k]));
    if (margins.least) put("margin_least", *margins.least);
    return rows;
}

}  // namespace signum::study
