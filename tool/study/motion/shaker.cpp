#include "shaker.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <random>
#include <string>

#include "../../scenes/arrangement.hpp"
#include "../../scenes/normal.hpp"

namespace signum::study {

double side_of_box(std::int64_t balls) {
    return 200.0 * std::sqrt(std::max(1.0, static_cast<double>(balls) / 100.0));
}

std::vector<double> radii_of(const Setting& setting) {
    const auto number = static_cast<double>(setting.count);
    std::vector<double> radii(static_cast<std::size_t>(setting.count));
    double squares = 0.0;
    for (std::size_t i = 0; i < radii.size(); ++i) {
        const double share = (static_cast<double>(i) + 0.5) / number;
        const double ratio = setting.size_ratio;
        radii[i] = 1.0 / std::sqrt(1.0 / (ratio * ratio) + share * (1.0 - 1.0 / (ratio * ratio)));
        squares += radii[i] * radii[i];
    }
    const double side = side_of_box(setting.count);
    const double scale = side * std::sqrt(setting.packing / (std::numbers::pi * squares));
    for (double& radius : radii) radius *= scale;
    return radii;
}

Shaker shaker_of(const Setting& setting, double speed, std::uint64_t seed) {
    const double side = side_of_box(setting.count);
    const std::vector<double> radii = radii_of(setting);
    motion::Effects<2> effects;
    effects.gravity = {0.0, -9.81};
    effects.restitution = effects.wall_restitution = 0.9;
    effects.contact_duration = 1e-3;
    effects.box = {{0.0, 0.0}, {side, side}};
    effects.shake = {{0.0, 5.0}, 2.0 * std::numbers::pi, 0.0};
    effects.time_step = setting.time_step;

    const Region<2> region = {*effects.box, false, side * side};
    const auto places = setting.packing < 0.4 ? place_by_chance<2>(region, radii, {}, seed)
                                              : place_by_growth<2>(region, radii, {}, seed);
    const double mean_mass = setting.packing * side * side / static_cast<double>(setting.count);
    std::vector<motion::Body<2>> bodies;
    Normal normal(seed);
    for (std::size_t i = 0; i < radii.size(); ++i) {
        const double mass = std::numbers::pi * radii[i] * radii[i];
        motion::Body<2> body{places[i], {}, radii[i], mass};
        if (speed > 0.0)
            for (double& v : body.v) v = speed * std::sqrt(mean_mass / mass) * normal();
        bodies.push_back(body);
    }
    return {motion::start<2>(bodies, effects), effects};
}

const Shaker& shaker_for(const Cell& cell) {
    static std::map<Setting, Shaker> made;
    Setting at = cell.setting;
    at.experiment = std::to_string(cell.speed);  // one for all experiments
    const auto [found, is_new] = made.try_emplace(at);
    Shaker& shaker = found->second;
    if (!is_new) return shaker;
    shaker = shaker_of(cell.setting, cell.speed, 1);
    if (cell.warming_up > 0.0) {
        const double strikes = cell.warming_up * static_cast<double>(cell.setting.count);
        motion::Simulation<2> simulation(shaker.state, shaker.effects);
        simulation.run({.strikes = static_cast<std::uint64_t>(strikes)});
        shaker.state = simulation.state();
    }
    return shaker;
}

}  // namespace signum::study
