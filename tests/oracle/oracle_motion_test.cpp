/// The oracle of moving balls against cases done by hand: rounding, meetings, and whole runs with
/// a known end. Meetings of degree 2 are found a second time by cases and by comparing squares.

#include <gtest/gtest.h>
#include "linear_form.hpp"
#include "motion.hpp"
#include "oracle_test_support.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace {

using namespace signum::oracle::motion;
using signum::oracle::exactly;
using signum::oracle::Rational;
using signum::oracle_test::Random;
using Kind = Wall::Kind;
using Time = std::optional<double>;
using Point = std::array<double, 3>;

constexpr Time never = std::nullopt;
constexpr double infinity = std::numeric_limits<double>::infinity();
const double ulp = 0x1p-52;

Wall plane(const Point& n, double c, double w = 0) {
    Wall wall;
    wall.kind = Kind::half_space, wall.n = n, wall.c = c, wall.w = w;
    return wall;
}
Wall circle(Kind kind, const Point& centre, double radius, const Point& u = {}) {
    Wall wall;
    wall.kind = kind, wall.centre = centre, wall.radius = radius, wall.u = u;
    return wall;
}
Wall floor_at(double y) {
    Wall wall;
    wall.n = {0, 1, 0}, wall.c = y;
    return wall;
}
World falling(double g) {
    World world;
    world.g = {0, g, 0};
    return world;
}
Time meeting(const Ball& a, const Ball& b, const World& world = {}) {
    const Time time = meeting_time(a, b, world);
    EXPECT_EQ(time, meeting_time(b, a, world));
    return time;
}

// Rounding

TEST(OracleMotion, QuotientsRoundLikeTheProcessor) {
    Random random(1601);
    for (int i = 0; i < 3000; ++i) {
        const auto number = [&] {
            const double x = (random.unit() + 0x1p-30) * (1 + random.unit() * 0x1p-22);
            return std::ldexp(random.below(2) == 0 ? x : -x, random.below(2100) - 1074);
        };
        const double p = number(), q = number();
        if (q == 0) continue;
        ASSERT_EQ(nearest_quotient(p, q), p / q) << p << " / " << q;
    }
}

TEST(OracleMotion, HalvesGoToTheEvenOne) {
    const double tiny = 0x1p-1074, big = std::numeric_limits<double>::max();
    EXPECT_EQ(nearest_quotient(1 + ulp, 2), 0.5 + ulp / 2);
    EXPECT_EQ(nearest_quotient(0x1p53 - 1, 0x1p53), 1 - 0x1p-53);
    EXPECT_EQ(nearest_quotient(3 * tiny, 2), 2 * tiny);  // of 1 and 2
    EXPECT_EQ(nearest_quotient(5 * tiny, 2), 2 * tiny);  // of 2 and 3
    EXPECT_EQ(nearest_quotient(-3 * tiny, 2), -2 * tiny);
    EXPECT_EQ(nearest_quotient(7 * tiny, 3), 2 * tiny);
    EXPECT_EQ(nearest_quotient(big, 1), big);
    EXPECT_EQ(nearest_quotient(big, -1), -big);
    EXPECT_EQ(nearest_quotient(big, 0.5), infinity);
    EXPECT_EQ(nearest_quotient(-big, 0.5), -infinity);
    for (const double p : {tiny, -tiny, 0.0, -0.0}) {
        EXPECT_EQ(nearest_quotient(p, 2), 0);
        EXPECT_FALSE(std::signbit(nearest_quotient(p, 2)));
    }
}

TEST(OracleMotion, RootsRoundLikeTheProcessor) {
    Random random(1602);
    for (int i = 0; i < 1000; ++i) {
        const double q = std::ldexp(random.unit() + 0x1p-30, 2 * random.below(1000) - 1000);
        ASSERT_EQ(nearest_quotient_by_root(q, q), std::sqrt(q));
    }
    EXPECT_EQ(nearest_quotient_by_root(0, 2), 0);
    EXPECT_EQ(nearest_quotient_by_root(21, 49), 3);
}

// When two balls meet

TEST(OracleMotion, HeadOn) {
    EXPECT_EQ(meeting({.x = {0, 0}, .v = {1, 0}, .r = 1}, {.x = {10, 0}, .r = 2}), 7);
    EXPECT_EQ(meeting({.x = {0, 0}, .v = {1, 0}, .r = 1}, {.x = {10, 0}, .v = {-2, 0}, .r = 0.5}),
              8.5 / 3);
    EXPECT_EQ(meeting({.x = {1, 1, 1}, .v = {2, 1, 2}, .r = 1}, {.x = {13, 7, 13}, .r = 2}), 5);
    // Points that would touch only pass through one another.
    EXPECT_EQ(meeting({.x = {0, 0}, .v = {1, 0}}, {.x = {10, 0}}), never);
}

