/// The logs and last states of fixed scenes, as hashes: whoever changes the house must not move a
/// byte of them. They go through every effect, every structure and both dimensions; the scenes are
/// the same with every standard library.
///
/// A change that is meant to change logs is recorded anew: the test prints what it found.

#include <array>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "harsh_scenes.hpp"

namespace signum::motion {
namespace {

/// FNV-1a, over the bytes of words, the least first.
class Hash {
 public:
    void take(std::uint64_t word) noexcept {
        for (int byte = 0; byte < 8; ++byte)
            value_ = (value_ ^ (word >> 8 * byte & 0xff)) * 0x100000001b3U;
    }
    void take(double x) noexcept { take(std::bit_cast<std::uint64_t>(x)); }
    void take(std::int32_t x) noexcept { take(static_cast<std::uint64_t>(x)); }
    void take(std::uint32_t x) noexcept { take(std::uint64_t{x}); }
    template <class T, std::size_t n>
    void take(const std::array<T, n>& all) noexcept {
        for (const T& each : all) take(each);
    }
    template <class Numbers>
    void take_all(const Numbers& numbers) noexcept {
        for (const auto& each : numbers) take(each);
    }
    void take(const Strike& strike) noexcept {
        take(strike.time);
        take(std::int32_t{strike.wall});
        take(strike.a);
        take(strike.b);
        take(strike.impulse);
    }
    /// But for its time, which structures that do not know that nothing meets any more go on to.
    template <int D>
    void take(const State<D>& state) noexcept {
        for (const Ball<D>& ball : state.balls) {
            take_all(ball.x);
            take_all(ball.v);
            take(ball.radius);
            take(ball.time);
        }
        take_all(state.masses);
        take_all(state.in_place);
        for (const Passed& passed : state.passed) {
            take(passed.a);
            take(passed.b);
            take(passed.time);
        }
        for (const Spin<D>& spin : state.spins) take_all(spin.values);
        take_all(state.last_strikes);
        for (const Pressed& pressed : state.pressed) {
            take(pressed.ball);
            take(pressed.strikes);
            take(std::uint32_t{pressed.by_wall});
            take(pressed.half);
            take(pressed.quarter);
            take(pressed.last);
        }
        for (const StandingContact<D>& contact : state.contacts) {
            take(contact.a);
            take(contact.b);
            take(contact.push);
            take_all(contact.rub);
        }
        take(state.half_steps);
    }
    [[nodiscard]] std::uint64_t value() const noexcept { return value_; }

