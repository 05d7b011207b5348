#pragma once
/// What was measured, to be asked. For the sources of study/motion/.

#include <algorithm>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "../plot.hpp"
#include "setting.hpp"

namespace signum::study {

using Names = std::vector<std::string>;

class MotionResults {
 public:
    explicit MotionResults(const std::vector<MotionRow>& rows) {
        for (const MotionRow& row : rows) {
            values_.emplace(key(row.setting, row.contestant, row.quantity), row.value);
            if (std::find(cells_.begin(), cells_.end(), row.setting) == cells_.end())
                cells_.push_back(row.setting);
        }
    }

    using Which = std::function<bool(const MotionSetting&)>;
    /// The cells of an experiment, in the order of the plan.
    [[nodiscard]] std::vector<MotionSetting> cells(const std::string& experiment,
                                                   const Which& which = {}) const {
        std::vector<MotionSetting> found;
        for (const MotionSetting& cell : cells_)
            if (cell.experiment == experiment && (!which || which(cell))) found.push_back(cell);
        return found;
    }
    [[nodiscard]] std::optional<Interval> interval(const MotionSetting& cell,
                                                   const std::string& contestant,
                                                   const std::string& quantity) const {
        const auto found = values_.find(key(cell, contestant, quantity));
        if (found == values_.end()) return std::nullopt;
        return found->second;
    }
    [[nodiscard]] std::optional<double> value(const MotionSetting& cell,
                                              const std::string& contestant,
                                              const std::string& quantity) const {
        const auto found = interval(cell, contestant, quantity);
        return found ? std::optional(found->median) : std::nullopt;
    }
    /// Of cells a point each, where there is a row, times a scale, by rising x.
    [[nodiscard]] std::vector<PlotPoint> points(
        const std::vector<MotionSetting>& cells, const std::string& contestant,
        const std::string& quantity, const std::function<double(const MotionSetting&)>& where,
        double scale = 1.0) const {
        std::vector<PlotPoint> result;
        for (const MotionSetting& cell : cells)
            if (const auto found = interval(cell, contestant, quantity))
                result.push_back(
                    {where(cell), scale * found->median, scale * found->low, scale * found->high});
        std::sort(result.begin(), result.end(),
                  [](const PlotPoint& a, const PlotPoint& b) { return a.x < b.x; });
        return result;
    }

 private:
    static std::string key(const MotionSetting& cell, const std::string& contestant,
                           const std::string& quantity) {
        return csv_line(MotionRow{cell, contestant, quantity, {}});
    }
    std::vector<MotionSetting> cells_;
    std::map<std::string, Interval> values_;
};

/// In the order of the legends.
inline const Names structures = {"pairs",  "cells", "tree",    "segments",
                                 "levels", "lists", "delaunay"};

/// Times of structures in a cell, each as a part of the least one.
struct Ranking {
    std::string fastest;
    std::string chosen;  ///< by auto
    std::map<std::string, double> factor;
};
/// None where no two structures were timed.
[[nodiscard]] std::optional<Ranking> ranking(const MotionResults& results,
                                             const MotionSetting& cell);

/// "100 balls, 1 : 10, 33 %, steps of 0.005 s"
[[nodiscard]] std::string words_for(const MotionSetting& cell);

}  // namespace signum::study
