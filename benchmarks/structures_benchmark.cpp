/// The structures of motion/ side by side, as in table 9.7 of the thesis, but measured: how many
/// pairs are asked, how many events a structure has of its own, how long it takes to begin and what
/// it takes of memory. Balls of one size and of radii 1 to 10 fill three tenths of a box with
/// walls, in the plane and in space. Of one gas all structures run through the very same strikes.
/// In a column the first number is that of one size, the second that of radii 1 to 10, or to
/// another one.
///
/// usage: structures_benchmark [balls [radii]]

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "../motion/simulation.hpp"
#include "../tool/scenes/arrangement.hpp"
#include "measuring.hpp"

namespace signum::benchmarks {
namespace {

using motion::Body;
using motion::Counts;
using motion::Structure;
using motion::Vector;

constexpr double packing = 0.3;
constexpr int rounds = 5;

template <int D>
struct Gas {
    std::vector<Body<D>> bodies;
    motion::Effects<D> effects;
};

/// Balls thrown into a box at random. Radii are from 1 to the largest; balls of any size and of
/// twice that size fill as much in all, so there are 2^D times as many of the smaller. Masses are
/// those of one stuff, speeds those of one temperature.
template <int D>
Gas<D> gas_of(std::size_t number, double largest) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> share;
    std::vector<double> radii(number);
    for (double& r : radii)
        r = std::pow(1.0 - share(random) * (1.0 - std::pow(largest, -D)), -1.0 / D);
    std::ranges::sort(radii, std::greater{});
    double volume = 0.0;
    for (const double r : radii) volume += motion::ball_volume<D>(r) / packing;
    Gas<D> gas;
    gas.effects.box.emplace();
    gas.effects.box->high.fill(std::pow(volume, 1.0 / D));
    const std::vector<Vector<D>> centres =
        place_by_chance<D>({.box = *gas.effects.box, .volume = volume}, radii, {}, 1);
    std::normal_distribution<double> speed;
    for (std::size_t i = 0; i < number; ++i) {
        Body<D> body{centres[i], {}, radii[i], std::pow(radii[i], D)};
        for (double& v : body.v) v = speed(random) / std::sqrt(body.mass);
        gas.bodies.push_back(body);
    }
    return gas;
}

struct Measured {
    Counts before;
    Counts after;
    double start = 0.0;  ///< seconds
    double bytes = 0.0;
    double strike = 0.0;  ///< seconds
};

/// The first strikes are left out: at the start all balls are asked.
template <int D>
Measured measure(const motion::State<D>& state, const motion::Effects<D>& effects,
                 Structure structure) {
    const bool is_slow = structure == Structure::pairs || structure == Structure::segments;
    const std::uint64_t strikes = state.balls.size() / (is_slow ? 10 : 1);
    Measured measured;
    std::vector<double> starts;
    std::vector<double> runs;
    const double before = bytes_taken();
    std::optional<motion::Simulation<D>> simulation;
    for (int round = 0; round < rounds; ++round) {
        simulation.reset();
        starts.push_back(
            seconds_of([&] { simulation.emplace(state, effects, motion::Options{structure}); }));
    }
    simulation->run({.strikes = strikes});
    measured.before = simulation->counts();
    for (int round = 0; round < rounds; ++round) {
        runs.push_back(seconds_of([&] { simulation->run({.strikes = strikes}); }) /
                       static_cast<double>(strikes));
    }
    measured.after = simulation->counts();
    measured.bytes = bytes_taken() - before;
    measured.start = median(starts);
    measured.strike = median(runs);
    return measured;
}

/// A line of a table; in each column what was measured for one size and for radii 1 : 10.
struct Row {
    Structure structure;
    std::array<std::vector<std::string>, 6> columns;
};

double ratio(std::uint64_t part, std::uint64_t whole) {
    return static_cast<double>(part) / static_cast<double>(whole);
}

/// The columns of one gas, those of all structures in turn.
template <int D>
void add_columns(std::vector<Row>& rows, std::size_t number, double largest) {
    const Gas<D> gas = gas_of<D>(number, largest);
    motion::Simulation<D> settling(motion::start<D>(gas.bodies, gas.effects), gas.effects);
    settling.run({.strikes = 10 * number});
    const motion::State<D> state = settling.state();
    double of_the_loop = 0.0;
    for (Row& row : rows) {
        const Measured measured = measure(state, gas.effects, row.structure);
        // Pairs are no structure: what they take the loop takes, over any.
        const bool is_pairs = row.structure == Structure::pairs;
        if (is_pairs) of_the_loop = measured.bytes;
        const std::uint64_t strikes = measured.after.strikes - measured.before.strikes;
        const std::uint64_t own = measured.after.own - measured.before.own;
        const std::uint64_t own_checks = measured.after.own_checks - measured.before.own_checks;
        const std::uint64_t checks = measured.after.checks - measured.before.checks - own_checks;
        const auto n = static_cast<double>(number);
        row.columns[0].push_back(fmt::format("{:.1f}", ratio(checks, strikes)));
        row.columns[1].push_back(own > 0 ? fmt::format("{:.2f}", ratio(own_checks, own)) : "–");
        row.columns[2].push_back(own > 0 ? fmt::format("{:.2f}", ratio(own, strikes)) : "–");
        row.columns[3].push_back(fmt::format("{:.2f}", measured.start / n * 1e6));
        row.columns[4].push_back(
            is_pairs ? "–" : fmt::format("{:.0f}", (measured.bytes - of_the_loop) / n));
        row.columns[5].push_back(fmt::format("{:.2f}", measured.strike * 1e6));
    }
}

template <int D>
std::vector<Row> rows_of() {
    std::vector<Row> rows;
    for (const Structure structure : motion::all_structures)
        if (structure != Structure::automatic && (D == 2 || structure != Structure::delaunay))
            rows.push_back({structure, {}});
    return rows;
}

template <int D>
void print_table(std::size_t number, double largest) {
    std::vector<Row> rows = rows_of<D>();
    for (const double each : {1.0, largest}) add_columns<D>(rows, number, each);
    fmt::print(
        "\n| {} {} | checks a strike | checks an own event | own events a strike | start, µs a "
        "ball "
        "| space, bytes a ball | µs a strike |\n"
        "| --- | --: | --: | --: | --: | --: | --: |\n",
        number, D == 2 ? "discs" : "spheres");
    for (const Row& row : rows) {
        fmt::print("| `{}` |", motion::name_of(row.structure));
        for (const auto& column : row.columns) fmt::print(" {} |", fmt::join(column, "; "));
        fmt::print("\n");
    }
}

}  // namespace
}  // namespace signum::benchmarks

int main(int count, char** words) {
    using namespace signum;
    const std::size_t number = count > 1 ? std::strtoul(words[1], nullptr, 10) : 10'000;
    const double largest = count > 2 ? std::strtod(words[2], nullptr) : 10.0;
    if (number < 100 || !(largest >= 1.0)) return 2;
    // So that the program itself lies in memory.
    std::vector<benchmarks::Row> rows = benchmarks::rows_of<2>();
    benchmarks::add_columns<2>(rows, 500, 1.0);
    rows = benchmarks::rows_of<3>();
    benchmarks::add_columns<3>(rows, 500, 1.0);
    benchmarks::print_table<2>(number, largest);
    benchmarks::print_table<3>(number, largest);
    return 0;
}
