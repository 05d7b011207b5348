// Conversions between doubles and rationals against GMP's own and against the definition of
// rounding.

#include "../../exact/multiprecision.hpp"

#include <bit>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "exact_reference.hpp"

namespace {

using signum::exact::Rational;
using signum::exact::round_to_double;
using signum::exact::to_rational;
using signum::reference::Hostile;
using signum::reference::in_environment;
using signum::reference::Random;

constexpr double largest = std::numeric_limits<double>::max();
constexpr double least = std::numeric_limits<double>::denorm_min();

/// GMP's conversion, exact in the default environment.
mpq_class reference_rational(double value) {
    return mpq_class(value);
}

bool same_bits(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

/// The same number of GMP, whatever the library's are.
mpq_class as_of_gmp(const Rational& value) {
#if defined(SIGNUM_WITHOUT_GMP)
    return {mpz_class(numerator(value).str()), mpz_class(denominator(value).str())};
#else
    return mpq_class(value.backend().data());
#endif
}

Rational shifted(const Rational& value, int exponent) {
    return signum::exact::scaled(value, exponent);
}

TEST(Numbers, AreScaledDividedAndCutLikeThoseOfGmp) {
    using signum::exact::Integer;
    Random random(7);
    for (int trial = 0; trial < 20'000; ++trial) {
        const double value = random.finite();
        const int exponent = random.between(-3000, 3000);
        mpq_class expected(value);
        if (exponent < 0) {
            expected /= mpz_class(1) << static_cast<unsigned>(-exponent);
        } else {
            expected *= mpz_class(1) << static_cast<unsigned>(exponent);
        }
        ASSERT_EQ(as_of_gmp(shifted(to_rational(value), exponent)), expected);

        // Integers of up to 1024 digits and more.
        const Integer a = signum::exact::floor_of(numerator(to_rational(value)) * 3 + 1, 7);
        mpz_class of_gmp;
        const mpz_class first = mpq_class(value).get_num() * 3 + 1;
        mpz_fdiv_q_ui(of_gmp.get_mpz_t(), first.get_mpz_t(), 7);
        ASSERT_EQ(a.str(), of_gmp.get_str());
        if (of_gmp == 0) continue;
        ASSERT_EQ(signum::exact::bits_of(a),
                  static_cast<std::int64_t>(mpz_sizeinbase(of_gmp.get_mpz_t(), 2)));
        long places = 0;
        const double fraction = mpz_get_d_2exp(&places, of_gmp.get_mpz_t());
        const auto digits = signum::exact::leading_digits(a);
        ASSERT_EQ(digits.fraction, fraction);
        ASSERT_EQ(digits.exponent, places);
    }
    EXPECT_EQ(signum::exact::bits_of(Integer(0)), 0);
}

TEST(ToRational, IsExactForEveryFiniteDoubleInEveryEnvironment) {
    Random random(1);
    for (int trial = 0; trial < 500'000; ++trial) {
        const double value = random.finite();
        const mpq_class expected = reference_rational(value);
        const Rational result =
            in_environment(trial % Hostile::modes, [&] { return to_rational(value); });
        ASSERT_EQ(as_of_gmp(result), expected)
            << std::hexfloat << value << " in environment " << trial % Hostile::modes;
        ASSERT_EQ(signum::exact::sign(result), sgn(expected));
    }
}

TEST(RoundToDouble, GivesEveryDoubleBack) {
    Random random(2);
    for (int trial = 0; trial < 300'000; ++trial) {
        const double value = random.finite();
        const double result = in_environment(trial % Hostile::modes,
                                             [&] { return round_to_double(to_rational(value)); });
        // A rational has no -0.
        ASSERT_TRUE(same_bits(result, value == 0.0 ? 0.0 : value)) << std::hexfloat << value;
    }
}

TEST(RoundToDouble, IsTheNearestAndTheEvenOneOfTwo) {
    // A double plus a part of the step to its neighbour, down to a hair beside the half.
    Random random(3);
    for (int trial = 0; trial < 200'000; ++trial) {
        const double below = std::fabs(random.finite());
        if (below == largest) continue;
        const double above = std::nextafter(below, largest);
        const Rational step = to_rational(above) - to_rational(below);
        const int side = random.between(-1, 1);
        const Rational part = Rational(1) / 2 + shifted(side, -random.between(2, 300));
        const Rational value = to_rational(below) + part * step;

        const bool even = (std::bit_cast<std::uint64_t>(below) & 1) == 0;
        const double expected = side < 0 || (side == 0 && even) ? below : above;
        const int mode = trial % Hostile::modes;
        ASSERT_TRUE(
            same_bits(in_environment(mode, [&] { return round_to_double(value); }), expected))
            << std::hexfloat << below << " side " << side << " in environment " << mode;
        ASSERT_TRUE(
            same_bits(in_environment(mode, [&] { return round_to_double(-value); }), -expected));
    }
}

TEST(RoundToDouble, IsTheNearestForQuotients) {
    Random random(4);
    for (int trial = 0; trial < 200'000; ++trial) {
        const long numerator = static_cast<long>(random.engine()() >> random.between(1, 63));
        const long denominator = 1 + static_cast<long>(random.engine()() >> random.between(1, 63));
        const Rational value =
            shifted(Rational(numerator) / denominator, random.between(-1140, 960));
        const double result = round_to_double(value);
        const Rational error = abs(value - to_rational(result));
        for (const double neighbour :
             {std::nextafter(result, largest), std::nextafter(result, -largest)}) {
            const Rational other = abs(value - to_rational(neighbour));
            ASSERT_LE(error, other);
            if (error == other) {
                ASSERT_EQ(std::bit_cast<std::uint64_t>(result) & 1, 0U);
            }
        }
    }
}

TEST(RoundToDouble, IsNanFromHalfAPlaceBeyondTheLargestDouble) {
    const Rational last_place = shifted(1, 971);
    const Rational limit = to_rational(largest) + last_place / 2;
    const Rational hair = shifted(1, -2000);
    EXPECT_EQ(round_to_double(limit - hair), largest);
    EXPECT_EQ(round_to_double(hair - limit), -largest);
    EXPECT_TRUE(std::isnan(round_to_double(limit)));
    EXPECT_TRUE(std::isnan(round_to_double(-limit)));
    EXPECT_TRUE(std::isnan(round_to_double(shifted(1, 1024))));
    EXPECT_TRUE(std::isnan(round_to_double(shifted(-3, 100'000))));
}

TEST(RoundToDouble, RoundsDenormalsOnceAndKeepsTheSignOfWhatVanishes) {
    EXPECT_TRUE(same_bits(round_to_double(to_rational(least) / 2), 0.0));
    EXPECT_TRUE(same_bits(round_to_double(to_rational(-least) / 2), -0.0));
    EXPECT_EQ(round_to_double(to_rational(least) / 2 + shifted(1, -3000)), least);
    EXPECT_EQ(round_to_double(to_rational(least) * 3 / 2), 2 * least);
    EXPECT_TRUE(same_bits(round_to_double(shifted(-1, -100'000)), -0.0));
    // 53 bits would round this up to a half, which would then go to the even 2: the number itself
    // is less than half way from 1 to 2.
    const Rational below_half = to_rational(least) * (Rational(3) / 2 - shifted(1, -60));
    EXPECT_EQ(round_to_double(below_half), least);
}

}  // namespace
