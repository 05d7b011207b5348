/// Every effect and every pair of them in small hostile scenes: all structures write one log, a run
/// that is cut anywhere goes on as if it had not been, doubles end, and an effect that does nothing
/// changes nothing.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "effects_scenes.hpp"

namespace signum::motion {
namespace {

const Limits limits{.until = 6.0, .strikes = 200, .stop = {}};
const std::uint64_t rounds = is_fast ? 2 : 1;

template <int D>
struct Recorded {
    std::vector<Strike> log;
    std::string end;
    State<D> state;
};

/// What is over is so by its time or because nothing meets any more: not all structures can tell.
std::string name_of(Ending ending) {
    switch (ending) {
        case Ending::until:
        case Ending::nothing:
            return "over";
        case Ending::strikes:
            return "strikes";
        case Ending::collapse:
            return "collapse";
        case Ending::stopped:
            break;
    }
    return "stopped";
}

/// Stops what would not end: few strikes and steps take few turns.
template <int D>
Recorded<D> run(const State<D>& state, const Effects<D>& effects, const Options& options,
                Limits to = limits) {
    Recorded<D> result;
    int asked = 0;
    to.stop = [&] { return ++asked > 1000; };
    try {
        Simulation<D> simulation(state, effects, options);
        const Outcome outcome =
            simulation.run(to, [&](const Strike& strike) { result.log.push_back(strike); });
        result.end = name_of(outcome.ending);
        result.state = simulation.state();
    } catch (const std::range_error& error) {
        result.end = error.what();
    }
    return result;
}

bool is_same(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
template <int D>
void expect_same(const State<D>& a, const State<D>& b) {
    EXPECT_TRUE(is_same(a.time, b.time));
    ASSERT_EQ(a.balls.size(), b.balls.size());
    for (std::size_t i = 0; i < a.balls.size(); ++i) {
        const Ball<D>& p = a.balls[i];
        const Ball<D>& q = b.balls[i];
        for (int k = 0; k < D; ++k) {
            EXPECT_TRUE(is_same(p.x[k], q.x[k]));
            EXPECT_TRUE(is_same(p.v[k], q.v[k]));
        }
        EXPECT_TRUE(is_same(p.radius, q.radius));
        EXPECT_TRUE(is_same(p.time, q.time));
    }
    EXPECT_EQ(a.in_place, b.in_place);
    EXPECT_EQ(a.passed, b.passed);
    EXPECT_EQ(a.spins, b.spins);
    EXPECT_EQ(a.last_strikes, b.last_strikes);
    EXPECT_EQ(a.pressed, b.pressed);
    EXPECT_EQ(a.contacts, b.contacts);
    EXPECT_EQ(a.half_steps, b.half_steps);
}

void expect_same(const std::vector<Strike>& log, const std::vector<Strike>& expected) {
    for (std::size_t i = 0; i < std::min(log.size(), expected.size()); ++i)
        ASSERT_EQ(log[i], expected[i]) << "strike " << i;
    ASSERT_EQ(log.size(), expected.size());
}

/// The log in pieces that end at some times, or after some strikes, by turns of two structures.
template <int D>
void expect_the_same_in_pieces(const State<D>& first, const Effects<D>& effects,
                               const Recorded<D>& whole, bool by_time, Choices& choose) {
    Recorded<D> piece{{}, "", first};
    std::vector<Strike> log;
    double until = by_time ? 0.0 : limits.until;
    for (bool odd = false;; odd = !odd) {
        Limits to{.until = until, .strikes = limits.strikes - log.size(), .stop = {}};
        if (by_time) {  // often at the very beginning of a step
            const double step = effects.time_step > 0.0 && choose.below(2) == 0
                                    ? effects.time_step
                                    : 0.25 * choose.unit();
            until = effects.time_step > 0.0 && choose.below(2) == 0
                        ? std::ceil(until / effects.time_step + 1.0) * effects.time_step
                        : until + step;
            to.until = until = std::min(until, limits.until);
        } else {
            to.strikes = std::min<std::uint64_t>(to.strikes,
                                                 1 + static_cast<std::uint64_t>(choose.below(5)));
        }
        piece = run(piece.state, effects, {odd ? Structure::lists : Structure::pairs}, to);
        log.insert(log.end(), piece.log.begin(), piece.log.end());
        if (log.size() >= limits.strikes || (piece.end != "over" && piece.end != "strikes")) break;
        if (by_time ? until >= limits.until : piece.end == "over") break;
    }
    expect_same(log, whole.log);
    expect_same(piece.state, whole.state);
}

template <int D>
void expect_one_log(std::uint64_t seed, const std::vector<Effect>& wanted, std::size_t& strikes) {
    std::string trace = (D == 2 ? "plane, seed " : "space, seed ") + std::to_string(seed);
    for (const Effect effect : wanted) trace += ", " + std::string(name_of(effect));
    SCOPED_TRACE(trace);
    const Scene<D> scene = effects_scene<D>(seed, wanted);
    const State<D> first = start<D>(scene.bodies, scene.effects);
    const Recorded<D> expected = run(first, scene.effects, {Structure::pairs});
    ASSERT_NE(expected.end, "stopped");
    strikes += expected.log.size();
    for (const Structure structure : all_structures) {
        SCOPED_TRACE(name_of(structure));
        const Recorded<D> other = run(first, scene.effects, {structure});
        ASSERT_EQ(other.end, expected.end);
        expect_same(other.log, expected.log);
    }
    if (expected.end == "over" || expected.end == "strikes") {
        Choices choose(seed);
        for (const bool by_time : {true, false}) {
            SCOPED_TRACE(by_time ? "by time" : "by strikes");
            expect_the_same_in_pieces(first, scene.effects, expected, by_time, choose);
        }
    }
    const Recorded<D> naive = run(first, scene.effects, {Structure::lists, Kernel::naive});
    EXPECT_NE(naive.end, "stopped");
}

template <int D>
void expect_one_log_of_all_pairs(std::uint64_t seed) {
    std::size_t strikes = 0;
    std::uint64_t scenes = 0;
    for (std::uint64_t round = 0; round < (D == 2 ? rounds : 1); ++round) {
        for (int one = 0; one < effects_in_all; ++one) {
            for (int other = one; other < effects_in_all; ++other) {
                std::vector<Effect> wanted = {static_cast<Effect>(one)};
                if (other > one) wanted.push_back(static_cast<Effect>(other));
                expect_one_log<D>(seed + scenes, wanted, strikes);
                if (testing::Test::HasFailure()) return;
                ++scenes;
            }
        }
    }
    EXPECT_GT(strikes, 5 * scenes);
}

TEST(Effects, InThePlaneAllStructuresWriteOneLogInPiecesAsWell) {
    expect_one_log_of_all_pairs<2>(1000);
}
TEST(Effects, InSpaceAllStructuresWriteOneLogInPiecesAsWell) {
    expect_one_log_of_all_pairs<3>(2000);
}

// What was once wrong

/// Two balls far from the sphere that holds them: a structure's own events are many before one
/// strikes.
TEST(Effects, AWorldWithoutABoxEndsAtItsObstacles) {
    Effects<2> effects;
    Sphere<2> circle;
    circle.radius = 1000.0;
    circle.side = Sphere<2>::Side::inside;
    effects.obstacles.emplace_back(circle);
    const std::vector<Body<2>> bodies = {{{0, 0}, {1, 0}, 0.5, 1}, {{5, 0}, {2, 0.25}, 0.5, 1}};
    const State<2> first = start<2>(bodies, effects);
    const Recorded<2> expected = run<2>(first, effects, {Structure::pairs}, {.until = 5000.0});
    EXPECT_GT(expected.log.size(), 5U);
    for (const Structure structure : all_structures)
        EXPECT_EQ(run<2>(first, effects, {structure}, {.until = 5000.0}).log, expected.log)
            << name_of(structure);
}

/// The same of a current that brings together what flies apart.
TEST(Effects, AWorldWithoutABoxDoesNotEndWhereAFluidFlows) {
    Effects<2> effects;
    effects.fluid.emplace();
    effects.fluid->gradient[0][0] = -0.125;  // u = -x/8
    effects.fluid->linear = 1.0;
    effects.time_step = 0.125;
    const std::vector<Body<2>> bodies = {{{-2, 0}, {-4, 0}, 0.5, 1}, {{2, 0}, {4, 0}, 0.5, 1}};
    const State<2> first = start<2>(bodies, effects);
    for (const Structure structure : all_structures)
        EXPECT_GE(run<2>(first, effects, {structure}, {.until = 300.0, .strikes = 3}).log.size(),
                  1U)
            << name_of(structure);
}

/// A ball whose floor sinks away at the speed that it has just been given, and comes back.
TEST(Effects, ABallDoesNotFallThroughAFloorThatShakes) {
    int again = 0;
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        Choices choose(seed);
        Effects<2> effects;
        effects.box = Box<2>{{-10.0, 0.0}, {10.0, 1000.0}};
        effects.gravity = {0.0, -1.0};
        effects.wall_restitution = 0.0;
        effects.shake =
            Shake<2>{{0.0, 0.5 + choose.unit()}, 1.0 + 2.0 * choose.unit(), 6.0 * choose.unit()};
        const std::vector<Body<2>> bodies = {{{0, 4.0 + choose.unit()}, {0.125, 0}, 0.5, 1}};
        const Recorded<2> found =
            run<2>(start<2>(bodies, effects), effects, {}, {.until = 60.0, .strikes = 2000});
        const double t = found.state.time;
        const double floor = effects.shake->amplitude[1] *
                             std::sin(effects.shake->frequency * t + effects.shake->phase);
        EXPECT_GT(coordinate(found.state.balls[0], 1, t, effects) - 0.5, floor - 1e-9) << seed;
        again += static_cast<int>(found.log.size() > 1);
    }
    EXPECT_GT(again, 10);
}

/// A strike at the very time when radii cease to grow, and a run that ends with it.
TEST(Effects, GrowthEndsOnceAlsoAtAStrike) {
    Effects<2> effects;
    effects.growth = Growth{0.25, 2.0};
    // Radii 1/2 become 3/4, and 1 is left between the centres' ways.
    const std::vector<Body<2>> bodies = {
        {{0, 0}, {0, 0}, 0.5, 1}, {{3.5, 0}, {-1, 0}, 0.5, 1}, {{20.0, 0}, {-1, 0}, 0.5, 1}};
    const State<2> first = start<2>(bodies, effects);
    const Recorded<2> whole = run<2>(first, effects, {}, {.until = 30.0});
    ASSERT_GE(whole.log.size(), 2U);
    EXPECT_EQ(whole.log[0].time, 2.0);
    const Recorded<2> one = run<2>(first, effects, {}, {.strikes = 1});
    ASSERT_EQ(one.log.size(), 1U);
    for (const Ball<2>& ball : one.state.balls) EXPECT_EQ(ball.radius, 0.75);
    const Recorded<2> rest = run<2>(one.state, effects, {}, {.until = 30.0});
    expect_same(rest.state, whole.state);
}

/// Small discs that grow beside large ones: who is a neighbour by power changes with the radii.
TEST(Effects, DiscsOfDifferentSizesThatGrowWriteOneLog) {
    for (std::uint64_t seed = 0; seed < 20 * rounds; ++seed) {
        SCOPED_TRACE(seed);
        Choices choose(seed);
        Effects<2> effects;
        effects.box = cube<2>(20.0);
        effects.periodic = seed % 2 == 0;
        effects.growth = Growth{0.5 + 2.0 * choose.unit(), 2.0};
        std::vector<Body<2>> bodies;
        for (int i = 0; i < 40; ++i) {
            Body<2> body{{1.0 + 18.0 * choose.unit(), 1.0 + 18.0 * choose.unit()},
                         {choose.number(-2.0, 2.0), choose.number(-2.0, 2.0)},
                         choose.below(4) > 0 ? 0.02 + 0.1 * choose.unit() : 0.4,
                         1.0};
            bodies.push_back(body);
            try {
                (void)start<2>(bodies, effects);
            } catch (const BallError&) {
                bodies.pop_back();
            }
        }
        const State<2> first = start<2>(bodies, effects);
        EXPECT_NE(motion::choose(Structure::delaunay, first, effects).structure,
                  Structure::delaunay);
        const Recorded<2> expected = run<2>(first, effects, {Structure::pairs});
        for (const Structure structure : all_structures) {
            SCOPED_TRACE(name_of(structure));
            const Recorded<2> other = run<2>(first, effects, {structure});
            expect_same(other.log, expected.log);
            if (HasFailure()) return;
        }
    }
}

/// A disc on a circle around it, over steps so long that the strikes in them count. Which contacts
/// may wait within a step is found at its beginning, and is not in the state at its end.
TEST(Effects, AStateBetweenTwoStepsKnowsNothingOfCuts) {
    Effects<2> effects;
    effects.restitution = effects.wall_restitution = 0.25;
    effects.contacts = LastingContacts{0.5};
    effects.time_step = 0.75;
    effects.obstacles.emplace_back(Sphere<2>{.radius = 1.0, .side = Sphere<2>::Side::inside});
    const std::vector<Body<2>> bodies = {{{0.0, -0.9375}, {1.0, 0.0}, 0.0625, 1}};
    const State<2> first = start<2>(bodies, effects);
    const Recorded<2> whole = run<2>(first, effects, {}, {.until = 4.5});
    ASSERT_EQ(whole.state.contacts.size(), 1U);
    ASSERT_EQ(whole.state.half_steps, 12U);
    const Recorded<2> part = run<2>(first, effects, {}, {.until = 4.0});
    const Recorded<2> rest = run<2>(part.state, effects, {}, {.until = 4.5});
    expect_same(rest.state, whole.state);
}

/// Two balls without room that grow and rub: thousands of strikes at time 0, after each of which
/// the ends of projections change places anew.
TEST(Effects, ManyStrikesAtOneTimeAreNoStandstill) {
    Effects<3> effects;
    effects.restitution = 0.75;
    effects.friction = Friction{0.875, 3.0, 1.0, 0.4};
    effects.growth = Growth{0.25, 1.0};
    effects.box = cube<3>(2.0);
    const std::vector<Body<3>> bodies = {
        {{1.5, 1.5, 1.5}, {-1.125, -0.875, -1.625}, 0.5, 2.125, {-0.625, 1.5, -0.75}},
        {{0.5, 1.5, 1.5}, {0.0, 0.0, 1.25}, 0.5, 3.875, {0.125, -0.75, 0.25}}};
    const State<3> first = start<3>(bodies, effects);
    const Limits all{.until = 1.0, .strikes = 50'000, .stop = {}};
    const Recorded<3> expected = run<3>(first, effects, {Structure::pairs}, all);
    EXPECT_EQ(expected.end, "collapse");
    EXPECT_EQ(expected.state.time, 0.0);
    for (const Structure structure : all_structures) {
        SCOPED_TRACE(name_of(structure));
        const Recorded<3> other = run<3>(first, effects, {structure}, all);
        EXPECT_EQ(other.end, expected.end);
        expect_same(other.log, expected.log);
    }
}

// What does nothing

template <int D>
void expect_no_change(const Scene<D>& scene, const Effects<D>& effects, const std::string& what) {
    SCOPED_TRACE(what);
    const Recorded<D> expected =
        run(start<D>(scene.bodies, scene.effects), scene.effects, {Structure::pairs});
    const Recorded<D> found = run(start<D>(scene.bodies, effects), effects, {Structure::pairs});
    expect_same(found.log, expected.log);
    ASSERT_EQ(found.end, expected.end);
}

template <int D>
void expect_that_nothing_changes_nothing(std::uint64_t seed) {
    SCOPED_TRACE(seed);
    const Scene<D> scene = effects_scene<D>(
        seed, seed % 2 == 0 ? std::vector{Effect::gravity, Effect::losses} : std::vector<Effect>());
    const auto with = [&](const auto& change, const std::string& what) {
        Effects<D> effects = scene.effects;
        change(effects);
        expect_no_change(scene, effects, what);
    };
    with([](Effects<D>& e) { e.friction = Friction{}; }, "no friction");
    with([](Effects<D>& e) { e.contact_duration = 0.0; }, "no duration");
    if (scene.effects.restitution == 1.0 && scene.effects.wall_restitution == 1.0) {
        with([](Effects<D>& e) { e.speed_law = SpeedLaw{}; }, "elastic at any speed");
        with([](Effects<D>& e) { e.speed_law = SpeedLaw{0x1p-150, 8.0}; }, "and a slow one");
    }
    if (scene.effects.periodic) return;
    if (scene.effects.box) {
        with([](Effects<D>& e) { e.shake = Shake<D>{{}, 3.0, 1.0}; }, "no amplitude");
        // It stands at its level.
        with([](Effects<D>& e) { e.shake = Shake<D>{{1.0, 0.5}, 0.0, 0.0}; }, "no frequency");
    }
    with(
        [](Effects<D>& e) {
            HalfSpace<D> floor;
            floor.normal[D - 1] = 3.0;
            floor.offset = -1e6;
            Sphere<D> circle;
            circle.radius = 1e6;
            circle.side = Sphere<D>::Side::inside;
            e.obstacles.emplace_back(floor);
            e.obstacles.emplace_back(circle);
            circle.side = Sphere<D>::Side::outside;
            circle.radius = 1.0;
            circle.centre[0] = 2e6;
            e.obstacles.emplace_back(circle);
        },
        "obstacles far away");
}

TEST(Effects, ThatDoNothingChangeNothing) {
    for (std::uint64_t seed = 0; seed < 10 * rounds; ++seed) {
        expect_that_nothing_changes_nothing<2>(seed);
        expect_that_nothing_changes_nothing<3>(seed);
        if (HasFailure()) return;
    }
}

}  // namespace
}  // namespace signum::motion