TEST(OracleMotion, OwnTimesAndCommonGravity) {
    const Ball a{.x = {0, 0}, .v = {1, 0}, .r = 1}, b{.x = {10, 0}, .r = 2};
    for (const double g : {0.0, -9.8125}) {
        Ball later = a;  // a after 4
        later.x = {4, g * 8}, later.v = {1, g * 4}, later.t0 = 4;
        EXPECT_EQ(meeting(later, b, falling(g)), 7);
        later.x = {12, g * 72}, later.v = {1, g * 12}, later.t0 = 12;  // it has passed the middle
        EXPECT_EQ(meeting(later, b, falling(g)), never);
        later.x = {8, g * 32}, later.v = {1, g * 8}, later.t0 = 8;  // it is inside
        EXPECT_EQ(meeting(later, b, falling(g)), 8);
    }
}

TEST(OracleMotion, Grazes) {
    const Ball a{.x = {-5, 1}, .v = {1, 0}, .r = 0.5}, b{.r = 0.5};
    EXPECT_EQ(meeting(a, b), never);
    Ball moved = a;
    moved.x[1] = 1 + ulp;
    EXPECT_EQ(meeting(moved, b), never);
    moved.x[1] = 1 - ulp / 2;  // the root is 5 - sqrt(2^-52 - 2^-106)
    EXPECT_EQ(meeting(moved, b), 5 - 0x1p-26);
}

TEST(OracleMotion, RecedingAndOverlapping) {
    const Ball b{.r = 1};
    const auto from = [&](double x, double v) {
        return meeting({.x = {x, 0}, .v = {v, 0}, .r = 1, .t0 = 0.25}, b);
    };
    EXPECT_EQ(from(3, 1), never);
    EXPECT_EQ(from(3, 0), never);
    EXPECT_EQ(from(2, 1), never);  // touching
    EXPECT_EQ(from(2, 0), never);
    EXPECT_EQ(from(2, -1), 0.25);
    EXPECT_EQ(from(1, 1), never);  // overlapping
    EXPECT_EQ(from(1, 0), never);
    EXPECT_EQ(from(1, -1), 0.25);
    EXPECT_EQ(from(0, -1), never);  // concentric: from here on they only part
}

TEST(OracleMotion, GrowingRadii) {
    // 4² - (2 + 2t)² with both at rest
    EXPECT_EQ(meeting({.r = 1, .growth = 1}, {.x = {4, 0}, .r = 1, .growth = 1}), 1);
    // Faster than a ball that flees: A = 1 - 2² < 0, 10 + t = 1 + 2t.
    EXPECT_EQ(meeting({.r = 1, .growth = 2}, {.x = {10, 0}, .v = {1, 0}}), 9);
    // A = 0: (5 + t)² - (3 + t)² does not decrease, (5 - t)² - (3 + t)² does.
    EXPECT_EQ(meeting({.r = 3, .growth = 1}, {.x = {5, 0}, .v = {1, 0}}), never);
    EXPECT_EQ(meeting({.r = 3, .growth = 1}, {.x = {5, 0}, .v = {-1, 0}}), 1);
    // Radii count from 0, not from the own time.
    EXPECT_EQ(meeting({.r = 1, .t0 = 0.5, .growth = 1}, {.x = {4, 0}, .r = 1, .growth = 1}), 1);
    // Overlapping: who grows faster than the other flees meets it at once.
    EXPECT_EQ(meeting({.r = 2, .growth = 3}, {.x = {1, 0}, .v = {2, 0}}), 0);
    EXPECT_EQ(meeting({.r = 2, .growth = 1}, {.x = {1, 0}, .v = {5, 0}}), never);
}

TEST(OracleMotion, ABallThatCannotRiseOffTheFloor) {
    // -a + t - t², at its summit 1/4 - a
    const auto from = [](double a) {
        return meeting_time({.x = {0, 1 - a}, .v = {0, 1}, .r = 1}, floor_at(0), falling(-2));
    };
    EXPECT_EQ(from(0.5), 0.5);
    EXPECT_EQ(from(0.25), 0.5);
    EXPECT_EQ(from(0), 1);
    EXPECT_EQ(from(0.1875), 0.75);
    EXPECT_EQ(from(-2), 2);
    // Lying there, touching, overlapping, and an ulp above.
    const auto at_rest = [](double y) {
        return meeting_time({.x = {0, y}, .r = 1}, floor_at(0), falling(-2));
    };
    EXPECT_EQ(at_rest(1), 0);
    EXPECT_EQ(at_rest(0.5), 0);
    EXPECT_EQ(at_rest(1 + ulp), 0x1p-26);
    // Thrown at the ceiling: it meets it while it rises, not when it only grazes it.
    Wall ceiling;
    ceiling.n = {0, -1, 0}, ceiling.c = -5;
    const Ball thrown{.v = {0, 4}, .r = 1};
    EXPECT_EQ(meeting_time(thrown, ceiling, falling(-2)), never);
    EXPECT_EQ(meeting_time(thrown, ceiling, falling(-2.125)), never);
    EXPECT_EQ(meeting_time(thrown, ceiling, falling(0)), 1);
    ceiling.c = -4;
    EXPECT_EQ(meeting_time(thrown, ceiling, falling(-2)), 1);
}

