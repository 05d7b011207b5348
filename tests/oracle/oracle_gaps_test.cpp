/// The oracle of gaps against what is known on paper.

#include "gaps.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace signum::oracle::motion {
namespace {

Ball ball(double x, double y, double vx, double vy, double r, double t0 = 0) {
    Ball result;
    result.x = {x, y, 0};
    result.v = {vx, vy, 0};
    result.r = r;
    result.t0 = t0;
    return result;
}

TEST(GapsOracle, GapsAreRoundedOnce) {
    const World plane;
    EXPECT_EQ(closest({ball(0, 0, 0, 0, 1), ball(3, 4, 0, 0, 1.5)}, plane, 0),
              (Near{0, 0, 1, 2.5}));
    // √2 - 1 = 1.0110101000001001111...b / 4, not the double of √2 less 1, which ends with 0.
    EXPECT_EQ(closest({ball(0, 0, 0, 0, 1), ball(1, 1, 0, 0, 0)}, plane, 0)->gap,
              0x1.a827999fcef32p-2);
    // Concentric, and each brought from its own time, falling.
    World falling;
    falling.g = {0, -2, 0};
    EXPECT_EQ(closest({ball(0, 4, 1, 0, 1), ball(1, 3, 1, -2, 0.5, 1)}, falling, 2),
              (Near{2, 0, 1, -1.5}));
}
TEST(GapsOracle, TiesGoToTheSmallerNumbers) {
    const World plane;
    const std::vector<Ball> square = {ball(0, 0, 0, 0, 0), ball(1, 1, 0, 0, 0), ball(1, 0, 0, 0, 0),
                                      ball(0, 1, 0, 0, 0)};
    EXPECT_EQ(closest(square, plane, 0), (Near{0, 0, 2, 1}));
    EXPECT_EQ(closest(square, plane, 0, 3), (Near{0, 0, 3, 1}));
    EXPECT_EQ(closest({square.front()}, plane, 0), std::nullopt);
}
TEST(GapsOracle, TheNearestImageCounts) {
    World box;
    box.periodic = true;
    box.high = {4, 4, 4};
    EXPECT_EQ(closest({ball(0.5, 0, 0, 0, 0.25), ball(3.5, 4, 0, 0, 0.25)}, box, 0),
              (Near{0, 0, 1, 0.5}));
    // Once around, and so the nearest one again; in between the other one is.
    EXPECT_EQ(closest_list({ball(0, 0, 0, 0, 0), ball(0, 1, 0, 0, 0), ball(0, 0.5, 1, 0, 0)}, box,
                           0, 4.5),
              (std::vector<Near>{{0, 0, 2, 0.5},
                                 {std::sqrt(0.75), 0, 1, 1},
                                 {0x1.9126145e9ecd5p+1, 0, 2, 0x1.0000000000001p+0}}));
}
TEST(GapsOracle, ListsKnownOnPaper) {
    const World plane;
    // 7 - 2t and √(t² + 25) - 2.
    EXPECT_EQ(
        closest_list({ball(0, 0, 1, 0, 1), ball(9, 0, -1, 0, 1), ball(0, 5, 0, 0, 1)}, plane, 0, 3),
        (std::vector<Near>{{0, 0, 2, 3}, {1.8366680010677345, 0, 1, 3.326663997864531}}));
    // On one line: |t - 2|, |t - 4| - 1 and 2 - 0.5 - 0.5; the first one at 0 turns back.
    EXPECT_EQ(
        closest_list({ball(0, 0, 1, 0, 0), ball(2, 0, 0, 0, 0), ball(4, 0, 0, 0, 1)}, plane, 0, 5),
        (std::vector<Near>{{0, 1, 2, 1}, {1, 0, 1, 1}, {2.5, 0, 2, 0.5}}));
    // Equal for ever, and equal once without a change.
    EXPECT_EQ(
        closest_list({ball(0, 0, 1, 0, 0), ball(1, 0, 1, 0, 0), ball(0, 1, 1, 0, 0)}, plane, 0, 5),
        (std::vector<Near>{{0, 0, 1, 1}}));
    EXPECT_EQ(closest_list({ball(-2, 1, 1, 0, 0), ball(0, 0, 0, 0, 0), ball(9, 0, 0, 0, 0),
                            ball(9, 1, 0, 0, 0)},
                           plane, 0, 5),
              (std::vector<Near>{{0, 2, 3, 1}}));
}

}  // namespace
}  // namespace signum::oracle::motion
