// Error-free transforms against GMP integers.

#include "../../core/error_free.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "exact_reference.hpp"

namespace {

using signum::TwoTerms;
using signum::reference::finest;
using signum::reference::Random;
using signum::reference::scaled;

constexpr double largest = std::numeric_limits<double>::max();

/// Law 1 for a sum or difference, law 2.
bool is_exact_sum(TwoTerms result, double a, double b) {
    const bool exact = scaled(result.high, finest) + scaled(result.low, finest) ==
                       scaled(a, finest) + scaled(b, finest);
    return exact && result.high == a + b && result.high + result.low == result.high;
}

/// Pairs whose sum does not overflow, many of them a rounding or a cancellation away from trouble.
template <class Check>
void for_each_pair(std::uint64_t seed, int count, Check check) {
    Random random(seed);
    for (int trial = 0; trial < count; ++trial) {
        const double a = random.finite();
        const int exponent = a == 0.0 ? 0 : std::ilogb(a);
        double b = random.finite();
        switch (random.below(6)) {
            case 0:
                b = -a;
                break;
            case 1:
                b = -std::nextafter(a, random.coin() ? largest : -largest);
                break;
            case 2:
                b = std::ldexp(random.significand(), exponent - random.between(50, 56));
                break;
            case 3:
                b = -2.0 * a;
                break;
            default:
                break;
        }
        if (!std::isfinite(a + b) || !std::isfinite(a - b)) continue;
        if (std::fabs(a) == largest || std::fabs(b) == largest) continue;
        if (!check(a, b)) {
            ADD_FAILURE() << std::hexfloat << a << " and " << b;
            return;
        }
    }
}

TEST(TwoSum, IsExactForFiniteNumbersWhoseSumDoesNotOverflow) {
    for_each_pair(1, 500'000,
                  [](double a, double b) { return is_exact_sum(signum::two_sum(a, b), a, b); });
}

TEST(TwoDifference, IsExactForFiniteNumbersWhoseDifferenceDoesNotOverflow) {
    for_each_pair(2, 300'000, [](double a, double b) {
        return is_exact_sum(signum::two_difference(a, b), a, -b);
    });
}

TEST(QuickTwoSum, IsExactWhenTheFirstTermIsTheLargerOrZero) {
    for_each_pair(3, 300'000, [](double a, double b) {
        if (std::fabs(a) < std::fabs(b)) std::swap(a, b);
        return is_exact_sum(signum::quick_two_sum(a, b), a, b) &&
               is_exact_sum(signum::quick_two_sum(0.0, b), 0.0, b);
    });
}

TEST(TwoProduct, IsExactFrom2ToMinus968ToOverflow) {
    Random random(4);
    int checked = 0;
    while (checked < 400'000) {
        double a = random.coin() ? random.in_binades(-1022, 1022) : random.in_binades(-30, 30);
        double b = random.coin() ? random.in_binades(-1022, 1022) : random.in_binades(-30, 30);
        if (random.below(8) == 0) b = std::ldexp(random.significand(), -968 - std::ilogb(a));
        if (random.below(50) == 0) a = 0.0;
        const double rounded = a * b;
        if (!std::isfinite(rounded) || (rounded != 0.0 && std::fabs(rounded) < 0x1p-968)) continue;
        if (rounded == 0.0 && a != 0.0) continue;
        ++checked;
        const TwoTerms product = signum::two_product(a, b);
        const mpz_class exact = scaled(a, finest) * scaled(b, finest);
        ASSERT_TRUE(scaled(product.high, 2 * finest) + scaled(product.low, 2 * finest) == exact)
            << std::hexfloat << a << " · " << b;
        ASSERT_EQ(product.high, rounded);
        ASSERT_EQ(product.high + product.low, product.high);
    }
}

}  // namespace
