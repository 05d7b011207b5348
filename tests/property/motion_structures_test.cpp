/// All structures write one log, byte for byte, on scenes that are meant to break it; and what the
/// log says is physics.

#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "motion_scenes.hpp"

namespace signum::motion {
namespace {

const std::uint64_t thoroughness = is_fast ? 10 : 1;

struct Recorded {
    std::vector<Strike> log;
    Outcome outcome;
    Counts counts;
    double time = 0.0;
};

template <int D>
Recorded run(const Scene<D>& scene, Structure structure, const Limits& limits) {
    Simulation<D> simulation(start<D>(scene.bodies, scene.effects), scene.effects, {structure});
    Recorded result;
    result.outcome =
        simulation.run(limits, [&](const Strike& strike) { result.log.push_back(strike); });
    result.counts = simulation.counts();
    result.time = simulation.state().time;
    return result;
}
template <int D>
Recorded run(const Scene<D>& scene, Structure structure, std::uint64_t strikes) {
    return run(scene, structure, Limits{.strikes = strikes});
}

/// By all structures, that of `pairs`; not all can tell that nothing meets any more.
template <int D>
void expect_one_log(const Scene<D>& scene, const Limits& limits) {
    SCOPED_TRACE(scene.name + (D == 2 ? ", plane" : ", space"));
    const Recorded expected = run(scene, Structure::pairs, limits);
    for (const Structure structure : all_structures) {
        if (structure == Structure::automatic || structure == Structure::pairs) continue;
        SCOPED_TRACE(name_of(structure));
        const Recorded other = run(scene, structure, limits);
        const bool is_over =
            expected.outcome.ending == Ending::nothing || expected.outcome.ending == Ending::until;
        if (is_over && other.outcome.ending != Ending::nothing) {
            EXPECT_EQ(other.outcome.ending, Ending::until);
        } else if (!is_over) {
            EXPECT_EQ(other.outcome.ending, expected.outcome.ending);
        }
        ASSERT_EQ(other.log.size(), expected.log.size());
        for (std::size_t i = 0; i < other.log.size(); ++i)
            ASSERT_EQ(other.log[i], expected.log[i]) << "strike " << i;
    }
}
/// The same, and there are strikes.
template <int D>
void expect_one_long_log(const Scene<D>& scene, const Limits& limits, std::size_t least) {
    ASSERT_GE(run(scene, Structure::pairs, limits).log.size(), least) << scene.name;
    ASSERT_NO_FATAL_FAILURE(expect_one_log(scene, limits));
}
template <int D>
void expect_one_log_of_all_scenes(std::size_t balls, std::uint64_t strikes) {
    for (const Scene<D>& scene : all_scenes<D>(balls)) {
        // There all flips are tied with others at times that are no doubles: 10 ms a strike.
        const bool is_tied = D == 2 && scene.name == "grazing";
        ASSERT_NO_FATAL_FAILURE(
            expect_one_long_log(scene, {.strikes = is_tied ? strikes / 8 : strikes}, 1));
    }
}

TEST(MotionStructures, AllWriteOneLogInThePlane) {
    expect_one_log_of_all_scenes<2>(100, 300 * thoroughness);
}
TEST(MotionStructures, AllWriteOneLogInSpace) {
    expect_one_log_of_all_scenes<3>(125, 300 * thoroughness);
}

/// Large balls and small ones, on all grounds: cells of several sizes that have an end, or none, or
/// go around.
template <int D>
void expect_one_log_of_many_sizes(std::size_t balls) {
    Scene<D> scene = radii<D>(balls, 8);
    scene.effects.gravity[0] = 0.25;
    scene.name = "radii 1 : 10^6, falling";
    ASSERT_NO_FATAL_FAILURE(expect_one_long_log(scene, {.strikes = 300 * thoroughness}, 100));
    scene = radii<D>(balls, 9);
    scene.effects.periodic = true;
    scene.name = "radii 1 : 10^6, periodic";
    ASSERT_NO_FATAL_FAILURE(expect_one_long_log(scene, {.strikes = 300 * thoroughness}, 100));
    const Scene<D> shrinking = meeting_place<D>(balls, 10);
    scene.effects = shrinking.effects;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) scene.bodies[i].v = shrinking.bodies[i].v;
    scene.name = "radii 1 : 10^6, without a box";
    expect_one_long_log(scene, {.strikes = 300 * thoroughness}, 50);
}
/// Discs that strike one another across the short side of a periodic box.
TEST(MotionStructures, ALongPeriodicBoxWritesOneLog) {
    for (const double length : {0x1p10, 0x1p11, 0x1p17, 0x1p30}) {
        std::mt19937_64 random(82);
        Scene<2> scene{"a box as long as " + std::to_string(length), {}, {}};
        scene.effects.box = Box<2>{{0.0, 0.0}, {length, 1.0}};
        scene.effects.periodic = true;
        for (int i = 0; i < 48; ++i) {
            const double y = static_cast<double>(random() % 64) / 64.0;
            const double speed = static_cast<double>(random() % 65) / 32.0 - 1.0;
            scene.bodies.push_back({{0.25 + 0.5 * i, y}, {0.25, speed}, 0.125, 1.0});
            scene.bodies.push_back(
                {{0.25 + 0.5 * i, y < 0.5 ? y + 0.5 : y - 0.5}, {0.25, -speed}, 0.125, 1.0});
        }
        ASSERT_NO_FATAL_FAILURE(expect_one_long_log(scene, {.strikes = 150 * thoroughness}, 100));
    }
}

TEST(MotionStructures, DiscsOfManySizesWriteOneLog) {
    expect_one_log_of_many_sizes<2>(100);
}
TEST(MotionStructures, BallsOfManySizesWriteOneLog) {
    expect_one_log_of_many_sizes<3>(125);
}

/// A flip may be isolated by an interval that is as long as the flight: it is not due at its
/// begin.
TEST(MotionStructures, DiscsNearlyInARowWriteOneLog) {
    Scene<2> scene{"nearly in a row", {}, {}};
    scene.effects.box = cube<2>(16.0);
    scene.effects.gravity = {0.0, -3.0};
    scene.bodies = {{{3.0, 5.0}, {0, 0}, 0.25, 0.0625},
                    {{5.0, 5.0}, {-1, 0}, 0.25, 1.0},
                    {{2.0, 5.0}, {0, 0}, 0.25, 0.0625},
                    {{4.0, 5.0}, {-1, 0}, 0.5, 1.0},
                    {{1.0, 5.0}, {-1, 0}, 0.5, 1.0}};
    expect_one_long_log(scene, {.until = 0x1.720c77761a474p+0}, 26);
}

/// A row of discs stays one, whichever way it lies: no face, and every event builds it anew.
TEST(MotionStructures, ARowOfDiscsWritesOneLog) {
    constexpr Vector<2> ways[] = {{1.0, 0.0}, {0.0, 1.0}, {1.0, 1.0}, {-3.0, 4.0}};
    for (const Vector<2>& way : ways) {
        for (const bool falls : {false, true}) {
            for (const bool in_a_ring : {false, true}) {
                const bool along_an_axis = way[0] * way[1] == 0.0;
                if (in_a_ring && (falls || !along_an_axis)) continue;
                std::mt19937_64 random(81);
                Scene<2> scene{"a row", {}, {}};
                const double length = std::sqrt(dot(way, way));
                for (int i = 0; i < 24; ++i) {
                    // Powers of two keep places and speeds on the line.
                    const double place = 2.0 * i;
                    const double speed = static_cast<double>(random() % 33) / 16.0 - 1.0;
                    scene.bodies.push_back({{place * way[0], place * way[1]},
                                            {speed * way[0], speed * way[1]},
                                            0.25 * length,
                                            1.0});
                }
                if (falls) {
                    scene.effects.gravity = {0.5, -0.75};
                } else if (along_an_axis) {
                    scene.effects.box = cube<2>(48.0);
                    scene.effects.periodic = in_a_ring;
                    for (Body<2>& body : scene.bodies)
                        for (int k = 0; k < 2; ++k) body.x[k] += way[k] == 0.0 ? 7.0 : 0.5;
                }
                // Without a box they strike until they are in order.
                ASSERT_NO_FATAL_FAILURE(
                    expect_one_long_log(scene, {.until = 40.0, .strikes = 60 * thoroughness}, 20));
            }
        }
    }
}

/// A periodic box in which discs stand on its borders and corners, and all but one stand still, fly
/// together, or fall.
TEST(MotionStructures, APeriodicBoxWritesOneLogWhereNothingMovesOrAllDo) {
    constexpr int side = 6;
    Scene<2> still{"discs on the border that stand still", {}, {}};
    still.effects.box = cube<2>(side);
    still.effects.periodic = true;
    // Places 0, which is also `side`, in both of its names.
    for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j) {
            const bool other_name = (i + j) % 2 == 0;
            const auto place = [&](int k) { return k == 0 && other_name ? side : 1.0 * k; };
            still.bodies.push_back({{place(i), place(j)}, {}, 0.3, 1.0});
        }
    const auto with = [&](const char* name, const auto& change) {
        Scene<2> scene = still;
        scene.name = name;
        change(scene);
        return scene;
    };
    const auto one_flies = [](Scene<2>& scene) { scene.bodies[7].v = {1.0, 0.375}; };
    const auto all_fly = [](Scene<2>& scene) {
        for (Body<2>& body : scene.bodies)
            for (int k = 0; k < 2; ++k) body.v[k] += k == 0 ? 3.0 : -1.25;
    };
    const auto all_fall = [](Scene<2>& scene) { scene.effects.gravity = {0.0, -2.0}; };
    const auto along_an_axis = [](Scene<2>& scene) {
        for (Body<2>& body : scene.bodies) body.v[0] = 1.0;
    };
    const Limits until{.until = 7.0};
    const Limits strikes{.strikes = 200};
    // Nothing meets; in lines of copies that stand on the border, all is tied for ever.
    for (const Scene<2>& scene :
         {still, with("all fly together", all_fly), with("all fly along an axis", along_an_axis),
          with("all fall together", all_fall)}) {
        ASSERT_NO_FATAL_FAILURE(expect_one_log(scene, until));
        EXPECT_TRUE(run(scene, Structure::pairs, until).log.empty()) << scene.name;
    }
    for (const Scene<2>& scene : {with("one flies", one_flies),
                                  with("one flies, and all together",
                                       [&](Scene<2>& s) {
                                           one_flies(s);
                                           all_fly(s);
                                       }),
                                  with("one flies, and all fall", [&](Scene<2>& s) {
                                      one_flies(s);
                                      all_fall(s);
                                  })})
        ASSERT_NO_FATAL_FAILURE(expect_one_long_log(scene, strikes, 200));
    Scene<2> wide = gas<2>(49, true, 82);
    wide.effects.gravity = {0.5, -1.0};
    wide.name = "a gas that falls for ever";
    ASSERT_NO_FATAL_FAILURE(expect_one_long_log(wide, {.strikes = 100 * thoroughness}, 100));
}

