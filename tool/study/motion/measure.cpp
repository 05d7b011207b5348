/// What is done with balls: structures run the same shaker, or two arithmetics, or time steps of
/// several lengths.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "../../../motion/queries.hpp"
#include "../../scenes/energy.hpp"
#include "../../scenes/snapshot.hpp"
#include "../work.hpp"
#include "shaker.hpp"

namespace signum::study {
namespace {

// ---- structures, each to the same time or number of strikes -------------------------------------

using motion::Structure;

/// Those that take some ten, or some hundred, times as long as the others are stopped earlier.
std::uint64_t most_strikes_of(Structure structure, const Cell& cell) {
    if (cell.setting.count < 1000 || cell.setting.time_step > 0.0) return cell.most_strikes;
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

// ---- exact and rounded arithmetic, whose logs are compared --------------------------------------

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

// ---- strikes and energy as time goes on, in time steps or without -------------------------------

constexpr int parts = 10;

/// The mean of a seed each, and low and high that are `widths` standard deviations off.
Interval mean_of(const std::vector<double>& values, double widths) {
    const auto number = static_cast<double>(values.size());
    double mean = 0.0;
    for (const double value : values) mean += value / number;
    double squares = 0.0;
    for (const double value : values) squares += (value - mean) * (value - mean);
    const double deviation = number > 1.0 ? std::sqrt(squares / (number - 1.0)) : 0.0;
    return {mean, mean - widths * deviation, mean + widths * deviation, values.size()};
}

}  // namespace

std::vector<Row> measure_structures(const Cell& cell, const Pass& pass) {
    const Shaker& shaker = shaker_for(cell);
    std::vector<Racer> racers;
    racers.reserve(cell.contestants.size());
    std::vector<Contestant> racing;
    std::vector<Row> rows;
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

std::vector<Row> measure_time_steps(const Cell& cell, const Pass& /*pass*/) {
    const double side = side_of_box(cell.setting.count);
    const double mass = cell.setting.packing * side * side;
    std::vector<std::vector<double>> strikes(parts);
    std::vector<std::vector<double>> energies(parts);
    std::vector<double> all_strikes;
    std::vector<double> mean_energies;
    for (std::size_t seed = 1; seed <= cell.sets; ++seed) {
        const Shaker shaker = shaker_of(cell.setting, cell.speed, seed);
        motion::Simulation<2> simulation(shaker.state, shaker.effects);
        double done = 0.0;
        double energy_sum = 0.0;
        for (int part = 0; part < parts; ++part) {
            const auto i = static_cast<std::size_t>(part);
            simulation.run({.until = cell.simulated * (part + 1) / parts});
            const motion::State<2> state = simulation.state();
            const auto now = static_cast<double>(simulation.counts().strikes);
            strikes[i].push_back(now - done);
            done = now;
            energies[i].push_back(Energy<2>(state, shaker.effects, state.time).total / mass);
            energy_sum += energies[i].back();
        }
        all_strikes.push_back(done);
        mean_energies.push_back(energy_sum / parts);
    }
    std::vector<Row> rows;
    const auto put = [&](const std::string& quantity, const Interval& value) {
        rows.push_back({cell.setting, "auto", quantity, value});
    };
    for (int part = 0; part < parts; ++part) {
        const auto i = static_cast<std::size_t>(part);
        const double time = cell.simulated * (part + 1) / parts;
        put(fmt::format("strikes_at_{}", time), mean_of(strikes[i], 1.0));
        put(fmt::format("energy_at_{}", time), mean_of(energies[i], 1.0));
    }
    const double of_the_mean = 1.0 / std::sqrt(static_cast<double>(cell.sets));
    put("all_strikes", mean_of(all_strikes, of_the_mean));
    put("mean_energy", mean_of(mean_energies, of_the_mean));
    return rows;
}

}  // namespace signum::study