TEST(OracleMotion, Circles) {
    const Ball ball{.v = {1, 0}, .r = 1};
    EXPECT_EQ(meeting_time(ball, circle(Kind::inside, {}, 5), {}), 4);
    EXPECT_EQ(meeting_time(ball, circle(Kind::inside, {}, 5, {-1, 0, 0}), {}), 2);
    EXPECT_EQ(meeting_time(ball, circle(Kind::outside, {10, 0, 0}, 2), {}), 7);
    EXPECT_EQ(meeting_time(ball, circle(Kind::outside, {10, 0, 0}, 2, {-1, 0, 0}), {}), 3.5);
    EXPECT_EQ(meeting_time(ball, circle(Kind::outside, {10, 3, 0}, 2), {}), never);  // a graze
    // Along the circle: outside it leaves, inside it meets.
    EXPECT_EQ(meeting_time({.x = {0, 3}, .v = {1, 0}, .r = 1}, circle(Kind::outside, {}, 2), {}),
              never);
    EXPECT_EQ(meeting_time({.x = {0, 3}, .v = {1, 0}, .r = 1}, circle(Kind::inside, {}, 4), {}), 0);
    // In space.
    World space;
    space.dimension = 3;
    EXPECT_EQ(meeting_time({.v = {1, 2, 2}, .r = 2}, circle(Kind::inside, {}, 11), space), 3);
}

TEST(OracleMotion, FallingInACircle) {
    // |(4t, 6t - t²)| = 15 at t = 3, and the same later on its way.
    const Wall bowl = circle(Kind::inside, {}, 16);
    EXPECT_EQ(meeting_time({.v = {4, 6}, .r = 1}, bowl, falling(-2)), 3);
    EXPECT_EQ(meeting_time({.x = {4, 5}, .v = {4, 4}, .r = 1, .t0 = 1}, bowl, falling(-2)), 3);
    EXPECT_EQ(meeting_time({.x = {12, 9}, .v = {4, 0}, .r = 1, .t0 = 3}, bowl, falling(-2)), 3);
    EXPECT_EQ(meeting_time({.r = 1}, bowl, falling(-30)), 1);
    // 225 - t⁴ - (1/8)²: t = 3.87…
    const Time sideways = meeting_time({.x = {0.125, 0}, .r = 1}, bowl, falling(-2));
    ASSERT_TRUE(sideways);
    EXPECT_NEAR(*sideways, std::pow(225 - 0x1p-6, 0.25), 1e-14);
    // Down upon a peg: 8 + 3y - y² = 6.
    const Wall peg = circle(Kind::outside, {0, 4, 0}, 1);
    EXPECT_EQ(meeting_time({.x = {0, 8}, .v = {0, 3}, .r = 1, .t0 = 2}, peg, falling(-2)),
              5.56155281280883027491);
}

TEST(OracleMotion, HalfPlanes) {
    const Ball ball{.x = {5, 5}, .v = {-1, -0.5}, .r = 2};
    EXPECT_EQ(meeting_time(ball, plane({3, 4, 0}, 0), {}), 5);
    EXPECT_EQ(meeting_time(ball, plane({3, 4, 0}, 0, 7.5), {}), 2);
    EXPECT_EQ(meeting_time(ball, plane({3, 4, 0}, 0, -5), {}), never);
    EXPECT_EQ(meeting_time({.x = {5, 5}, .r = 2}, plane({3, 4, 0}, 0), falling(-2)), 2.5);
    EXPECT_EQ(meeting_time({.x = {2, 0}, .v = {-1, 0}, .r = 1}, plane({1, 1, 0}, 0), {}),
              0.58578643762690495120);
    // A point does not fall through.
    EXPECT_EQ(meeting_time({.x = {5, 5}, .v = {-1, -0.5}}, plane({3, 4, 0}, 0), {}), 7);
    // A side is a half-plane.
    EXPECT_EQ(meeting_time(ball, plane({1, 0, 0}, 0.5), {}), 2.5);
    EXPECT_EQ(meeting_time(ball, plane({2, 0, 0}, 1), {}), 2.5);
    EXPECT_THROW(meeting_time(ball, plane({0, 0, 0}, 1), {}), std::invalid_argument);
}

/// F = a y² + 2 b y + c, y >= 0 the time since `since`, by cases and by comparing squares.
struct Quadratic {
    Rational a, b, c;

    bool falls_at_once() const { return b < 0 || (b == 0 && a < 0); }
    /// Nothing where there is no meeting, else the sign of the meeting's y minus another one.
    std::optional<int> compare(const Rational& y) const {
        if (c <= 0 && falls_at_once()) return Rational(0).compare(y);
        const Rational square = b * b - a * c;
        if (c <= 0 && (a >= 0 || square < 0)) {
            if (a >= 0) return std::nullopt;
            return Rational(-b / a).compare(y);  // the summit
        }
        if (a == 0) return b < 0 ? std::optional(Rational(-c / b / 2).compare(y)) : std::nullopt;
        if (a > 0 && (b >= 0 || square <= 0)) return std::nullopt;
        const Rational p = -b - a * y;  // y is (-b - √square) / a
        const int sign = p < 0 ? -1 : Rational(p * p).compare(square);
        return a > 0 ? sign : -sign;
    }
    bool agrees(const Time& time, double since) const {
        if (!compare(0)) return !time;
        if (!time || *time < since) return false;
        const auto half_way = [&](double neighbour) {
            return Rational((exactly(*time) + exactly(neighbour)) / 2 - exactly(since));
        };
        const int below = *compare(half_way(std::nextafter(*time, -infinity)));
        const int above = *compare(half_way(std::nextafter(*time, infinity)));
        return below >= 0 && above <= 0;
    }
};

