/// The log of the simulation against the oracle's, strike by strike and bit by bit, whatever the
/// structure: small systems, many of them degenerate.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "motion_oracle.hpp"
#include "motion_scenes.hpp"

namespace signum::motion {
namespace {

const std::uint64_t scenes = is_fast ? 40 : 6;

template <int D>
bool overlap(const Body<D>& a, const Body<D>& b, const Effects<D>& effects) {
    return square_of_distance(a.x, b.x, effects) <
           (a.radius + b.radius) * (a.radius + b.radius) * (1.0 + 1e-15);
}

/// Balls that do not overlap, with numbers that are small multiples of 1/8 or random ones.
template <int D>
Scene<D> random_scene(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    const auto choose = [&](int n) {
        return static_cast<int>(random() % static_cast<unsigned>(n));
    };
    const bool round = choose(2) == 0;
    const auto number = [&](double low, double high) {
        const double x = std::uniform_real_distribution<double>(low, high)(random);
        return round ? std::round(8.0 * x) / 8.0 : x;
    };
    Scene<D> scene{"small", {}, {}};
    Effects<D>& effects = scene.effects;
    constexpr double size = 6.0;
    const int kind = choose(4);  // no box, a box twice, a periodic one
    if (kind > 0) {
        effects.box.emplace();
        effects.box->low.fill(0.0);
        effects.box->high.fill(size);
        effects.periodic = kind == 3;
    }
    if (choose(3) == 0) effects.gravity[D - 1] = round ? -0.5 : number(-1.0, 0.0);
    constexpr std::array<double, 5> restitutions = {1.0, 1.0, 0.9, 0.5, 0.0};
    effects.restitution = restitutions[static_cast<std::size_t>(choose(5))];
    effects.wall_restitution = restitutions[static_cast<std::size_t>(choose(4))];
    const bool equal = choose(2) == 0;
    const int most = 3 + choose(8);
    for (int tries = 0; tries < 100 && static_cast<int>(scene.bodies.size()) < most; ++tries) {
        Body<D> body;
        body.radius = equal ? 0.5 : std::max(number(0.0, 0.7), 0.125);
        body.mass = equal ? 1.0 : std::max(number(0.0, 4.0), 0.125);
        for (int k = 0; k < D; ++k) {
            body.x[k] = number(body.radius, size - body.radius);
            body.v[k] = choose(4) == 0 ? 0.0 : number(-2.0, 2.0);
        }
        if (std::ranges::none_of(
                scene.bodies, [&](const Body<D>& other) { return overlap(body, other, effects); }))
            scene.bodies.push_back(body);
    }
    return scene;
}

TEST(MotionLog, OfRandomScenesInThePlaneIsTheOracles) {
    for (std::uint64_t seed = 0; seed < scenes; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        expect_log_of_oracle(random_scene<2>(seed), 20.0, 60);
        if (HasFatalFailure()) return;
    }
}

TEST(MotionLog, OfRandomScenesInSpaceIsTheOracles) {
    for (std::uint64_t seed = 0; seed < scenes; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        expect_log_of_oracle(random_scene<3>(seed), 20.0, 60);
        if (HasFatalFailure()) return;
    }
}

/// Two heavy walls that a ball flies between, so that the clock of a lonely ball stands still, and
/// one that it meets far off and long after.
TEST(MotionLog, OfABallThatFliesFarBeforeItStrikesIsTheOracles) {
    const std::vector<Body<2>> bodies = {
        {{0, 1.5}, {0, 0}, 0.25, 0x1p120},
        {{0, -1.5}, {0, 0}, 0.25, 0x1p120},
        {{0, 0.1}, {0, 2}, 0.25, 1.0},
        {{-1.0, 0x1.3896b28936ba7p-3}, {0x1p-9, 0}, 0.25, 0x1p40},
        {{3, 0}, {0x1.31e302e6a04dfp+0, 0x1.e40f28f0d2a97p-3}, 0.25, 1.0}};
    expect_log_of_oracle<2>({"far", bodies, {}}, 700.0, 400);
}

TEST(MotionLog, NumbersOutsideTheWindowAreRefused) {
    for (const double number : {0x1p-151, 0x1p151, -0x1p-151, 5e-324, 1e300}) {
        SCOPED_TRACE(number);
        EXPECT_THROW(start<2>(std::vector<Body<2>>{{{number, 0}, {0, 0}, 1, 1}}, {}), BallError);
        EXPECT_THROW(start<2>(std::vector<Body<2>>{{{0, 0}, {0, number}, 1, 1}}, {}), BallError);
        EXPECT_THROW(start<2>(std::vector<Body<2>>{{{0, 0}, {0, 0}, number, 1}}, {}), BallError);
        EXPECT_THROW(start<2>(std::vector<Body<2>>{{{0, 0}, {0, 0}, 1, number}}, {}), BallError);
        Effects<2> pull;
        pull.gravity = {0, number};
        EXPECT_THROW(start<2>({}, pull), std::invalid_argument);
        Effects<2> walls;
        walls.box = Box<2>{{-1, -1}, {1, std::fabs(number)}};
        EXPECT_THROW(start<2>({}, walls), std::invalid_argument);
    }
    EXPECT_NO_THROW(start<2>(std::vector<Body<2>>{{{0x1p-150, 0}, {0, 0x1p150}, 1, 1}}, {}));
}

}  // namespace
}  // namespace signum::motion
