/// Meeting times of every kind against the oracle's, bit by bit: balls that grow, periodic boxes,
/// oblique walls, circles and spheres from both sides. Small numbers, so that grazes and touching
/// starts are common, and the same an ulp aside.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include "../../motion/exact_meeting.hpp"
#include "../../motion/meeting_time.hpp"
#include "../oracle/linear_form.hpp"
#include "../oracle/oracle_test_support.hpp"
#include "motion_oracle.hpp"

namespace signum::motion {
namespace {

using oracle::exactly;
using oracle::Rational;
using oracle_test::Random;

/// Numbers of one kind: integers, halves, any of 30 bits; sometimes an ulp aside.
class Numbers {
 public:
    explicit Numbers(std::uint64_t seed) : random_(seed) { next_kind(); }
    void next_kind() {
        kind_ = random_.below(3);
        aside_ = random_.below(2) == 0;
    }
    int below(int bound) { return random_.below(bound); }
    /// From -size to size.
    double operator()(int size) {
        double x = kind_ == 0   ? random_.below(2 * size + 1) - size
                   : kind_ == 1 ? 0.5 * (random_.below(4 * size + 1) - 2 * size)
                                : size * (2.0 * random_.unit() - 1.0);
        if (aside_ && random_.below(8) == 0) {  // of 0 less little: the oracle would take its time
            const double way = random_.below(2) == 0 ? -infinity : infinity;
            x = x == 0.0 ? std::copysign(0x1p-60, way) : std::nextafter(x, way);
        }
        return x;
    }
    double positive(int size) { return std::fabs((*this)(size)); }