TEST(OracleMotion, MeetingsOfBallsByComparingSquares) {
    Random random(1603);
    int meetings = 0;
    for (int i = 0; i < 1000; ++i) {
        const auto number = [&](int range) {
            const double fraction = i % 2 == 0 ? 0 : random.unit() * 0x1p-22;
            return random.below(2 * range + 1) - range + fraction;
        };
        const auto ball = [&] {
            return Ball{.x = {number(6), number(6), number(2)},
                        .v = {number(3), number(3), number(1)},
                        .r = std::abs(number(2)),
                        .t0 = std::abs(number(2)),
                        .growth = i % 3 == 0 ? std::abs(number(2)) : 0};
        };
        const Ball p = ball(), q = ball();
        const double since = std::max(p.t0, q.t0);
        const Rational t = exactly(since);
        const Rational reach =
            exactly(p.r) + exactly(q.r) + (exactly(p.growth) + exactly(q.growth)) * t;
        const Rational growth = exactly(p.growth) + exactly(q.growth);
        Quadratic f{-growth * growth, -growth * reach, -reach * reach};
        for (std::size_t k = 0; k < 3; ++k) {
            const Rational v = exactly(p.v[k]) - exactly(q.v[k]);
            const Rational x = exactly(p.x[k]) + exactly(p.v[k]) * (t - exactly(p.t0)) -
                               exactly(q.x[k]) - exactly(q.v[k]) * (t - exactly(q.t0));
            f.a += v * v, f.b += v * x, f.c += x * x;
        }
        const Time time = meeting(p, q);
        ASSERT_TRUE(f.agrees(time, since)) << "input " << i;
        if (time) ++meetings;
    }
    EXPECT_GT(meetings, 200);
}

TEST(OracleMotion, MeetingsWithAFloorByComparingSquares) {
    Random random(1604);
    int meetings = 0;
    for (int i = 0; i < 1000; ++i) {
        const double fraction = i % 2 == 0 ? 0 : random.unit() * 0x1p-22;
        const double y = random.below(9) - 2 + fraction, v = random.below(9) - 4 - fraction;
        const double g = random.below(7) - 4, since = random.below(3) + fraction;
        const Quadratic f{exactly(g) / 2, exactly(v) / 2, exactly(y) - 1};
        const Ball ball{.x = {0, y}, .v = {0, v}, .r = 1, .t0 = since};
        const Time time = meeting_time(ball, floor_at(0), falling(g));
        ASSERT_TRUE(f.agrees(time, since)) << "input " << i;
        if (time) ++meetings;
    }
    EXPECT_GT(meetings, 300);
}

/// The square of the distance that ball and circle have at time t, from the square of the distance
/// at which they touch; positive on the side that the circle allows.
Rational apart(const Ball& ball, const Wall& wall, const World& world, const Rational& t) {
    const Rational y = t - exactly(ball.t0), rho = exactly(wall.radius), r = exactly(ball.r);
    Rational square = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const Rational x = exactly(ball.x[k]) +
                           y * (exactly(ball.v[k]) + y * exactly(world.g[k]) / 2) -
                           exactly(wall.centre[k]) - t * exactly(wall.u[k]);
        square += x * x;
    }
    return wall.kind == Kind::outside ? Rational(square - (rho + r) * (rho + r))
                                      : Rational((rho - r) * (rho - r) - square);
}

TEST(OracleMotion, MeetingsWithCirclesByLookingOften) {
    Random random(1607);
    int meetings = 0, nevers = 0;
    for (int i = 0; i < 400; ++i) {
        const auto number = [&] { return 4 * random.unit() - 2; };
        World world;
        world.dimension = 3, world.g = {number(), number(), number()};
        const Ball ball{.x = {number(), number(), number()},
                        .v = {number(), number(), number()},
                        .r = random.unit() / 2,
                        .t0 = random.unit()};
        Wall wall = circle(i % 2 == 0 ? Kind::outside : Kind::inside,
                           {number(), number(), number()}, i % 2 == 0 ? 1 : 3);
        if (i % 3 == 0) wall.u = {number(), number(), number()};
        const Rational since = exactly(ball.t0);
        if (apart(ball, wall, world, since) <= 0) continue;
        const Time time = meeting_time(ball, wall, world);
        Rational until = since + 40;
        if (time) {
            until = (exactly(std::nextafter(*time, 0)) + exactly(*time)) / 2;
            const Rational after = (exactly(std::nextafter(*time, 99)) + exactly(*time)) / 2;
            ASSERT_GE(apart(ball, wall, world, until), 0) << "input " << i;
            ASSERT_LE(apart(ball, wall, world, after), 0) << "input " << i;
        }
        for (int k = 0; k < 60; ++k)
            ASSERT_GT(apart(ball, wall, world, since + (until - since) * k / 200), 0)
                << "input " << i;
        ++(time ? meetings : nevers);
    }
    EXPECT_GT(meetings, 100);
    EXPECT_GT(nevers, 30);
}

