/// The stages of a meeting time are uncertain wherever what they round could have changed what they
/// tell, and of hardly more: where each begins to tell is set beside the bounds of
/// motion/meeting.hpp and motion/exact_meeting.cpp.

#include <cmath>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "../../motion/exact_meeting.hpp"
#include "../../motion/meeting.hpp"
#include "../oracle/oracle_test_support.hpp"

#include "threshold.hpp"

namespace signum::motion {
namespace {

using oracle_test::Random;
using threshold::expect_first_certain;

constexpr double u = 0x1p-53;

double steps_of(std::int64_t steps, double unit) {
    return static_cast<double>(steps) * unit;
}

/// What the first of two balls is told, all numbers of both at most `extent`.
Meeting told(const Ball<2>& a, const Ball<2>& b, double now, double extent) {
    MeetingFilter<2> filter(Effects<2>{}, Kernel::exact);
    const std::vector<Ball<2>> balls = {a, b};
    for (const Ball<2>& ball : balls) filter.include(ball);
    filter.include(Ball<2>{{extent, 0}, {}, 0, now});
    Crowd crowd;
    crowd.push(1);
    filter.asker(balls[0], now).meetings(balls.data(), crowd);
    return {crowd.early[0], crowd.late[0]};
}

/// A ball that passes another one at the sum of their radii, 1, and a little more: B² - AC is minus
/// the double of that.
TEST(MeetingBounds, OfWhoPasses) {
    for (const double extent : {4.0, 0x1p10}) {
        const double square = extent * extent;
        expect_first_certain("passes", 1682, 2200, [&](std::int64_t steps) {
            const double more = 0.5 * steps_of(steps, u * square);
            return told({{0, 0}, {1, 0}, 0.5, 0}, {{3, 1 + more}, {0, 0}, 0.5, 0}, 0, extent)
                       .early == infinity;
        });
    }
}

/// Late, when a tick of the clock is far above all errors of the way, and near the middle of two
/// ticks.
TEST(MeetingBounds, AnIntervalIsAsWideAsWhatTheClockRounds) {
    Random random(1810);
    const double now = 0x1p40;
    const double tick = 0x1p-12;
    for (int trial = 0; trial < 4000; ++trial) {
        const double y = 0.75 * random.unit();
        const double middle = 1.0 + (random.below(1000) + 0.5) * tick;
        const double about = middle + std::sqrt(1.0 - y * y) + (random.below(17) - 8) * 0x1p-52;
        const Ball<2> a{{0, 0}, {1, 0}, 0.5, now};
        const Ball<2> b{{about, y}, {0, 0}, 0.5, now};
        const Meeting meeting = told(a, b, now, 4.0);
        const double exact = exact_meeting(a, b, {}, Effects<2>{});
        ASSERT_LE(meeting.early, exact);
        ASSERT_GE(meeting.late, exact);
    }
}

/// A ball that touches a wall and rises, by a speed that is a sum of others, never meets it.
TEST(MeetingBounds, OfSpeedsThatAreRounded) {
    MeetingFilter<2> filter(Effects<2>{}, Kernel::exact);
    const Ball<2> ball{{0, 0}, {0, 0}, 1, 0};
    const auto asker = filter.asker(ball, 0);
    for (const double sizes : {1.0, 0x1p20})
        expect_first_certain("rises", 7, 9, [&](std::int64_t steps) {
            return asker
                       .descent({.distance = 1,
                                 .v = steps_of(steps, u * sizes),
                                 .g = 1,
                                 .extent = 1,
                                 .sizes = sizes})
                       .early == infinity;
        });
}

/// The root is so far below the middle of 2 and the double before it; far from the origin places
/// have errors.
template <class Refine>
void expect_refined(const char* what, double least, double most, const Refine& refine) {
    constexpr double unit = 0x1p-70;
    const auto first = threshold::first_certain(1 << 14, [&](std::int64_t steps) {
        const double time = refine(0x1p-53 + steps_of(steps, unit));
        EXPECT_TRUE(std::isnan(time) || time == 2.0 - 0x1p-52) << what;
        return !std::isnan(time);
    });
    EXPECT_GT(steps_of(first, unit), least) << what;
    EXPECT_LE(steps_of(first, unit), most) << what;
}

TEST(MeetingBounds, OfDoubleDoubles) {
    constexpr double far = 0x1p36;
    // Double-doubles err by some 2^-104 of what they add up.
    expect_refined("balls", 0x1p-100 * far, 0x1p-93 * far, [](double radius) {
        const Ball<2> a{{far, 0}, {1, 0}, 1, 0};
        const Ball<2> b{{far + 3, 0}, {0, 0}, radius, 0};
        return refined_meeting(a, b, {}, Effects<2>{}, 2.0);
    });
    expect_refined("a wall", 0x1p-103 * far, 0x1p-94 * far, [](double radius) {
        Effects<2> effects;
        effects.box = Box<2>{{far - 2, -1}, {far + 4, 1}};
        return refined_meeting(Ball<2>{{far, 0}, {-1, 0}, radius, 0}, 0, effects, 2.0);
    });
}

/// A Newton step leaves what the parabola bends: from far away nothing, or the truth.
TEST(MeetingBounds, OfStepsThatAreLong) {
    const Ball<2> a{{0, 0}, {1, 0.25}, 0.5, 0};
    const Ball<2> b{{3, 1.25}, {-0.5, 0}, 0.75, 0};
    const double exact = exact_meeting(a, b, {}, Effects<2>{});
    ASSERT_LT(exact, 3.0);
    int refined = 0;
    for (int k = 10; k < 60; ++k)
        for (const double sign : {-1.0, 1.0}) {
            const double time =
                refined_meeting(a, b, {}, Effects<2>{}, exact + sign * std::ldexp(1.0, -k));
            if (std::isnan(time)) continue;
            ++refined;
            EXPECT_EQ(time, exact) << k;
        }
    EXPECT_GT(refined, 40);
}

}  // namespace
}  // namespace signum::motion
