// Dyadic numbers: exact on both sides of 128 bits, for all doubles, in every environment.

#include "../../exact/dyadic.hpp"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "../../exact/multiprecision.hpp"
#include "exact_reference.hpp"

namespace {

using signum::exact::Dyadic;
using signum::exact::Rational;
using signum::exact::to_rational;
using signum::reference::in_environment;
using signum::reference::quartic;
using signum::reference::Random;

Rational rational(double value) {
    return to_rational(value);
}
Dyadic dyadic(double value) {
    return Dyadic(value);
}

/// Doubles of a few binades, of many, small integers, any; often some of them equal.
std::array<double, 4> draw(Random& random) {
    std::array<double, 4> values{};
    const int kind = random.below(5);
    for (double& value : values)
        value = kind == 0   ? random.between(-3, 3)
                : kind == 1 ? std::ldexp(random.between(-9, 9), random.between(-70, 70))
                : kind == 2 ? random.in_binades(0, 3)
                : kind == 3 ? random.in_binades(-60, 60)
                            : random.finite();
    if (random.below(3) == 0) values[3] = values[2];
    return values;
}

TEST(Dyadic, HasTheSignsOfRationalsUpToDegreeEight) {
    Random random(3);
    int ties = 0;
    for (int trial = 0; trial < 20'000; ++trial) {
        const std::array<double, 4> values = draw(random);
        // Signs of degree 1, 2, 4 and 8, many of them of small differences of large numbers.
        const auto signs = [&]<class Number>(Number (*number)(double)) {
            const Number a = number(values[0]);
            const Number b = number(values[1]);
            const Number c = number(values[2]);
            const Number d = number(values[3]);
            const Number first = quartic(a, b, c, d);
            const Number second = quartic(a, b, d, c);
            return std::array{a.sign(),
                              Number(a + b - c).sign(),
                              Number(-(a * d) + b * c).sign(),
                              Number(first - second).sign(),
                              Number(first * second - first * first).sign(),
                              static_cast<int>(first < second),
                              static_cast<int>(a * c == a * d),
                              static_cast<int>(b > 0)};
        };
        const auto expected = signs(&rational);
        const auto given = in_environment(trial % signum::reference::Hostile::modes,
                                          [&] { return signs(&dyadic); });
        ASSERT_EQ(given, expected) << trial << ": " << testing::PrintToString(values);
        ties += static_cast<int>(expected[3] == 0);
    }
    EXPECT_GT(ties, 1000);
}

TEST(Dyadic, SeesAHairWhereNumbersOutgrow128Bits) {
    // (x + y)(x - y) - x² + y² is 0; with a hair added it has the hair's sign. From 2 to 1000 bits.
    for (int apart = 0; apart < 500; ++apart)
        for (const double off : {0.0, 1.0, -1.0}) {
            const Dyadic x = Dyadic(std::ldexp(1.0, apart)) + Dyadic(off);
            const Dyadic y(std::ldexp(3.0, -apart / 2));
            const Dyadic zero = (x + y) * (x - y) - x * x + y * y;
            ASSERT_EQ(zero.sign(), 0) << apart;
            ASSERT_EQ((zero + zero).sign(), 0);
            ASSERT_EQ((zero * x).sign(), 0);
            const Dyadic hair(-std::ldexp(1.0, -apart));
            ASSERT_EQ((zero + hair).sign(), -1) << apart;
            ASSERT_EQ((x * x + hair - x * x).sign(), -1) << apart;
            ASSERT_EQ((-(x * x * x) - 2 * hair + x * x * x).sign(), 1) << apart;
        }
}

TEST(Dyadic, IsZeroAtFirst) {
    EXPECT_EQ(Dyadic().sign(), 0);
    EXPECT_EQ((Dyadic() + Dyadic(0x1p-1074)).sign(), 1);
    EXPECT_EQ((Dyadic(-0.0) - Dyadic(0x1p1023)).sign(), -1);
    EXPECT_EQ((Dyadic() * Dyadic(0x1p1023)).sign(), 0);
}

}  // namespace
