/// Exact and rounded arithmetic run the same shaker, and the logs are compared.

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "../../../motion/queries.hpp"
#include "../../scenes/snapshot.hpp"
#include "../work.hpp"
#include "shaker.hpp"

namespace signum::study {
namespace {

constexpr int looks = 10;

motion::Options arithmetic_named(const std::string& name) {
    return {.kernel = name == "naive" ? motion::Kernel::naive : motion::Kernel::exact};
}

/// A run, and what was wrong at the times at which it was looked at.
struct Run {
    std::vector<motion::Strike> log;
    double overlap = 0.0;
    double wall_overlap = 0.0;
    double lost = 0.0;
    bool is_broken = false;
};

/// How deep discs lie in each other and in the sides of the box, and how many are outside.
void look(Run& run, const motion::State<2>& state, const motion::Effects<2>& effects) {
    if (const auto pair = motion::closest_pair(state, effects))
        run.overlap = std::max(run.overlap, -pair->gap);
    const motion::Box<2> box = box_at(*effects.box, effects, state.time);
    double lost = 0.0;
    for (const motion::Ball<2>& ball : state.balls) {
        const motion::Vector<2> x = centre(ball, state.time, effects);
        bool is_outside = false;
        for (int k = 0; k < 2; ++k) {
            const double way = std::min(x[k] - box.low[k], box.high[k] - x[k]);
            is_outside |= !(way >= 0.0);
            run.wall_overlap = std::max(run.wall_overlap, ball.radius - way);
        }
        lost += is_outside ? 1.0 : 0.0;
    }
    run.lost = std::max(run.lost, lost);
}

Run run_of(const Cell& cell, const motion::Options& options, std::size_t most_strikes) {
    const Shaker& shaker = shaker_for(cell);
    Run run;
    try {
        motion::Simulation<2> simulation(shaker.state, shaker.effects, options);
        for (int i = 1; i <= looks && !run.is_broken; ++i) {
            const double until = shaker.state.time + cell.simulated * i / looks;
            const motion::Outcome outcome =
                simulation.run({.until = until, .strikes = most_strikes - run.log.size()},
                               [&](const motion::Strike& strike) { run.log.push_back(strike); });
            run.is_broken = outcome.ending == motion::Ending::strikes ||
                            outcome.ending == motion::Ending::collapse;
            look(run, simulation.state(), shaker.effects);
        }
    } catch (const std::exception&) {
        run.is_broken = true;
    }
    return run;
}

/// The first strike in which two logs differ.
template <class Same>
std::size_t first_difference(const Run& a, const Run& b, const Same& same) {
    const auto [in_a, in_b] =
        std::mismatch(a.log.begin(), a.log.end(), b.log.begin(), b.log.end(), same);
    return static_cast<std::size_t>(in_a - a.log.begin());
}

std::vector<Row> compare_runs(const Cell& cell) {
    std::vector<Row> rows;
    const double radius = radii_of(cell.setting).back();
    Run exact;
    for (const char* name : {"exact", "naive"}) {
        const bool is_exact = exact.log.empty();
        // Balls that overlap for good strike without end.
        const std::size_t most = is_exact ? 1'000'000'000 : 20 * exact.log.size() + 1000;
        Run run = run_of(cell, arithmetic_named(name), most);
        const auto put = [&](const std::string& quantity, double value) {
            rows.push_back({cell.setting, name, quantity, exactly(value)});
        };
        put(std::string(broken_percent), run.is_broken ? 100.0 : 0.0);
        put("strikes", static_cast<double>(run.log.size()));
        put("overlap", run.overlap / radius);
        put("wall_overlap", run.wall_overlap / radius);
        put("lost", run.lost);
        if (is_exact) {
            exact = std::move(run);
            continue;
        }
        const std::size_t other_bits = first_difference(exact, run, std::equal_to<>());
        const std::size_t other =
            first_difference(exact, run, [](const motion::Strike& a, const motion::Strike& b) {
                return a.wall == b.wall && a.a == b.a && a.b == b.b;
            });
        if (other_bits < exact.log.size() || other_bits < run.log.size())
            put("first_other_bits", static_cast<double>(other_bits));
        if (other < exact.log.size()) {
            put("first_other_strike", static_cast<double>(other));
            put("first_other_strike_time", exact.log[other].time - shaker_for(cell).state.time);
        }
    }
    return rows;
}

}  // namespace

std::vector<Row> measure_rounding(const Cell& cell, const Pass& pass) {
    const Shaker& shaker = shaker_for(cell);
    std::vector<Row> rows;
    if (pass.number == 1) rows = compare_runs(cell);
    for (const Row& row : rows)
        if (row.quantity == broken_percent && row.value.median > 0.0) return rows;
    if (pass.number > 1 && pass.breaks) return rows;
    std::vector<Contestant> racing;
    for (const std::string& name : cell.contestants)
        racing.emplace_back([&, options = arithmetic_named(name)] {
            motion::Simulation<2> simulation(shaker.state, shaker.effects, options);
            const double seconds =
                seconds_of([&] { simulation.run({.until = shaker.state.time + cell.simulated}); });
            // Each has a log of its own, which may be longer.
            return seconds /
                   static_cast<double>(std::max<std::uint64_t>(simulation.counts().strikes, 1));
        });
    const Race race = race_of(racing, cell, pass);
    for (std::size_t i = 0; i < racing.size(); ++i) {
        rows.push_back({cell.setting, cell.contestants[i], "seconds_per_strike", race.seconds[i]});
        rows.push_back({cell.setting, cell.contestants[i], "ratio", race.ratios[i]});
    }
    return rows;
}

}  // namespace signum::study
