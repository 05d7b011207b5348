/// The Euclidean in_circle in every stage behind its filter: sites that only the stage named can
/// decide, with signs worked out by hand.

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "../../predicates/euclidean.hpp"

namespace signum {
namespace {

/// i, j and k touch the circle of radius 4 around the origin from outside.
constexpr Site i = {5, 0, 1};
constexpr Site j = {-6, 8, 6};
constexpr Site k = {0, -7, 3};

Decision decide(const Site& q, double scale = 1.0) {
    const auto scaled = [&](const Site& s) -> Site {
        return {s.x * scale, s.y * scale, s.r * scale};
    };
    return euclidean::in_circle_decision(scaled(i), scaled(j), scaled(k), scaled(q), {0, 1, 2, 3});
}

TEST(EuclideanInCircleStages, Filter) {
    EXPECT_EQ(decide({6, 8, 6.5}).sign, 1);
    EXPECT_EQ(decide({6, 8, 6.5}).stage, Stage::filter);
    EXPECT_EQ(decide({6, 8, 5.5}).sign, -1);
}

/// Off the circle by an ulp or two.
TEST(EuclideanInCircleStages, Refine) {
    const double above = std::nextafter(6.0, 7.0);
    const double below = std::nextafter(6.0, 5.0);
    for (const double scale : {1.0, 0x1p-80, 0x1p80}) {
        EXPECT_EQ(decide({6, 8, above}, scale).sign, 1) << scale;
        EXPECT_EQ(decide({6, 8, above}, scale).stage, Stage::refine) << scale;
        EXPECT_EQ(decide({6, 8, below}, scale).sign, -1) << scale;
        EXPECT_EQ(decide({6, 8, below}, scale).stage, Stage::refine) << scale;
    }
    // Where products lose bits under the denormals, integers answer.
    EXPECT_EQ(decide({6, 8, above}, 0x1p-300).sign, 1);
    EXPECT_EQ(decide({6, 8, above}, 0x1p-300).stage, Stage::exact);
}

/// On the circle: in small integers, and in such that double-doubles leave the sign open.
TEST(EuclideanInCircleStages, Exact) {
    for (const double scale : {1.0, 0x1p31 + 1, 0x1p47 - 3, 123456789.0 * 65537.0}) {
        const Decision decision = decide({6, 8, 6}, scale);
        EXPECT_EQ(decision.stage, Stage::exact) << scale;
        EXPECT_EQ(decision.sign, 0) << scale;
    }
    // Off it by 2^-100 of its size.
    EXPECT_EQ(decide({10, 0x1p-50, 6}).sign, -1);
    EXPECT_EQ(decide({10, 0x1p-50, 6}).stage, Stage::exact);
}

TEST(EuclideanInCircleStages, Multiprecision) {
    EXPECT_EQ(decide({10, 0x1p-500, 6}).sign, -1);
    EXPECT_EQ(decide({10, 0x1p-500, 6}).stage, Stage::multiprecision);
}

}  // namespace
}  // namespace signum
