/// What cut dyadic numbers are certain of is true of rationals.

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <random>
#include <utility>

#include "../../exact/cut_dyadic.hpp"

namespace signum::exact {
namespace {

class CutDyadicNumbers : public testing::Test {
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
    template <class Cut>
    std::pair<Cut, Rational> make(int depth) {
        if (depth == 0) {
            const double value = number();
            return {Cut(value), to_rational(value)};
        }
        const auto [a, b] = make<Cut>(depth - 1);
        // What is nearly the same is what a sum must tell apart.
        const auto [c, d] = below(4) == 0 ? std::pair{a, b} : make<Cut>(depth - 1);
        switch (below(3)) {
            case 0:
                return {a + c, Rational(b + d)};
            case 1:
                return {a - c, Rational(b - d)};
            default:
                return {a * c, Rational(b * d)};
        }
    }
};

TEST_F(CutDyadicNumbers, AreRightWhereCertain) {
    int certain = 0;
    int uncertain = 0;
    const auto compare = [&]<class Cut>(Cut /*type*/) {
        for (int round = 0; round < 4000; ++round) {
            const auto [cut, exact] = make<Cut>(round % 5);
            ++(cut.is_certain() ? certain : uncertain);
            ASSERT_TRUE(!cut.is_certain() || cut.sign() == sign(exact));
        }
    };
    compare(CutDyadic<8>());
    compare(CutDyadic<64>());
    compare(CutDyadic<400>());
    EXPECT_GT(uncertain, 100);
    EXPECT_GT(certain, 10 * uncertain);
}

TEST_F(CutDyadicNumbers, TellWhatTheyStillKnow) {
    using Cut = CutDyadic<64>;
    // 2^200 + 1 - 2^200: the 1 is gone, and the number knows it.
    EXPECT_FALSE((Cut(0x1p200) + Cut(1) - Cut(0x1p200)).is_certain());
    EXPECT_TRUE((Cut(0x1p200) + Cut(1)).is_certain());
    // Nothing was cut off: a 0 is one.
    const Cut zero = Cut(0x1p40) + Cut(1) - Cut(0x1p40) - Cut(1);
    EXPECT_TRUE(zero.is_certain());
    EXPECT_EQ(zero.sign(), 0);
    EXPECT_EQ((CutDyadic<256>(0x1p200) + CutDyadic<256>(1) - CutDyadic<256>(0x1p200)).sign(), 1);
}

}  // namespace
}  // namespace signum::exact
