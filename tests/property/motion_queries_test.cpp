/// Who is near whom, when, and what strikes: equal to brute force in rationals, on input with ties
/// of all kinds.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

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
    ranges     ///< sizes from 2^-140 to 2^140
};
constexpr int kinds = 8;

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
                ball.radius = std::fabs(random.in_binades(-140, 100));
                break;
            default:
                ball.radius = 0.25 * random.between(0, 2);
        }
        state.balls.push_back(ball);
        state.masses.push_back(1.0);
    }
    state.in_place.resize(state.balls.size());
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
                if (effects.periodic && Kind{kind} == Kind::ranges) continue;
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
        for (int kind = 0; kind < kinds; ++kind) {
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
    std::printf("%zu lists, %zu entries\n", lists, entries);
    ASSERT_GT(entries, lists);
}

TEST(MotionQueries, NearestAndClosestAreThoseOfBruteForce) {
    expect_near_in_all<2>(is_fast ? 40 : 4, 1);
    expect_near_in_all<3>(is_fast ? 20 : 2, 2);
}

TEST(MotionQueries, ListsAreThoseOfBruteForceInThePlane) {
    expect_lists_in_all<2>(is_fast ? 8 : 2, 3);
}
TEST(MotionQueries, ListsAreThoseOfBruteForceInSpace) {
    expect_lists_in_all<3>(is_fast ? 8 : 2, 4);
}

}  // namespace
}  // namespace signum::motion
