/// Structures run the same shaker, each to the same time or number of strikes.

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "work.hpp"

namespace signum::study {
namespace {

using motion::Structure;

/// Those that take some ten, or some hundred, times as long as the others are stopped earlier.
std::uint64_t most_strikes_of(Structure structure, const MotionCell& cell) {
    if (cell.setting.balls < 1000 || cell.setting.time_step > 0.0) return cell.most_strikes;
    if (structure == Structure::segments) return cell.most_strikes / 100;
    if (structure == Structure::delaunay || structure == Structure::pairs)
        return cell.most_strikes / 10;
    return cell.most_strikes;
}

/// A number that is the same for states whose balls are the same in every bit, and hardly ever for
/// others.
double digest_of(const motion::State<2>& state) {
    std::string bits;
    const auto add = [&](double x) { bits.append(reinterpret_cast<const char*>(&x), sizeof x); };
    for (const motion::Ball<2>& ball : state.balls) {
        for (const double x : ball.x) add(x);
        for (const double v : ball.v) add(v);
        add(ball.time);
    }
    return static_cast<double>(std::hash<std::string>{}(bits) >> 11);
}

struct Racer {
    std::string name;
    motion::Counts counts;
    double digest = 0.0;
    std::vector<double> starts;
    std::vector<double> runs;
};

}  // namespace

std::vector<MotionRow> measure_structures(const MotionCell& cell, const Pass& pass) {
    const Shaker& shaker = shaker_for(cell);
    std::vector<Racer> racers;
    racers.reserve(cell.contestants.size());
    std::vector<Contestant> racing;
    std::vector<MotionRow> rows;
    for (const std::string& name : cell.contestants) {
        const Structure wish = *motion::structure_named(name);
        const Structure chosen = choose(wish, shaker.state, shaker.effects).structure;
        if (wish == Structure::automatic && pass.number == 1)
            rows.push_back(
                {cell.setting, name, "chooses_" + std::string(name_of(chosen)), exactly(1.0)});
        if (wish != Structure::automatic && chosen != wish) continue;
        Racer& racer = racers.emplace_back();
        racer.name = name;
        racing.emplace_back([&shaker, &cell, &racer, wish, chosen] {
            std::optional<motion::Simulation<2>> simulation;
            racer.starts.push_back(seconds_of([&] {
                simulation.emplace(shaker.state, shaker.effects,
                                   motion::Options{.structure = wish});
            }));
            racer.runs.push_back(seconds_of([&] {
                simulation->run({.until = shaker.state.time + cell.simulated,
                                 .strikes = most_strikes_of(chosen, cell)});
            }));
            racer.counts = simulation->counts();
            if (racer.runs.size() == 1) racer.digest = digest_of(simulation->state());
            // A run that ends after some strikes stands for a longer one.
            const bool is_whole = cell.most_strikes == std::numeric_limits<std::uint64_t>::max();
            if (is_whole) racer.runs.back() += racer.starts.back();
            return racer.runs.back() /
                   static_cast<double>(std::max<std::uint64_t>(racer.counts.strikes, 1));
        });
    }
    const Race race = race_of(racing, cell, pass);
    for (std::size_t i = 0; i < racers.size(); ++i) {
        Racer& racer = racers[i];
        const auto put = [&](const char* quantity, const Interval& value) {
            rows.push_back({cell.setting, racer.name, quantity, value});
        };
        if (pass.number == 1) {
            put("strikes", exactly(static_cast<double>(racer.counts.strikes)));
            put("digest", exactly(racer.digest));
            put("own", exactly(static_cast<double>(racer.counts.own)));
            put("checks", exactly(static_cast<double>(racer.counts.checks)));
            put("predictions", exactly(static_cast<double>(racer.counts.predictions)));
        }
        put("seconds", median_of(std::move(racer.runs)));
        put("start_seconds", median_of(std::move(racer.starts)));
        put("seconds_per_strike", race.seconds[i]);
        put("ratio", race.ratios[i]);
    }
    return rows;
}

}  // namespace signum::study