World torus(int dimension, double length) {
    World world;
    world.dimension = dimension, world.periodic = true;
    for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k) world.high[k] = length;
    return world;
}

TEST(OracleMotion, AcrossTheBorder) {
    const World world = torus(2, 10);
    const Ball a{.x = {9, 5}, .v = {1, 0}, .r = 1}, b{.x = {3, 5}, .r = 1};
    EXPECT_EQ(meeting_time(a, b, world, 100), 2);
    EXPECT_EQ(meeting_time(a, b, world, 2), 2);
    EXPECT_EQ(meeting_time(a, b, world, 1.75), never);
    // 1/3 rounds down: it is no later than its double.
    EXPECT_EQ(
        meeting_time({.x = {9, 5}, .v = {3, 0}, .r = 1}, {.x = {2, 5}, .r = 1}, world, 1.0 / 3),
        1.0 / 3);
    // Three times around in x, four times in y.
    EXPECT_EQ(meeting_time({.x = {5, 5}, .v = {3, 4}, .r = 0.5},
                           {.x = {5, 5.0 + 5.0 / 8}, .v = {0, 0}, .r = 0.125}, world, 0),
              0);
    EXPECT_EQ(meeting_time({.x = {0, 0}, .v = {3, 4}, .r = 0.125},
                           {.x = {3, 4}, .v = {0, 0}, .r = 0.125}, world, 100),
              0.95);
    // It is near b itself earlier than near the image above, but touches that one first.
    World low = torus(2, 10);
    low.high[1] = 1.9;
    const Ball c{.x = {0, 0.805}, .v = {1, 0.13}, .r = 0.5}, d{.x = {1.5, 0}, .r = 0.5};
    const Ball above{.x = {1.5, 1.9}, .r = 0.5};
    EXPECT_LT(meeting(c, above), meeting(c, d));
    EXPECT_EQ(meeting_time(c, d, low, 100), meeting(c, above));
    EXPECT_THROW(meeting_time(a, b, world), std::invalid_argument);
}

TEST(OracleMotion, TheLeastOverAllShifts) {
    Random random(1605);
    int meetings = 0;
    for (int i = 0; i < 30; ++i) {
        const auto ball = [&] {
            return Ball{.x = {random.below(16) / 4.0, random.below(16) / 4.0},
                        .v = {random.below(17) / 4.0 - 2, random.below(17) / 4.0 - 2},
                        .r = random.below(6) / 8.0,
                        .growth = random.below(3) / 8.0};
        };
        const Ball p = ball(), q = ball();
        Time least;
        for (int k = -5; k <= 5; ++k) {
            for (int l = -5; l <= 5; ++l) {
                Ball image = q;
                image.x[0] += 4 * k, image.x[1] += 4 * l;
                const Time time = meeting_time(p, image, {}, 3);
                if (time && (!least || *time < *least)) least = time;
            }
        }
        ASSERT_EQ(meeting_time(p, q, torus(2, 4), 3), least) << "input " << i;
        if (least) ++meetings;
    }
    EXPECT_GT(meetings, 10);
}

// Runs

World box(double width, double height) {
    World world;
    world.walls = box_walls({0, 0, 0}, {width, height, 0}, 2);
    return world;
}

TEST(OracleMotion, NewtonsCradle) {
    for (const double spacing : {2.0, 3.0}) {
        std::vector<Ball> balls{{.x = {-10, 0}, .v = {1, 0}, .r = 1}};
        for (int i = 0; i < 4; ++i) balls.push_back({.x = {i * spacing, 0}, .r = 1});
        const auto run = simulate(balls, {}, infinity, 100);
        ASSERT_EQ(run.log.size(), 4U);
        for (int i = 0; i < 4; ++i) {
            const double time = 8 + i * (spacing - 2);
            EXPECT_EQ(run.log[static_cast<std::size_t>(i)], (Strike{time, false, i, i + 1, 1}));
            EXPECT_EQ(run.balls[static_cast<std::size_t>(i)].v, (Point{}));
        }
        EXPECT_EQ(run.balls[4].v, (Point{1, 0, 0}));
        EXPECT_FALSE(run.collapsed);
    }
}

TEST(OracleMotion, GalperinsDigitsOfPi) {
    for (const bool mirrored : {false, true}) {
        const double side = mirrored ? -1 : 1;
        World world;
        world.walls.resize(1);
        world.walls[0].n = {side, 0, 0};
        std::size_t expected[] = {3, 31, 314};
        double mass = 1;
        for (const std::size_t count : expected) {
            const std::vector<Ball> balls{{.x = {side * 2, 0}, .r = 0.5},
                                          {.x = {side * 5, 0}, .v = {-side, 0}, .r = 1, .m = mass}};
            const auto run = simulate(balls, world, infinity, 1000);
            EXPECT_EQ(run.log.size(), count);
            EXPECT_FALSE(run.collapsed);
            mass *= 100;
        }
    }
}

