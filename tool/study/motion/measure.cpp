#include "measure.hpp"

#include <cmath>
#include <cstdint>
#include <map>
#include <string>

#include "work.hpp"

namespace signum::study {

const Shaker& shaker_for(const MotionCell& cell) {
    static std::map<std::string, Shaker> made;
    MotionSetting at = cell.setting;
    at.experiment = std::to_string(cell.speed);  // one for all experiments
    const auto [found, is_new] = made.try_emplace(key_of(at));
    Shaker& shaker = found->second;
    if (!is_new) return shaker;
    shaker = shaker_of(cell.setting, cell.speed, 1);
    if (cell.warming_up > 0.0) {
        const double strikes = cell.warming_up * static_cast<double>(cell.setting.balls);
        motion::Simulation<2> simulation(shaker.state, shaker.effects);
        simulation.run({.strikes = static_cast<std::uint64_t>(strikes)});
        shaker.state = simulation.state();
    }
    return shaker;
}

std::vector<MotionRow> measure(const MotionCell& cell, const Pass& pass) {
    std::vector<MotionRow> rows;
    const double seconds = seconds_of([&] {
        switch (cell.work) {
            case MotionWork::structures:
                rows = measure_structures(cell, pass);
                break;
            case MotionWork::accuracy:
                rows = measure_rounding(cell, pass);
                break;
            case MotionWork::time_steps:
                rows = measure_time_steps(cell);
                break;
        }
    });
    rows.push_back({cell.setting, "study", std::string(end_of_cell), exactly(seconds)});
    return rows;
}

}  // namespace signum::study
