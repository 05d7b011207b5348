/// Meetings with a wall that shakes against a second method: sampling, and bisection in 50 decimal
/// digits with the sines of Boost. And against what is known by hand.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <stdexcept>

#include <gtest/gtest.h>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include "../../motion/meeting_time.hpp"
#include "../../motion/shaking_wall.hpp"
#include "../oracle/oracle_test_support.hpp"
#include "../thoroughness.hpp"

namespace signum::motion {
namespace {

using oracle_test::Random;
using Real = boost::multiprecision::cpp_bin_float_50;

const int share = is_fast ? 1 : 3;  // of the trials one in so many

struct Case {
    GrowingBall<2> ball;
    ShakingWall wall;
    Effects<2> effects;

    [[nodiscard]] double time() const { return meeting_time(ball, wall, effects); }

    template <class T>
    [[nodiscard]] T gap(const T& t) const {
        using std::sin;
        const int k = wall.wall / 2;
        const T dt = t - T(ball.time);
        const T x = T(ball.x[k]) + (T(ball.v[k]) + T(effects.gravity[k]) * dt / 2) * dt;
        const T height =
            x - T(wall.level) - T(wall.amplitude) * sin(T(wall.frequency) * t + T(wall.phase));
        return (wall.wall % 2 != 0 ? -height : height) - T(ball.radius) - T(ball.growth) * t;
    }
    template <class T>
    [[nodiscard]] T slope(const T& t) const {
        using std::cos;
        const int k = wall.wall / 2;
        const T v =
            T(ball.v[k]) + T(effects.gravity[k]) * (t - T(ball.time)) -
            T(wall.amplitude) * T(wall.frequency) * cos(T(wall.frequency) * t + T(wall.phase));
        return (wall.wall % 2 != 0 ? -v : v) - T(ball.growth);
    }
    template <class T>
    [[nodiscard]] bool falls_below(const T& t) const {
        return gap(t) < 0 && slope(t) < 0;
    }
};

/// Where a property begins that holds at `high`, not at `low`, once and for all in between.
template <class Holds>
Real beginning(Real low, Real high, const Holds& holds) {
    for (int i = 0; i < 140; ++i) {
        const Real middle = (low + high) / 2;
        (holds(middle) ? high : low) = middle;
    }
    return (low + high) / 2;
}

/// Whether a double is the nearest one to a number, as far as 35 digits behind the point tell.
testing::AssertionResult is_nearest(double time, const Real& number) {
    const auto off = [&](double x) { return Real(abs(Real(x) - number)); };
    const Real tiny("1e-35");
    if (off(time) <= off(std::nextafter(time, infinity)) + tiny &&
        off(time) <= off(std::nextafter(time, -infinity)) + tiny)
        return testing::AssertionSuccess();
    return testing::AssertionFailure() << time << " for " << number;
}

/// The first time, on a fine grid, when it falls below 0.
std::optional<Real> sampled_meeting(const Case& scene, double until) {
    const double step = 0.004 / (1.0 + std::fabs(scene.wall.frequency));
    const double start = scene.ball.time;
    double before = start;
    for (double t = start; t < until; t += step) {
        if (scene.falls_below(t)) {
            return beginning(Real(before), Real(t),
                             [&](const Real& x) { return scene.falls_below(x); });
        }
        before = t;
    }
    return std::nullopt;
}

Case random_case(Random& random) {
    const bool round = random.below(2) == 0;
    const auto number = [&](double size) {
        const double x = size * (2.0 * random.unit() - 1.0);
        return round ? 0.5 * std::round(2.0 * x) : x;
    };
    Case scene;
    scene.wall.wall = random.below(4);
    scene.wall.level = number(1.0);
    scene.wall.amplitude = number(2.0);
    scene.wall.frequency = number(4.0);
    scene.wall.phase = number(4.0);
    scene.ball.x = {number(4.0), number(4.0)};
    scene.ball.v = {number(3.0), number(3.0)};
    scene.ball.time = number(4.0);
    scene.ball.radius = std::fabs(number(1.0));
    if (random.below(4) == 0) scene.ball.growth = number(0.5);
    if (random.below(3) != 0) scene.effects.gravity = {number(2.0), number(2.0)};
    return scene;
}

TEST(ShakingWall, MeetsWhenSamplesSay) {
    Random random(1801);
    int met = 0;
    int at_once = 0;
    for (int i = 0; i < 300 / share; ++i) {
        const Case scene = random_case(random);
        const double until = scene.ball.time + 12.0;
        const double time = scene.time();
        const std::optional<Real> expected = sampled_meeting(scene, until);
        if (expected) {
            ASSERT_TRUE(is_nearest(time, *expected)) << "case " << i;
            ++met;
            at_once += static_cast<int>(time == scene.ball.time);
        } else {
            ASSERT_GE(time, until) << "case " << i;
        }
    }
    EXPECT_GT(met, 120 / share);
    EXPECT_LT(met, 290 / share);
    EXPECT_GT(at_once, 20 / share);
}

/// A ball that is thrown so that at a time it is as fast as the wall, and a little way from it.
Case nearly_grazing(Random& random, bool from_above) {
    Case scene;
    scene.wall = {2, 0.5, 0.25 + random.unit(), 0.5 + 2.0 * random.unit(), random.unit()};
    const double sine = std::sin(scene.wall.frequency * 3.0 + scene.wall.phase);
    const double cosine = std::cos(scene.wall.frequency * 3.0 + scene.wall.phase);
    const double bend = scene.wall.amplitude * scene.wall.frequency * scene.wall.frequency;
    const double g = (from_above ? 1.25 : -1.25) * bend;
    const double v = scene.wall.amplitude * scene.wall.frequency * cosine - 0.5 * g;
    const double off = std::ldexp(2.0 * random.unit() - 1.0, -3 - random.below(50));
    scene.ball.radius = 0.25;
    scene.ball.time = 2.5;
    scene.ball.v[1] = v;
    scene.ball.x[1] = 0.5 + scene.wall.amplitude * sine + 0.25 - 0.5 * v - 0.125 * g + off;
    scene.effects.gravity[1] = g;
    return scene;
}

TEST(ShakingWall, NearlyGrazesFromAbove) {
    Random random(1802);
    int met = 0;
    for (int i = 0; i < 150 / share; ++i) {
        const Case scene = nearly_grazing(random, true);
        const double time = scene.time();
        const Real start(scene.ball.time);
        if (scene.gap(start) <= 0 || scene.slope(start) >= 0) continue;
        const Real least =
            beginning(start, Real(4.0), [&](const Real& t) { return scene.slope(t) >= 0; });
        if (scene.gap(least) >= 0) {
            ASSERT_EQ(time, infinity) << "case " << i;
        } else {
            const Real root =
                beginning(start, least, [&](const Real& t) { return scene.gap(t) < 0; });
            ASSERT_TRUE(is_nearest(time, root)) << "case " << i;
            ++met;
        }
    }
    EXPECT_GT(met, 40 / share);
    EXPECT_LT(met, 110 / share);
}

TEST(ShakingWall, NearlyGrazesFromBelow) {
    Random random(1803);
    int crossed = 0;
    int turned = 0;
    for (int i = 0; i < 150 / share; ++i) {
        const Case scene = nearly_grazing(random, false);
        const double time = scene.time();
        const Real start(scene.ball.time);
        if (scene.gap(start) >= 0 || scene.slope(start) <= 0) continue;
        const Real peak =
            beginning(start, Real(5.0), [&](const Real& t) { return scene.slope(t) <= 0; });
        if (scene.gap(peak) <= 0) {
            ASSERT_TRUE(is_nearest(time, peak)) << "case " << i;
            ++turned;
        } else {
            const Real root =
                beginning(peak, Real(8.0), [&](const Real& t) { return scene.gap(t) <= 0; });
            ASSERT_TRUE(is_nearest(time, root)) << "case " << i;
            ++crossed;
        }
    }
    EXPECT_GT(crossed, 40 / share);
    EXPECT_GT(turned, 40 / share);
}

TEST(ShakingWall, AtRestIsAPlane) {
    Random random(1804);
    for (int i = 0; i < 300; ++i) {
        Case scene = random_case(random);
        if (i % 2 == 0) {
            scene.wall.amplitude = 0.0;
        } else {
            scene.wall.frequency = 0.0;
            scene.wall.phase = 0.0;
        }
        HalfSpace<2> plane;
        const bool ceiling = scene.wall.wall % 2 != 0;
        plane.normal[scene.wall.wall / 2] = ceiling ? -1.0 : 1.0;
        plane.offset = ceiling ? -scene.wall.level : scene.wall.level;
        ASSERT_EQ(scene.time(), meeting_time(scene.ball, plane, scene.effects)) << "case " << i;
    }
}

Case falling(double x, double v, double g, double time = 0.0) {
    Case scene;
    scene.ball.x = {0.0, x};
    scene.ball.v = {0.0, v};
    scene.ball.time = time;
    scene.effects.gravity = {0.0, g};
    scene.wall.wall = 2;
    scene.wall.amplitude = 1.0;
    scene.wall.frequency = 1.0;
    return scene;
}

/// A wall that is stopped, with a phase, is where its sine says.
TEST(ShakingWall, Stopped) {
    Case scene = falling(4.0, -1.0, 0.0);
    scene.wall.frequency = 0.0;
    scene.wall.phase = 1.0;
    EXPECT_TRUE(is_nearest(scene.time(), 4 - sin(Real(1))));
    scene.ball.v[1] = 1.0;
    EXPECT_EQ(scene.time(), infinity);
    scene.effects.gravity[1] = -2.0;
    EXPECT_TRUE(is_nearest(scene.time(), Real(0.5) + sqrt(Real(4.25) - sin(Real(1)))));
}

/// At rest at the height of the crests it is grazed each time, an ulp below struck by the first.
TEST(ShakingWall, AtTheCrests) {
    EXPECT_EQ(falling(1.0, 0.0, 0.0).time(), infinity);
    const double below = std::nextafter(1.0, 0.0);
    EXPECT_TRUE(is_nearest(falling(below, 0.0, 0.0).time(), asin(Real(below))));
    // Below all troughs it is overlapped least when it is nearest.
    EXPECT_TRUE(is_nearest(falling(-1.0, 0.0, 0.0).time(), 3 * asin(Real(1))));
    EXPECT_TRUE(is_nearest(falling(-9.0, 0.0, 0.0).time(), 3 * asin(Real(1))));
}

/// As fast as the wall ever is, it leaves or meets it without an instant of rest between them.
TEST(ShakingWall, AsFastAsTheWall) {
    for (const double start : {-20.0, -1.0, 0.0, 1.0})
        EXPECT_EQ(falling(start, 1.0, 0.0, start).time(), infinity);
    Case scene = falling(20.0, -1.0, 0.0, -20.0);
    scene.wall.amplitude = -1.0;
    EXPECT_EQ(scene.time(), 0.0);  // sin t - t
    EXPECT_EQ(falling(0.0, 1.0, -0.25).time(), 0.0);
    EXPECT_EQ(falling(0.0, 1.0, 0.25).time(), infinity);
}

/// The sine at 0 is the only one that a parabola with rational numbers grazes: at a double, and at
/// 1/3.
TEST(ShakingWall, GrazesAtRationalTimes) {
    Case scene = falling(-0.5, 0.0, 1.0, 2.0);  // u + u²/2 - sin u, u = t - 3
    scene.wall.phase = -3.0;
    EXPECT_EQ(scene.time(), infinity);
    scene.ball.x[1] = -0.5 - 0x1p-53;
    EXPECT_NEAR(scene.time(), 3.0, 1e-7);
    scene.ball.x[1] = -0.5 + 0x1p-54;
    EXPECT_EQ(scene.time(), infinity);

    scene = falling(0.0, -3.0, 18.0);  // 3u + 9u² - sin 3u, u = t - 1/3
    scene.wall.frequency = 3.0;
    scene.wall.phase = -1.0;
    EXPECT_EQ(scene.time(), infinity);
    scene.ball.x[1] = -0x1p-60;
    EXPECT_NEAR(scene.time(), 1.0 / 3.0, 1e-8);
    scene.ball.x[1] = 0x1p-60;
    EXPECT_EQ(scene.time(), infinity);
}

/// Far away, and fast or slow: time is spent near the wall only.
TEST(ShakingWall, FromFarAway) {
    Case scene = falling(0x1p40, -1.0, 0.0);
    scene.wall.frequency = 1024.0;
    EXPECT_NEAR(scene.time(), 0x1p40, 2.0);
    EXPECT_TRUE(is_nearest(scene.time(),
                           beginning(Real(scene.time() - 0x1p-12), Real(scene.time() + 0x1p-12),
                                     [&](const Real& t) { return scene.gap(t) < 0; })));
    scene.effects.gravity[1] = 0x1p-10;
    EXPECT_EQ(scene.time(), infinity);
    scene = falling(0.0, 0x1p30, -0x1p-20);
    scene.wall.frequency = 0x1p-20;
    EXPECT_NEAR(scene.time(), 0x1p51, 0x1p21);
    scene = falling(3.0, -0x1p-1060, 0.0);
    EXPECT_EQ(scene.time(), infinity);
    scene.wall.frequency = 0x1p300;
    EXPECT_EQ(scene.time(), infinity);
}

TEST(ShakingWall, InSpace) {
    GrowingBall<3> ball;
    ball.x = {0.0, 0.0, 2.0};
    Effects<3> effects;
    effects.gravity = {0.0, 0.0, -1.0};
    const ShakingWall wall{4, 0.0, 0.5, 2.0, 1.0};
    Case scene = falling(2.0, 0.0, -1.0);
    scene.wall = {2, 0.0, 0.5, 2.0, 1.0};
    EXPECT_EQ(meeting_time(ball, wall, effects), scene.time());
}

/// Where the argument is tiny the sine is hardly told from it.
TEST(ShakingWall, OfTinyArguments) {
    for (const double start : {0x1p-1070, 0x1p-600, 0x1p-300, 0x1p-100}) {
        Case scene = falling(-start, -1.0, 0.0, start);
        scene.wall.amplitude = -1.0;  // sin t - t, some t³ below 0
        EXPECT_EQ(scene.time(), start);
        scene = falling(start, -1.0, 0.0, -start);
        scene.wall.amplitude = -1.0;  // as much above 0
        EXPECT_EQ(scene.time(), 0.0);
        scene = falling(start, 1.0, 0.0, start);  // t - sin t
        EXPECT_EQ(scene.time(), infinity);
    }
}

TEST(ShakingWall, RefusesRatherThanGuesses) {
    for (const double start : {0x1p-1070, 0x1p-300}) {
        // t - sin t - start · (t - start)²/2: its slope is nowhere below start²/2 until far later.
        const Case scene = falling(start, 1.0, -start, start);
        if (start < 0x1p-1000) {
            EXPECT_THROW((void)scene.time(), std::domain_error);
        } else {
            EXPECT_EQ(scene.time(), 2.0 / start);
        }
    }
}

}  // namespace
}  // namespace signum::motion
