/// A gas of discs in loops that do not know an effect, and in the library's, which knows all of
/// them and has none on: gas NAME LOG writes the log, gas NAME runs alone. Instructions are counted
/// by effects_cost.sh.

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <numbers>
#include <numeric>
#include <string_view>
#include <vector>

#include "../../../motion/loop.hpp"
#include "../../../motion/structures/lists.hpp"

namespace {

using namespace signum::motion;

constexpr int side = 20;
constexpr double radius = 0.5;
constexpr double packing = 0.5;

Effects<2> effects() {
    Effects<2> effects;
    const double length = side * std::sqrt(std::numbers::pi * radius * radius / packing);
    effects.box = Box<2>{{0.0, 0.0}, {length, length}};
    return effects;
}
State<2> gas(const Effects<2>& effects) {
    std::vector<Body<2>> bodies;
    std::uint64_t random = 2026;
    const auto speed = [&] {
        random = random * 6364136223846793005 + 1442695040888963407;
        return std::ldexp(static_cast<double>(random >> 11), -52) - 1.0;
    };
    const double step = effects.box->high[0] / side;
    for (int i = 0; i < side * side; ++i) {
        const double vx = speed();
        bodies.push_back(
            {{(i % side + 0.5) * step, (i / side + 0.5) * step}, {vx, speed()}, radius, 1.0});
    }
    return start<2>(bodies, effects);
}

template <Known known>
void run(std::FILE* log) {
    const Effects<2> of_gas = effects();
    const State<2> state = gas(of_gas);
    std::vector<std::int32_t> order(state.balls.size());
    std::iota(order.begin(), order.end(), 0);
    Loop<2, Lists, known> loop(Structure::lists, state, of_gas, Kernel::exact, order);
    double sum = 0.0;
    (void)loop.run({.strikes = 6000}, [&](const Strike& strike) {
        sum += strike.impulse;
        if (log != nullptr)
            std::fprintf(log, "%a %d %d %d %a\n", strike.time, static_cast<int>(strike.wall),
                         strike.a, strike.b, strike.impulse);
    });
    std::printf("%a\n", sum);
}

struct Row {
    std::string_view left_out;
    void (*run)(std::FILE* log);
};
constexpr Row rows[] = {
    {"none", run<Known{}>},
    {"walls", run<Known{.walls = false}>},
    {"speed_law", run<Known{.speed_law = false}>},
    {"contact_duration", run<Known{.contact_duration = false}>},
    {"friction", run<Known{.friction = false}>},
    {"growth", run<Known{.growth = false}>},
    {"time_steps", run<Known{.time_steps = false}>},
    {"contacts", run<Known{.contacts = false}>},
    {"all", run<Known{false, false, false, false, false, false, false}>},
};

}  // namespace

int main(int count, char** arguments) {
    for (const Row& row : rows) {
        if (count < 2 || row.left_out != arguments[1]) continue;
        std::FILE* const log = count > 2 ? std::fopen(arguments[2], "w") : nullptr;
        row.run(log);
        return log != nullptr && std::fclose(log) != 0 ? 3 : 0;
    }
    std::fputs("gas NAME [LOG]: say what to leave out, or none\n", stderr);
    return 2;
}
