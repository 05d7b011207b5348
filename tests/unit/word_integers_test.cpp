/// Integers of a few words against GMP's, and the signs that a judge of space takes from them
/// against rationals.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <random>

#include "../../exact/multiprecision.hpp"
#include "../../triangulation/any_dimension/determinant.hpp"
#include "../../triangulation/any_dimension/sites.hpp"
#include "../../triangulation/any_dimension/word_integers.hpp"

namespace signum::any_dimension {
namespace {

using exact::Integer;
using exact::Rational;

template <std::size_t n>
Words<n> any_words(std::mt19937_64& g) {
    Words<n> result;
    // Words of all bits and of none make carries.
    for (std::uint64_t& word : result.word) word = g() % 3 == 0 ? std::uint64_t{0} - g() % 2 : g();
    return result;
}
template <std::size_t n>
Integer value_of(const Words<n>& a) {
    Integer result = a.is_negative() ? -1 : 0;
    for (std::size_t k = n; k-- > 0;) result = result * (Integer(1) << 64) + Integer(a.word[k]);
    return result;
}

template <std::size_t n, std::size_t m>
void expect_products(std::mt19937_64& g) {
    const Words<n> a = any_words<n>(g);
    const Words<m> b = any_words<m>(g);
    EXPECT_EQ(value_of(a * b), value_of(a) * value_of(b));
    EXPECT_EQ(a.sign(), value_of(a).sign());
}

TEST(WordIntegers, AreIntegers) {
    std::mt19937_64 g(1);
    for (int trial = 0; trial < 20000; ++trial) {
        expect_products<1, 1>(g);
        expect_products<2, 1>(g);
        expect_products<3, 2>(g);
        expect_products<6, 4>(g);
        // Half as large, so that sums fit.
        Words<5> a = any_words<5>(g), b = any_words<5>(g);
        for (Words<5>* each : {&a, &b}) {
            const auto top = static_cast<std::int64_t>(each->word[4]);
            each->word[4] = static_cast<std::uint64_t>(top / 4);
        }
        EXPECT_EQ(value_of(a + b), value_of(a) + value_of(b));
        EXPECT_EQ(value_of(a - b), value_of(a) - value_of(b));
    }
}

TEST(WordIntegers, AreTheNumbersInUnits) {
    std::mt19937_64 g(2);
    for (int trial = 0; trial < 20000; ++trial) {
        const double number =
            std::ldexp(static_cast<double>(static_cast<std::int64_t>(g() >> (g() % 64))),
                       static_cast<int>(g() % 30) - 40);
        Bits bits;
        bits.take(number);
        if (bits.is_none()) continue;
        const int unit = bits.lowest - static_cast<int>(g() % 60);
        ASSERT_EQ(Rational(value_of(words_of<2>(number, unit))),
                  Rational(std::ldexp(number, -unit)));
        ASSERT_LT(std::fabs(number), std::ldexp(1.0, bits.highest));
    }
    EXPECT_EQ(words_of<1>(0x1p-1074, -1074).word[0], 1U);
    EXPECT_EQ(words_of<1>(-0.0, -1074).sign(), 0);
}

template <class S>
S site(std::mt19937_64& g, int bits, int lowest) {
    const auto number = [&] {
        const auto most = std::int64_t{1} << bits;
        const auto whole = static_cast<std::int64_t>(g() % static_cast<std::uint64_t>(2 * most));
        // Sometimes the largest, so that each count is reached.
        const double value = g() % 4 == 0 ? static_cast<double>(most - 1) * (g() % 2 ? 1 : -1)
                                          : static_cast<double>(whole - most);
        return std::ldexp(value, lowest + static_cast<int>(g() % 2) * (bits < 8 ? 0 : 8));
    };
    S s{};
    s.x = number();
    s.y = number();
    s.z = number();
    if constexpr (requires { s.w; }) s.w = number() * number();
    if constexpr (requires { s.r; }) s.r = number();
    return s;
}
/// The signs by rationals.
template <class S>
Sign in_sphere_by_rationals(const std::array<S, 4>& v, const S& q) {
    Matrix<Rational, 4> rows;
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t k = 0; k < 3; ++k) rows[i][k] = offset<Rational>(v[i], q, k);
        rows[i][3] = height<Rational>(v[i], q);
    }
    return determinant(rows, 4).sign();
}
template <class S>
Sign orientation_by_rationals(const std::array<S, 4>& v) {
    Matrix<Rational, 3> rows;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 3; ++k) rows[i][k] = offset<Rational>(v[i + 1], v[0], k);
    return determinant(rows, 3).sign();
}

template <class S>
void expect_signs(std::uint64_t seed) {
    std::mt19937_64 g(seed);
    std::array<int, 3> of_sign{};
    int none = 0;
    for (int trial = 0; trial < 4000; ++trial) {
        const int bits = static_cast<int>(1 + g() % 50);
        const int lowest = static_cast<int>(g() % 40) - 30;
        std::array<S, 4> v;
        for (S& s : v) s = site<S>(g, bits, lowest);
        S q = site<S>(g, bits, lowest);
        // From far apart to farther than fits.
        if (g() % 4 == 0) q.x = std::ldexp(q.x, -static_cast<int>(g() % 200));
        if (g() % 4 == 0) q = v[g() % 4];
        const std::optional<Sign> sign = in_sphere_in_words(v, q);
        none += !sign.has_value();
        if (sign) {
            ASSERT_EQ(*sign, in_sphere_by_rationals(v, q)) << trial;
            ++of_sign[static_cast<std::size_t>(*sign + 1)];
        }
        if (const std::optional<Sign> turn = orientation_in_words(v[0], v[1], v[2], v[3])) {
            ASSERT_EQ(*turn, orientation_by_rationals(v)) << trial;
        }
    }
    EXPECT_GT(*std::ranges::min_element(of_sign), 100);
    EXPECT_GT(none, 10);
}
TEST(WordIntegers, DecideAsRationalsOfPoints) {
    expect_signs<Point3>(3);
}
TEST(WordIntegers, DecideAsRationalsOfRadii) {
    expect_signs<Site3>(4);
}
TEST(WordIntegers, DecideAsRationalsOfWeights) {
    expect_signs<power::Site3>(5);
}

/// Numbers of all the bits that fit, of signs that make every sum as large as it can be.
TEST(WordIntegers, HoldTheLargest) {
    std::mt19937_64 g(6);
    for (const int bits : {61, 125}) {
        for (int trial = 0; trial < 4000; ++trial) {
            const auto number = [&] {
                const double largest = std::ldexp(1.0 - 0x1p-53, bits);
                const double value = g() % 8 == 0 ? 1.0 : largest;
                return g() % 2 == 0 ? value : -value;
            };
            std::array<Site3, 4> v;
            for (Site3& s : v) s = {number(), number(), number(), number()};
            const Site3 q{number(), number(), number(), number()};
            const std::optional<Sign> sign = in_sphere_in_words(v, q);
            ASSERT_TRUE(sign.has_value());
            ASSERT_EQ(*sign, in_sphere_by_rationals(v, q)) << trial;
        }
    }
}

}  // namespace
}  // namespace signum::any_dimension
