/// No scene strikes without end: each comes to its time, or ends with a sentence that says who and
/// when, within a number of strikes that is told here and in docs/motion.md.

#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "harsh_scenes.hpp"

namespace signum::motion {
namespace {

const std::uint64_t scenes = scenes_to_draw(50'000);
const std::uint64_t crushing_scenes = scenes_to_draw(6'000) / 3;

/// Of a ball, in a run of some units of time: four million. Nearly all end within a quarter of
/// them. The most, 12 199 354 of five discs, are those of a heavy one that rolls into the neck
/// between a sphere and a wall, which is as wide as the disc, and comes to rest there.
constexpr std::uint64_t most_strikes = 1 << 22;

struct End {
    std::uint64_t strikes = 0;
    std::string why;
};
template <int D>
End end_of(const Scene<D>& scene, double until) {
    if (scene.bodies.empty()) return {0, "nobody"};
    End end;
    try {
        Simulation<D> simulation(start<D>(scene.bodies, scene.effects), scene.effects);
        const Outcome outcome =
            simulation.run({.until = until, .strikes = most_strikes * scene.bodies.size()});
        end.strikes = simulation.counts().strikes;
        end.why = outcome.ending == Ending::until      ? "until"
                  : outcome.ending == Ending::nothing  ? "nothing"
                  : outcome.ending == Ending::collapse ? "collapse"
                                                       : "strikes";
    } catch (const std::range_error& error) {
        end.why = "clock";
    } catch (const std::invalid_argument& error) {
        end.why = "refused";
    }
    return end;
}

/// One ball pressed into a corner, or wedged there by a heavy one: with friction of 1 and more each
/// strike of one wall sends it into the other.
TEST(MotionEnds, CornersWithMuchFriction) {
    for (const double friction : {0.9, 1.0, 1.5, 2.0, 3.0}) {
        if (!is_fast && friction != 1.0) continue;
        for (const double rise : {0.0, 0.3}) {
            for (const double heavy : {0.0, 1.0, 1e6}) {
                for (const double speed : {0.5, 1.0, 2.0}) {
                    Scene<2> scene{"corner", {}, {}};
                    Effects<2>& effects = scene.effects;
                    effects.gravity = {0.0, -10.0};
                    effects.restitution = effects.wall_restitution = 0.5;
                    effects.friction = Friction{friction, friction, 0.0, 0.5};
                    effects.contacts = LastingContacts{speed};
                    effects.time_step = 0.1;
                    effects.obstacles.push_back(HalfSpace<2>{{0.0, 1.0}, 0.0, rise});
                    effects.obstacles.push_back(HalfSpace<2>{{-1.0, 0.0}, -4.0, 0.0});
                    effects.obstacles.push_back(HalfSpace<2>{{1.0, 0.0}, 0.0, 0.0});
                    const double x = heavy > 0.0 ? 3.75 : 3.0;
                    scene.bodies.push_back({{x, 0.25}, {heavy > 0.0 ? 0.0 : 1.5, 0.0}, 0.25, 1.0});
                    if (heavy > 0.0) scene.bodies.push_back({{1.1, 1.0}, {0.9, 0.0}, 1.0, heavy});
                    const End end = end_of(scene, 3.0);
                    SCOPED_TRACE(testing::Message() << "friction " << friction << ", rise " << rise
                                                    << ", heavy " << heavy << ", speed " << speed);
                    // What can rest rests. From friction 1 on a floor that rises cannot take along
                    // a ball that a wall holds: most of these end with a sentence.
                    if (rise == 0.0 || friction < 1.0) {
                        EXPECT_EQ(end.why, "until");
                    }
                    EXPECT_TRUE(end.why == "until" || end.why == "collapse") << end.why;
                    EXPECT_LE(end.strikes, 5000U);
                }
            }
        }
    }
}

/// A ball as wide as its box flies from side to side at time 0, when no step has begun, until it
/// stays at one: after 100 strikes, too, when contacts would be solved over the rest of a step.
TEST(MotionEnds, AJamWithoutTimeLeft) {
    Effects<2> effects;
    effects.restitution = effects.wall_restitution = 0.9;
    effects.contacts = LastingContacts{0.25};
    effects.time_step = 0.125;
    effects.box = Box<2>{{0.0, 0.0}, {1.0, 8.0}};
    for (double first = 1000.0; first < 20'000.0; first += 500.0) {
        std::uint64_t expected = 1;
        for (double v = first; 0.9 * v >= effects.contacts->speed; v *= 0.9) ++expected;
        const std::vector<Body<2>> bodies = {{{0.5, 4.0}, {first, 0.0}, 0.5, 1.0}};
        Simulation<2> simulation(start<2>(bodies, effects), effects);
        EXPECT_EQ(simulation.run({.until = 0.0}).ending, Ending::until);
        EXPECT_EQ(simulation.counts().strikes, expected) << first;
        EXPECT_EQ(simulation.state().balls[0].v[0], 0.0) << first;
    }
}

/// What goes on must not end: elastic hops on a floor and a gas, however late the clock is; slow
/// growth of a dense packing to just before its jam, a wall that moves far away, one that presses
/// the packing slowly, and a box that shakes it by less than its gaps.
TEST(MotionEnds, NotWhereThereIsNoEnd) {
    for (const double time : {0.0, 1.7e9, 0x1p31}) {
        SCOPED_TRACE(time);
        Effects<2> effects;
        effects.box = cube<2>(1.0);
        effects.gravity[1] = -1.0;
        State<2> state = start<2>(std::vector<Body<2>>{{{0.25, 0.5}, {3.0, 1.0}, 0.1, 1.0},
                                                       {{0.75, 0.5}, {-4.0, 2.0}, 0.1, 1.0}},
                                  effects);
        state.time = time;
        for (Ball<2>& ball : state.balls) ball.time = time;
        Simulation<2> simulation(state, effects);
        EXPECT_EQ(simulation.run({.until = time + (is_fast ? 1000.0 : 200.0)}).ending,
                  Ending::until);
        EXPECT_GT(simulation.counts().strikes, 2000U);
    }
    for (const std::string what : {"growth", "far", "slow", "shaken"}) {
        Effects<2> effects;
        if (what == "growth") effects.growth = Growth{1e-9, 4.0};
        if (what == "far") effects.obstacles.push_back(HalfSpace<2>{{1.0, 0.0}, -1000.0, 1e-6});
        if (what == "slow") effects.obstacles.push_back(HalfSpace<2>{{1.0, 0.0}, 0.0, 1e-6});
        if (what == "shaken") effects.shake = Shake<2>{{0x1p-15, 0x1p-15}, 2.0};
        effects.box = cube<2>(6.0);
        std::vector<Body<2>> bodies;
        for (int i = 0; i < 36; ++i)
            bodies.push_back({{0.5 + i % 6, 0.5 + i / 6},
                              {(i * 7 % 5 - 2) / 4.0, (i * 3 % 5 - 2) / 4.0},
                              0.5 - 0x1p-14,
                              1.0});
        Simulation<2> simulation(start<2>(bodies, effects), effects);
        EXPECT_EQ(simulation.run({.until = is_fast ? 1.0 : 0.05}).ending, Ending::until) << what;
    }
    // A heavy ball turns round after 411 774 strikes, beside a wall that nobody reaches, too.
    Effects<2> beside;
    beside.obstacles.push_back(HalfSpace<2>{{1.0, 0.0}, 0.0, 0.0});
    beside.obstacles.push_back(HalfSpace<2>{{0.0, 1.0}, -1e6, 1e-6});
    const std::vector<Body<2>> two = {{{1.0 + 0x1p-12, 0.0}, {0.0, 0.0}, 1.0, 1.0},
                                      {{3.0 + 0x1p-10, 0.0}, {-1.0, 0.0}, 1.0, 0x1p34}};
    Simulation<2> turns(start<2>(two, beside), beside);
    EXPECT_EQ(turns.run({.until = 10.0, .strikes = is_fast ? ~std::uint64_t{0} : 40'000}).ending,
              is_fast ? Ending::until : Ending::strikes);
    // A flight may take many steps, each of them short.
    Effects<2> effects;
    effects.box = cube<2>(8.5);
    effects.periodic = true;
    effects.growth = Growth{0x1p-15, 1024.0};
    effects.fluid = Fluid<2>{.linear = 0x1p-40};
    effects.time_step = 0x1p-12;
    std::vector<Body<2>> bodies;
    for (int i = 0; i < 4; ++i)
        bodies.push_back({{1.0 + 2.125 * i, 4.0}, {i % 2 == 0 ? 4.0 : -4.0, 0.0}, 1.0, 1.0});
    Simulation<2> simulation(start<2>(bodies, effects), effects);
    EXPECT_EQ(simulation.run({.until = is_fast ? 300.0 : 3.0}).ending, Ending::until);
    EXPECT_GT(simulation.counts().strikes, is_fast ? 20'000U : 100U);
}

/// Balls in a row between two walls that close. Without loss they fly ever faster.
TEST(MotionEnds, RowsBetweenWallsThatClose) {
    for (const double restitution : {1.0, 0.9, 0.5, 0.0}) {
        for (int balls = 1; balls <= (is_sanitized ? 2 : 4); ++balls) {
            for (const double step : {0.0, 0.125}) {
                Scene<2> scene{"row", {}, {}};
                scene.effects.restitution = scene.effects.wall_restitution = restitution;
                scene.effects.time_step = step;
                scene.effects.obstacles.push_back(HalfSpace<2>{{1.0, 0.0}, 0.0, 0.5});
                scene.effects.obstacles.push_back(HalfSpace<2>{{-1.0, 0.0}, -8.0, 0.5});
                for (int i = 0; i < balls; ++i)
                    scene.bodies.push_back(
                        {{1.0 + 1.5 * i, 0.0}, {i % 2 - 0.5, 0.0}, 0.5, 1.0 + i});
                const End end = end_of(scene, 16.0);
                EXPECT_EQ(end.why, "collapse") << restitution << ' ' << balls << ' ' << step;
                EXPECT_LE(end.strikes, 200'000U * balls);
            }
        }
    }
}

/// Balls that grow until there is no room, with and without loss.
TEST(MotionEnds, GrowthIntoAJam) {
    for (const double restitution : {1.0, 0.5}) {
        if (restitution == 1.0 && !is_fast) continue;
        for (const bool is_periodic : {false, true}) {
            Scene<2> scene{"growth", {}, {}};
            scene.effects.restitution = scene.effects.wall_restitution = restitution;
            scene.effects.box = cube<2>(12.0);
            scene.effects.periodic = is_periodic;
            scene.effects.growth = Growth{0.5, 2.15};
            for (int i = 0; i < 36; ++i)
                scene.bodies.push_back({{1.0 + 2.0 * (i % 6), 1.0 + 2.0 * (i / 6)},
                                        {(i * 7 % 5 - 2) / 4.0, (i * 3 % 5 - 2) / 4.0},
                                        0.46875 + 0.03125 * (i % 3),
                                        1.0});
            EXPECT_EQ(end_of(scene, 8.0).why, "collapse") << restitution << ' ' << is_periodic;
        }
    }
}

template <int D>
void expect_ends(std::uint64_t number, bool crushes) {
    std::map<std::string, std::uint64_t> ends;
    for (std::uint64_t seed = 0; seed < number; ++seed) {
        const std::string why = end_of(harsh_scene<D>(seed, crushes), 1.0).why;
        ASSERT_NE(why, "strikes") << "seed " << seed;
        ++ends[why];
    }
    // Most come to their time; few are refused, or by a clock that cannot tell.
    EXPECT_GT(10 * ends["until"], 6 * number);
    EXPECT_LE(20 * (ends["refused"] + ends["clock"]), number);
}
TEST(MotionEnds, EveryMixtureOfEffectsInThePlane) {
    expect_ends<2>(scenes, false);
}
TEST(MotionEnds, EveryMixtureOfEffectsInSpace) {
    expect_ends<3>(scenes, false);
}
TEST(MotionEnds, WhatIsCrushed) {
    expect_ends<2>(crushing_scenes, true);
    expect_ends<3>(crushing_scenes, true);
}

}  // namespace
}  // namespace signum::motion