/// No disc, one, two and three, in every world.
TEST(MotionStructures, FewDiscsWriteOneLog) {
    const std::vector<Body<2>> bodies = {{{0.0, 4.0}, {1.0, 0.7}, 0.5, 1.0},
                                         {{8.0, 6.0}, {-0.5, -0.25}, 1.0, 2.0},
                                         {{3.0, 0.0}, {0.25, 1.0}, 0.5, 1.0}};
    for (std::size_t count = 0; count <= bodies.size(); ++count) {
        SCOPED_TRACE(count);
        Scene<2> scene{"free", {bodies.begin(), bodies.begin() + static_cast<int>(count)}, {}};
        const Limits until{.until = 50.0};
        ASSERT_NO_FATAL_FAILURE(expect_one_log(scene, until));
        ASSERT_NO_FATAL_FAILURE(expect_one_log(scene, {}));
        scene.effects.box = Box<2>{{0.0, 0.0}, {8.0, 8.0}};
        scene.effects.periodic = true;
        scene.name = "periodic";
        ASSERT_NO_FATAL_FAILURE(expect_one_long_log(scene, until, count < 2 ? 0 : 3));
        scene.effects.gravity = {0.125, -0.25};
        scene.name = "periodic and falling";
        ASSERT_NO_FATAL_FAILURE(expect_one_long_log(scene, until, count < 2 ? 0 : 3));
        scene.effects = {};
        scene.effects.box = Box<2>{{-1.0, -1.0}, {9.0, 9.0}};
        scene.name = "walls";
        ASSERT_NO_FATAL_FAILURE(expect_one_long_log(scene, until, 3 * count));
    }
}

