// Sums: polynomials in them are their own expanded forms, exact also where factors are added up.

#include "../../exact/sum.hpp"

#include <array>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "../../exact/multiprecision.hpp"
#include "../../predicates/ccw.hpp"
#include "../../predicates/power/in_circle.hpp"
#include "exact_reference.hpp"

namespace {

using signum::Point;
using signum::Site;
using signum::exact::Rational;
using signum::exact::Sum;
using signum::exact::to_rational;
using signum::reference::quartic;

/// Rounded or small numbers, some of them far apart, some 0.
class Draw {
 public:
    double operator()() {
        const int kind = static_cast<int>(random_() % 4);
        if (kind == 0) return static_cast<double>(random_() % 7) - 3;
        return std::ldexp(unit_(random_), kind == 1 ? 0 : static_cast<int>(random_() % 101) - 50);
    }

 private:
    std::mt19937_64 random_{5};
    std::uniform_real_distribution<double> unit_{-1, 1};
};

TEST(Sum, KeepsEverySignUpToDegreeEight) {
    Draw draw;
    int added_up = 0;
    for (int trial = 0; trial < 3000; ++trial) {
        // ((a-b)(c-d) + (b-c)² - 4(a-d)b)² - the same with the last two exchanged.
        std::array<double, 4> values{};
        for (double& value : values) value = draw();
        if (trial % 3 == 0) values[3] = values[2];
        const auto polynomial = [&]<class Number>(Number (*number)(double)) {
            const Number a = number(values[0]);
            const Number b = number(values[1]);
            const Number c = number(values[2]);
            const Number d = number(values[3]);
            const Number first = quartic(a, b, c, d);
            const Number second = quartic(a, b, d, c);
            return Number(first * first - second * second);
        };
        const Rational expected = polynomial(+[](double v) { return to_rational(v); });
        const Sum sum = polynomial(+[](double v) { return Sum(v); });
        ASSERT_EQ(sum.sign(), expected.sign()) << trial;
        added_up += static_cast<int>(sum.terms() <= 2 * Sum::most_terms);
    }
    EXPECT_GT(added_up, 0);
}

TEST(Sum, IsZeroWithoutATerm) {
    EXPECT_EQ(Sum().terms(), 0U);
    EXPECT_EQ(Sum(0.0).terms(), 0U);
    EXPECT_EQ(Sum().sign(), 0);
    EXPECT_EQ((Sum(3) * Sum()).terms(), 0U);
    EXPECT_EQ((Sum(3) - Sum(3)).terms(), 0U);
    EXPECT_EQ((Sum(1) - Sum(0x1p-60)).terms(), 2U);
    EXPECT_EQ((Sum(5) * Sum(7)).terms(), 1U);
}

TEST(Sum, Compares) {
    EXPECT_TRUE(Sum(1) > Sum(0.5));
    EXPECT_TRUE(Sum(1) + Sum(0x1p-80) > Sum(1));
    EXPECT_TRUE(Sum(1) + Sum(0x1p-80) != Sum(1));
    EXPECT_TRUE(Sum(0.1) * Sum(3) == Sum(3) * Sum(0.1));
    EXPECT_TRUE(Sum(0.1) - Sum(0.1) == 0);
    EXPECT_TRUE(Sum(0.1) > 0);
    EXPECT_TRUE(-Sum(0.1) < 0);
}

/// The lengths that exact/sum.hpp names: nothing is added up on the way.
TEST(Sum, HasTheExpandedFormOfInCircle) {
    const auto terms = []<class S>(const S(&s)[4]) {
        using signum::power::row;
        return signum::power::in_circle_determinant(row<Sum>(s[0], s[3]), row<Sum>(s[1], s[3]),
                                                    row<Sum>(s[2], s[3]))
            .terms();
    };
    // Differences that are doubles, all of whose products need two.
    const Point a{0.1, 0.7};
    const Point b{-1.3, 0.9};
    const Point c{-0.3, -1.1};
    EXPECT_EQ(terms({a, b, c, Point{0, 0}}), 96U);
    EXPECT_EQ(terms({Site{a.x, a.y, 0.6}, Site{b.x, b.y, 1.7}, Site{c.x, c.y, 0.1}, Site{0, 0, 0}}),
              144U);
    // Differences that are sums of two doubles.
    const Point q{0x1.999999999999ap-45, 0x1.6666666666667p-43};
    EXPECT_LE(terms({a, b, c, q}), 1536U);
    EXPECT_GT(terms({a, b, c, q}), 1400U);
}

}  // namespace
