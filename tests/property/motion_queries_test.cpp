/// Who is near whom, when, and what strikes: equal to brute force in rationals, on input with ties
/// of all kinds.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "../../motion/near_pairs.hpp"
#include "../../motion/queries.hpp"
#include "../oracle/gaps.hpp"
#include "../unit/exact_reference.hpp"
#include "motion_oracle.hpp"
#include "motion_scenes.hpp"

namespace signum::motion {
namespace {

using reference::Random;

template <int D>
std::vector<brute::Ball> to_brute(const std::vector<Ball<D>>& balls) {
    std::vector<brute::Ball> result;
    for (const Ball<D>& ball : balls) {
        result.push_back(flying(ball));
        result.back().t0 = ball.time;
    }
    return result;
}
std::string in_words(const ClosestPair& p) {
    std::ostringstream text;
    text.precision(17);
    text << p.time << ": " << p.a << " " << p.b << " " << p.gap;
    return text.str();
}
std::pair<int, int> numbers(const ClosestPair& pair) {
    return {pair.a, pair.b};
}
ClosestPair of_oracle(const brute::Near& near) {
    return {near.time, near.a, near.b, near.gap};
}

/// Balls in flight, made to tie.
enum class Kind {
    random,    ///< places and speeds of all kinds
    grid,      ///< small integers: equal gaps, the same speeds, balls in one another
    line,      ///< the same on one line: gaps are linear, with kinks
    meeting,   ///< points that all meet at one place
    parallel,  ///< one speed for all, but for a few
    beside,    ///< the grid, an ulp beside it
    lattice,   ///< a lattice at rest that touches
    ranges,    ///< sizes from 2^-140 to 2^140
    extremes   ///< sizes from 2^-1000 to 2^1000
};
constexpr int kinds = 9;
/// Of those with which a clock of doubles can do.
constexpr int kinds_that_fly = 8;

template <int D>
State<D> state_of(Kind kind, int number, const Effects<D>& effects, Random& random) {
    State<D> state;
    state.time = kind == Kind::random ? 3.0 * random.significand() : random.between(0, 2);
    const double unit = std::ldexp(1.0, -53);
    const auto real = [&] {
        return (static_cast<double>(random.engine()() >> 11) * unit - 0.5) * 4.0;
    };
    const auto whole = [&] { return static_cast<double>(random.between(-3, 3)); };
    const auto beside = [&](double x) {
        return random.coin() ? x : std::nextafter(x, random.coin() ? 9.0 : -9.0);
    };
    for (int i = 0; i < number; ++i) {
        Ball<D> ball;
        ball.time = random.coin() ? state.time : 0.5 * state.time;
        for (int k = 0; k < D; ++k) {
            switch (kind) {
                case Kind::random:
                    ball.x[k] = real();
                    ball.v[k] = real();
                    break;
                case Kind::grid:
                    ball.x[k] = whole();
                    ball.v[k] = whole();
                    break;
                case Kind::line:
                    ball.x[k] = k == 0 ? 2.0 * whole() : 0.0;
                    ball.v[k] = k == 0 ? whole() : 0.0;
                    break;
                case Kind::meeting:
                    ball.v[k] = whole();
                    ball.x[k] = -ball.v[k] * (state.time + 1.0 - ball.time);
                    break;
                case Kind::parallel:
                    ball.x[k] = whole();
                    ball.v[k] = random.below(4) == 0 ? whole() : 1.0;
                    break;
                case Kind::beside:
                    ball.x[k] = beside(whole());
                    ball.v[k] = beside(whole());
                    break;
                case Kind::lattice:
                    ball.x[k] = whole();
                    break;
                case Kind::extremes:
                    ball.x[k] = random.in_binades(-1000, 999);
                    ball.v[k] = random.in_binades(-1000, 999);
                    break;
                case Kind::ranges:
                    ball.x[k] = random.in_binades(-140, 139);
                    ball.v[k] = random.in_binades(-140, 139);
                    break;
            }
            if (effects.periodic) ball.x[k] = std::remainder(ball.x[k], 8.0);
        }
        switch (kind) {
            case Kind::random:
                ball.radius = 0.1 * std::fabs(real());
                break;
            case Kind::meeting:
                break;
            case Kind::lattice:
                ball.radius = 0.5;
                break;
            case Kind::ranges:
            case Kind::extremes:
                ball.radius = std::fabs(random.in_binades(-140, 100));
                break;
            default:
                ball.radius = 0.25 * random.between(0, 2);
        }
        state.balls.push_back(ball);
        state.masses.push_back(1.0);
    }
    state.in_place.resize(state.balls.size());
    if (kind == Kind::extremes) return state;
    // Nothing may be left to do before the time of a state.
    const std::vector<brute::Ball> balls = to_brute<D>(state.balls);
    for (std::size_t i = 0; i < balls.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (brute::meeting_time(balls[i], balls[j], to_brute<D>(effects), state.time))
                for (Ball<D>& ball : state.balls) ball.time = state.time;
    return state;
}

template <int D>
std::vector<Effects<D>> worlds() {
    Effects<D> falling;
    falling.gravity[D - 1] = -1.0;
    Effects<D> endless;
    endless.box = cube<D>(4.0);
    endless.box->low.fill(-4.0);
    endless.periodic = true;
    Effects<D> lost = endless;
    lost.restitution = 0.5;
    lost.gravity[0] = 0.25;
    return {{}, falling, endless, lost};
}

template <int D>
void expect_near(const State<D>& state, const Effects<D>& effects) {
    const std::vector<brute::Ball> balls = to_brute<D>(state.balls);
    const brute::World world = to_brute<D>(effects);
    const auto expected = brute::closest(balls, world, state.time);
    const auto pair = closest_pair(state, effects);
    ASSERT_EQ(pair.has_value(), expected.has_value());
    if (!pair) return;
    ASSERT_EQ(*pair, of_oracle(*expected))
        << in_words(*pair) << "\nexpected " << in_words(of_oracle(*expected));
    for (int i = 0; i < static_cast<int>(balls.size()); ++i) {
        const auto near = brute::closest(balls, world, state.time, i);
        const Neighbour right{near->a == i ? near->b : near->a, near->gap};
        ASSERT_EQ(nearest(state, effects, i), right) << i;
    }
}

/// By brute force from strike to strike.
template <int D>
std::vector<ClosestPair> brute_list(const State<D>& state, const Effects<D>& effects, double end) {
    std::vector<ClosestPair> list;
    Simulation<D> simulation(state, effects);
    simulation.run({.until = state.time});
    const auto world = to_brute<D>(effects);
    for (double from = state.time; from < end;) {
        const State<D> now = simulation.state();
        double to = end;
        const Outcome outcome = simulation.run({.until = end, .strikes = 1},
                                               [&](const Strike& strike) { to = strike.time; });
        if (outcome.ending == Ending::collapse) to = outcome.last.time;
        if (from < to) {
            for (const brute::Near& near :
                 brute::closest_list(to_brute<D>(now.balls), world, from, to))
                if (list.empty() || list.back().a != near.a || list.back().b != near.b)
                    list.push_back(of_oracle(near));
        }
        from = to;
        if (outcome.ending != Ending::strikes) break;
    }
    return list;
}
template <int D>
void expect_list(const State<D>& state, const Effects<D>& effects, double end,
                 std::size_t& entries) {
    std::vector<ClosestPair> expected;
    try {
        expected = brute_list(state, effects, end);
    } catch (const std::range_error&) {
        EXPECT_THROW((void)closest_pairs(state, effects, state.time, end), std::range_error);
        return;
    }
    const ClosestPairs list = closest_pairs(state, effects, state.time, end);
    entries += expected.size();
    for (std::size_t i = 0; i < std::min(expected.size(), list.pairs.size()); ++i)
        ASSERT_EQ(list.pairs[i], expected[i]) << "entry " << i << ": " << in_words(list.pairs[i])
                                              << "\nexpected " << in_words(expected[i]);
    ASSERT_EQ(list.pairs.size(), expected.size());
}

template <int D>
void expect_near_in_all(int rounds, std::uint64_t seed) {
    Random random(seed);
    for (int round = 0; round < rounds; ++round) {
        for (int kind = 0; kind < kinds; ++kind) {
            for (const Effects<D>& effects : worlds<D>()) {
                SCOPED_TRACE(testing::Message() << "kind " << kind << " round " << round);
                if (effects.periodic && Kind{kind} >= Kind::ranges) continue;
                const int most = effects.periodic ? 4 : 12;
                const auto state =
                    state_of<D>(Kind{kind}, random.between(0, most), effects, random);
                expect_near(state, effects);
                if (testing::Test::HasFatalFailure()) return;
            }
        }
    }
}
template <int D>
void expect_lists_in_all(int rounds, std::uint64_t seed) {
    Random random(seed);
    std::size_t entries = 0;
    std::size_t lists = 0;
    for (int round = 0; round < rounds; ++round) {
        for (int kind = 0; kind < kinds_that_fly; ++kind) {
            for (const Effects<D>& effects : worlds<D>()) {
                SCOPED_TRACE(testing::Message() << "kind " << kind << " round " << round);
                if (effects.periodic && (Kind{kind} == Kind::ranges || round % 8 != 0)) continue;
                const int number = effects.periodic ? 2 + random.below(2) : random.between(2, 4);
                const auto state = state_of<D>(Kind{kind}, number, effects, random);
                const double time = effects.periodic ? 0.5 : 2.0;
                expect_list(state, effects, state.time + time * random.significand(), entries);
                ++lists;
                if (testing::Test::HasFatalFailure()) return;
            }
        }
    }
    ASSERT_GT(entries, lists);
}

TEST(MotionQueries, NearestAndClosestAreThoseOfBruteForce) {
    expect_near_in_all<2>(is_fast ? 6 : 3, 1);
    expect_near_in_all<3>(is_fast ? 4 : 2, 2);
}

/// Balls that are larger than the periodic box, and lie in it many times over.
template <int D>
State<D> in_a_small_box(Kind kind, double largest, const Effects<D>& effects, Random& random) {
    State<D> state = state_of<D>(kind, random.between(2, 4), effects, random);
    for (Ball<D>& ball : state.balls) ball.radius = largest * 0.125 * random.between(0, 8);
    return state;
}
template <int D>
Effects<D> small_box(bool falls) {
    Effects<D> effects;
    effects.box = cube<D>(1.0);
    effects.box->high[0] = 0.75;
    effects.periodic = true;
    if (falls) effects.gravity[D - 1] = -1.0;
    return effects;
}
template <int D>
void expect_near_in_a_small_box(int rounds, std::uint64_t seed) {
    Random random(seed);
    for (int round = 0; round < rounds; ++round)
        for (const Kind kind : {Kind::random, Kind::grid, Kind::beside, Kind::parallel})
            for (const double largest : {0.5, 8.0, 0x1p30})
                ASSERT_NO_FATAL_FAILURE(
                    expect_near(in_a_small_box(kind, largest, small_box<D>(round % 2 == 0), random),
                                small_box<D>(round % 2 == 0)));
}
TEST(MotionQueries, NearestAndClosestInABoxSmallerThanTheBalls) {
    expect_near_in_a_small_box<2>(is_fast ? 12 : 3, 6);
    expect_near_in_a_small_box<3>(is_fast ? 6 : 2, 7);
}

/// At any moment of a flight through many images the closest pair is one of those told.
template <int D>
void expect_closest_among_those_told(int rounds, std::uint64_t seed) {
    Random random(seed);
    const std::function<bool()> nobody;
    Stop never(nobody);
    int lists = 0;
    for (int round = 0; round < rounds; ++round) {
        for (const Kind kind : {Kind::random, Kind::grid, Kind::parallel}) {
            const Effects<D> effects = small_box<D>(round % 2 == 0);
            const State<D> state =
                in_a_small_box(kind, round % 3 == 0 ? 0.0 : 2.0, effects, random);
            const double end =
                state.time + random.significand() * (round % 2 == 0 ? 0.25 : 4.0 / D);
            const NearPairs<D> near(state.balls, effects, state.time, end);
            const auto told = near.closest(NearPairs<D>::no_limit - 1, never);
            if (!told) continue;
            ++lists;
            for (int look = 0; look <= 8; ++look) {
                const double time = state.time + (end - state.time) * look / 8;
                const auto closest =
                    *brute::closest(to_brute<D>(state.balls), to_brute<D>(effects), time);
                const auto is_it = [&](const NearPair<D>& pair) {
                    return pair.a == closest.a && pair.b == closest.b &&
                           pair.gap.low <= closest.gap + 1e-12 &&
                           closest.gap - 1e-12 <= pair.gap.high;
                };
                ASSERT_TRUE(std::ranges::any_of(*told, is_it)) << round << ", " << look;
            }
        }
    }
    // Few flights are too long.
    ASSERT_GT(lists, 2 * rounds);
}
TEST(MotionQueries, TheClosestPairIsAmongThoseToldInABoxSmallerThanTheBalls) {
    expect_closest_among_those_told<2>(is_fast ? 30 : 6, 8);
    expect_closest_among_those_told<3>(is_fast ? 10 : 3, 9);
}

/// A pair that may be nearest in a million images is refused at once, however these are spread over
/// the axes.
TEST(MotionQueries, AMillionImagesAreTooMany) {
    Effects<2> effects;
    effects.box = cube<2>(1.0);
    effects.periodic = true;
    State<2> state;
    state.time = 1.0;
    state.masses.assign(2, 1.0);
    state.in_place.resize(2);
    for (const double far : {0x1p62, 0x1p64, 0x1p80}) {
        // It is known within some thousand lengths, or more, where it is.
        state.balls = {{{-far, -far}, {far, far}, 0.0, 0.0}, {{0.5, 0.5}, {0, 0}, 0.0, 0.0}};
        EXPECT_THROW((void)closest_pair(state, effects), std::range_error) << far;
        EXPECT_THROW((void)nearest(state, effects, 1), std::range_error) << far;
        // Such balls cannot be told from others that are larger by a length.
        state.balls = {{{0.25, 0.25}, {0, 0}, far, 0.0}, {{0.5, 0.5}, {0, 0}, 0.0, 0.0}};
        EXPECT_THROW((void)closest_pair(state, effects), std::range_error) << far;
    }
}

TEST(MotionQueries, ListsAreThoseOfBruteForceInThePlane) {
    expect_lists_in_all<2>(is_fast ? 5 : 2, 3);
}
TEST(MotionQueries, ListsAreThoseOfBruteForceInSpace) {
    expect_lists_in_all<3>(is_fast ? 5 : 2, 4);
}

/// At rest, or along the first axis.
template <int D>
Ball<D> on_a_line(double x, double v, double radius, double beside) {
    Ball<D> ball;
    ball.x[0] = x;
    ball.v[0] = v;
    ball.x[D - 1] = beside;
    ball.radius = radius;
    return ball;
}
/// Two gaps that are equal for some time and not for all of it. Two points are |l| apart, l linear
/// in time with its root at 1 / speed, and two balls of radius 1/2 are |l + 1| apart: where l >= 0
/// the gaps are equal, and where l < 0 the balls are closer.
template <int D>
void expect_change_at_a_kink(double speed, bool is_rising, bool points_come_first) {
    SCOPED_TRACE(testing::Message()
                 << D << " axes, speed " << speed << (is_rising ? ", rising" : "")
                 << (points_come_first ? ", points first" : ""));
    const double sign = is_rising ? 1.0 : -1.0;
    State<D> state;
    state.balls = {on_a_line<D>(-sign, sign * speed, 0, 0), on_a_line<D>(0, 0, 0, 0),
                   on_a_line<D>(1 - sign, sign * speed, 0.5, 20), on_a_line<D>(0, 0, 0.5, 20)};
    if (!points_come_first)
        std::rotate(state.balls.begin(), state.balls.begin() + 2, state.balls.end());
    state.masses.assign(4, 1.0);
    state.in_place.resize(4);
    std::size_t entries = 0;
    for (const Effects<D>& effects : worlds<D>())
        if (!effects.periodic) expect_list(state, effects, 1.5 / speed, entries);
    // Falling, the balls strike at about 1 / speed.
    if (!is_rising) return;
    const ClosestPairs list = closest_pairs(state, Effects<D>{}, 0.0, 1.5 / speed);
    ASSERT_EQ(list.pairs.size(), points_come_first ? 2U : 1U);
    EXPECT_EQ(list.pairs.back().time, points_come_first ? 1.0 / speed : 0.0);
    EXPECT_EQ(numbers(list.pairs.back()), std::pair(0, 1));
}
TEST(MotionQueries, GapsThatAreEqualForSomeTime) {
    for (const double speed : {1.0, 3.0, 10.0, 0.7}) {
        for (const bool is_rising : {false, true}) {
            for (const bool points_come_first : {false, true}) {
                expect_change_at_a_kink<2>(speed, is_rising, points_come_first);
                expect_change_at_a_kink<3>(speed, is_rising, points_come_first);
            }
        }
    }
}

/// An end that leaves so many strikes, for scenes that have a million of them.
template <int D>
double end_of(const Scene<D>& scene, double end, std::uint64_t strikes) {
    Simulation<D> simulation(start<D>(scene.bodies, scene.effects), scene.effects);
    simulation.run({.until = end, .strikes = strikes});
    return std::min(end, simulation.state().time);
}
/// At times of all kinds the list names the pair that is the closest one then.
template <int D>
void expect_list_at_times(const Scene<D>& scene, double begin, double end, int looks) {
    SCOPED_TRACE(scene.name);
    const State<D> first = start<D>(scene.bodies, scene.effects);
    const ClosestPairs list = closest_pairs(first, scene.effects, begin, end);
    ASSERT_NE(list.outcome.ending, Ending::collapse);
    ASSERT_FALSE(list.pairs.empty());
    ASSERT_EQ(list.pairs.front().time, begin);
    for (std::size_t i = 1; i < list.pairs.size(); ++i) {
        ASSERT_LE(list.pairs[i - 1].time, list.pairs[i].time);
        ASSERT_NE(numbers(list.pairs[i - 1]), numbers(list.pairs[i]));
    }
    State<D> then = first;
    for (int look = 0; look < looks; ++look) {
        const double time = begin + (end - begin) * (look + 0.375) / looks;
        then = state_at(then, scene.effects, time);
        ASSERT_EQ(then.time, time);
        const auto pair = closest_pair(then, scene.effects);
        const auto next = std::ranges::upper_bound(list.pairs, time, {}, &ClosestPair::time);
        const ClosestPair& listed = *(next - 1);
        ASSERT_EQ(numbers(*pair), numbers(listed)) << in_words(*pair) << ", " << in_words(listed);
        // The nearest neighbour of each of the two is no farther.
        ASSERT_EQ(nearest(then, scene.effects, pair->a)->gap, pair->gap);
        ASSERT_EQ(nearest(then, scene.effects, pair->b)->gap, pair->gap);
    }
}
TEST(MotionQueries, ListsOfManyBallsNameTheClosestPairOfEachTime) {
    const int looks = is_fast ? 25 : 5;
    for (const Scene<2>& scene : all_scenes<2>(is_fast ? 144 : 36))
        expect_list_at_times(scene, 0.125, end_of(scene, 0.75, 1000), looks);
    for (const Scene<3>& scene : all_scenes<3>(is_fast ? 125 : 27))
        expect_list_at_times(scene, 0.125, end_of(scene, 0.75, 1000), looks);
}
/// So long a flight that all pairs may come near is taken in parts.
TEST(MotionQueries, LongFlightsOfManyPointsAreTakenInParts) {
    for (const bool periodic : {false, true}) {
        Scene<2> scene = gas<2>(is_fast ? 121 : 49, periodic, 11);
        if (!periodic) scene.effects.box.reset();
        for (Body<2>& body : scene.bodies) body.radius = 0.0;
        expect_list_at_times(scene, 1.0, 9.0, is_fast ? 100 : 10);
    }
    // Two balls go around a box many times.
    Scene<3> fast{"fast", {}, {}};
    fast.effects.box = cube<3>(1.0);
    fast.effects.periodic = true;
    fast.bodies = {{{0.25, 0.25, 0.25}, {}, 0.0, 1.0},
                   {{0.5, 0.75, 0.125}, {1000.0, 1.0, 30.0}, 0.0, 1.0},
                   {{0.75, 0.5, 0.125}, {-10.0, 20.0, 500.0}, 0.0, 1.0}};
    expect_list_at_times(fast, 0.0, 1.0, is_fast ? 100 : 10);
}
/// Many pairs are equally close all the time: no part of it has fewer.
TEST(MotionQueries, PointsThatFlyTogether) {
    Scene<2> scene{"points that fly together", {}, {}};
    for (int i = 0; i < 60; ++i)
        scene.bodies.push_back({{0.0, 0.0}, {i % 2 == 0 ? 1.0 : -1.0, 0.5}, 0.0, 1.0});
    expect_list_at_times(scene, 0.0, 4.0, 7);
    const State<2> first = start<2>(scene.bodies, scene.effects);
    const ClosestPairs list = closest_pairs(first, scene.effects, 1.0, 4.0);
    ASSERT_EQ(list.pairs, (std::vector<ClosestPair>{{1.0, 0, 2, 0.0}}));
}

/// A list is stopped between strikes, too, and is right as far as it goes.
TEST(MotionQueries, AListIsStoppedWithinAFlight) {
    Scene<2> points = gas<2>(is_fast ? 400 : 200, false, 12);
    points.effects.box.reset();
    for (Body<2>& body : points.bodies) body.radius = 0.0;
    // All pairs are equally close for ever, and there is no part of the time with fewer.
    Scene<2> one_place = points;
    for (std::size_t i = 0; i < one_place.bodies.size(); ++i)
        one_place.bodies[i] = {{0.0, 0.0}, {i % 2 == 0 ? 1.0 : -1.0, 0.5}, 0.0, 1.0};
    for (const Scene<2>& scene : {points, one_place}) {
        const State<2> first = start<2>(scene.bodies, scene.effects);
        std::uint64_t questions = 0;
        double reached = 1.0;
        const auto list_until = [&](std::uint64_t most) {
            questions = 0;
            reached = 1.0;
            // Pairs have no events of their own: the run itself asks nobody.
            return closest_pairs(first, scene.effects, 1.0, 9.0, {Structure::pairs},
                                 [&](double time) {
                                     EXPECT_GE(time, reached);
                                     EXPECT_LE(time, 9.0);
                                     reached = time;
                                     return ++questions > most;
                                 });
        };
        const ClosestPairs whole = list_until(~std::uint64_t{0});
        ASSERT_EQ(whole.outcome.ending, Ending::nothing);
        EXPECT_EQ(whole.time, 9.0);
        const std::uint64_t all = questions;
        ASSERT_GT(all, 10U);
        for (const std::uint64_t most : {std::uint64_t{0}, all / 4, all / 2, all - 1}) {
            const ClosestPairs part = list_until(most);
            EXPECT_EQ(part.outcome.ending, Ending::stopped);
            EXPECT_EQ(questions, most + 1);
            ASSERT_LE(part.pairs.size(), whole.pairs.size());
            EXPECT_TRUE(std::equal(part.pairs.begin(), part.pairs.end(), whole.pairs.begin()));
            // It is complete up to the time that was told last.
            EXPECT_EQ(part.time, reached);
            if (part.pairs.size() < whole.pairs.size()) {
                EXPECT_LE(part.time, whole.pairs[part.pairs.size()].time);
            }
            if (!part.pairs.empty()) {
                EXPECT_GE(part.time, part.pairs.back().time);
            }
        }
        struct Thrown {};
        EXPECT_THROW((void)closest_pairs(first, scene.effects, 1.0, 9.0, {Structure::pairs},
                                         [](double) -> bool { throw Thrown(); }),
                     Thrown);
    }
}

TEST(MotionQueries, StrikesAheadAreThoseOfTheRun) {
    for (const Scene<2>& scene : all_scenes<2>(64)) {
        SCOPED_TRACE(scene.name);
        const State<2> first = start<2>(scene.bodies, scene.effects);
        std::vector<Strike> log;
        const double last = end_of(scene, 2.0, 1000);
        Simulation<2>(first, scene.effects).run({.until = last}, [&](const Strike& strike) {
            log.push_back(strike);
        });
        // Asked from where a simulation stands, which goes on as if nobody had.
        Simulation<2> simulation(first, scene.effects);
        std::vector<Strike> same;
        const auto record = [&](const Strike& strike) { same.push_back(strike); };
        simulation.run({.until = 0.25 * last}, record);
        const State<2> then = simulation.state();
        const double begin =
            log.size() > 4 ? std::max(0.25 * last, log[log.size() / 2].time) : 0.5 * last;
        const double end = log.empty() ? last : log.back().time;
        if (begin <= end) {
            std::vector<Strike> expected;
            for (std::size_t i = same.size(); i < log.size(); ++i)
                if (begin <= log[i].time && log[i].time <= end) expected.push_back(log[i]);
            EXPECT_EQ(strikes_between(then, scene.effects, begin, end).strikes, expected);
            EXPECT_EQ(expected.empty(), log.size() == same.size());
        }
        for (std::size_t i = same.size(); i < log.size(); i += 7) {
            const double time = log[i].time;
            const auto next = std::ranges::upper_bound(log, time, {}, &Strike::time);
            const auto told = next_strike(then, scene.effects, time, last);
            ASSERT_EQ(told.has_value(), next != log.end());
            if (told.has_value()) {
                ASSERT_EQ(*told, *next);
            }
        }
        simulation.run({.until = last}, record);
        EXPECT_EQ(same, log);
    }
}

TEST(MotionQueries, NearestAndClosestInEveryEnvironment) {
    Random random(5);
    const Effects<2> effects;
    for (int round = 0; round < 5 * kinds; ++round) {
        const auto state = state_of<2>(Kind{round % kinds}, 9, effects, random);
        const ClosestPair pair = *closest_pair(state, effects);
        const Neighbour near = *nearest(state, effects, 4);
        for (int mode = 1; mode < reference::Hostile::modes; ++mode) {
            EXPECT_EQ(
                reference::in_environment(mode, [&] { return *closest_pair(state, effects); }),
                pair);
            EXPECT_EQ(reference::in_environment(mode, [&] { return *nearest(state, effects, 4); }),
                      near);
        }
    }
}
TEST(MotionQueries, WhatCannotBeAskedIsRefused) {
    const std::vector<Body<2>> bodies = {{{0, 0}, {1, 0}, 1, 1}, {{5, 0}, {0, 0}, 1, 1}};
    const Effects<2> effects;
    const State<2> first = start<2>(bodies, effects);
    const State<2> later = state_at(first, effects, 2.0);
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double time : {1.0, nan, infinity, -infinity}) {
        EXPECT_THROW((void)state_at(later, effects, time), std::invalid_argument);
        EXPECT_THROW((void)closest_pairs(later, effects, time, time), std::invalid_argument);
        if (time == infinity) continue;
        EXPECT_THROW((void)strikes_between(later, effects, time, 9.0), std::invalid_argument);
        EXPECT_THROW((void)strikes_between(later, effects, 4.0, time), std::invalid_argument);
        EXPECT_THROW((void)closest_pairs(later, effects, 4.0, time), std::invalid_argument);
        EXPECT_THROW((void)next_strike(later, effects, time), std::invalid_argument);
    }
    EXPECT_THROW((void)nearest(first, effects, 2), std::out_of_range);
    EXPECT_THROW((void)nearest(first, effects, -1), std::out_of_range);
    EXPECT_EQ(next_strike(later, effects, 2.0)->time, 3.0);
    EXPECT_EQ(next_strike(later, effects, 3.0), std::nullopt);

    const State<2> one = start<2>(std::vector<Body<2>>(1), effects);
    EXPECT_EQ(nearest(one, effects, 0), std::nullopt);
    EXPECT_EQ(closest_pair(one, effects), std::nullopt);
    EXPECT_TRUE(closest_pairs(one, effects, 0.0, 1.0).pairs.empty());

    Effects<2> box;
    box.box = cube<2>(1.0);
    box.periodic = true;
    const std::vector<Body<2>> points = {{{0.5, 0.5}, {1, 0}, 0, 1}, {{0.25, 0.75}, {0, 0}, 0, 1}};
    State<2> far = start<2>(points, box);
    EXPECT_EQ(closest_pair(far, box)->gap, std::sqrt(0.125));
    far.balls[1].x[0] += 0x1p29;
    EXPECT_THROW((void)closest_pair(far, box), std::range_error);
    EXPECT_THROW((void)nearest(far, box, 0), std::range_error);
}
/// A strike at the time of the state is one of its strikes, with time steps, too.
TEST(MotionQueries, AStrikeAtTheBeginningIsBeforeTheFirstStep) {
    Effects<2> effects;
    effects.box = cube<2>(8.0);
    for (const double step : {0.0, 0.25}) {
        effects.time_step = step;
        const State<2> touching =
            start<2>(std::vector<Body<2>>{{{7.0, 4.0}, {1.0, 0.0}, 1.0, 1.0}}, effects);
        EXPECT_EQ(strikes_between(touching, effects, 0.0, 0.0).strikes.size(), 1U) << step;
        EXPECT_EQ(next_strike(touching, effects, 0.0)->time, 6.0) << step;
        EXPECT_EQ(next_strike(touching, effects, 6.0)->time, 12.0) << step;
        EXPECT_EQ(state_at(touching, effects, 0.0).balls[0].v[0], -1.0) << step;
    }
}

TEST(MotionQueries, ACollapseIsTold) {
    // A ball that bounces on a floor and comes to rest before t = 2.
    Effects<2> effects;
    effects.box = cube<2>(8.0);
    effects.gravity[1] = -1.0;
    effects.restitution = effects.wall_restitution = 0.125;
    const std::vector<Body<2>> bodies = {
        {{2, 2}, {0, 0}, 1, 1}, {{5, 5}, {0, 0}, 1, 1}, {{7, 2.5}, {0, 0}, 1, 1}};
    const State<2> first = start<2>(bodies, effects);
    const StrikeList strikes = strikes_between(first, effects, 0.0, 9.0);
    ASSERT_EQ(strikes.outcome.ending, Ending::collapse);
    const double last = strikes.outcome.last.time;
    EXPECT_EQ(strikes.strikes.back().time, last);
    const ClosestPairs list = closest_pairs(first, effects, 0.0, 9.0);
    EXPECT_EQ(list.outcome.ending, Ending::collapse);
    EXPECT_EQ(list.pairs, brute_list(first, effects, 9.0));
    for (const ClosestPair& pair : list.pairs) EXPECT_LE(pair.time, last);
    EXPECT_THROW((void)state_at(first, effects, 9.0), std::range_error);
    EXPECT_EQ(next_strike(first, effects, 8.0), std::nullopt);
}

}  // namespace
}  // namespace signum::motion
