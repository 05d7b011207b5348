#include "results.hpp"

#include <fmt/format.h>

namespace signum::study {

std::optional<Ranking> ranking(const MotionResults& results, const MotionSetting& cell) {
    Ranking all;
    for (const std::string& name : structures) {
        if (const auto ratio = results.value(cell, name, "ratio")) all.factor[name] = *ratio;
        if (results.value(cell, "auto", "chooses_" + name)) all.chosen = name;
    }
    if (all.factor.size() < 2) return std::nullopt;
    const auto best =
        std::min_element(all.factor.begin(), all.factor.end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    all.fastest = best->first;
    const double least = best->second;
    all.factor["auto"] = 1.0;
    for (auto& [name, factor] : all.factor) factor = std::max(1.0, factor / least);
    return all;
}

std::string words_for(const MotionSetting& cell) {
    const std::string sizes =
        cell.size_ratio == 1.0 ? "one size" : fmt::format("1 : {}", cell.size_ratio);
    const std::string way =
        cell.time_step > 0.0 ? fmt::format("steps of {} s", cell.time_step) : "events";
    return fmt::format("{} balls, {}, {:.3g} %, {}", cell.balls, sizes, 100.0 * cell.packing, way);
}

}  // namespace signum::study