 private:
    std::uint64_t value_ = 0xcbf29ce484222325U;
};

/// Half of the strikes in one run, and the others in one that goes on from its state. A structure
/// whose clock is too coarse says so, and nothing is taken.
template <int D>
void take(Hash& hash, const Scene<D>& scene, const Options& options, std::uint64_t strikes) {
    if (scene.bodies.empty()) return;
    Hash taken = hash;
    int asked = 0;
    const Limits limits{
        .until = 4.0, .strikes = strikes / 2, .stop = [&] { return ++asked > 400; }};
    const auto record = [&](const Strike& strike) { taken.take(strike); };
    try {
        State<D> state = start<D>(scene.bodies, scene.effects);
        for (int run = 0; run < 2; ++run) {
            Simulation<D> simulation(state, scene.effects, options);
            taken.take(simulation.run(limits, record).ending == Ending::collapse ? 1 : 0);
            taken.take(simulation.counts().strikes);
            state = simulation.state();
        }
        taken.take(state);
        hash = taken;
    } catch (const std::range_error&) {
        hash.take(std::int32_t{-1});
    }
}

/// A gas whose velocities are the same with every standard library.
template <int D>
Scene<D> even_gas(std::uint64_t seed, bool is_periodic) {
    Scene<D> scene = struck_lattice<D>(D == 2 ? 64 : 125, 0.35);
    scene.bodies.pop_back();
    scene.effects.box = cube<D>(D == 2 ? 8.0 : 5.0);
    scene.effects.periodic = is_periodic;
    Choices choose(seed);
    for (Body<D>& body : scene.bodies)
        for (double& v : body.v) v = choose.number(-2.0, 2.0);
    return scene;
}

struct Row {
    std::string name;
    std::uint64_t hash;
};

template <int D>
void expect_hashes(const std::vector<Row>& rows) {
    constexpr std::uint64_t seeds = 6;
    using Scenes = std::vector<Scene<D>>;
    std::vector<std::pair<std::string, Scenes>> groups = {
        {"gas", {even_gas<D>(1, false), even_gas<D>(2, true)}},
        {"lattice", {struck_lattice<D>(36, 0.5), struck_lattice<D>(36, 0.375)}},
        {"cradle, grazing", {cradle<D>(20), grazing<D>(40)}}};
    for (int effect = 0; effect < effects_in_all; ++effect) {
        Scenes scenes;
        for (std::uint64_t seed = 0; seed < seeds; ++seed)
            scenes.push_back(effects_scene<D>(100 * seed + static_cast<std::uint64_t>(effect),
                                              {static_cast<Effect>(effect)}));
        groups.emplace_back(name_of(static_cast<Effect>(effect)), scenes);
    }
    Scenes harsh;
    for (std::uint64_t seed = 0; seed < 8 * seeds; ++seed) harsh.push_back(harsh_scene<D>(seed));
    groups.emplace_back("every mixture", harsh);

    ASSERT_EQ(rows.size(), groups.size());
    for (std::size_t g = 0; g < groups.size(); ++g) {
        const auto& [name, scenes] = groups[g];
        EXPECT_EQ(name, rows[g].name);
        Hash hash;
        for (const Scene<D>& scene : scenes) {
            for (const Structure structure : all_structures) take(hash, scene, {structure}, 400);
            take(hash, scene, {Structure::automatic, Kernel::naive}, 400);
        }
        std::array<char, 32> found;
        std::snprintf(found.data(), found.size(), "0x%016llx",
                      static_cast<unsigned long long>(hash.value()));
        EXPECT_EQ(hash.value(), rows[g].hash) << '"' << name << "\", " << found.data();
    }
}

TEST(MotionHashes, InThePlane) {
    expect_hashes<2>({
        {"gas", 0xe238451101e6e7f8},
        {"lattice", 0x5569dd9f4fcaf0f8},
        {"cradle, grazing", 0x2a2acd27ceab36fd},
        {"gravity", 0x5270390c813d69d3},
        {"losses", 0x56517cb2f32d6e3a},
        {"speed law", 0xfe73fc7915c3c167},
        {"contact duration", 0x23de8dd5b8a1bee6},
        {"friction", 0x899d3bfadb0ee630},
        {"shake", 0x67d9f1db11a1c420},
        {"obstacles", 0xf4b67444ea5b7e79},
        {"growth", 0x7d0e0c684a03c075},
        {"fluid", 0x794c49e23e45b168},
        {"time steps", 0x767de456f3f5891d},
        {"contacts", 0x1875374a0520b8c9},
        {"every mixture", 0x5acab2d6dbc39f9c},
    });
}

TEST(MotionHashes, InSpace) {
    expect_hashes<3>({
        {"gas", 0xda7bd458a1cf4a42},
        {"lattice", 0x009c5e17c5b5acc3},
        {"cradle, grazing", 0x77cbba5e4bd6ecbd},
        {"gravity", 0x7c82e4c77a95ebf3},
        {"losses", 0xaaa3428317d6531e},
        {"speed law", 0x1d8f359a8eed68b4},
        {"contact duration", 0x2dfdaa3191ac82bf},
        {"friction", 0xdd5051fc2e227dc9},
        {"shake", 0xb0ba3b70df382f8e},
        {"obstacles", 0x7bba08450add1e84},
        {"growth", 0x9e126b9520c77c42},
        {"fluid", 0xd74c5bbb7d7c580f},
        {"time steps", 0x9ad23e615e5fdd5c},
        {"contacts", 0x6643a0f2ef7e53a7},
        {"every mixture", 0xf4c6fe9d328b94e},
    });
}

}  // namespace
}  // namespace signum::motion
