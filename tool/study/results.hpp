#pragma once
/// What was measured, to be asked and drawn. For the sources of study/.

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "plot.hpp"
#include "rows.hpp"

namespace signum::study {

using Names = std::vector<std::string>;

/// What a figure draws of a row against what.
using Where = std::function<double(const Row&)>;
inline double by_sites(const Row& row) {
    return static_cast<double>(row.setting.sites);
}
inline double by_perturbation(const Row& row) {
    return row.setting.perturbation;
}
inline double by_radius(const Row& row) {
    return row.setting.radius_to;
}

/// Which rows are asked for; an empty name is any.
struct Query {
    std::string experiment;
    std::string metric;
    std::string distribution;
    std::string contestant;
    std::string quantity;
};

class Results {
 public:
    explicit Results(const std::vector<Row>& rows) : rows_(rows) {}

    [[nodiscard]] std::vector<const Row*> all(const Query& query) const {
        const auto fits = [](const std::string& wanted, const std::string& is) {
            return wanted.empty() || wanted == is;
        };
        std::vector<const Row*> found;
        for (const Row& row : rows_)
            if (fits(query.experiment, row.setting.experiment) &&
                fits(query.metric, row.setting.metric) &&
                fits(query.distribution, row.setting.distribution) &&
                fits(query.contestant, row.contestant) && fits(query.quantity, row.quantity))
                found.push_back(&row);
        return found;
    }

    [[nodiscard]] std::vector<PlotPoint> points(const Query& query, const Where& where) const {
        std::vector<PlotPoint> result;
        for (const Row* row : all(query))
            result.push_back({where(*row), row->value.median, row->value.low, row->value.high});
        std::sort(result.begin(), result.end(),
                  [](const PlotPoint& a, const PlotPoint& b) { return a.x < b.x; });
        return result;
    }

    /// The value at a number of sites (0: the only one).
    [[nodiscard]] std::optional<double> at(const Query& query, std::int64_t sites = 0,
                                           double perturbation = 0.0) const {
        for (const Row* row : all(query))
            if ((sites == 0 || row->setting.sites == sites) &&
                (perturbation == 0.0 || row->setting.perturbation == perturbation))
                return row->value.median;
        return std::nullopt;
    }

    /// Of the names those that have rows.
    [[nodiscard]] Names present(const std::string& experiment, const Names& metrics) const {
        Names result;
        for (const std::string& metric : metrics)
            if (!all({experiment, metric, "", "", ""}).empty()) result.push_back(metric);
        return result;
    }

    /// The greatest number of sites that all distributions of an experiment have.
    [[nodiscard]] std::int64_t most_sites(const Query& query) const {
        std::int64_t most = 0;
        for (const Row* row : all(query)) most = std::max(most, row->setting.sites);
        return most;
    }

 private:
    const std::vector<Row>& rows_;
};

/// Whether there is anything to draw.
[[nodiscard]] inline bool has_points(const Plot& plot) {
    for (const Panel& panel : plot.panels)
        for (const Series& series : panel.series)
            if (!series.points.empty()) return true;
    return false;
}

}  // namespace signum::study
