/// Intervals contain what the exact numbers give, at both ends of the doubles' range too.

#include "../../filters/interval.hpp"

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "../../exact/multiprecision.hpp"

#include "exact_reference.hpp"

namespace {

using signum::exact::Rational;
using signum::exact::to_rational;
using signum::filters::exceeds;
using signum::filters::Interval;
using signum::filters::sign_of_nonzero;
using signum::reference::Random;

constexpr double infinity = std::numeric_limits<double>::infinity();

bool contains(const Interval& interval, const Rational& number) {
    return (interval.low == -infinity || to_rational(interval.low) <= number) &&
           (interval.high == infinity || number <= to_rational(interval.high));
}

Interval between(double a, double b) {
    return {std::min(a, b), std::max(a, b)};
}

double number(Random& random, int trial) {
    switch (trial % 4) {
        case 0:
            return random.finite();
        case 1:
            return random.in_binades(-1074, -1000);
        case 2:
            return random.in_binades(1000, 1023);
        default:
            return static_cast<double>(random.between(-4, 4)) / 4;
    }
}

TEST(Interval, ContainsExactResults) {
    Random random(5);
    for (int trial = 0; trial < 20000; ++trial) {
        const double a[] = {number(random, trial), number(random, trial)};
        const double b[] = {number(random, trial / 4), number(random, trial / 4)};
        const Interval left = between(a[0], a[1]);
        const Interval right = between(b[0], b[1]);
        const Interval sum = left + right;
        const Interval difference = left - right;
        const Interval product = left * right;
        for (const double x : a)
            for (const double y : b) {
                const Rational p = to_rational(x);
                const Rational q = to_rational(y);
                ASSERT_TRUE(contains(sum, p + q)) << x << " " << y;
                ASSERT_TRUE(contains(difference, p - q)) << x << " " << y;
                ASSERT_TRUE(contains(product, p * q)) << x << " " << y;
                ASSERT_TRUE(contains(magnitude(left), abs(p))) << x;
                ASSERT_TRUE(contains(max(left, right), std::max(p, q))) << x << " " << y;
            }
    }
}

TEST(Interval, StaysNarrow) {
    Random random(6);
    for (int trial = 0; trial < 2000; ++trial) {
        const double a = random.in_binades(-200, 200);
        const double b = random.in_binades(-200, 200);
        for (const Interval& result : {Interval(a) + Interval(b), Interval(a) * Interval(b)})
            EXPECT_LE(result.high - result.low, 0x1p-50 * std::fabs(result.high));
    }
    const Interval zero = Interval(0.1) - Interval(0.1);
    EXPECT_EQ(zero.low, 0.0);
    EXPECT_EQ(zero.high, 0.0);
}

TEST(Interval, IsEverythingWhereSomethingOverflows) {
    const Interval large(std::numeric_limits<double>::max());
    for (const Interval& all : {large + large, large * large, large * large - large * large,
                                Interval(0.0) * (large + large)}) {
        EXPECT_EQ(all.low, -infinity);
        EXPECT_EQ(all.high, infinity);
        EXPECT_FALSE(exceeds(all, 0.0));
    }
}

TEST(Interval, HasASignWhereItDoesNotContainZero) {
    EXPECT_TRUE(exceeds(Interval(1, 2), 0.0));
    EXPECT_EQ(sign_of_nonzero(Interval(1, 2)), 1);
    EXPECT_TRUE(exceeds(Interval(-2, -1), 0.0));
    EXPECT_EQ(sign_of_nonzero(Interval(-2, -1)), -1);
    EXPECT_FALSE(exceeds(Interval(-1, 2), 0.0));
    EXPECT_FALSE(exceeds(Interval(0, 2), 0.0));
    EXPECT_FALSE(exceeds(Interval(1, 2), 1.0));
}

TEST(Interval, HasNoSignInOtherRoundingModes) {
    for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
        ASSERT_EQ(std::fesetround(mode), 0);
        const bool has = exceeds(Interval(1, 2), 0.0);
        ASSERT_EQ(std::fesetround(FE_TONEAREST), 0);
        EXPECT_FALSE(has);
    }
}

}  // namespace
