/// Numbers with one square root, against doubles where these tell them apart, and by hand where
/// not.

#include <gtest/gtest.h>
#include "oracle_test_support.hpp"
#include "surd.hpp"

#include <cmath>
#include <stdexcept>

namespace {

using namespace signum::oracle_test;
using signum::oracle::between;
using signum::oracle::Rational;
using signum::oracle::Surd;

double value(const Surd& x) {
    return static_cast<double>(x.a()) +
           static_cast<double>(x.b()) * std::sqrt(static_cast<double>(x.g()));
}

TEST(OracleSurd, SignsAndComparisons) {
    EXPECT_EQ(Surd().sign(), 0);
    EXPECT_EQ(Surd(-3, 2, 2).sign(), -1);  // 2√2 < 3
    EXPECT_EQ(Surd(3, -2, 2).sign(), 1);
    EXPECT_EQ(Surd(-14, 10, 2).sign(), 1);  // √2 > 1.4
    EXPECT_EQ(Surd(-6, 2, 9).sign(), 0);
    EXPECT_EQ(Surd(0, -1, 5).sign(), -1);
    EXPECT_EQ(Surd(1, 1, 2) * Surd(1, -1, 2), Surd(-1));
    EXPECT_EQ(Surd(1, 2, 12), Surd(1, 4, 3));
    EXPECT_EQ(Surd(1, 2, Rational(9, 4)), Surd(4));
    EXPECT_FALSE(Surd(0, 1, 2) == Surd(0, -1, 2));
    EXPECT_LT(Surd(0, 1, 2), Surd(0, 1, 3));
    EXPECT_LT(Surd(0, -1, 3), Surd(0, -1, 2));
    EXPECT_LT(Surd(1, 1, 3), Surd(0, 2, 2));     // 2.732 < 2.828
    EXPECT_LT(Surd(-1, -1, 2), Surd(-4, 1, 3));  // -2.414 < -2.268
    EXPECT_FALSE(Surd(-4, 1, 3) < Surd(-1, -1, 2));
    EXPECT_THROW(Surd(0, 1, -1), std::invalid_argument);
    EXPECT_THROW(Surd(0, 1, 2) + Surd(0, 1, 3), std::logic_error);
    EXPECT_EQ(Surd(5) + Surd(0, 1, 3) * Surd(2), Surd(5, 2, 3));
}

TEST(OracleSurd, ComparesAsDoubles) {
    Random random(1);
    const auto some = [&] {
        return Surd(random.below(21) - 10, random.below(9) - 4, random.below(12));
    };
    for (int trial = 0; trial < 3000; ++trial) {
        const Surd x = some(), y = some();
        const double difference = value(x) - value(y);
        ASSERT_EQ(x == y, std::abs(difference) < 1e-9);
        ASSERT_EQ(x < y, difference < -1e-9);
        ASSERT_EQ(x.sign(), value(x) > 1e-9 ? 1 : value(x) < -1e-9 ? -1 : 0);
    }
}

TEST(OracleSurd, HasRationalsBetween) {
    const auto is_between = [](const Surd& x, const Surd& y) {
        const Surd z(between(x, y));
        return x < z && z < y;
    };
    EXPECT_TRUE(is_between(0, 1));
    EXPECT_TRUE(is_between({0, 1, 2}, {0, 1, 3}));
    EXPECT_TRUE(is_between({0, -1, 3}, {0, -1, 2}));
    EXPECT_TRUE(is_between({0, 1, 2}, Rational(1414213563, 1000000000)));
    EXPECT_TRUE(is_between(Rational(1414213562, 1000000000), {0, 1, 2}));
    EXPECT_TRUE(is_between({5, -1, 25}, signum::oracle::exactly(0x1p-300)));
    EXPECT_TRUE(is_between({-1000, -7, 1000001}, {-1000, -7, 1000000}));
}

}  // namespace
