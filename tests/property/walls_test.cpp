/// Meetings with walls: the filter and the refinement against the exact meeting, for every kind of
/// obstacle and a box that shakes, also right after a strike; segments against an oracle in
/// rationals.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "../../motion/meeting_time.hpp"
#include "../../motion/strike.hpp"
#include "../../motion/walls.hpp"
#include "../oracle/real_roots.hpp"
#include "effects_scenes.hpp"

namespace signum::motion {
namespace {

const int trials = is_fast ? 150 : 20;

enum class Kind { shaking, half_space, outside, inside, segment };

template <int D>
Effects<D> one_wall(Kind kind, Choices& choose) {
    Effects<D> effects;
    Sphere<D> sphere;
    for (double& x : sphere.centre) x = choose.number(-5.0, 5.0);
    sphere.radius = choose.number(0.0, 3.0);
    if (choose.below(2) == 0)
        for (double& u : sphere.velocity) u = choose.number(-1.0, 1.0);
    switch (kind) {
        case Kind::shaking:
            effects.box = Box<D>{};
            effects.box->low.fill(-5.0);
            effects.box->high.fill(5.0);
            effects.shake.emplace();
            effects.shake->amplitude[D - 1] = 0.125 + choose.unit();
            effects.shake->frequency = 10.0 * choose.unit();
            effects.shake->phase = choose.number(-3.0, 3.0);
            break;
        case Kind::half_space: {
            HalfSpace<D> wall;
            for (double& n : wall.normal) n = choose.number(-1.0, 1.0);
            if (wall.normal == Vector<D>{}) wall.normal[0] = 1.0;
            wall.offset = -5.0 * std::sqrt(dot(wall.normal, wall.normal));
            if (choose.below(2) == 0) wall.speed = choose.number(-1.0, 1.0);
            effects.obstacles.emplace_back(wall);
            break;
        }
        case Kind::outside:
            effects.obstacles.emplace_back(sphere);
            break;
        case Kind::inside:
            sphere.side = Sphere<D>::Side::inside;
            sphere.centre = {};
            sphere.radius = 12.0;
            effects.obstacles.emplace_back(sphere);
            break;
        case Kind::segment:
            if constexpr (D == 2) {
                Segment segment{{choose.number(-4.0, 4.0), choose.number(-4.0, 4.0)}, {}};
                do {
                    segment.to = {choose.number(-4.0, 4.0), choose.number(-4.0, 4.0)};
                } while (segment.to == segment.from);
                effects.obstacles.emplace_back(segment);
            }
            break;
    }
    return effects;
}

struct Told {
    int asked = 0;
    int unknown = 0;
    int met = 0;
    int refined = 0;
    int wide = 0;
};

template <int D>
void ask(const Walls<D>& walls, const MeetingFilter<D>& filter, const Ball<D>& ball, double now,
         Wall wall, Told& told) {
    MeetingFilter<D> bounds = filter;
    bounds.include(ball);
    const typename MeetingFilter<D>::Asker asker = bounds.asker(ball, now);
    const Meeting meeting = walls.meeting(wall, asker, infinity);
    const double exact = walls.exact_meeting(ball, wall);
    // Asked when it has met, or overlaps: then nothing is promised.
    Ball<D> then = ball;
    then.time = now;
    then.x = asker.place().x;
    then.radius = asker.radius();
    if (exact <= now || walls.gap(then, wall) < -1e-9) return;
    ++told.asked;
    if (meeting.early == -infinity) {
        ++told.unknown;
        return;
    }
    ASSERT_LE(meeting.early, exact);
    ASSERT_GE(meeting.late, exact);
    // Later than some time is never.
    const double latest = now + 2.0;
    const Meeting soon = walls.meeting(wall, asker, latest);
    if (soon.early > -infinity) {
        ASSERT_LE(soon.early, std::max(exact, std::nextafter(latest, infinity)));
        ASSERT_TRUE(soon.late >= exact);
    }
    if (meeting.early == infinity) return;
    ++told.met;
    told.wide += static_cast<int>(meeting.late - meeting.early > 1e-9 * (1.0 + exact));
    const double refined = walls.refined_meeting(ball, wall, 0.5 * (meeting.early + meeting.late));
    if (std::isnan(refined)) return;
    ++told.refined;
    ASSERT_EQ(refined, exact);
}

template <int D>
Told expect_filters_to_agree(Kind kind, bool falls, bool grows, std::uint64_t seed) {
    SCOPED_TRACE("kind " + std::to_string(static_cast<int>(kind)) + (falls ? ", falls" : "") +
                 (grows ? ", grows" : ""));
    Told told;
    // Sines of exact numbers take long.
    const int most = kind == Kind::shaking ? trials / 10 : trials;
    for (int trial = 0; trial < most; ++trial) {
        Choices choose(seed * 10'000 + static_cast<std::uint64_t>(trial));
        choose.be_round(trial % 3 == 0);
        Effects<D> effects = one_wall<D>(kind, choose);
        if (falls) effects.gravity[D - 1] = -1.0;
        if (falls && choose.below(2) == 0)
            for (double& g : effects.gravity) g = choose.number(-1.0, 1.0);
        if (grows) effects.growth = Growth{0.01 + 0.1 * choose.unit(), 100.0};
        const MeetingFilter<D> filter(effects, Kernel::exact);
        const Walls<D> walls(effects, Kernel::exact);
        for (int i = 0; i < 3; ++i) {
            Ball<D> ball;
            for (int k = 0; k < D; ++k) {
                ball.x[k] = choose.number(-3.0, 3.0);
                ball.v[k] = choose.number(-2.0, 2.0);
            }
            ball.radius = choose.number(0.0, 0.5);
            ball.time = choose.below(2) == 0 ? 0.0 : choose.number(0.0, 20.0);
            const double now = ball.time + (choose.below(2) == 0 ? 0.0 : 0.2 * choose.unit());
            for (const Wall wall : walls.numbers()) {
                ask(walls, filter, ball, now, wall, told);
                if (testing::Test::HasFatalFailure()) return told;
                // And right after it was struck.
                const double t = walls.exact_meeting(ball, wall);
                if (t == infinity) continue;
                StrikeTally tally;
                Ball<D> struck = arrived(ball, t, effects, tally);
                if (!strike(struck, walls.facing(struck, wall), 1.0, 0.9, growth_of(ball, effects))
                         .struck)
                    continue;
                ask(walls, filter, struck, t, wall, told);
                if (testing::Test::HasFatalFailure()) return told;
            }
        }
    }
    EXPECT_GT(told.asked, most);
    // Of a few, as where the test is less thorough, perhaps none.
    EXPECT_GE(told.met, told.asked / 50 - 2);
    EXPECT_LE(told.wide * 20, told.met);
    return told;
}

/// What the filter leaves open, in parts of what it is asked; less than a part in `open`.
template <int D>
void expect_filter(Kind kind, int open) {
    Told all;
    for (const bool falls : {false, true}) {
        for (const bool grows : {false, true}) {
            const Told told =
                expect_filters_to_agree<D>(kind, falls, grows, 100 + 10 * falls + grows);
            if (testing::Test::HasFatalFailure()) return;
            all.asked += told.asked;
            all.unknown += told.unknown;
            all.refined += told.refined;
        }
    }
    testing::Test::RecordProperty("asked", all.asked);
    testing::Test::RecordProperty("unknown", all.unknown);
    EXPECT_LT(all.unknown * open, all.asked) << all.unknown << " of " << all.asked;
    if (kind == Kind::shaking) {
        EXPECT_GT(all.refined, trials / 10);
    }
}

TEST(Walls, FilterOfABoxThatShakes) {
    expect_filter<2>(Kind::shaking, 5);
    expect_filter<3>(Kind::shaking, 5);
}
TEST(Walls, FilterOfHalfSpaces) {
    expect_filter<2>(Kind::half_space, 5);
    expect_filter<3>(Kind::half_space, 5);
}
TEST(Walls, FilterOutsideOfSpheres) {
    expect_filter<2>(Kind::outside, 5);
    expect_filter<3>(Kind::outside, 5);
}
TEST(Walls, FilterInsideOfSpheres) {
    expect_filter<2>(Kind::inside, 5);
    expect_filter<3>(Kind::inside, 5);
}
TEST(Walls, FilterOfSegments) {
    expect_filter<2>(Kind::segment, 5);
}

// Segments

/// From the constant coefficient upwards.
using Powers = std::vector<mpq_class>;

Powers sum(const Powers& p, const mpq_class& factor, const Powers& q) {
    Powers result(std::max(p.size(), q.size()));
    for (std::size_t i = 0; i < p.size(); ++i) result[i] += p[i];
    for (std::size_t i = 0; i < q.size(); ++i) result[i] += factor * q[i];
    return result;
}
Powers product(const Powers& p, const Powers& q) {
    Powers result(p.size() + q.size() - 1);
    for (std::size_t i = 0; i < p.size(); ++i)
        for (std::size_t j = 0; j < q.size(); ++j) result[i + j] += p[i] * q[j];
    return result;
}
oracle::IntegerPolynomial in_integers(const Powers& p) {
    mpz_class common = 1;
    for (const mpq_class& each : p) common = lcm(common, each.get_den());
    oracle::IntegerPolynomial result;
    for (const mpq_class& each : p) result.push_back(each.get_num() * (common / each.get_den()));
    while (result.size() > 1 && result.back() == 0) result.pop_back();
    return result;
}

/// F = d² - r², times the square of the length beside the segment. Of a ball that has a radius and
/// is apart at its own time: the first root of F at which it falls below 0. Nothing where F or the
/// place of the foot is constant.
std::optional<double> meeting_of_segment(const GrowingBall<2>& ball, const Segment& wall,
                                         const Vector<2>& gravity) {
    const mpq_class start(ball.time);
    std::array<Powers, 2> seen;
    std::array<Powers, 2> from_end;
    std::array<mpq_class, 2> along;
    for (int k = 0; k < 2; ++k) {
        const mpq_class half_g = mpq_class(gravity[k]) / 2;
        const mpq_class v(ball.v[k]);
        const Powers x = {ball.x[k] + (half_g * start - v) * start, v - 2 * half_g * start, half_g};
        seen[static_cast<std::size_t>(k)] = sum(x, -1, {mpq_class(wall.from[k])});
        from_end[static_cast<std::size_t>(k)] = sum(x, -1, {mpq_class(wall.to[k])});
        along[static_cast<std::size_t>(k)] = mpq_class(wall.to[k]) - mpq_class(wall.from[k]);
    }
    const Powers radius = {mpq_class(ball.radius), mpq_class(ball.growth)};
    const auto square = [](const std::array<Powers, 2>& v) {
        return sum(product(v[0], v[0]), 1, product(v[1], v[1]));
    };
    const mpq_class length = along[0] * along[0] + along[1] * along[1];
    const Powers reach = product(radius, radius);
    const Powers foot = sum(product({along[0]}, seen[0]), 1, product({along[1]}, seen[1]));
    const Powers rest = sum({length}, -1, foot);
    const Powers across = sum(product({along[0]}, seen[1]), -1, product({along[1]}, seen[0]));
    const std::vector<oracle::IntegerPolynomial> all = {
        in_integers(sum(square(seen), -1, reach)), in_integers(sum(square(from_end), -1, reach)),
        in_integers(sum(product(across, across), -length, reach)), in_integers(foot),
        in_integers(rest)};
    for (const oracle::IntegerPolynomial& each : all)
        if (each.size() < 2) return std::nullopt;
    // Which of the three F is, by the signs of the last two.
    const auto gap_by = [](int of_foot, int of_rest) {
        return of_foot < 0 ? 0 : of_rest < 0 ? 1 : 2;
    };
    const auto sign_at_start = [&](int polynomial) {
        return oracle::sign_at(all[static_cast<std::size_t>(polynomial)], start);
    };
    if (sign_at_start(gap_by(sign_at_start(3), sign_at_start(4))) <= 0) return std::nullopt;
    const oracle::RealRoots roots(all);
    for (int i = 0; i < roots.count(); ++i) {
        if (roots.compare(i, start) <= 0) continue;
        const int after = gap_by(roots.sign_after(i, 3), roots.sign_after(i, 4));
        if (roots.sign_after(i, after) < 0) return roots.nearest_double(i);
    }
    return infinity;
}

TEST(Walls, MeetingsWithSegmentsAreThoseOfRationals) {
    int met = 0;
    int missed = 0;
    for (std::uint64_t seed = 0; seed < std::uint64_t(4 * trials); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Choices choose(seed);
        choose.be_round(choose.below(2) == 0);
        const auto wall = std::get<Segment>(one_wall<2>(Kind::segment, choose).obstacles[0]);
        Effects<2> effects;
        if (choose.below(2) == 0) effects.gravity = {choose.number(-1.0, 1.0), -1.0};
        GrowingBall<2> ball;
        for (int k = 0; k < 2; ++k) {
            ball.x[k] = choose.number(-4.0, 4.0);
            // Many to the segment, some of them to its ends.
            const double part = 0.25 * (choose.below(9) - 2);
            const double there = wall.from[k] + part * (wall.to[k] - wall.from[k]);
            ball.v[k] = choose.below(3) == 0 ? choose.number(-2.0, 2.0) : 0.5 * (there - ball.x[k]);
        }
        ball.radius = std::max(choose.number(0.0, 1.0), 0.125);
        if (choose.below(3) == 0) ball.growth = choose.number(0.0, 0.5);
        if (choose.below(2) == 0) ball.time = choose.number(0.0, 2.0);
        const std::optional<double> expected = meeting_of_segment(ball, wall, effects.gravity);
        if (!expected) continue;
        ASSERT_EQ(meeting_time(ball, wall, effects), *expected);
        ++(*expected < infinity ? met : missed);
        const Segment turned{wall.to, wall.from};
        ASSERT_EQ(meeting_time(ball, turned, effects), *expected);
    }
    EXPECT_GT(met, trials);
    EXPECT_GT(missed, trials / 10);
}

/// It touches an end so gently that its velocity does not change, and then falls onto the line.
TEST(Walls, ABallThatTouchedAnEndStillMeetsTheSegment) {
    Effects<2> effects;
    effects.gravity = {0.0, -1.0};
    effects.wall_restitution = 0.0;
    effects.obstacles.emplace_back(Segment{{0.0, 0.0}, {4000.0, 2900.0}});
    const std::vector<Body<2>> bodies = {{{-3.0, 4.0}, {4.0 + 0x1p-50, 3.0 + 0x1p-51}, 5.0, 1.0}};
    Simulation<2> simulation(start<2>(bodies, effects), effects);
    std::vector<Strike> log;
    (void)simulation.run({.until = 4.0, .strikes = 3},
                         [&](const Strike& strike) { log.push_back(strike); });
    ASSERT_FALSE(log.empty());
    EXPECT_LT(log.front().time, 1.0);
    const State<2> state = simulation.state();
    const Vector<2> x = centre(state.balls[0], state.time, effects);
    EXPECT_GT(40.0 * x[1] - 29.0 * x[0], 0.0);
}

/// It touches a wall, and neither the slope of their gap nor its bend leads away from it or into
/// it: what comes after them does.
TEST(Walls, WhatBendsLaterLeadsIntoAWallOrAway) {
    struct Case {
        Effects<2> effects;
        Body<2> body;
        bool collapses = false;
    };
    const auto beside = [](double radius, Sphere<2>::Side side, Vector<2> gravity, Body<2> body,
                           bool collapses) {
        Case result{{}, body, collapses};
        result.effects.gravity = gravity;
        result.effects.obstacles.emplace_back(Sphere<2>{.radius = radius, .side = side});
        return result;
    };
    constexpr auto inside = Sphere<2>::Side::inside;
    constexpr auto outside = Sphere<2>::Side::outside;
    std::vector<Case> cases = {beside(6.0, inside, {1.0, -5.0}, {{0, 5}, {5, 0}, 1, 1}, true),
                               beside(6.0, inside, {0.0, -5.0}, {{0, 5}, {5, 0}, 1, 1}, true),
                               beside(3.0, outside, {-1.0, -5.0}, {{0, 5}, {5, 0}, 2, 1}, true),
                               beside(3.0, outside, {1.0, -5.0}, {{0, 5}, {5, 0}, 2, 1}, false),
                               beside(3.0, outside, {0.0, -5.0}, {{0, 5}, {5, 0}, 2, 1}, false)};
    // With the speed of a side of the box that shakes, which slows down.
    for (const double speed : {2.0, -2.0}) {
        Case shaken{{}, {{4.0, speed > 0.0 ? 7.0 : 1.0}, {0.0, speed}, 1, 1}, true};
        shaken.effects.box = Box<2>{{0.0, 0.0}, {8.0, 8.0}};
        shaken.effects.shake = Shake<2>{{0.0, std::copysign(0.25, speed)}, 8.0, 0.0};
        cases.push_back(shaken);
    }
    for (const Case& each : cases) {
        Simulation<2> simulation(start<2>(std::vector<Body<2>>{each.body}, each.effects),
                                 each.effects);
        EXPECT_EQ(simulation.run({.until = 0.5}).ending == Ending::collapse, each.collapses)
            << &each - cases.data();
    }
}

/// Thrown up beside a segment, a ball comes back onto it, onto its end or past it.
TEST(Walls, AParabolaComesBackToASegment) {
    Effects<2> effects;
    effects.gravity = {0.0, -2.0};
    const Segment wall{{0.0, 0.0}, {4.0, 0.0}};
    GrowingBall<2> ball;
    ball.x = {-2.0, -3.0};
    ball.v = {1.0, 4.0};
    ball.radius = 0.5;
    // y = -3 + 4 t - t² is 1/2 at 2 + √(1/2) and 2 - √(1/2), x = -2 + t; at the first one x is
    // -0.7.
    EXPECT_EQ(meeting_time(ball, wall, effects), 2.0 + std::sqrt(0.5));
    ball.v[0] = 0.25;  // past it
    EXPECT_EQ(meeting_time(ball, wall, effects), infinity);
    ball.x[0] = -1.0;  // 0 at t = 2, at its peak above the end
    EXPECT_EQ(meeting_time(ball, wall, effects), *meeting_of_segment(ball, wall, effects.gravity));
    ball.x = {2.0, -3.0};  // from below, where it does not get through
    ball.v = {0.0, 4.0};
    EXPECT_NEAR(meeting_time(ball, wall, effects), 2.0 - std::sqrt(1.5), 1e-15);
}

}  // namespace
}  // namespace signum::motion
