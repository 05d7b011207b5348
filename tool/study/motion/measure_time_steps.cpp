/// One shaker of several seeds, in time steps or without: strikes and energy as time goes on.

#include <cmath>
#include <string>

#include <fmt/format.h>

#include "../../scenes/energy.hpp"
#include "../work.hpp"
#include "shaker.hpp"

namespace signum::study {
namespace {

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
