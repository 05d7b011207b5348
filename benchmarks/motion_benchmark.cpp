/// Strikes a second of elastic discs and spheres in a periodic box, exact and in plain doubles, and
/// what a ball takes of memory. Each gas starts from a lattice and is run until it has forgotten
/// it; then the two kernels take turns, and the medians of their rates are told.
///
/// usage: motion_benchmark [most balls [structure]]

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <numbers>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "../motion/simulation.hpp"
#include "../tool/scenes/arrangement.hpp"
#include "measuring.hpp"

namespace signum::benchmarks {
namespace {

using motion::Body;
using motion::Kernel;
using motion::Structure;

template <int D>
struct Gas {
    std::vector<Body<D>> bodies;
    motion::Effects<D> effects;
};

/// Balls of diameter 1 that fill a share of a periodic box, on a triangular or face-centred cubic
/// lattice; velocities are normal.
template <int D>
Gas<D> on_lattice(std::size_t number, double packing) {
    std::mt19937_64 random(1);
    std::normal_distribution<double> speed;
    const double volume = static_cast<double>(number) * motion::ball_volume<D>(0.5) / packing;
    Gas<D> gas;
    gas.effects.box.emplace();
    gas.effects.box->high.fill(std::pow(volume, 1.0 / D));
    gas.effects.periodic = true;
    const std::vector<double> radii(number, 0.5);
    for (const motion::Vector<D>& x :
         place_on_lattice<D>({*gas.effects.box, gas.effects.periodic, volume}, radii, {})) {
        Body<D> body{x, {}, 0.5, 1.0};
        for (double& v : body.v) v = speed(random);
        gas.bodies.push_back(body);
    }
    return gas;
}

template <int D>
void measure(std::size_t number, double packing, Structure structure) {
    constexpr int rounds = 7;
    const Gas<D> gas = on_lattice<D>(number, packing);
    const auto settling = std::max<std::uint64_t>(10 * number, 200'000);
    const auto strikes = std::max<std::uint64_t>(number, 200'000);
    const motion::State<D> start = motion::start<D>(gas.bodies, gas.effects);
    const double before = bytes_taken();
    motion::Simulation<D> exact(start, gas.effects, {structure, Kernel::exact});
    exact.run({.strikes = settling});
    const double bytes = (bytes_taken() - before) / static_cast<double>(number);
    motion::Simulation<D> naive(exact.state(), gas.effects, {structure, Kernel::naive});
    naive.run({.strikes = number});
    const auto rate_of = [strikes](motion::Simulation<D>& simulation) {
        return static_cast<double>(strikes) /
               seconds_of([&] { simulation.run({.strikes = strikes}); }) * 1e-6;
    };
    Turns rates;
    for (int round = 0; round < rounds; ++round) {
        const double rate = rate_of(exact);
        rates.add(rate, rate_of(naive));
    }
    const motion::Counts& counts = exact.counts();
    fmt::print("| {} | {} | {} | {:.2f} | {:.2f} | {:.2f} | {:.0f} | {:.1f} | {:.2f} |\n",
               D == 2 ? "discs" : "spheres", packing, number, median(rates.first),
               median(rates.second), median(rates.ratios), bytes,
               static_cast<double>(counts.checks) / static_cast<double>(counts.strikes),
               static_cast<double>(counts.own) / static_cast<double>(counts.strikes));
    std::fflush(stdout);
}

/// Discs at rest on a square lattice, all coordinates small integers, one of which is sent along
/// an axis and the others' rows in turn: nothing but ties, and touches that are no strikes.
Gas<2> lattice_at_rest(std::size_t number) {
    Gas<2> gas;
    gas.effects.box.emplace();
    gas.effects.periodic = true;
    const auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(number)));
    gas.effects.box->high = {static_cast<double>(2 * side), static_cast<double>(2 * side)};
    for (std::size_t i = 0; i < side; ++i)
        for (std::size_t j = 0; j < side; ++j)
            gas.bodies.push_back({{static_cast<double>(2 * i + 1), static_cast<double>(2 * j + 1)},
                                  {0.0, j == 0 ? 1.0 : 0.0},
                                  0.5,
                                  1.0});
    return gas;
}

/// From the start on: exact / doubles, time.
template <int D>
double ratio_from_start(const Gas<D>& gas, std::uint64_t strikes, Structure structure) {
    std::vector<double> ratios;
    for (int round = 0; round < 7; ++round) {
        const auto time_of = [&](Kernel kernel) {
            return seconds_of([&] {
                motion::Simulation<D> simulation(motion::start<D>(gas.bodies, gas.effects),
                                                 gas.effects, {structure, kernel});
                simulation.run({.strikes = strikes});
            });
        };
        const double exact = time_of(Kernel::exact);
        ratios.push_back(exact / time_of(Kernel::naive));
    }
    return median(ratios);
}

}  // namespace
}  // namespace signum::benchmarks

int main(int count, char** words) {
    using namespace signum;
    using benchmarks::on_lattice;
    using benchmarks::ratio_from_start;
    const std::size_t most = count > 1 ? std::strtoul(words[1], nullptr, 10) : 1'000'000;
    const std::string_view name = count > 2 ? words[2] : "lists";
    const auto structure = motion::structure_named(name);
    if (!structure) return 2;
    // So that the program itself lies in memory.
    static_cast<void>(ratio_from_start(on_lattice<3>(500, 0.25), 1000, *structure));
    static_cast<void>(ratio_from_start(on_lattice<2>(500, 0.25), 1000, *structure));
    fmt::print(
        "| balls | packing | number | million strikes a second | in doubles | exact / "
        "doubles, time | bytes a ball | pairs asked a strike | structure's events a strike "
        "|\n| --- | --: | --: | --: | --: | --: | --: | --: | --: |\n");
    for (const std::size_t number : {4000UL, 32'000UL, 1'000'000UL})
        for (const double packing : {0.25, 0.49})
            if (number <= most) benchmarks::measure<3>(number, packing, *structure);
    for (const std::size_t number : {1000UL, 4096UL, 10'000UL, 100'000UL, 1'000'000UL})
        for (const double packing : {0.25, 0.5})
            if (number <= most) benchmarks::measure<2>(number, packing, *structure);
    fmt::print("\nfrom the start on, exact / doubles, time:\n");
    fmt::print("spheres on a face-centred lattice: {:.2f}\n",
               ratio_from_start(on_lattice<3>(4000, 0.49), 100'000, *structure));
    fmt::print("discs on a triangular lattice: {:.2f}\n",
               ratio_from_start(on_lattice<2>(4096, 0.5), 100'000, *structure));
    fmt::print("discs at rest on a square lattice, rows struck at once: {:.2f}\n",
               ratio_from_start(benchmarks::lattice_at_rest(4096), 100'000, *structure));
    return 0;
}
