/// Integers of 256 bits against Boost's, and in_sphere by them.

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <utility>

#include <gtest/gtest.h>
#include <boost/multiprecision/cpp_int.hpp>

#include "../../exact/integer_rows.hpp"
#include "../../predicates/space.hpp"
#include "../../predicates/space/in_sphere.hpp"

namespace signum {
namespace {

using exact::Integer128;
using exact::Integer256;
using Wide = boost::multiprecision::int1024_t;

/// Any number of bits, often at a border.
Integer128 any(std::mt19937_64& random, int most_bits) {
    const int bits = static_cast<int>(random() % static_cast<unsigned>(most_bits + 1));
    auto value = static_cast<unsigned __int128>(random()) << 64 | random();
    if (random() % 4 == 0) value = ~static_cast<unsigned __int128>(0) << (random() % 128);
    value &= (static_cast<unsigned __int128>(1) << bits) - 1;
    const auto result = static_cast<Integer128>(value);
    return random() % 2 == 0 ? result : -result;
}
Wide wide(Integer128 value) {
    return Wide(value);
}

TEST(Integer256, IsAsBoostsAre) {
    std::mt19937_64 random(1);
    for (int trial = 0; trial < 500'000; ++trial) {
        const Integer128 a = any(random, 98), b = any(random, 96), c = any(random, 99),
                         d = any(random, 48), e = any(random, 120), f = any(random, 120);
        const Integer256 value =
            Integer256(c) * (Integer256(a) * Integer256(d) - Integer256(b) * Integer256(d)) +
            Integer256(e) * Integer256(f) - Integer256(e, f);
        const Wide expected = wide(c) * (wide(a) * wide(d) - wide(b) * wide(d));
        ASSERT_EQ(value.sign(), expected.sign()) << trial;
        const Integer256 nearly = Integer256(a) * Integer256(c) * Integer256(d) -
                                  Integer256(d) * (Integer256(a) * Integer256(c) - Integer256(1));
        ASSERT_EQ(nearly.sign(), Sign((d > 0) - (d < 0))) << trial;
    }
}

/// Sites on a sphere around the origin by exchange of coordinates and signs, of 30 to 60 bits, and
/// an ulp beside it, relative to one of them: beyond double-doubles, by integers of any width.
template <class S>
void expect_exact_signs() {
    std::mt19937_64 random(2);
    int zeros = 0;
    int others = 0;
    for (int trial = 0; trial < 60'000; ++trial) {
        const int bits = 20 + trial % 33;
        const std::int64_t most = std::int64_t{1} << bits;
        std::array<double, 3> c{};
        for (double& each : c)
            each = static_cast<double>(static_cast<std::int64_t>(random()) % most);
        std::array<S, 5> s{};
        for (S& site : s) {
            std::array<double, 3> at = c;
            std::shuffle(at.begin(), at.end(), random);
            for (double& each : at)
                if (random() % 2 == 0) each = -each;
            site.x = at[0], site.y = at[1], site.z = at[2];
            if constexpr (requires { site.w; }) site.w = 3.0;
            if constexpr (requires { site.r; }) site.r = 1.0;
        }
        if (trial % 3 == 0) s[4].x += 1.0;
        if (trial % 3 == 1) s[4].z -= static_cast<double>(random() % 3);
        const Sign turn = ccw(centre3(s[0]), centre3(s[1]), centre3(s[2]), centre3(s[3]));
        if (turn == 0) continue;
        if (turn < 0) std::swap(s[0], s[1]);
        const auto answer = power::in_sphere_decision(s[0], s[1], s[2], s[3], s[4]);
        const Decision expected = predicates::decide<Arithmetic::multiprecision, power::InSphere>(
            s[0], s[1], s[2], s[3], s[4]);
        ASSERT_EQ(answer.sign, expected.sign) << trial;
        ++(answer.sign == 0 ? zeros : others);
    }
    EXPECT_GT(zeros, 10'000);
    EXPECT_GT(others, 10'000);
}

TEST(InSphereInIntegers, ExactSignsOfPoints) {
    expect_exact_signs<Point3>();
}
TEST(InSphereInIntegers, ExactSignsOfBalls) {
    expect_exact_signs<Site3>();
}
TEST(InSphereInIntegers, ExactSignsOfWeights) {
    expect_exact_signs<power::Site3>();
}

}  // namespace
}  // namespace signum