 private:
    Random random_;
    int kind_ = 0;
    bool aside_ = false;
};

template <int D>
Vector<D> vector(Numbers& number, int size) {
    Vector<D> v;
    for (double& x : v) x = number(size);
    return v;
}

template <int D>
GrowingBall<D> random_ball(Numbers& number) {
    GrowingBall<D> ball;
    ball.x = vector<D>(number, 4);
    ball.v = vector<D>(number, 2);
    ball.radius = number.positive(1);
    if (number.below(2) == 0) ball.time = number.positive(2);
    if (number.below(2) == 0) ball.growth = number.positive(1);
    return ball;
}

template <int D>
Effects<D> random_effects(Numbers& number) {
    Effects<D> effects;
    if (number.below(2) == 0) effects.gravity[D - 1] = -number.positive(2);
    if (number.below(4) == 0) effects.gravity = vector<D>(number, 1);
    return effects;
}

/// How many cases of a test met, and how many at once.
struct Seen {
    int cases = 0;
    int met = 0;
    int at_once = 0;
    void add(double time, double start) {
        ++cases;
        met += static_cast<int>(time < infinity);
        at_once += static_cast<int>(time == start);
    }
    /// Each answer was there.
    void expect_variety() const {
        EXPECT_GT(met, cases / 20);
        EXPECT_LT(met, cases);
        EXPECT_GT(at_once, 0);
    }
};

/// So many cases, each with numbers of one kind; each(number, seen) tells when they meet.
template <class Each>
Seen see(std::uint64_t seed, int cases, const Each& each) {
    Numbers number(seed);
    Seen seen;
    while (seen.cases < cases && !testing::Test::HasFatalFailure()) {
        SCOPED_TRACE("case " + std::to_string(seen.cases));
        number.next_kind();
        each(number, seen);
    }
    return seen;
}

// Two balls

template <int D>
void expect_pairs_of_oracle(std::uint64_t seed, int cases) {
    see(seed, cases, [&](Numbers& number, Seen& seen) {
        const Effects<D> effects = random_effects<D>(number);
        const GrowingBall<D> a = random_ball<D>(number);
        const GrowingBall<D> b = random_ball<D>(number);
        const double time = meeting_time(a, b, effects);
        ASSERT_EQ(time, brute_meeting_time(a, b, effects));
        ASSERT_EQ(time, meeting_time(b, a, effects));
        ASSERT_EQ(time, meeting_time(a, b, Image<D>{}, effects));
        if (a.growth == 0.0 && b.growth == 0.0) {
            ASSERT_EQ(time, (exact_meeting<D>(a, b, Image<D>{}, effects)));
        }
        seen.add(time, std::max(a.time, b.time));
    }).expect_variety();
}

TEST(MeetingTime, OfGrowingBallsIsTheOraclesInThePlane) {
    expect_pairs_of_oracle<2>(1701, 800);
}
TEST(MeetingTime, OfGrowingBallsIsTheOraclesInSpace) {
    expect_pairs_of_oracle<3>(1702, 500);
}

/// 3-4-5 triangles: touching at the start, or exactly touching once.
TEST(MeetingTime, OfTouchingBallsIsTheOracles) {
    see(1703, 600, [&](Numbers& number, Seen& seen) {
        GrowingBall<2> a;
        GrowingBall<2> b;
        a.x = {3.0, 4.0};
        b.radius = 5.0;
        const int kind = number.below(3);
        if (kind == 0) {  // any speed
            a.v = vector<2>(number, 3);
        } else if (kind == 1) {  // along the tangent
            a.v = {4.0, -3.0};
            a.growth = 0.5 * number.below(3);
        } else {  // not at all or as fast as they grow
            a.v = {0.6 * number.below(2), 0.8 * number.below(2)};
            a.growth = number.below(2);
        }
        if (number.below(2) == 0) {  // some time before
            const double ago = number.below(4);
            for (int k = 0; k < 2; ++k) a.x[k] -= a.v[k] * ago;
            b.radius -= a.growth * ago;
        }
        if (number.below(3) == 0) a.x[0] = std::nextafter(a.x[0], number(100));
        const double time = meeting_time(a, b, {});
        ASSERT_EQ(time, brute_meeting_time(a, b, {}));
        seen.add(time, 0.0);
    }).expect_variety();
}

template <int D>
void expect_images_of_oracle(std::uint64_t seed, int cases) {
    see(seed, cases, [&](Numbers& number, Seen& seen) {
        Effects<D> effects = random_effects<D>(number);
        effects.periodic = true;
        effects.box.emplace();
        for (int k = 0; k < D; ++k) {
            effects.box->low[k] = number(2);
            effects.box->high[k] = effects.box->low[k] + 2.0 + number.positive(3);
        }
        GrowingBall<D> a = random_ball<D>(number);
        GrowingBall<D> b = random_ball<D>(number);
        if (number.below(2) == 0) a.growth = b.growth = 0.0;
        const double until = number.below(8);
        const double time = meeting_time(a, b, effects, until);
        ASSERT_EQ(time, brute_meeting_time(a, b, effects, until));
        if (a.growth > 0.0 && time <= until) {
            ASSERT_EQ(time, meeting_time(a, b, effects));
        }
        seen.add(time, std::max(a.time, b.time));
    }).expect_variety();
}

TEST(MeetingTime, InAPeriodicBoxIsTheOraclesInThePlane) {
    expect_images_of_oracle<2>(1704, 300);
}
TEST(MeetingTime, InAPeriodicBoxIsTheOraclesInSpace) {
    expect_images_of_oracle<3>(1705, 80);
}

TEST(MeetingTime, OfImagesHasAnEnd) {
    Effects<2> effects;
    effects.periodic = true;
    effects.box = Box<2>{{0.0, 0.0}, {1.0, 1.0}};
    GrowingBall<2> a{{{0.0, 0.0}, {0.0, 0.0}, 0.125, 0.0}, 0.0};
    GrowingBall<2> b{{{0.375, 0.5}, {1.0, 0.0}, 0.125, 0.0}, 0.0};
    EXPECT_THROW((void)meeting_time(a, b, effects), std::invalid_argument);
    EXPECT_EQ(meeting_time(a, b, effects, 1000.0), infinity);
    b.v = {0.0, 0.0};
    EXPECT_EQ(meeting_time(a, b, effects, 1e300), infinity);
    a.growth = 0x1p-60;  // 5/8 is reached after all
    EXPECT_EQ(meeting_time(a, b, effects), 0.375 * 0x1p60);
    EXPECT_EQ(meeting_time(a, b, effects, 1.0), infinity);
}

// Oblique walls

/// Whether the ball is in front of the wall, has a radius and does not overlap the wall, so that
/// s² - n·n r² has the same meetings as s - |n| r.
template <int D>
bool is_in_front(const GrowingBall<D>& ball, const HalfSpace<D>& wall) {
    const Rational t = exactly(ball.time);
    const Rational r = exactly(ball.radius) + exactly(ball.growth) * t;
    Rational s = -exactly(wall.offset) - exactly(wall.speed) * t;
    Rational square = 0;
    for (int k = 0; k < D; ++k) {
        const Rational n = exactly(wall.normal[k]);
        s += n * exactly(ball.x[k]);
        square += n * n;
    }
    return r > 0 && s > 0 && s * s >= square * r * r;
}

template <int D>
void expect_half_spaces_of_oracle(std::uint64_t seed, int cases) {
    see(seed, cases, [&](Numbers& number, Seen& seen) {
        const Effects<D> effects = random_effects<D>(number);
        GrowingBall<D> ball = random_ball<D>(number);
        HalfSpace<D> wall;
        wall.normal = vector<D>(number, 3);
        wall.offset = number(4);
        if (number.below(2) == 0) wall.speed = number(2);
        if (number.below(4) == 0) {  // it touches
            ball.x = {};
            ball.time = 0.0;
            wall.normal = {};
            wall.normal[0] = 3.0;
            wall.normal[1] = number.below(2) == 0 ? 4.0 : -4.0;
            ball.radius = 0.5 + 0.5 * number.below(3);
            wall.offset = -5.0 * ball.radius;
        }
        if (wall.normal == Vector<D>{} || !is_in_front(ball, wall)) return;
        const double time = meeting_time(ball, wall, effects);
        ASSERT_EQ(time, brute_meeting_time(ball, wall, effects));
        seen.add(time, ball.time);
    }).expect_variety();
}

TEST(MeetingTime, OfHalfPlanesIsTheOracles) {
    expect_half_spaces_of_oracle<2>(1706, 700);
}
TEST(MeetingTime, OfHalfSpacesIsTheOracles) {
    expect_half_spaces_of_oracle<3>(1707, 400);
}

/// Where |n| is an integer, s and |n| r are those of a side, from which the ball may be on either
/// side and a point as well.
template <int D>
void expect_sides_of_oracle(std::uint64_t seed, int cases) {
    constexpr std::array<std::array<double, 4>, 5> normals = {
        {{3, 4, 0, 5}, {-4, 3, 0, 5}, {5, -12, 0, 13}, {1, 2, -2, 3}, {2, 3, 6, 7}}};
    see(seed, cases, [&](Numbers& number, Seen& seen) {
        Effects<D> effects;
        GrowingBall<D> ball;
        HalfSpace<D> wall;
        const auto& normal = normals[static_cast<std::size_t>(number.below(D == 2 ? 3 : 5))];
        const double norm = normal[3];
        brute::Ball along;
        brute::World world;
        const auto small = [&] { return 0.5 * (number.below(9) - 4); };
        const bool falls = number.below(3) > 0;
        for (int k = 0; k < D; ++k) {
            wall.normal[k] = normal[static_cast<std::size_t>(k)];
            effects.gravity[k] = falls ? small() : 0.0;
            ball.x[k] = small();
            ball.v[k] = small();
            along.x[0] += wall.normal[k] * ball.x[k];
            along.v[0] += wall.normal[k] * ball.v[k];
            world.g[0] += wall.normal[k] * effects.gravity[k];
        }
        ball.radius = 0.5 * number.below(3);
        ball.growth = number.below(2) == 0 ? 0.0 : 0.5 * (number.below(5) - 2);
        ball.time = 0.5 * number.below(3);
        wall.offset = 0.5 * (number.below(41) - 20);
        wall.speed = number.below(2) == 0 ? 0.0 : small();
        if (number.below(4) == 0)  // nearly touching
            wall.offset = std::nextafter(along.x[0] - norm * ball.radius, small());
        along.r = norm * ball.radius;
        along.growth = norm * ball.growth;
        along.t0 = ball.time;
        brute::Wall side;
        side.n = {1.0, 0.0, 0.0};
        side.c = wall.offset;
        side.w = wall.speed;
        const double time = meeting_time(ball, wall, effects);
        ASSERT_EQ(time, or_never(brute::meeting_time(along, side, world)));
        seen.add(time, ball.time);
    }).expect_variety();
}

TEST(MeetingTime, OfPointsAndBallsBehindAHalfPlaneIsTheOracles) {
    expect_sides_of_oracle<2>(1708, 1500);
}
TEST(MeetingTime, OfPointsAndBallsBehindAHalfSpaceIsTheOracles) {
    expect_sides_of_oracle<3>(1709, 1500);
}

TEST(MeetingTime, OfABoxSideIsTheSimulations) {
    Numbers number(1710);
    for (int i = 0; i < 400; ++i) {
        number.next_kind();
        Effects<2> effects = random_effects<2>(number);
        effects.box = Box<2>{{-4.0, -4.0}, {4.0, 4.0}};
        GrowingBall<2> ball = random_ball<2>(number);
        ball.growth = 0.0;
        for (Wall wall = 0; wall < 4; ++wall) {
            HalfSpace<2> side;
            side.normal[wall / 2] = wall % 2 == 0 ? 1.0 : -1.0;
            side.offset = -4.0;
            ASSERT_EQ(meeting_time(ball, side, effects), (exact_meeting<2>(ball, wall, effects)))
                << "case " << i;
        }
    }
}

/// From either side and with any n, by the formulas of quadratics in 50 digits.
TEST(MeetingTime, OfHalfPlanesIsThatOfTheFormulas) {
    using Real = boost::multiprecision::cpp_bin_float_50;
    see(1716, 2000, [&](Numbers& number, Seen& seen) {
        const Effects<2> effects = random_effects<2>(number);
        GrowingBall<2> ball = random_ball<2>(number);
        if (number.below(4) == 0) ball.radius = 0.0;
        const HalfSpace<2> wall{vector<2>(number, 3), number(4), number(1)};
        if (wall.normal == Vector<2>{}) return;
        const auto along = [&](const Vector<2>& v) {
            return Real(wall.normal[0]) * v[0] + Real(wall.normal[1]) * v[1];
        };
        const Real start = ball.time;
        const Real norm = sqrt(along(wall.normal));
        const Real a = along(effects.gravity) / 2;
        const Real b = along(ball.v) - wall.speed - norm * ball.growth;
        const Real c = along(ball.x) - wall.offset - start * wall.speed -
                       norm * (ball.radius + start * ball.growth);
        const Real square = b * b - 4 * a * c;
        const auto unclear = [](const Real& x) { return x != 0 && abs(x) < 1e-30; };
        if (unclear(a) || unclear(b) || unclear(c) || unclear(square)) return;
        const double time = meeting_time(ball, wall, effects);
        std::optional<Real> expected;
        if (c <= 0 && (b < 0 || (b == 0 && a < 0))) {
            expected = start;
        } else if (a == 0) {
            if (b < 0) expected = start - c / b;
        } else if (a > 0) {
            if (b < 0 && square > 0) expected = start + 2 * c / (sqrt(square) - b);
        } else {
            expected = start - (b + (square > 0 ? Real(sqrt(square)) : Real(0))) / (2 * a);
        }
        if (!expected || *expected > std::numeric_limits<double>::max()) {
            ASSERT_EQ(time, infinity);
        } else {
            const auto off = [&](double x) { return Real(abs(x - *expected)); };
            ASSERT_LE(off(time), off(std::nextafter(time, infinity)));
            ASSERT_LE(off(time), off(std::nextafter(time, -infinity)));
        }
        seen.add(time, ball.time);
    }).expect_variety();
}

/// With |n| = √2 the peak of what grows while it falls is not rational.
TEST(MeetingTime, OfAPeakBehindAnIrrationalHalfPlane) {
    Effects<2> effects;
    effects.gravity = {-1.0, -1.0};
    GrowingBall<2> ball;
    ball.x = {-10.0, -10.0};
    ball.v = {4.0, 4.0};
    ball.growth = 1.0;
    const HalfSpace<2> wall{{1.0, 1.0}, 0.0, 0.0};
    // s = -20 + 8 t - t², the peak of s - √2 t where 8 - 2 t = √2.
    EXPECT_EQ(meeting_time(ball, wall, effects), 4.0 - std::sqrt(0.5));
}

// Circles and spheres

template <int D>
void expect_spheres_of_oracle(std::uint64_t seed, int cases, typename Sphere<D>::Side side) {
    const Seen all = see(seed, cases, [&](Numbers& number, Seen& seen) {
        const Effects<D> effects = random_effects<D>(number);
        GrowingBall<D> ball = random_ball<D>(number);
        Sphere<D> wall;
        wall.side = side;
        const bool inside = side == Sphere<D>::Side::inside;
        wall.centre = vector<D>(number, 2);
        if (number.below(2) == 0) wall.velocity = vector<D>(number, 1);
        wall.radius = inside ? 3.0 + number.positive(3) : number.positive(3);
        if (number.below(4) == 0) {  // it touches
            ball.x = {};
            ball.time = 0.0;
            wall.centre = {};
            wall.centre[0] = 3.0;
            wall.centre[1] = 4.0;
            wall.radius = inside ? 5.0 + ball.radius : 5.0 - ball.radius;
            if (number.below(2) == 0) wall.radius = std::nextafter(wall.radius, number(100));
        }
        const double time = meeting_time(ball, wall, effects);
        ASSERT_EQ(time, brute_meeting_time(ball, wall, effects));
        seen.add(time, ball.time);
    });
    // Who is inside and falls or grows meets, sooner or later.
    EXPECT_GT(all.met, cases / 10);
    EXPECT_GT(all.at_once, 0);
}

TEST(MeetingTime, OutsideOfACircleIsTheOracles) {
    expect_spheres_of_oracle<2>(1711, 500, Sphere<2>::Side::outside);
}
TEST(MeetingTime, InsideOfACircleIsTheOracles) {
    expect_spheres_of_oracle<2>(1712, 500, Sphere<2>::Side::inside);
}
TEST(MeetingTime, OutsideOfASphereIsTheOracles) {
    expect_spheres_of_oracle<3>(1713, 300, Sphere<3>::Side::outside);
}
TEST(MeetingTime, InsideOfASphereIsTheOracles) {
    expect_spheres_of_oracle<3>(1714, 300, Sphere<3>::Side::inside);
}

/// Thrown up inside a circle, a ball grazes it from inside at its peak: it turns there, and the gap
/// touches 0 from above.
TEST(MeetingTime, OfAPeakAtACircle) {
    Effects<2> effects;
    effects.gravity = {0.0, -1.0};
    GrowingBall<2> ball;
    ball.v = {0.0, 2.0};  // up to 2
    ball.radius = 1.0;
    Sphere<2> circle;
    circle.radius = 3.0;
    circle.side = Sphere<2>::Side::inside;
    EXPECT_EQ(meeting_time(ball, circle, effects), 2.0 + std::sqrt(8.0));
    circle.radius = std::nextafter(3.0, 0.0);
    EXPECT_LT(meeting_time(ball, circle, effects), 2.0);
    circle.radius = 2.0;  // overlapping below, it comes up to the top
    ball.x = {0.0, -1.5};
    EXPECT_EQ(meeting_time(ball, circle, effects), brute_meeting_time(ball, circle, effects));
}

// Numbers of every size

TEST(MeetingTime, OfNumbersOfManyBinadesIsTheOracles) {
    Random random(1715);
    const auto number = [&] {
        const double x = std::ldexp(2.0 * random.unit() - 1.0, random.below(61) - 30);
        return random.below(5) == 0 ? 0.0 : x;
    };
    for (int i = 0; i < 200; ++i) {
        Effects<2> effects;
        if (i % 2 == 0) effects.gravity = {number(), number()};
        GrowingBall<2> a;
        GrowingBall<2> b;
        for (GrowingBall<2>* ball : {&a, &b}) {
            ball->x = {number(), number()};
            ball->v = {number(), number()};
            ball->radius = std::fabs(number());
            ball->time = std::fabs(number());
            ball->growth = std::fabs(number());
        }
        ASSERT_EQ(meeting_time(a, b, effects), brute_meeting_time(a, b, effects)) << "case " << i;
        Sphere<2> circle{a.x, a.v, a.radius, Sphere<2>::Side::outside};
        if (i % 3 == 0) circle.side = Sphere<2>::Side::inside;
        ASSERT_EQ(meeting_time(b, circle, effects), brute_meeting_time(b, circle, effects))
            << "case " << i;
        const HalfSpace<2> wall{a.v, a.x[0], a.x[1]};
        if (wall.normal != Vector<2>{} && is_in_front(b, wall)) {
            ASSERT_EQ(meeting_time(b, wall, effects), brute_meeting_time(b, wall, effects))
                << "case " << i;
        }
    }
}

TEST(MeetingTime, AtTheEndsOfTheDoubles) {
    constexpr double tiny = std::numeric_limits<double>::denorm_min();
    constexpr double huge = std::numeric_limits<double>::max();
    GrowingBall<2> a;
    GrowingBall<2> b;
    b.x = {1.0, 0.0};
    b.radius = 0.5;
    a.v = {tiny, 0.0};
    EXPECT_EQ(meeting_time(a, b, {}), infinity);  // 2^1073
    a.v = {0.5 / huge, 0.0};
    EXPECT_EQ(meeting_time(a, b, {}), brute_meeting_time(a, b, {}));
    a.v = {huge, 0.0};
    EXPECT_EQ(meeting_time(a, b, {}), 0.5 / huge);
    b.x = {huge, 0.0};
    EXPECT_EQ(meeting_time(a, b, {}), 1.0);
    a.v = {tiny, 0.0};
    b.x = {3 * tiny, 0.0};
    b.radius = tiny;
    EXPECT_EQ(meeting_time(a, b, {}), 2.0);
}

}  // namespace
}  // namespace signum::motion