double dot(const Point& a, const Point& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Point operator-(const Point& a, const Point& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
double length(const Point& a) {
    return std::sqrt(dot(a, a));
}

/// From -1 to 1.
double random_number(Random& random) {
    return 2 * random.unit() - 1;
}
Point random_vector(Random& random) {
    return {random_number(random), random_number(random), random_number(random)};
}
Ball random_ball(Random& random) {
    return {
        .x = random_vector(random), .v = random_vector(random), .r = 0.5, .m = 1 + random.unit()};
}

TEST(OracleMotion, StrikesByTheBook) {
    Random random(1608);
    int strikes = 0;
    for (int i = 0; i < 300; ++i) {
        World world;
        world.dimension = 3, world.restitution = random.unit();
        const Ball a = random_ball(random);
        const Ball b = random_ball(random);
        const auto run = simulate({a, b}, world, 100, 1);
        if (run.log.empty()) continue;
        const Point n = run.balls[0].x - run.balls[1].x, &p = run.balls[0].v, &q = run.balls[1].v;
        EXPECT_NEAR(dot(p - q, n), -world.restitution * dot(a.v - b.v, n), 1e-14);
        EXPECT_NEAR(a.m * length(p - a.v), run.log[0].impulse, 1e-14);
        EXPECT_NEAR(b.m * length(q - b.v), run.log[0].impulse, 1e-14);
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_NEAR(a.m * (p[k] - a.v[k]), b.m * (b.v[k] - q[k]), 1e-14);
        ++strikes;
    }
    EXPECT_GT(strikes, 50);
}

TEST(OracleMotion, StrikesOfMovingWallsByTheBook) {
    Random random(1609);
    int strikes = 0;
    for (int i = 0; i < 300; ++i) {
        World world;
        world.dimension = 3, world.wall_restitution = random.unit();
        const Point along = random_vector(random), u = random_vector(random);
        world.walls = {i % 3 == 0   ? plane(along, -2, u[0])
                       : i % 3 == 1 ? circle(Kind::outside, {3, 0, 0}, 2, u)
                                    : circle(Kind::inside, along, 4, u)};
        const Wall& wall = world.walls[0];
        const Ball a = random_ball(random);
        const auto run = simulate({a}, world, 100, 1);
        if (run.log.empty()) continue;
        const double time = run.log[0].time;
        const Ball& after = run.balls[0];
        Point n = wall.n;
        double w = wall.w;
        if (wall.kind != Kind::half_space) {
            for (std::size_t k = 0; k < 3; ++k)
                n[k] = after.x[k] - wall.centre[k] - wall.u[k] * time;
            w = dot(wall.u, n);
        }
        EXPECT_NEAR(dot(after.v, n) - w, -world.wall_restitution * (dot(a.v, n) - w), 1e-13);
        EXPECT_NEAR(a.m * length(after.v - a.v), run.log[0].impulse, 1e-13);
        EXPECT_NEAR(length(n) * run.log[0].impulse, a.m * std::abs(dot(after.v - a.v, n)), 1e-12);
        EXPECT_TRUE(run.log[0].wall);
        ++strikes;
    }
    EXPECT_GT(strikes, 150);
}

double energy(const Ball& ball, const World& world, double time) {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const double y = time - ball.t0, v = ball.v[k] + world.g[k] * y;
        const double x = ball.x[k] + ball.v[k] * y + world.g[k] * y * y / 2;
        sum += ball.m * (v * v / 2 - world.g[k] * x);
    }
    return sum;
}

TEST(OracleMotion, EnergyStays) {
    Random random(1606);
    World world = box(8, 8);
    world.walls.push_back(plane({1, 2, 0}, 2));
    world.walls.push_back(circle(Kind::outside, {8, 8, 0}, 1.5));
    world.g = {0, -1, 0};
    std::vector<Ball> balls;
    for (const double x : {3.0, 5.0})
        for (const double y : {3.0, 5.0})
            balls.push_back({.x = {x + random.unit() * 0.25, y},
                             .v = {random.unit() - 0.5, random.unit() - 0.5},
                             .r = 0.5 + random.unit() * 0.25,
                             .m = 1 + random.unit()});
    const auto total = [&](const std::vector<Ball>& all, double time) {
        double sum = 0;
        for (const Ball& ball : all) sum += energy(ball, world, time);
        return sum;
    };
    const auto run = simulate(balls, world, infinity, 60);
    ASSERT_EQ(run.log.size(), 60U);
    EXPECT_FALSE(run.collapsed);
    EXPECT_NEAR(total(run.balls, run.log.back().time), total(balls, 0), 1e-12);
    EXPECT_TRUE(std::is_sorted(run.log.begin(), run.log.end(),
                               [](const Strike& a, const Strike& b) { return a.time < b.time; }));
}

World bouncing(double restitution) {
    World world = falling(-2);
    world.walls = {floor_at(0)};
    world.wall_restitution = restitution;
    return world;
}

TEST(OracleMotion, BouncesUntilItCollapses) {
    // From 1 above the floor: 1, 1 + 1/2, 1 + 1/2 + 1/8, …; 2^-53 more rounds back.
    const auto run = simulate({{.x = {0, 2}, .r = 1, .m = 4}}, bouncing(0.25), infinity, 1000);
    ASSERT_EQ(run.log.size(), 27U);
    double time = 1;
    for (int i = 0; i < 27; ++i) {
        EXPECT_EQ(run.log[static_cast<std::size_t>(i)],
                  (Strike{time, true, 0, 0, std::ldexp(10, -2 * i)}));
        time += std::ldexp(0.5, -2 * i);
    }
    EXPECT_TRUE(run.collapsed);
    EXPECT_EQ(run.balls[0].x, (Point{0, 1, 0}));
    EXPECT_EQ(run.balls[0].v, (Point{0, 0x1p-53, 0}));
}

TEST(OracleMotion, BouncesForEverFromDoubleToDouble) {
    // 1, 2, 2 1/2, …, 3 - 2^-51, 3. From there on its flight of 2 e / (1 + e) = 2/3 of the distance
    // of two times rounds up to the next one: nothing in the rule ends this.
    const auto run = simulate({{.x = {0, 2}, .r = 1, .m = 4}}, bouncing(0.5), infinity, 200);
    ASSERT_EQ(run.log.size(), 200U);
    for (int i = 0; i < 53; ++i)
        EXPECT_EQ(run.log[static_cast<std::size_t>(i)],
                  (Strike{3 - std::ldexp(2, -i), true, 0, 0, std::ldexp(12, -i)}));
    for (int i = 53; i < 200; ++i)
        EXPECT_EQ(run.log[static_cast<std::size_t>(i)].time, 3 + (i - 53) * 0x1p-51);
    EXPECT_FALSE(run.collapsed);
}

TEST(OracleMotion, LyingOnTheFloorIsACollapse) {
    World world = falling(-2);
    world.walls = {floor_at(0)};
    const std::vector<Ball> balls{{.x = {0, 1}, .r = 1}};
    const auto run = simulate(balls, world, infinity, 1000);
    EXPECT_TRUE(run.log.empty());
    EXPECT_TRUE(run.collapsed);
    EXPECT_EQ(run.balls, balls);
}

TEST(OracleMotion, TheThousandthStrikeAtOneTime) {
    World world = box(10, 2);  // as high as the ball
    const std::vector<Ball> balls{{.x = {3, 1}, .v = {1, 1}, .r = 1}};
    world.g = {0, -1, 0};
    const auto run = simulate(balls, world, infinity, 1001);
    EXPECT_TRUE(run.collapsed);
    ASSERT_EQ(run.log.size(), 1000U);
    EXPECT_EQ(run.log.back(), (Strike{0, true, 0, 2, 2}));
    // Without gravity and loss there is no collapse, only `most`.
    world.g = {};
    EXPECT_FALSE(simulate(balls, world, infinity, 1001).collapsed);
    EXPECT_EQ(simulate(balls, world, infinity, 1001).log.size(), 1001U);
    world.restitution = 0.5;
    EXPECT_TRUE(simulate(balls, world, infinity, 1001).collapsed);
}

TEST(OracleMotion, TooSlowToChangeABit) {
    // 0 and 1 overlap and approach by ulp·0.1875 in their direction: half an ulp is never gained.
    World world = box(100, 100);
    world.walls[1].c = -12.875;
    const std::vector<Ball> balls{{.x = {1, 10}, .v = {1, 1 + ulp}, .r = 1},
                                  {.x = {2.875, 10.1875}, .v = {1, 1}, .r = 1},
                                  {.x = {2, 50}, .v = {-0.5, 0}, .r = 1}};
    EXPECT_EQ(meeting(balls[0], balls[1]), 0);
    const auto run = simulate(balls, world, infinity, 3);
    ASSERT_EQ(run.log.size(), 3U);
    EXPECT_EQ(run.log[0], (Strike{2, true, 2, 0, 1}));
    // 1 turns at the wall, and 0 no longer leaves it alone.
    EXPECT_EQ(run.log[1], (Strike{9, true, 1, 1, 2}));
    EXPECT_EQ(run.log[2].time, 9);
    EXPECT_EQ(std::pair(run.log[2].a, run.log[2].b), std::pair(0, 1));
    // Alone they change nothing, not even their own times.
    const std::vector<Ball> two{balls[0], balls[1]};
    const auto nothing = simulate(two, {}, infinity, 3);
    EXPECT_TRUE(nothing.log.empty());
    EXPECT_EQ(nothing.balls, two);
}

TEST(OracleMotion, LeftAloneForTheRestOfItsWay) {
    // Touching the peg and approaching it by 3 ulp(4), it gains 12/25 of an ulp. It leaves, and
    // falls through the peg from above: so the rule has it. A little later it would strike.
    World world = falling(-15);
    world.wall_restitution = 0;
    world.walls = {circle(Kind::outside, {}, 4)};
    Ball ball{.x = {-3, 4}, .v = {7 + 0x1p-50, 5.25}, .r = 1};
    EXPECT_EQ(meeting_time(ball, world.walls[0], world), 0);
    EXPECT_TRUE(simulate({ball}, world, infinity, 10).log.empty());
    ball.x[1] = 4.0625;
    EXPECT_FALSE(simulate({ball}, world, infinity, 1).log.empty());
}

TEST(OracleMotion, NoneIsLeftAloneWhereTheWallBendsInwards) {
    // It touches the circle from inside and runs along it.
    World world;
    world.walls = {circle(Kind::inside, {}, 5)};
    const std::vector<Ball> along{{.x = {0, 4}, .v = {1, 0}, .r = 1}};
    EXPECT_TRUE(simulate(along, world, infinity, 10).collapsed);
    // It leaves by 3 ulp(4): no velocity would change, yet left alone it would be lost.
    world.walls[0].radius = 6;
    world.wall_restitution = 0;
    const std::vector<Ball> slow{{.x = {-3, 4}, .v = {7 - 0x1p-50, 5.25}, .r = 1}};
    const auto run = simulate(slow, world, infinity, 10);
    EXPECT_TRUE(run.log.empty());
    EXPECT_TRUE(run.collapsed);
    EXPECT_EQ(run.balls, slow);
}

TEST(OracleMotion, OneTimeBallsFirstThenByNumber) {
    World world = box(100, 100);
    const auto ball = [](double x, double y, double v) {
        return Ball{.x = {x, y}, .v = {v, 0}, .r = 1};
    };
    const auto run =
        simulate({ball(96, 10, 1), ball(54, 20, -1), ball(4, 30, -1), ball(46, 20, 1),
                  ball(40, 40, 2), ball(50, 40, 0), ball(46, 50, 0), ball(36, 50, 8.0 / 3)},
                 world, 3, 100);
    const std::vector<std::pair<int, int>> expected{{1, 3}, {6, 7}, {0, 1}, {2, 0}};
    std::vector<std::pair<int, int>> actual;
    for (const Strike& strike : run.log) {
        EXPECT_EQ(strike.time, 3);
        actual.emplace_back(strike.a, strike.b);
    }
    EXPECT_EQ(actual, expected);
}

TEST(OracleMotion, ACornerIsTwoStrikes) {
    const auto run = simulate({{.x = {5, 5}, .v = {-1, -1}, .r = 1}}, box(20, 20), infinity, 2);
    ASSERT_EQ(run.log.size(), 2U);
    EXPECT_EQ(run.log[0], (Strike{4, true, 0, 0, 2}));
    EXPECT_EQ(run.log[1], (Strike{4, true, 0, 2, 2}));
    EXPECT_EQ(run.balls[0].v, (Point{1, 1, 0}));
}

TEST(OracleMotion, PeriodicRunsWrapAndStrikeTheNearestImage) {
    World world = torus(2, 10);
    world.low = {0, -20, 0}, world.high = {10, -11, 0};
    const auto run =
        simulate({{.x = {9, 5}, .v = {1, 0}, .r = 1}, {.x = {3, 5}, .r = 1}}, world, 8, 100);
    // At 2 ball 0 is in 11, which is 1; then ball 1 moves from 3 to 9. Both are taken into the box.
    ASSERT_EQ(run.log.size(), 2U);
    EXPECT_EQ(run.log[0], (Strike{2, false, 0, 1, 1}));
    EXPECT_EQ(run.log[1], (Strike{8, false, 0, 1, 1}));
    EXPECT_EQ(run.balls[0].x, (Point{1, -13, 0}));
    EXPECT_EQ(run.balls[0].v, (Point{1, 0, 0}));
    EXPECT_EQ(run.balls[1].x, (Point{9, -13, 0}));
}

TEST(OracleMotion, PeriodicRunsKeepEnergyAndMomentumAndTheBox) {
    Random random(1610);
    const World world = torus(3, 3);
    std::vector<Ball> balls;
    for (int i = 0; i < 4; ++i)
        balls.push_back({.x = {i % 2 * 1.5, i / 2 * 1.5, 1 + random.unit()},
                         .v = {random.unit(), random.unit() - 1, random.unit() - 0.5},
                         .r = 0.5,
                         .m = 1 + random.unit()});
    const auto run = simulate(balls, world, 50, 20);
    ASSERT_EQ(run.log.size(), 20U);
    double energy_gained = 0;
    Point momentum_gained{};
    for (std::size_t i = 0; i < balls.size(); ++i) {
        const Point &v = balls[i].v, &w = run.balls[i].v;
        energy_gained += balls[i].m * (dot(w, w) - dot(v, v));
        for (std::size_t k = 0; k < 3; ++k) {
            momentum_gained[k] += balls[i].m * (w[k] - v[k]);
            EXPECT_GE(run.balls[i].x[k], 0);
            EXPECT_LE(run.balls[i].x[k], 3);
        }
    }
    EXPECT_NEAR(energy_gained, 0, 1e-13);
    EXPECT_NEAR(length(momentum_gained), 0, 1e-13);
}

TEST(OracleMotion, WhatIsRefused) {
    World world = torus(2, 10);
    world.walls = {floor_at(0)};
    EXPECT_THROW(simulate({{.r = 1}}, world, 1, 1), std::invalid_argument);
    EXPECT_THROW(simulate({{.growth = 1}}, {}, 1, 1), std::invalid_argument);
    EXPECT_THROW(meeting_time({.x = {infinity, 0}}, Ball{}, {}), std::invalid_argument);
}

}  // namespace
