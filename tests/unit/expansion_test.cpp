// Expansions against GMP integers: exact, nonadjacent, and right under a hostile caller.

#include "../../exact/expansion.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "../../exact/floating_environment.hpp"
#include "../thoroughness.hpp"

#include "exact_reference.hpp"

namespace {

using signum::exact::difference;
using signum::exact::Expansion;
using signum::exact::in_ieee_environment;
using signum::exact::product;
using signum::exact::square;
using signum::reference::Hostile;
using signum::reference::in_environment;
using signum::reference::Random;
using signum::reference::scaled;

/// In the window a number of degree d is an integer at the scale d·unit.
constexpr int unit = 252;

const int share = signum::is_fast ? 1 : 10;  // of the trials one in so many

int lowest_bit(double value) {
    int exponent = 0;
    const auto integer =
        static_cast<std::uint64_t>(std::ldexp(std::frexp(std::fabs(value), &exponent), 53));
    return exponent - 53 + std::countr_zero(integer);
}

/// Laws 2 and 3.
bool is_well_formed(std::span<const double> terms) {
    for (std::size_t i = 0; i < terms.size(); ++i) {
        if (terms[i] == 0.0 || !std::isnormal(terms[i])) return false;
        if (i > 0 && lowest_bit(terms[i]) < std::ilogb(terms[i - 1]) + 2) return false;
    }
    return true;
}

mpz_class value_of(std::span<const double> terms, int scale) {
    static mpz_class integer;  // keeps its memory
    mpz_class sum = 0;
    for (const double term : terms) {
        signum::reference::set_scaled(integer, term, scale);
        sum += integer;
    }
    return sum;
}

/// Whether the expansion of degree d is that integer, with all that it promises.
template <int Capacity>
testing::AssertionResult equals(const Expansion<Capacity>& e, const mpz_class& expected,
                                int degree) {
    const int scale = degree * unit;
    const char* fault = nullptr;
    if (e.size() > Capacity) fault = "too many terms";
    if (!is_well_formed(e.terms())) fault = "adjacent terms";
    if (value_of(e.terms(), scale) != expected) fault = "not exact";
    if (e.sign() != sgn(expected)) fault = "wrong sign";
    // |approximation - expected| < 2^-50 |expected|
    const mpz_class error = abs(scaled(e.approximate(), scale) - expected) << 50;
    if (error >= abs(expected) && expected != 0) fault = "poor approximation";
    if (error != 0 && expected == 0) fault = "poor approximation";
    if (fault == nullptr) return testing::AssertionSuccess();
    testing::AssertionResult failure = testing::AssertionFailure() << fault << ":" << std::hexfloat;
    for (const double term : e.terms()) failure << " " << term;
    return failure;
}

struct Operands {
    std::array<double, 8> c;  // coordinates
    std::array<double, 3> w;  // weights
};

/// Coordinates of the window, chosen to cancel, to be short, or to span it.
Operands random_operands(Random& random) {
    Operands o{};
    const double base = random.in_binades(-2, 2);
    const int kind = random.below(8);
    for (double& c : o.c) {
        switch (kind) {
            case 0:
                c = random.between(-3, 3);
                break;
            case 1:
                c = random.between(-40'000, 40'000);
                break;
            case 2:
                c = base + std::ldexp(random.between(-3, 3), -52);
                break;
            case 3:
                c = std::ldexp(random.coin() ? 1.0 : -1.0, random.between(-200, 200));
                break;
            case 4:
                c = random.in_binades(-200, 199);
                break;
            case 5:
                c = random.coin() ? 0x1p200 : random.in_binades(-200, -199);
                break;
            case 6:
                c = random.in_binades(-1, 1);
                break;
            default:
                c = random.coin() ? base : random.in_binades(-30, 0);
                break;
        }
        if (random.below(16) == 0) c = 0.0;
        if (random.below(16) == 0) c = o.c[static_cast<std::size_t>(random.below(8))];
        if (random.below(32) == 0) c = -o.c[static_cast<std::size_t>(random.below(8))];
    }
    for (double& w : o.w) {
        w = random.coin() ? random.in_binades(-3, 3) : random.in_binades(-400, 399);
        if (kind <= 1) w = random.between(-100, 100);
        if (random.below(16) == 0) w = 0.0;
    }
    return o;
}

/// The sums, products and the determinant of degree 4 that predicates are made of.
struct Results {
    Expansion<2> difference_01;
    Expansion<2> product_01;
    Expansion<4> sum;        // (c0 - c1) + (c2 - c3)
    Expansion<4> opposite;   // (c0 - c1) - (c2 - c3)
    Expansion<4> scaled;     // (c0 - c1) c4
    Expansion<8> squared;    // (c0 - c1)^2
    Expansion<8> times;      // (c0 - c1)(c2 - c3)
    Expansion<16> minor;     // (c0 - c1)(c2 - c3) - (c4 - c5)(c6 - c7)
    Expansion<1536> circle;  // in_circle of c0 c1, c2 c3, c4 c5 about c6 c7, with weights
};

[[gnu::noinline]] Results compute(const Operands& o) {
    const auto& c = o.c;
    const auto a = difference(c[0], c[1]);
    const auto b = difference(c[2], c[3]);
    Results r;
    r.difference_01 = a;
    r.product_01 = product(c[0], c[1]);
    r.sum = a + b;
    r.opposite = a - b;
    r.scaled = a * c[4];
    r.squared = square(a);
    r.times = a * b;
    r.minor = a * b - difference(c[4], c[5]) * difference(c[6], c[7]);

    const auto x0 = difference(c[0], c[6]);
    const auto y0 = difference(c[1], c[7]);
    const auto x1 = difference(c[2], c[6]);
    const auto y1 = difference(c[3], c[7]);
    const auto x2 = difference(c[4], c[6]);
    const auto y2 = difference(c[5], c[7]);
    const auto row = [](const auto& x, const auto& y, double w, const auto& minor) {
        return (square(x) + square(y) - Expansion<1>(w)) * minor;
    };
    Expansion<16> minors[] = {x1 * y2 - x2 * y1, x2 * y0 - x0 * y2, x0 * y1 - x1 * y0};
    const auto first = row(x0, y0, o.w[0], minors[0]);
    const auto second = row(x1, y1, o.w[1], minors[1]);
    const auto third = row(x2, y2, o.w[2], minors[2]);
    // At most 17 · 16 · 2 terms each, were they not so much shorter.
    Expansion<2000> circle;
    circle.assign_sum((first + second).terms(), third.terms());
    r.circle.assign_sum(circle.terms(), {});
    return r;
}

void expect_exact(const Results& r, const Operands& o, int mode) {
    std::array<mpz_class, 8> c;
    for (std::size_t i = 0; i < c.size(); ++i) c[i] = scaled(o.c[i], unit);
    std::array<mpz_class, 3> w;
    for (std::size_t i = 0; i < w.size(); ++i) w[i] = scaled(o.w[i], 2 * unit);

    const mpz_class a = c[0] - c[1];
    const mpz_class b = c[2] - c[3];
    const mpz_class x0 = c[0] - c[6], y0 = c[1] - c[7];
    const mpz_class x1 = c[2] - c[6], y1 = c[3] - c[7];
    const mpz_class x2 = c[4] - c[6], y2 = c[5] - c[7];
    const mpz_class circle = (x0 * x0 + y0 * y0 - w[0]) * (x1 * y2 - x2 * y1) +
                             (x1 * x1 + y1 * y1 - w[1]) * (x2 * y0 - x0 * y2) +
                             (x2 * x2 + y2 * y2 - w[2]) * (x0 * y1 - x1 * y0);
    const std::string where =
        testing::PrintToString(o.c) + " in environment " + std::to_string(mode);
    ASSERT_TRUE(equals(r.difference_01, a, 1)) << where;
    ASSERT_TRUE(equals(r.product_01, c[0] * c[1], 2)) << where;
    ASSERT_TRUE(equals(r.sum, a + b, 1)) << where;
    ASSERT_TRUE(equals(r.opposite, a - b, 1)) << where;
    ASSERT_TRUE(equals(r.scaled, a * c[4], 2)) << where;
    ASSERT_TRUE(equals(r.squared, a * a, 2)) << where;
    ASSERT_TRUE(equals(r.times, a * b, 2)) << where;
    ASSERT_TRUE(equals(r.minor, a * b - (c[4] - c[5]) * (c[6] - c[7]), 2)) << where;
    ASSERT_TRUE(equals(r.circle, circle, 4)) << where;
}

TEST(Expansion, IsExactUpToDegree4InTheWholeWindowFromEveryEnvironment) {
    Random random(1);
    for (int trial = 0; trial < 100'000 / share; ++trial) {
        const Operands operands = random_operands(random);
        for (const double c : operands.c) ASSERT_TRUE(signum::exact::in_expansion_window(c));
        for (const double w : operands.w) ASSERT_TRUE(signum::exact::weight_in_expansion_window(w));
        const int mode = trial % Hostile::modes;
        const Results results =
            in_environment(mode, [&] { return in_ieee_environment(compute, operands); });
        ASSERT_NO_FATAL_FAILURE(expect_exact(results, operands, mode));
    }
}

TEST(Expansion, OfNeighbouringProductsHasTheSignOfTheLastBit) {
    // a·d - b·c where the products differ by a place or so: every rounding decides wrongly.
    Random random(2);
    for (int trial = 0; trial < 200'000 / share; ++trial) {
        const double a = random.in_binades(-2, 2);
        const double b = random.in_binades(-2, 2);
        const double k = std::ldexp(1.0, random.between(-5, 5));
        const double c = random.coin() ? a * k : std::nextafter(a * k, random.coin() ? 0.0 : 99.0);
        const double d = random.coin() ? b * k : std::nextafter(b * k, random.coin() ? 0.0 : 99.0);
        const Expansion<4> determinant = product(a, d) - product(b, c);
        const mpz_class expected =
            scaled(a, unit) * scaled(d, unit) - scaled(b, unit) * scaled(c, unit);
        ASSERT_TRUE(equals(determinant, expected, 2)) << std::hexfloat << a << " " << b;
    }
}

/// Nonadjacent terms, built from the lowest up: some single bits, some long runs, narrow gaps.
std::vector<double> random_terms(Random& random, int count) {
    std::vector<double> terms;
    int low = random.between(-150, -100);
    for (int i = 0; i < count; ++i) {
        const int width = random.coin() ? 1 : random.between(1, 53);
        const auto full = (std::uint64_t{1} << width) - 1;
        const std::uint64_t bits = random.coin() ? full : (random.engine()() & full) | 1;
        const double magnitude = std::ldexp(static_cast<double>(bits), low);
        terms.push_back(random.coin() ? magnitude : -magnitude);
        low = std::ilogb(magnitude) + 2 + (random.coin() ? 0 : random.below(60));
        if (low > 140) break;
    }
    return terms;
}

template <int Capacity>
Expansion<Capacity> expansion_of(const std::vector<double>& terms) {
    Expansion<Capacity> e;
    e.assign_sum(terms, {});
    return e;
}

TEST(Expansion, SumOfAnyNonadjacentTermsIsExactAndNonadjacent) {
    Random random(3);
    for (int trial = 0; trial < 150'000 / share; ++trial) {
        auto e_terms = random_terms(random, random.between(0, 8));
        auto f_terms = random_terms(random, random.between(0, 8));
        if (random.below(4) == 0) {
            // All but cancels.
            f_terms = e_terms;
            for (double& term : f_terms) term = -term;
            if (!f_terms.empty()) f_terms.back() *= random.coin() ? 2.0 : 1.0;
        }
        const auto e = expansion_of<8>(e_terms);
        const auto f = expansion_of<8>(f_terms);
        const mpz_class sum = value_of(e_terms, unit) + value_of(f_terms, unit);
        ASSERT_TRUE(equals(e + f, sum, 1))
            << testing::PrintToString(e_terms) << " + " << testing::PrintToString(f_terms);
        ASSERT_TRUE(equals(-(f + e), -sum, 1));
        ASSERT_TRUE(equals(e - e, 0, 1));
    }
}

TEST(Expansion, ProductOfAnyNonadjacentTermsIsExactAndNonadjacent) {
    Random random(4);
    for (int trial = 0; trial < 100'000 / share; ++trial) {
        const auto e_terms = random_terms(random, random.between(0, 6));
        const auto f_terms = random_terms(random, random.between(0, 3));
        const auto e = expansion_of<6>(e_terms);
        const auto f = expansion_of<3>(f_terms);
        const double b = random.in_binades(-40, 40);
        const mpz_class e_value = value_of(e_terms, unit);
        ASSERT_TRUE(equals(e * b, e_value * scaled(b, unit), 2))
            << testing::PrintToString(e_terms) << " · " << std::hexfloat << b;
        ASSERT_TRUE(equals(b * e, e_value * scaled(b, unit), 2));
        ASSERT_TRUE(equals(e * f, e_value * value_of(f_terms, unit), 2));
        ASSERT_TRUE(equals(f * e, e_value * value_of(f_terms, unit), 2));
        ASSERT_TRUE(equals(square(e), e_value * e_value, 2));
    }
}

TEST(Expansion, SumKeepsTermsNonadjacentWhereOnePassDoesNot) {
    // One pass leaves -2^-99 below 0x1.1f01p-82, whose last bit is 2^-98.
    const std::vector<double> e{0x1p-100, -0x1.fffffffffffffp-46};
    const std::vector<double> f{0x1p-100, 0x1.fep-91, 0x1.0ed7a4c3d1ep-46};
    Expansion<5> sum;
    sum.assign_sum(e, f);
    EXPECT_TRUE(equals(sum, value_of(e, unit) + value_of(f, unit), 1));
}

TEST(Expansion, OfIntegersHasOneTermWhereDoublesAreExact) {
    Random random(5);
    for (int trial = 0; trial < 50'000 / share; ++trial) {
        const auto integer = [&] { return static_cast<double>(random.between(-2048, 2048)); };
        const auto x = difference(integer(), integer());
        const auto y = difference(integer(), integer());
        ASSERT_LE(((square(x) + square(y)) * (x * y - y * y)).size(), 1);
        ASSERT_EQ((x * y - y * x).size(), 0);
        ASSERT_EQ((x * y - y * x).sign(), 0);
        ASSERT_EQ((x * y - y * x).approximate(), 0.0);
    }
}

TEST(ExpansionWindow, HoldsZeroAndMagnitudesFrom2ToMinus200To2To200InEveryEnvironment) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double inside[] = {0.0, 1.0, 0x1p-200, 0x1.8p-200, 0x1p200, 0x1.fffffffffffffp199};
    const double outside[] = {0x1.fffffffffffffp-201,
                              0x1.0000000000001p200,
                              std::numeric_limits<double>::denorm_min(),
                              std::numeric_limits<double>::max(),
                              infinity,
                              std::numeric_limits<double>::quiet_NaN()};
    for (int mode = 0; mode < Hostile::modes; ++mode) {
        const auto in_window = [mode](double value) {
            return in_environment(mode,
                                  [value] { return signum::exact::in_expansion_window(value); });
        };
        for (const double value : inside) {
            EXPECT_TRUE(in_window(value)) << std::hexfloat << value;
            EXPECT_TRUE(in_window(-value)) << std::hexfloat << value;
        }
        for (const double value : outside) {
            EXPECT_FALSE(in_window(value)) << std::hexfloat << value;
            EXPECT_FALSE(in_window(-value)) << std::hexfloat << value;
        }
    }
}

TEST(ExpansionWindow, HoldsWeightsFrom2ToMinus400To2To400) {
    for (const double weight : {0.0, -0.0, 1.0, 0x1p-400, -0x1p400})
        EXPECT_TRUE(signum::exact::weight_in_expansion_window(weight));
    for (const double weight : {0x1.fffffffffffffp-401, 0x1.0000000000001p400, 0x1p-1074})
        EXPECT_FALSE(signum::exact::weight_in_expansion_window(weight));
}

TEST(IeeeEnvironment, HoldsWhileTheGuardLivesAndGivesBackTheCallersOwn) {
    const auto default_inside = [] {
        const signum::exact::IeeeEnvironment environment;
        volatile double one = 1.0;
        volatile double tiny = 0x1p-60;
        volatile double smallest_normal = 0x1p-1022;
        // Rounds to nearest on either side, and a denormal is not 0.
        return one + tiny == 1.0 && one - tiny == 1.0 && smallest_normal / 4.0 != 0.0;
    };
    for (int mode = 0; mode < Hostile::modes; ++mode)
        EXPECT_TRUE(in_environment(mode, default_inside)) << "environment " << mode;
}

}  // namespace
