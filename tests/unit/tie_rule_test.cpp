/// The order of the tie rule, number by number, and what it makes of a tie in space: the last site
/// that can decide does.

#include <array>
#include <cstddef>

#include <gtest/gtest.h>

#include "../../predicates/additive.hpp"
#include "../../predicates/space/ties.hpp"

namespace signum {
namespace {

TEST(TieRule, OrdersDiscsByFallingRadiusThenPlaceThenNumber) {
    using additive::precedes;
    // Each number decides against all that come after it.
    EXPECT_TRUE(precedes({1, 1, 2}, 1, {0, 0, 1}, 0));
    EXPECT_FALSE(precedes({0, 0, 1}, 0, {1, 1, 2}, 1));
    EXPECT_TRUE(precedes({0, 1, 1}, 1, {1, 0, 1}, 0));
    EXPECT_FALSE(precedes({1, 0, 1}, 0, {0, 1, 1}, 1));
    EXPECT_TRUE(precedes({0, 0, 1}, 1, {0, 1, 1}, 0));
    EXPECT_FALSE(precedes({0, 1, 1}, 0, {0, 0, 1}, 1));
    EXPECT_TRUE(precedes({0, 0, 1}, 0, {0, 0, 1}, 1));
    EXPECT_FALSE(precedes({0, 0, 1}, 1, {0, 0, 1}, 0));
}

TEST(TieRule, OrdersBallsByFallingWeightThenPlaceThenNumber) {
    using power::precedes;
    using S = power::Site3;
    EXPECT_TRUE(precedes(S{1, 1, 1, 2}, 1, S{0, 0, 0, 1}, 0));
    EXPECT_FALSE(precedes(S{0, 0, 0, 1}, 0, S{1, 1, 1, 2}, 1));
    EXPECT_TRUE(precedes(S{0, 1, 1, 1}, 1, S{1, 0, 0, 1}, 0));
    EXPECT_FALSE(precedes(S{1, 0, 0, 1}, 0, S{0, 1, 1, 1}, 1));
    EXPECT_TRUE(precedes(S{0, 0, 1, 1}, 1, S{0, 1, 0, 1}, 0));
    EXPECT_FALSE(precedes(S{0, 1, 0, 1}, 0, S{0, 0, 1, 1}, 1));
    EXPECT_TRUE(precedes(S{0, 0, 0, 1}, 1, S{0, 0, 1, 1}, 0));
    EXPECT_FALSE(precedes(S{0, 0, 1, 1}, 0, S{0, 0, 0, 1}, 1));
    EXPECT_TRUE(precedes(S{0, 0, 0, 1}, 0, S{0, 0, 0, 1}, 1));
    EXPECT_FALSE(precedes(S{0, 0, 0, 1}, 1, S{0, 0, 0, 1}, 0));
}

/// The corners of a cube in the order of their places, which is that of the rule: 0 the first.
Point3 corner(std::size_t number) {
    return {static_cast<double>(number >> 2), static_cast<double>(number >> 1 & 1),
            static_cast<double>(number & 1)};
}
Sign tie_of(const std::array<std::size_t, 5>& corners) {
    std::array<Point3, 5> sites;
    for (std::size_t m = 0; m < 5; ++m) sites[m] = corner(corners[m]);
    EXPECT_GT(ccw(sites[0], sites[1], sites[2], sites[3]), 0);
    return power::in_sphere_tie(sites, {0, 1, 2, 3, 4});
}

TEST(TieRule, KeepsTheLastSiteOutside) {
    // 0, 4, 2, 1 turn left, and 7 is the last of all.
    EXPECT_EQ(tie_of({0, 4, 2, 1, 7}), -1);
}

TEST(TieRule, LetsTheFirstSiteInWhereItIsOnTheLastOnesSide) {
    // 7 is last: with 0 in its place the cell still turns left, which is a conflict.
    EXPECT_EQ(tie_of({7, 1, 2, 4, 0}), ccw(corner(0), corner(1), corner(2), corner(4)));
    EXPECT_EQ(tie_of({1, 7, 4, 2, 0}), ccw(corner(1), corner(0), corner(4), corner(2)));
    // With 6 in the place of 7 it does not turn as with 3 there.
    EXPECT_EQ(tie_of({7, 1, 2, 4, 6}), ccw(corner(6), corner(1), corner(2), corner(4)));
    EXPECT_EQ(tie_of({7, 1, 2, 4, 3}), ccw(corner(3), corner(1), corner(2), corner(4)));
}

TEST(TieRule, PassesOverSitesThatCannotDecide) {
    // 7 is last, but 0 lies in the plane of the other three: with 0 in the place of 6 it is 6 that
    // decides.
    EXPECT_EQ(ccw(corner(0), corner(6), corner(2), corner(4)), 0);
    EXPECT_EQ(tie_of({7, 6, 4, 2, 0}), ccw(corner(7), corner(0), corner(4), corner(2)));
    EXPECT_NE(tie_of({7, 6, 4, 2, 0}), 0);
}

}  // namespace
}  // namespace signum
