// Dyadic numbers against rationals: exact ones agree with them, and what cut ones are certain of is
// true.

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <random>
#include <type_traits>
#include <utility>

#include "../../exact/dyadic.hpp"

namespace signum::exact {
namespace {

class DyadicNumbers : public testing::Test {
 protected:
    std::mt19937_64 random_{7};
    int below(int count) { return static_cast<int>(random_() % static_cast<std::uint64_t>(count)); }
    /// Any finite double, or one of few bits, so that sums cancel.
    double number() {
        if (below(2) == 0) return std::ldexp(1.0 * below(16) - 8, 300 * below(3));
        for (;;) {
            const auto value = std::bit_cast<double>(random_());
            if (std::isfinite(value)) return value;
        }
    }
    /// A number made of the same doubles by the same operations in both types.
    template <class A, class B>
    std::pair<A, B> make(int depth) {
        if (depth == 0) {
            const double value = number();
            if constexpr (std::is_same_v<B, Rational>)
                return {A(value), to_rational(value)};
            else
                return {A(value), B(value)};
        }
        const auto [a, b] = make<A, B>(depth - 1);
        // What is nearly the same is what a sum must tell apart.
        const auto [c, d] = below(4) == 0 ? std::pair{a, b} : make<A, B>(depth - 1);
        switch (below(3)) {
            case 0:
                return {a + c, b + d};
            case 1:
                return {a - c, b - d};
            default:
                return {a * c, b * d};
        }
    }
};

TEST_F(DyadicNumbers, AreExact) {
    for (int round = 0; round < 2000; ++round) {
        const auto [number, rational] = make<Dyadic<>, Rational>(round % 5);
        EXPECT_TRUE(number.is_certain());
        ASSERT_EQ(number.sign(), sign(rational));
        ASSERT_EQ(number == 0, rational == 0);
    }
}

TEST_F(DyadicNumbers, CutAreRightWhereCertain) {
    int certain = 0;
    int uncertain = 0;
    const auto compare = [&]<class Cut>(Cut) {
        for (int round = 0; round < 4000; ++round) {
            const auto [cut, exact] = make<Cut, Dyadic<>>(round % 5);
            ++(cut.is_certain() ? certain : uncertain);
            ASSERT_TRUE(!cut.is_certain() || cut.sign() == exact.sign());
        }
    };
    compare(Dyadic<8>());
    compare(Dyadic<64>());
    compare(Dyadic<400>());
    EXPECT_GT(uncertain, 100);
    EXPECT_GT(certain, 10 * uncertain);
}

TEST_F(DyadicNumbers, CutTellWhatTheyStillKnow) {
    using Cut = Dyadic<64>;
    // 2^200 + 1 - 2^200: the 1 is gone, and the number knows it.
    EXPECT_FALSE((Cut(0x1p200) + Cut(1) - Cut(0x1p200)).is_certain());
    EXPECT_TRUE((Cut(0x1p200) + Cut(1)).is_certain());
    // Nothing was cut off: a 0 is one.
    const Cut zero = Cut(0x1p40) + Cut(1) - Cut(0x1p40) - Cut(1);
    EXPECT_TRUE(zero.is_certain());
    EXPECT_EQ(zero.sign(), 0);
    EXPECT_EQ((Dyadic<256>(0x1p200) + Dyadic<256>(1) - Dyadic<256>(0x1p200)).sign(), 1);
}

}  // namespace
}  // namespace signum::exact
