/// The checks of a run: good of right records, not good of the same ones spoilt, not told of short
/// ones, and not there where what they expect does not hold.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "../../tool/scenes/beside_wall.hpp"
#include "../../tool/scenes/checks.hpp"
#include "../../tool/scenes/normal.hpp"
#include "io_scratch.hpp"

namespace signum {
namespace {

using motion::Body;
using motion::Box;
using motion::Counts;
using motion::Effects;
using motion::Simulation;
using motion::State;

/// What is done to a frame before it is recorded.
template <int D>
using Spoil = std::function<void(State<D>&, Counts&)>;

template <int D>
RunRecord<D> recorded(const State<D>& start, const Effects<D>& effects, double end, int frames,
                      const Spoil<D>& spoil = {}) {
    RunRecord<D> record(effects);
    Simulation<D> simulation(start, effects);
    for (int i = 0; i <= frames; ++i) {
        const double time = end * i / frames;
        (void)simulation.run({.until = time});
        State<D> state = simulation.state();
        Counts counts = simulation.counts();
        if (spoil) spoil(state, counts);
        record.add(state, time, counts);
    }
    return record;
}

/// Balls of radius 1/2 on a square or cubic lattice in a periodic box, with normal velocities.
template <int D>
struct Gas {
    Effects<D> effects;
    State<D> start;
    Gas(int side, double spacing, std::uint64_t seed) {
        Box<D> box;
        box.high.fill(side * spacing);
        effects.box = box;
        effects.periodic = true;
        Normal normal(seed);
        std::vector<Body<D>> bodies;
        const int count = D == 2 ? side * side : side * side * side;
        for (int i = 0; i < count; ++i) {
            Body<D> body;
            body.radius = 0.5;
            for (int k = 0, rest = i; k < D; ++k, rest /= side) {
                body.x[k] = (rest % side + 0.5) * spacing;
                body.v[k] = normal();
            }
            bodies.push_back(body);
        }
        start = motion::start<D>(bodies, effects);
    }
};

Judgement judgement(const std::optional<Check>& check) {
    EXPECT_TRUE(check.has_value());
    return check ? check->judgement : Judgement::not_told;
}
Judgement judgement(const std::vector<Check>& checks, std::string_view what) {
    for (const Check& check : checks)
        if (check.what == what) return check.judgement;
    ADD_FAILURE() << "no check " << what;
    return Judgement::not_told;
}

constexpr auto good = Judgement::good;
constexpr auto not_good = Judgement::not_good;
constexpr auto not_told = Judgement::not_told;

TEST(SceneChecks, EnergyAndMomentumStay) {
    const Gas<2> gas(12, 1.6, 1);
    const RunRecord<2> right = recorded<2>(gas.start, gas.effects, 20.0, 40);
    EXPECT_EQ(judgement(energy_is_conserved(right)), good);
    EXPECT_EQ(judgement(momentum_is_conserved(right)), good);
    // All speeds grow by a part in 10^11 a frame: the energy drifts.
    double factor = 1.0;
    const RunRecord<2> drifting =
        recorded<2>(gas.start, gas.effects, 20.0, 40, [&](State<2>& state, Counts&) {
            for (motion::Ball<2>& ball : state.balls)
                for (double& v : ball.v) v *= factor;
            factor += 1e-11;
        });
    EXPECT_EQ(judgement(energy_is_conserved(drifting)), not_good);
    EXPECT_EQ(judgement(momentum_is_conserved(drifting)), not_good);
}

TEST(SceneChecks, AreNotThereWhereWhatTheyExpectDoesNotHold) {
    Gas<2> gas(4, 1.6, 1);
    gas.effects.restitution = 0.9;
    const RunRecord<2> lossy = recorded<2>(gas.start, gas.effects, 1.0, 4);
    EXPECT_FALSE(energy_is_conserved(lossy));
    EXPECT_TRUE(momentum_is_conserved(lossy));
    EXPECT_FALSE(gas_has_known_pressure(lossy));
    EXPECT_FALSE(speeds_are_maxwellian(lossy));
    EXPECT_FALSE(heights_are_barometric(lossy));
    EXPECT_TRUE(heap_is_at_rest(lossy).empty());
    EXPECT_FALSE(fluid_carries_balls(lossy));
    // Nothing cools in so short a time.
    EXPECT_EQ(judgement(gas_cools_as_haff_says(lossy)), not_told);
    EXPECT_EQ(nothing_overlaps(lossy).size(), 1U);
    gas.effects.restitution = 1.0;
    gas.effects.periodic = false;
    const RunRecord<2> walled = recorded<2>(gas.start, gas.effects, 1.0, 4);
    EXPECT_TRUE(energy_is_conserved(walled));
    EXPECT_FALSE(momentum_is_conserved(walled));
    EXPECT_EQ(nothing_overlaps(walled).size(), 2U);
    gas.effects.obstacles.emplace_back(
        motion::HalfSpace<2>{.normal = {0.0, 1.0}, .offset = -9.0, .speed = 1.0});
    EXPECT_FALSE(energy_is_conserved(recorded<2>(gas.start, gas.effects, 1.0, 4)));
}

template <int D>
void expect_pressure(const Gas<D>& gas, double end) {
    const RunRecord<D> right = recorded<D>(gas.start, gas.effects, end, 60);
    const std::optional<Check> check = gas_has_known_pressure(right);
    EXPECT_EQ(judgement(check), good) << check->found << check->deviation;
    EXPECT_EQ(judgement(speeds_are_maxwellian(right)), good);
    // The virial a twentieth too large: of Z, more than the error and 0.5 %.
    const RunRecord<D> wrong = recorded<D>(gas.start, gas.effects, end, 60,
                                           [](State<D>&, Counts& c) { c.virial *= 1.05; });
    EXPECT_EQ(judgement(gas_has_known_pressure(wrong)), not_good);
    const RunRecord<D> few = recorded<D>(gas.start, gas.effects, 1.0, 4);
    EXPECT_EQ(judgement(gas_has_known_pressure(few)), not_told);
    EXPECT_EQ(judgement(speeds_are_maxwellian(few)), not_told);
}

TEST(SceneChecks, AGasOfDiscsHasItsPressureAndSpeeds) {
    expect_pressure<2>(Gas<2>(20, 1.6, 1), 160.0);
}

TEST(SceneChecks, AGasOfSpheresHasItsPressureAndSpeeds) {
    expect_pressure<3>(Gas<3>(7, 1.4, 1), 100.0);
}

/// A virial as it would be if Z were a given part of what Henderson says.
TEST(SceneChecks, OnePerCentOfPressureIsToldWhereItHasNoError) {
    const Gas<2> gas(16, 1.6, 1);
    constexpr double n = 256.0;
    double energy = 0.0;
    motion::Vector<2> momentum{};
    for (const motion::Ball<2>& ball : gas.start.balls) {
        energy += 0.5 * dot(ball.v, ball.v);
        for (int k = 0; k < 2; ++k) momentum[k] += ball.v[k];
    }
    // Of the motion relative to the mean, which has two degrees of freedom less.
    const double temperature = (energy - 0.5 * dot(momentum, momentum) / n) / (n - 1.0);
    const double eta = std::numbers::pi * 0.25 / (1.6 * 1.6);
    const double z = (1.0 + eta * eta / 8.0) / ((1.0 - eta) * (1.0 - eta));
    const auto judged = [&](double part) {
        RunRecord<2> record(gas.effects);
        for (int i = 0; i <= 40; ++i)
            record.add(gas.start, i, {.virial = (part * z - 1.0) * 2.0 * n * temperature * i});
        return judgement(gas_has_known_pressure(record));
    };
    EXPECT_EQ(judged(1.0), good);
    EXPECT_EQ(judged(1.004), good);
    EXPECT_EQ(judged(0.996), good);
    EXPECT_EQ(judged(1.01), not_good);
    EXPECT_EQ(judged(0.99), not_good);
}

/// Energies are right on the average and wrongly distributed: all have the same.
TEST(SceneChecks, EqualSpeedsAreNotMaxwellian) {
    const Gas<2> gas(16, 1.6, 1);
    const RunRecord<2> wrong =
        recorded<2>(gas.start, gas.effects, 60.0, 60, [](State<2>& state, Counts&) {
            for (std::size_t i = 0; i < state.balls.size(); ++i) {
                const double angle = static_cast<double>(i);
                state.balls[i].v = {{std::cos(angle), std::sin(angle)}};
            }
        });
    EXPECT_EQ(judgement(speeds_are_maxwellian(wrong)), not_good);
}

/// A record whose temperature falls as 1 / (1 + t)^exponent.
RunRecord<2> cooling(double exponent) {
    Gas<2> gas(8, 3.0, 1);
    gas.effects.restitution = 0.9;
    RunRecord<2> record(gas.effects);
    for (int i = 0; i <= 100; ++i) {
        State<2> state = gas.start;
        const double time = 0.1 * i;
        for (motion::Ball<2>& ball : state.balls)
            for (double& v : ball.v) v *= std::pow(1.0 + time, -0.5 * exponent);
        record.add(state, time, {});
    }
    return record;
}

TEST(SceneChecks, TheExponentOfCoolingIsFitted) {
    EXPECT_EQ(judgement(gas_cools_as_haff_says(cooling(2.0))), good);
    EXPECT_EQ(judgement(gas_cools_as_haff_says(cooling(5.0 / 3.0))), not_good);
    EXPECT_EQ(judgement(gas_cools_as_haff_says(cooling(2.4))), not_good);
}

/// Heights by the inverse of their distribution, and with another temperature than the speeds.
TEST(SceneChecks, HeightsAreBarometricAtTheTemperatureOfSpeeds) {
    Effects<2> effects;
    effects.gravity = {{0.0, -1.0}};
    effects.box = Box<2>{{{0.0, 0.0}}, {{10.0, 100.0}}};
    const auto record_of = [&](double temperature) {
        RunRecord<2> record(effects);
        Uniform uniform(7);
        Normal normal(7);
        for (int look = 0; look < 20; ++look) {
            State<2> state;
            for (int i = 0; i < 100; ++i) {
                motion::Ball<2> ball;
                ball.radius = 1e-4;
                ball.time = look;
                ball.x = {{10.0 * uniform(), 1e-4 - temperature * std::log(1.0 - uniform())}};
                ball.v = {{normal(), normal()}};
                state.balls.push_back(ball);
                state.masses.push_back(1.0);
            }
            record.add(state, look, {.strikes = static_cast<std::uint64_t>(look) * 2000});
        }
        return record;
    };
    EXPECT_EQ(judgement(heights_are_barometric(record_of(1.0))), good);
    EXPECT_EQ(judgement(heights_are_barometric(record_of(1.3))), not_good);
}

/// Grains on a floor of fixed discs, as they have come to rest.
TEST(SceneChecks, AHeapRestsAndPresses) {
    Effects<2> effects;
    effects.gravity = {{0.0, -10.0}};
    effects.restitution = effects.wall_restitution = 0.2;
    effects.friction = motion::Friction{0.5, 0.5, 0.0, 0.5};
    effects.contacts = motion::LastingContacts{0.2, 1e-8, 200};
    effects.time_step = 0.01;
    for (int i = -25; i <= 25; ++i)
        effects.obstacles.emplace_back(
            motion::Sphere<2>{.centre = {{1.3 * i, 0.0}}, .radius = 0.5});
    std::vector<Body<2>> bodies;
    Uniform uniform(3);
    for (int i = 0; i < 40; ++i) {
        const double r = 0.4 + 0.2 * uniform();
        bodies.push_back(
            {{{(i % 6 - 2.5) * 1.25 + 0.02 * uniform(), 1.7 + 1.25 * (i / 6)}}, {}, r, r * r});
    }
    const State<2> start = motion::start<2>(bodies, effects);
    constexpr auto rest = "all has come to rest";
    constexpr auto weight = "the walls bear the weight";
    constexpr auto slope = "the heap is not steeper than friction holds";
    constexpr auto apart = "no two balls overlap";
    const RunRecord<2> right = recorded<2>(start, effects, 20.0, 40);
    const std::vector<Check> checks = check_run(right);
    for (const auto* const what : {rest, weight, slope, apart})
        EXPECT_EQ(judgement(checks, what), good) << what;
    // Falling: nothing rests, and what bears what is not told.
    const std::vector<Check> falling = check_run(recorded<2>(start, effects, 1.0, 40));
    EXPECT_NE(judgement(falling, rest), good);
    EXPECT_EQ(judgement(falling, weight), not_told);
    // The end of the right one, spoilt.
    const auto spoilt = [&](const std::function<void(State<2>&)>& spoil) {
        RunRecord<2> record(effects);
        State<2> state = right.end();
        spoil(state);
        for (int i = 0; i <= 40; ++i) record.add(state, 20.0 + i, {});
        return check_run(record);
    };
    EXPECT_EQ(judgement(spoilt([](State<2>& s) {
                            for (auto& contact : s.contacts) contact.push *= 1.01;
                        }),
                        weight),
              not_good);
    EXPECT_EQ(judgement(spoilt([](State<2>& s) { s.balls[7].v[0] = 0.1; }), rest), not_good);
    EXPECT_EQ(judgement(spoilt([](State<2>& s) {
                            for (auto& ball : s.balls) ball.x[0] *= 0.3;
                        }),
                        slope),
              not_good);
}

TEST(SceneChecks, AFluidCarriesBallsThatAreAlone) {
    Effects<2> effects;
    effects.fluid = motion::Fluid<2>{.velocity = {{2.0, 0.0}}, .linear = 1.0};
    effects.time_step = 0.05;
    std::vector<Body<2>> bodies;
    for (int i = 0; i < 8; ++i) bodies.push_back({{{10.0 * i, 5.0 * (i % 3)}}, {}, 1.0, 1.0});
    const State<2> start = motion::start<2>(bodies, effects);
    EXPECT_EQ(judgement(fluid_carries_balls(recorded<2>(start, effects, 10.0, 10))), good);
    EXPECT_EQ(judgement(fluid_carries_balls(recorded<2>(start, effects, 1.0, 10))), not_told);
    const auto judged_when = [&](const Spoil<2>& spoil) {
        return judgement(fluid_carries_balls(recorded<2>(start, effects, 10.0, 10, spoil)));
    };
    EXPECT_EQ(judged_when([](State<2>& s, Counts&) {
                  for (auto& ball : s.balls) ball.v[0] = -ball.v[0];
              }),
              not_good);
    EXPECT_EQ(judged_when([](State<2>& s, Counts&) {
                  for (auto& ball : s.balls) std::swap(ball.v[0], ball.v[1]);
              }),
              not_good);
    // Who was near another one on the way may not have got there yet.
    EXPECT_EQ(judged_when([](State<2>& s, Counts&) {
                  if (s.time < 8.0)
                      for (auto& ball : s.balls) ball.x[0] *= 0.1;
              }),
              not_told);
    bodies.resize(3);
    const State<2> three = motion::start<2>(bodies, effects);
    EXPECT_EQ(judgement(fluid_carries_balls(recorded<2>(three, effects, 10.0, 10))), not_told);
}

/// A ball moved by a thousandth of its radius into another, across a side of the box, and out of
/// it.
TEST(SceneChecks, NothingOverlaps) {
    constexpr auto balls = "no two balls overlap";
    constexpr auto walls = "no ball is in a wall, or outside";
    Effects<2> effects;
    effects.box = Box<2>{{{0.0, 0.0}}, {{10.0, 10.0}}};
    const auto at = [&](double x, double y) {
        State<2> state;
        state.balls = {{{{x, y}}, {}, 1.0, 0.0}, {{{9.0, 5.0}}, {}, 1.0, 0.0}};
        state.masses = {1.0, 1.0};
        RunRecord<2> record(effects);
        record.add(state, 0.0, {});
        return nothing_overlaps(record);
    };
    EXPECT_EQ(judgement(at(7.0, 5.0), balls), good);
    EXPECT_EQ(judgement(at(7.001, 5.0), balls), not_good);
    EXPECT_EQ(judgement(at(1.0, 5.0), walls), good);
    EXPECT_EQ(judgement(at(0.999, 5.0), walls), not_good);
    EXPECT_EQ(judgement(at(5.0, 20.0), walls), not_good);
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(judgement(at(nan, 5.0), balls), not_good);
    EXPECT_EQ(judgement(at(nan, 5.0), walls), not_good);
    effects.periodic = true;
    EXPECT_EQ(judgement(at(1.0, 5.0), balls), good);
    EXPECT_EQ(judgement(at(0.999, 5.0), balls), not_good);
}

/// Of each kind of wall the distance of the surface and the direction away from it.
TEST(BesideWall, TellsDistanceAndNormal) {
    Effects<2> effects;
    effects.box = Box<2>{{{0.0, 0.0}}, {{10.0, 10.0}}};
    effects.obstacles = {
        motion::HalfSpace<2>{.normal = {{0.0, 2.0}}, .offset = 2.0, .speed = 2.0},
        motion::Sphere<2>{.centre = {{0.0, 0.0}}, .velocity = {{1.0, 0.0}}, .radius = 1.0},
        motion::Sphere<2>{
            .centre = {{0.0, 0.0}}, .radius = 9.0, .side = motion::Sphere<2>::Side::inside},
        motion::Segment{.from = {{2.0, 0.0}}, .to = {{4.0, 0.0}}}};
    const auto expect = [&](int wall, double x, double y, double time, double distance,
                            motion::Vector<2> normal) {
        const BesideWall<2> found = beside_wall<2>(effects, wall, {{x, y}}, time);
        EXPECT_DOUBLE_EQ(found.distance, distance) << wall;
        for (int k = 0; k < 2; ++k) EXPECT_DOUBLE_EQ(found.normal[k], normal[k]) << wall;
    };
    expect(1, 7.0, 5.0, 0.0, 3.0, {{-1.0, 0.0}});
    expect(2, 7.0, 5.0, 0.0, 5.0, {{0.0, 1.0}});
    expect(4, 7.0, 5.0, 3.0, 1.0, {{0.0, 1.0}});
    expect(5, 5.0, 0.0, 2.0, 2.0, {{1.0, 0.0}});
    expect(6, 0.0, 5.0, 0.0, 4.0, {{0.0, -1.0}});
    expect(7, 7.0, 4.0, 0.0, 5.0, {{0.6, 0.8}});
    expect(7, 3.0, -2.0, 0.0, 2.0, {{0.0, -1.0}});
}

}  // namespace
}  // namespace signum