/// Points and tiny discs in a periodic box, two and three: nothing but rounding keeps their
/// projections apart.
TEST(MotionStructures, FewPointsInAPeriodicBoxWriteOneLog) {
    for (const double radius : {0.0, 0x1p-26, 0x1p-17}) {
        for (std::uint64_t seed = 0; seed < 20; ++seed) {
            SCOPED_TRACE(testing::Message() << "radius " << radius << ", seed " << seed);
            std::mt19937_64 random(seed);
            const auto unit = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
            Scene<2> scene{"points", {}, {}};
            for (std::uint64_t i = 0; i < 2 + seed % 2; ++i)
                scene.bodies.push_back({{2.0 * unit(), seed % 4 == 0 ? 1.25 : 2.0 * unit()},
                                        {3.0 * unit() - 1.5, seed % 3 == 0 ? 0.0 : unit() - 0.5},
                                        radius,
                                        1.0});
            scene.effects.box = Box<2>{{0.0, 0.0}, {2.0, 2.0}};
            scene.effects.periodic = true;
            ASSERT_NO_FATAL_FAILURE(expect_one_log(scene, {.until = 50.0}));
        }
    }
}

/// What a record or a stop throws comes out of the run, and the log goes on without a gap.
TEST(MotionStructures, WhatARecordOrAStopThrowsLosesNothing) {
    struct Thrown {};
    for (Scene<2> scene : {gas<2>(64, false, 83), falling<2>(64, 84), gas<2>(64, true, 85)}) {
        scene.bodies.front().mass = 3.0;
        const Recorded expected = run(scene, Structure::lists, 6000);
        for (const Structure structure : {Structure::lists, Structure::delaunay}) {
            SCOPED_TRACE(scene.name + ", " + std::string(name_of(structure)));
            Simulation<2> simulation(start<2>(scene.bodies, scene.effects), scene.effects,
                                     {structure});
            std::vector<Strike> log;
            std::uint64_t told = 0;
            std::uint64_t thrown = 0;
            while (log.size() < expected.log.size()) {
                try {
                    simulation.run({.strikes = expected.log.size() - log.size(),
                                    .stop = [&]() -> bool { throw Thrown(); }},
                                   [&](const Strike& strike) {
                                       if (told < 350 && ++told % 7 == 0) throw Thrown();
                                       log.push_back(strike);
                                   });
                } catch (const Thrown&) {
                    ++thrown;
                }
                ASSERT_EQ(simulation.counts().strikes, log.size());
            }
            // Once more by the stop at least.
            EXPECT_GT(thrown, 50U);
            ASSERT_EQ(log.size(), expected.log.size());
            for (std::size_t i = 0; i < log.size(); ++i)
                ASSERT_EQ(log[i], expected.log[i]) << "strike " << i;
        }
    }
}

