#include "plan.hpp"

#include <algorithm>
#include <utility>

#include "../../../motion/simulation.hpp"

namespace signum::study {
namespace {

using Packings = std::vector<double>;

/// The first one is whom the others are compared with.
std::vector<std::string> structures_for(std::int64_t balls) {
    std::vector<std::string> names;
    for (const motion::Structure structure : motion::all_structures)
        if (structure != motion::Structure::pairs || balls <= 1000)
            names.emplace_back(name_of(structure));
    return names;
}

class MotionCells {
 public:
    explicit MotionCells(const MotionScope& scope) : scope_(scope) {}

    void add(MotionCell cell) {
        const std::int64_t balls = cell.setting.balls;
        if (balls < scope_.least_balls || balls > scope_.most_balls) return;
        cells_.push_back(std::move(cell));
    }
    /// Both ways of the thesis's tables: from event to event, and by its time step.
    void add_structures(const MotionSetting& setting, MotionCell cell) {
        cell.setting = setting;
        cell.work = MotionWork::structures;
        cell.contestants = structures_for(setting.balls);
        // Six are the fewest whose extremes are an interval of 95 %.
        cell.passes = scope_.quick ? 2 : 6;
        add(cell);
    }

    std::vector<MotionCell> take() { return std::move(cells_); }

 private:
    const MotionScope& scope_;
    std::vector<MotionCell> cells_;
};

}  // namespace

std::vector<MotionCell> plan_motion(const MotionScope& scope) {
    MotionCells cells(scope);
    const bool quick = scope.quick;
    constexpr double thesis_step = 0.005;
    const Packings packings =
        quick ? Packings{0.05, 0.33, 0.7} : Packings{0.05, 0.2, 0.33, 0.5, 0.7};
    MotionCell shaken;
    shaken.simulated = quick ? 2.0 : 10.0;

    // Tables 10.4.1 to 10.4.4.
    for (const double size_ratio : {1.0, 10.0})
        for (const double packing : packings)
            for (const double step : {0.0, thesis_step})
                cells.add_structures({"packing", 100, size_ratio, packing, step}, shaken);
    // Table 10.4.5: 100 balls of radii 5 to 10 fill 0.363 of the box. There are as many predictions
    // in it as in two seconds.
    MotionCell counted = shaken;
    counted.simulated = 2.0;
    for (std::int64_t balls = 10; balls <= 100; balls += quick ? 30 : 10)
        for (const double step : {0.0, thesis_step})
            cells.add_structures({"number", balls, 2.0, 0.00363 * static_cast<double>(balls), step},
                                 counted);

    // What accuracy costs, and what goes wrong without it.
    MotionCell judged;
    judged.work = MotionWork::accuracy;
    judged.contestants = {"naive", "exact"};
    judged.passes = quick ? 2 : 6;
    for (const double size_ratio : {1.0, 10.0})
        for (const double packing : packings) {
            judged.setting = {"accuracy", 100, size_ratio, packing, 0.0};
            cells.add(judged);
        }
    judged.speed = 30.0;
    judged.warming_up = 5.0;
    judged.simulated = 1.0;
    for (const std::int64_t balls :
         quick ? std::vector<std::int64_t>{1000} : std::vector<std::int64_t>{1000, 10000})
        for (const double size_ratio : {1.0, 10.0})
            for (const double packing : quick ? Packings{0.33} : Packings{0.05, 0.33, 0.5, 0.7}) {
                judged.setting = {"accuracy", balls, size_ratio, packing, 0.0};
                cells.add(judged);
            }

    // Time steps against events.
    MotionCell stepped = shaken;
    stepped.work = MotionWork::time_steps;
    stepped.seeds = quick ? 3 : 8;
    for (const double packing : quick ? Packings{0.33} : Packings{0.05, 0.33, 0.5})
        for (const double step : {0.0, 0.00125, 0.0025, thesis_step}) {
            stepped.setting = {"time_steps", 100, 1.0, packing, step};
            cells.add(stepped);
        }

    // More balls than the thesis had: flying, or the floor alone would strike at first.
    MotionCell large;
    large.speed = 30.0;
    large.warming_up = 5.0;
    large.most_strikes = quick ? 20'000 : 200'000;
    using Numbers = std::vector<std::int64_t>;
    for (const std::int64_t balls : quick ? Numbers{1000, 10000} : Numbers{1000, 10000, 100000})
        for (const double size_ratio : {1.0, 10.0})
            for (const double packing : {0.05, 0.33, 0.5, 0.7}) {
                large.simulated = 10.0;
                if (quick && packing == 0.5) continue;
                cells.add_structures({"large", balls, size_ratio, packing, 0.0}, large);
                // A step moves all balls, whoever strikes.
                large.simulated = quick ? 0.05 : 0.5;
                if (balls == 1000)
                    cells.add_structures({"large", balls, size_ratio, packing, thesis_step}, large);
            }
    return cells.take();
}

double expected_seconds(const MotionCell& cell, std::size_t pass) {
    const auto balls = static_cast<double>(cell.setting.balls);
    const double steps =
        cell.setting.time_step > 0.0 ? cell.simulated / cell.setting.time_step : 0.0;
    const double strikes =
        std::min(20.0 * balls * cell.simulated, static_cast<double>(cell.most_strikes));
    const double runs = static_cast<double>(std::max(cell.contestants.size(), cell.seeds));
    const double place = pass == 1 && cell.setting.packing >= 0.4 ? 2e-4 * balls : 0.0;
    return place + runs * (4e-6 * strikes + 2e-6 * steps * balls);
}

}  // namespace signum::study