/// Balls in another order strike the same, renumbered, for no two times are equal.
TEST(MotionStructures, RenumberedBallsStrikeTheSame) {
    const Scene<2> scene = gas<2>(100, false, 11);
    std::vector<std::size_t> order(scene.bodies.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::shuffle(order.begin(), order.end(), std::mt19937_64(5));
    Scene<2> shuffled = scene;
    for (std::size_t i = 0; i < order.size(); ++i) shuffled.bodies[i] = scene.bodies[order[i]];
    const Recorded one = run(scene, Structure::lists, 5000);
    Recorded other = run(shuffled, Structure::lists, 5000);
    ASSERT_EQ(one.log.size(), other.log.size());
    for (std::size_t i = 0; i < one.log.size(); ++i) {
        Strike& strike = other.log[i];
        strike.a = static_cast<std::int32_t>(order[static_cast<std::size_t>(strike.a)]);
        if (!strike.wall) {
            strike.b = static_cast<std::int32_t>(order[static_cast<std::size_t>(strike.b)]);
            if (strike.a > strike.b) std::swap(strike.a, strike.b);
        }
        ASSERT_EQ(one.log[i], strike) << "strike " << i;
    }
}

/// A run that is cut anywhere goes on with the log it would have had.
template <int D>
void expect_same_log_in_pieces(const Scene<D>& scene, std::uint64_t strikes, std::uint64_t piece) {
    const Recorded whole = run(scene, Structure::lists, strikes);
    State<D> state = start<D>(scene.bodies, scene.effects);
    std::vector<Strike> log;
    int turn = 0;
    while (log.size() < whole.log.size()) {
        // The structures take turns.
        Simulation<D> simulation(state, scene.effects,
                                 {turn++ % 2 == 0 ? Structure::lists : Structure::tree});
        const std::size_t before = log.size();
        simulation.run({.strikes = std::min<std::uint64_t>(piece, strikes - log.size())},
                       [&](const Strike& strike) { log.push_back(strike); });
        state = simulation.state();
        ASSERT_GT(log.size(), before);
    }
    EXPECT_EQ(log, whole.log);
}

TEST(MotionStructures, ARunGoesOnFromAnyState) {
    expect_same_log_in_pieces(gas<2>(100, true, 12), 1000, 37);
    expect_same_log_in_pieces(struck_lattice<2>(64, 0.5), 400, 7);
    expect_same_log_in_pieces(falling<3>(64, 13), 1000, 41);
    expect_same_log_in_pieces(symmetric<2>(64, 14), 600, 13);
}

/// Two balls and a wall, masses 1 : 100^k: the digits of π (Galperin 2003).
TEST(MotionStructures, GalperinsBallsCountPi) {
    for (const bool wall_on_the_left : {true, false}) {
        double mass = 1.0;
        for (const std::uint64_t expected : {3U, 31U, 314U, 3141U, 31415U}) {
            Scene<2> scene;
            const double side = wall_on_the_left ? 1.0 : -1.0;
            scene.bodies = {{{side * 3.0, 0.0}, {0.0, 0.0}, 0.5, 1.0},
                            {{side * 5.0, 0.0}, {side * -1.0, 0.0}, 0.5, mass}};
            scene.effects.box = {{-1e9, -1.0}, {1e9, 1.0}};
            (wall_on_the_left ? scene.effects.box->low : scene.effects.box->high)[0] = 0.0;
            Simulation<2> simulation(start<2>(scene.bodies, scene.effects), scene.effects);
            // Long before the other wall.
            simulation.run({.until = 1e4 * std::sqrt(mass)});
            EXPECT_EQ(simulation.counts().strikes, expected) << "mass " << mass;
            mass *= 100.0;
        }
    }
}

TEST(MotionStructures, ImpulseGoesThroughACradle) {
    const Recorded result = run(cradle<2>(6), Structure::lists, 5);
    ASSERT_EQ(result.log.size(), 5U);
    for (std::int32_t i = 0; i < 5; ++i)
        EXPECT_EQ(result.log[static_cast<std::size_t>(i)],
                  (Strike{3.0 - 0.0, false, i, i + 1, 1.0}));
}

TEST(MotionStructures, NothingGoesThrough) {
    for (const Structure structure : all_structures) {
        SCOPED_TRACE(name_of(structure));
        const int looks = 10 * static_cast<int>(thoroughness);
        expect_nothing_through(gas<2>(64, true, 21), 3 * looks, 0.0371, structure);
        expect_nothing_through(gas<3>(64, false, 22), 3 * looks, 0.0371, structure);
        expect_nothing_through(falling<2>(64, 23), 2 * looks, 0.0371, structure);
    }
}

TEST(MotionStructures, ElasticStrikesKeepTheEnergy) {
    const Scene<3> scene = gas<3>(216, true, 31);
    Simulation<3> simulation(start<3>(scene.bodies, scene.effects), scene.effects);
    const double before = energy(simulation);
    simulation.run({.strikes = 20'000 * thoroughness});
    EXPECT_NEAR(energy(simulation) / before, 1.0, 1e-13);
    // Nearly all are told by the filter and by double-doubles.
    const Counts& counts = simulation.counts();
    EXPECT_EQ(counts.strikes, 20'000 * thoroughness);
    EXPECT_GE(counts.refined, counts.strikes / 2);
    EXPECT_LT(counts.exact, counts.strikes / 100);
    EXPECT_LT(counts.rounded_exactly, counts.strikes / 100);
}

/// Three balls that lose nearly all of their speed against each other and a wall collapse.
/// Where doubles are a 4096th apart.
TEST(MotionStructures, APeriodicBoxFarFromTheOriginWritesOneLog) {
    constexpr double far = 0x1p40;
    Scene<2> scene{"far", {}, {}};
    scene.effects.box = Box<2>{{far, 0.0}, {far + 8.0, 8.0}};
    scene.effects.periodic = true;
    scene.bodies = {{{far + 6.0, 2.25}, {-3.0, 1.75}, 0.5, 1.0},
                    {{far + 7.5, 0.75}, {0.0, 0.0}, 0.125, 1.0},
                    {{far + 4.5, 7.25}, {0.0, 2.25}, 1.0, 1.0},
                    {{far + 4.0, 2.75}, {-1.0, -0.25}, 0.5, 1.0},
                    {{far + 0.25, 5.25}, {0.0, 2.25}, 0.25, 1.0},
                    {{far + 6.75, 4.75}, {-2.75, 0.0}, 0.125, 1.0},
                    {{far + 2.5, 4.0}, {-3.0, -0.25}, 1.0, 1.0}};
    expect_one_long_log(scene, Limits{.until = 8.0}, 10);
}

TEST(MotionStructures, ACollapseIsNamed) {
    Scene<2> scene;
    scene.bodies = {{{1.0, 0.0}, {0.0, 0.0}, 0.5, 1.0},
                    {{2.5, 0.0}, {0.0, 0.0}, 0.5, 1.0},
                    {{4.0, 0.0}, {-1.0, 0.0}, 0.5, 1.0}};
    scene.effects.box = {{0.0, -1.0}, {10.0, 1.0}};
    scene.effects.restitution = 0.1;
    scene.effects.wall_restitution = 0.1;
    const Recorded result = run(scene, Structure::pairs, 1'000'000);
    EXPECT_EQ(result.outcome.ending, Ending::collapse);
    EXPECT_LT(result.log.size(), 10'000U);

    // A ball that bounces ever lower comes to rest after v0/g (1+e)/(1-e).
    Scene<2> bounce;
    bounce.bodies = {{{0.0, 2.0}, {0.0, 0.0}, 1.0, 1.0}};
    bounce.effects.box = {{-10.0, 0.0}, {10.0, 10.0}};
    bounce.effects.gravity = {0.0, -2.0};
    bounce.effects.wall_restitution = 0.5;
    const Recorded rest = run(bounce, Structure::pairs, 1'000'000);
    EXPECT_EQ(rest.outcome.ending, Ending::collapse);
    EXPECT_NEAR(rest.log.back().time, 1.0 + 2.0 * (0.5 / (1.0 - 0.5)), 1e-9);
}

TEST(MotionStructures, BallsJammedBetweenWallsEnd) {
    Scene<2> scene;
    scene.bodies = {{{0.5, 0.5}, {1.0, 0.0}, 0.5, 1.0}, {{1.5, 0.5}, {0.0, 0.0}, 0.5, 1.0}};
    scene.effects.box = {{0.0, 0.0}, {2.0, 1.0}};
    EXPECT_EQ(run(scene, Structure::pairs, 10'000'000).outcome.ending, Ending::collapse);
}

TEST(MotionStructures, AClockTooCoarseIsAnError) {
    Scene<2> scene;
    scene.bodies = {{{-1e17, 0.0}, {1e7, 0.0}, 0.5, 1.0}, {{0.0, 0.0}, {0.0, 0.0}, 0.5, 1.0}};
    EXPECT_THROW(run(scene, Structure::pairs, 10), std::range_error);
}

/// Balls that fly apart for ever: the run is over soon after their last strike.
TEST(MotionStructures, AGasWithoutABoxEndsSoonAfterItsLastStrike) {
    Scene<2> scene = gas<2>(100, false, 63);
    scene.effects.box.reset();
    for (const Structure structure : all_structures) {
        SCOPED_TRACE(name_of(structure));
        const Recorded result = run(scene, structure, 1'000'000);
        ASSERT_EQ(result.outcome.ending, Ending::nothing);
        ASSERT_FALSE(result.log.empty());
        EXPECT_LT(result.time, 1000.0 * result.log.back().time);
    }
}

/// A scene that begins then.
template <int D>
State<D> at_time(const Scene<D>& scene, double time) {
    State<D> state = start<D>(scene.bodies, scene.effects);
    state.time = time;
    for (Ball<D>& ball : state.balls) ball.time = time;
    return state;
}

/// A lonely ball that is through the box many times before the clock ticks.
TEST(MotionStructures, ABallFasterThanTheClockIsAnError) {
    Scene<2> scene = gas<2>(25, true, 5);
    for (Body<2>& body : scene.bodies) body.v = {0.0, 0.0};
    scene.bodies.push_back({{0.0, 0.0}, {0x1p80, 0.0}, 0.001, 1.0});
    for (const Structure structure :
         {Structure::cells, Structure::tree, Structure::levels, Structure::lists}) {
        SCOPED_TRACE(name_of(structure));
        Simulation<2> simulation(at_time(scene, 1.0), scene.effects, {structure});
        EXPECT_THROW(simulation.run({.until = 2.0}), std::range_error);
    }
}

/// Late, when the clock ticks coarsely, structures still propose in time; where they could not any
/// more they say so.
template <int D>
void expect_one_log_as_long_as_the_clock_allows(const Scene<D>& scene) {
    const auto log = [&](Structure structure, double time) {
        Simulation<D> simulation(at_time(scene, time), scene.effects, {structure});
        std::vector<Strike> strikes;
        simulation.run({.strikes = 500}, [&](const Strike& s) { strikes.push_back(s); });
        return strikes;
    };
    for (const double time : {0x1p20, 0x1p26}) {
        const std::vector<Strike> expected = log(Structure::pairs, time);
        ASSERT_EQ(expected.size(), 500U);
        for (const Structure structure : all_structures) {
            SCOPED_TRACE(name_of(structure));
            EXPECT_EQ(log(structure, time), expected) << time;
        }
    }
    for (const Structure structure : {Structure::cells, Structure::tree, Structure::segments,
                                      Structure::levels, Structure::lists, Structure::delaunay})
        EXPECT_THROW(log(structure, 0x1p36), std::range_error) << name_of(structure);
}
TEST(MotionStructures, LateLogsAreOneAsLongAsTheClockAllows) {
    expect_one_log_as_long_as_the_clock_allows(gas<2>(100, true, 61));
    expect_one_log_as_long_as_the_clock_allows(gas<3>(125, false, 62));
    expect_one_log_as_long_as_the_clock_allows(struck_lattice<2>(100, 0.5));
}

/// Lengths in units a power of two larger or smaller, and speeds too: the same times.
TEST(MotionStructures, ALogInOtherUnitsIsTheSame) {
    const Scene<2> scene = gas<2>(100, false, 51);
    for (const int exponent : {-140, -76, 50, 75, 140}) {
        Scene<2> scaled = scene;
        const double unit = std::ldexp(1.0, exponent);
        scaled.effects.box = cube<2>(scene.effects.box->high[0] * unit);
        for (Body<2>& body : scaled.bodies) {
            body.radius *= unit;
            for (double& x : body.x) x *= unit;
            for (double& v : body.v) v *= unit;
        }
        for (const Structure structure : all_structures) {
            SCOPED_TRACE(std::string(name_of(structure)) + ", 2^" + std::to_string(exponent));
            const Recorded expected = run(scene, structure, 500);
            const Recorded result = run(scaled, structure, 500);
            ASSERT_EQ(result.log.size(), expected.log.size());
            for (std::size_t i = 0; i < expected.log.size(); ++i) {
                Strike strike = result.log[i];
                strike.impulse /= unit;
                ASSERT_EQ(strike, expected.log[i]) << i;
            }
        }
    }
}

TEST(MotionStructures, WhatCannotBeIsRefused) {
    using Bodies = std::vector<Body<2>>;
    const Effects<2> none;
    const auto refused = [&](const Bodies& bodies, const Effects<2>& effects) -> std::int64_t {
        try {
            static_cast<void>(start<2>(bodies, effects));
        } catch (const BallError& error) {
            return error.ball();
        } catch (const std::invalid_argument&) {
            return -2;
        }
        return -1;
    };
    const Body<2> ball{{0.0, 0.0}, {0.0, 0.0}, 1.0, 1.0};
    const auto with = [&](auto&& change) {
        Body<2> other = ball;
        other.x[0] = 10.0;
        change(other);
        return Bodies{ball, other};
    };
    EXPECT_EQ(refused(with([](auto&) {}), none), -1);
    EXPECT_EQ(refused(with([](auto& b) { b.x[1] = NAN; }), none), 1);
    EXPECT_EQ(refused(with([](auto& b) { b.v[0] = HUGE_VAL; }), none), 1);
    EXPECT_EQ(refused(with([](auto& b) { b.x[0] = 1e300; }), none), 1);
    EXPECT_EQ(refused(with([](auto& b) { b.radius = -1.0; }), none), 1);
    EXPECT_EQ(refused(with([](auto& b) { b.mass = 0.0; }), none), 1);
    EXPECT_EQ(refused(with([](auto& b) { b.x[0] = 2.0; }), none), -1);
    EXPECT_EQ(refused(with([](auto& b) { b.x[0] = std::nextafter(2.0, 0.0); }), none), 1);
    EXPECT_EQ(refused(with([](auto& b) { b.x = {1.2, 1.6}; }), none), -1);
    Effects<2> box;
    box.box = Box<2>{{-1.0, -1.0}, {11.0, 1.0}};
    EXPECT_EQ(refused(with([](auto&) {}), box), -1);
    box.box->high[0] = std::nextafter(11.0, 0.0);
    EXPECT_EQ(refused(with([](auto&) {}), box), 1);
    box.periodic = true;
    EXPECT_EQ(refused(with([](auto&) {}), box), 0);
    box.box->high = {-5.0, 5.0};
    EXPECT_EQ(refused(with([](auto&) {}), box), -2);
    Effects<2> bouncy;
    bouncy.restitution = 1.5;
    EXPECT_EQ(refused(with([](auto&) {}), bouncy), -2);
}

TEST(MotionStructures, AutoChoosesByNumberRadiiBoundsAndPacking) {
    const auto chosen = [](std::size_t balls, double largest, double box, bool periodic) {
        State<2> state;
        for (std::size_t i = 0; i < balls; ++i)
            state.balls.push_back({{}, {}, i == 0 ? largest : 1.0, 0.0});
        Effects<2> effects;
        if (box > 0.0) effects.box = Box<2>{{0, 0}, {box, box}};
        effects.periodic = periodic;
        const Choice choice = choose(Structure::automatic, state, effects);
        EXPECT_FALSE(choice.why.empty());
        return choice.structure;
    };
    EXPECT_EQ(chosen(16, 1.0, 100.0, false), Structure::pairs);
    // They fill 0.6 of a box that is 9.44 wide.
    EXPECT_EQ(chosen(17, 1.0, 9.4, false), Structure::lists);
    EXPECT_EQ(chosen(17, 1.0, 9.5, false), Structure::cells);
    // Of a box that is 26.24 wide two are in a square as wide as the largest, of one that is 288.2
    // wide, too.
    EXPECT_EQ(chosen(17, 4.5, 26.2, false), Structure::levels);
    EXPECT_EQ(chosen(17, 4.5, 26.3, false), Structure::cells);
    EXPECT_EQ(chosen(2050, 4.5, 288.0, true), Structure::levels);
    EXPECT_EQ(chosen(2050, 4.5, 288.3, true), Structure::cells);
    EXPECT_EQ(chosen(17, 4.1, 0.0, false), Structure::levels);
    EXPECT_EQ(chosen(17, 4.0, 0.0, false), Structure::tree);
    EXPECT_EQ(chosen(17, 1.0, 0.0, false), Structure::tree);
    EXPECT_EQ(chosen(17, 1.0, 1000.0, true), Structure::cells);
    EXPECT_EQ(chosen(17, 1.0, 9.0, true), Structure::lists);
    // Where the margin is no longer little.
    State<2> state;
    for (int i = 0; i < 17; ++i) state.balls.push_back({{}, {}, 0x1p-6, 0.0});
    Effects<2> thin;
    thin.box = Box<2>{{0, 0}, {0x1p36, 1.0}};
    thin.periodic = true;
    EXPECT_EQ(choose(Structure::levels, state, thin).structure, Structure::levels);
    thin.box->high[0] = 0x1.1p36;
    for (const Structure wish : all_structures)
        EXPECT_EQ(choose(wish, state, thin).structure, Structure::pairs);
    thin.periodic = false;
    EXPECT_EQ(choose(Structure::levels, state, thin).structure, Structure::levels);
}

/// Where radii are too different, or places are rounded by too much, another structure is used.
TEST(MotionStructures, DelaunayIsForDiscsThatItCanTellApart) {
    const auto chosen = [](double smallest, double largest, double x, const Effects<2>& effects) {
        State<2> state;
        state.balls = {{{x, 0.0}, {}, smallest, 0.0}, {{0.0, 0.0}, {}, largest, 0.0}};
        return choose(Structure::delaunay, state, effects).structure;
    };
    const Effects<2> none;
    EXPECT_EQ(chosen(1.0, 4096.0, 0.0, none), Structure::delaunay);
    EXPECT_EQ(chosen(1.0, 4097.0, 0.0, none), Structure::levels);
    EXPECT_EQ(chosen(0.0, 1.0, 0.0, none), Structure::levels);
    EXPECT_EQ(chosen(1.0, 1.0, -0x1p40, none), Structure::delaunay);
    EXPECT_EQ(chosen(1.0, 1.0, -0x1.1p40, none), Structure::levels);
    EXPECT_EQ(chosen(0x1p-10, 1.0, 0x1p20, none), Structure::delaunay);
    EXPECT_EQ(chosen(0x1p-10, 1.0, 0x1.1p20, none), Structure::levels);
    Effects<2> far;
    far.box = Box<2>{{0.0, -0x1.1p40}, {1.0, 0.0}};
    EXPECT_EQ(chosen(1.0, 1.0, 0.0, far), Structure::levels);
    far.box->low[1] = -0x1p40;
    EXPECT_EQ(chosen(1.0, 1.0, 0.0, far), Structure::delaunay);
}

/// Lists lost a strike where a speed was beyond 2^512, whose square is no double.
TEST(MotionStructures, StatesAtTheEndOfTheWindowWriteOneLog) {
    std::vector<Body<2>> bodies;
    for (int i = 0; i < 10; ++i)
        bodies.push_back({{static_cast<double>(i % 4), static_cast<double>(i / 4)},
                          {(i % 3 - 1) / 3.0, (i % 2) / 3.0},
                          0.2 + 0.01 * i,
                          1.0 + i % 3});
    const State<2> first = start<2>(bodies, {});
    for (const double large : {0x1p150, 0x1p200}) {
        for (const bool is_speed : {true, false}) {
            SCOPED_TRACE(std::to_string(large) + (is_speed ? " fast" : " far"));
            State<2> state = first;
            (is_speed ? state.balls[3].v : state.balls[3].x)[0] = large;
            const auto log_of = [&](Structure structure) {
                std::vector<Strike> log;
                Simulation<2> simulation(state, {}, {structure});
                (void)simulation.run({.until = 64.0, .strikes = 40},
                                     [&](const Strike& each) { log.push_back(each); });
                return log;
            };
            const std::vector<Strike> expected = log_of(Structure::pairs);
            EXPECT_GE(expected.size(), 3U);
            for (const Structure structure : all_structures) {
                SCOPED_TRACE(name_of(structure));
                try {
                    EXPECT_EQ(log_of(structure), expected);
                } catch (const std::range_error&) {
                    // Of the clock, which `pairs` and worlds without a box do not need.
                    EXPECT_EQ(structure, Structure::delaunay);
                }
            }
        }
    }
}

}  // namespace
}  // namespace signum::motion
