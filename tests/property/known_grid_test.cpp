/// What a construction knows of sites on a grid: the unit of the grid, and that in_circle is then
/// decided by its filter, zeros too; and the filter of two circles at once.

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "../../predicates/power.hpp"
#include "../../predicates/power/in_circle.hpp"
#include "../../triangulation/construction/grid_unit.hpp"
#include "../../triangulation/kernels/power_kernel.hpp"

namespace signum {
namespace {

using triangulation::fourth_power_of_grid_unit;

TEST(GridUnit, IsTheGreatestPowerOfTwo) {
    const auto of = [](const std::vector<Site>& sites, bool weighted = true) {
        return fourth_power_of_grid_unit(sites, weighted);
    };
    EXPECT_EQ(of({{0, 0, 0}, {8, 4, 0}}), 256.0);
    EXPECT_EQ(of({{0, 0, 0}, {8, 4, 2}}), 16.0);
    EXPECT_EQ(of({{0, 0, 0}, {8, 4, 2}}, false), 256.0);
    EXPECT_EQ(of({{-0.75, 0, 0}, {8, 4, 0}}), 0x1p-8);
    EXPECT_EQ(of({{0x1p52 + 1, 0, 0}, {0x1p52, 4, 0}}), 1.0) << "far from the origin";
    EXPECT_EQ(of({{0x1p52 + 1, 0, 0}, {0, 4, 0}}), 0.0) << "far from one another";
    EXPECT_EQ(of({{0.1, 0.1, 0}, {0.2, 0.2, 0}}), 0.0);
    EXPECT_EQ(of({{0x1p-1074, 0, 0}, {0, 0, 0}}), 0.0);
    EXPECT_EQ(of({{0x1p250, 0, 0}, {0, 0, 0}}), 0x1p960) << "no greater one is of use";
    EXPECT_EQ(of({{0x1p1000, 0, 0}, {0, 0, 0}}), 0.0);
    EXPECT_EQ(of({{0x1p1023, 0, 0}, {-0x1p1023, 0, 0}}), 0x1p960);
    const std::vector<power::Site> weights = {{0, 0, 2}, {4, 4, 4}, {8, 4, 32}};
    EXPECT_EQ(fourth_power_of_grid_unit(weights, true), 1.0) << "weights are multiples of u²";
    const std::vector<power::Site> quarters = {{0, 0, 0.25}, {4, 4, 4}};
    EXPECT_EQ(fourth_power_of_grid_unit(quarters, true), 0x1p-4);
}

/// Points, radii and weights that are small integers, many on one circle, and a power of two.
template <class S>
S site_of(std::mt19937_64& random, std::int64_t size, double unit) {
    const auto number = [&] {
        return static_cast<double>(static_cast<std::int64_t>(random() % (2 * size + 1)) - size);
    };
    S site{};
    site.x = number() * unit;
    site.y = number() * unit;
    if constexpr (requires { site.r; }) site.r = number() * unit;
    if constexpr (requires { site.w; }) site.w = number() * number() * unit * unit;
    return site;
}

template <class S>
void expect_exact_signs() {
    std::mt19937_64 random(1);
    for (const double unit : {1.0, 0x1p-200, 0x1p200, 0x1p-3})
        for (int bits = 1; bits < 30; ++bits) {
            const triangulation::SignsOfKnown<S> signs{{}, 4 * unit * unit * unit * unit};
            int certain = 0;
            int zeros = 0;
            int asked = 0;
            for (int trial = 0; trial < 1500; ++trial) {
                const std::int64_t size = std::int64_t{1} << bits;
                S s[4];
                for (S& site : s) site = site_of<S>(random, size, unit);
                if (trial % 3 == 0) {
                    // On a circle, or nearly.
                    const double x = s[0].x;
                    const double y = s[0].y;
                    s[1].x = -y, s[1].y = x, s[2].x = -x, s[2].y = -y, s[3].x = y, s[3].y = -x;
                    for (int k = 1; k < 4; ++k) {
                        if constexpr (requires { s[0].r; }) s[k].r = s[0].r;
                        if constexpr (requires { s[0].w; }) s[k].w = s[0].w;
                    }
                    if (trial % 2 == 0) s[3].x += unit;
                }
                const Sign turn = ccw(s[0], s[1], s[2]);
                if (turn == 0) continue;
                if (turn < 0) std::swap(s[0], s[1]);
                ++asked;
                const Sign exact =
                    triangulation::PowerSigns<S, Arithmetic::multiprecision>::in_circle(s[0], s[1],
                                                                                        s[2], s[3])
                        .sign;
                const Decision known = signs.in_circle(s[0], s[1], s[2], s[3]);
                ASSERT_EQ(known.sign, exact) << bits << " bits, trial " << trial;
                const auto verdict =
                    power::in_circle_filter(s[0], s[1], s[2], s[3], signs.exact_below);
                if (verdict.is_certain()) {
                    ++certain;
                    zeros += exact == 0;
                    ASSERT_EQ(verdict.sign(), exact);
                }
            }
            if (bits <= 8) {
                EXPECT_EQ(certain, asked) << "the filter decides small integers";
                EXPECT_GT(zeros, asked / 10);
            }
        }
}

TEST(KnownGrid, ExactSignsOfPoints) {
    expect_exact_signs<Point>();
}
TEST(KnownGrid, ExactSignsOfDiscs) {
    expect_exact_signs<Site>();
}
TEST(KnownGrid, ExactSignsOfWeights) {
    expect_exact_signs<power::Site>();
}

/// x, y with a x + b y = 1 for coprime a and b; |x| <= |b|, |y| <= |a|.
std::array<std::int64_t, 2> bezout(std::int64_t a, std::int64_t b) {
    std::array<std::int64_t, 4> m = {1, 0, 0, 1};
    while (b != 0) {
        const std::int64_t quotient = a / b;
        m = {m[2], m[3], m[0] - quotient * m[2], m[1] - quotient * m[3]};
        a = std::exchange(b, a - quotient * b);
    }
    return {a * m[0], a * m[1]};
}

/// Determinants of -1, 0 and 1 from terms as large as the filter lets pass, and larger: weights are
/// chosen so that the terms cancel. An error of one unit in any of them shows.
TEST(KnownGrid, ExactSignsWhereLargeTermsCancel) {
    std::mt19937_64 random(3);
    int certain = 0;
    int uncertain = 0;
    for (int trial = 0; trial < 200'000; ++trial) {
        const std::int64_t size = std::int64_t{1} << (8 + trial % 10);
        std::array<std::array<std::int64_t, 2>, 3> at{};
        for (auto& each : at)
            for (std::int64_t& x : each)
                x = static_cast<std::int64_t>(random() % (2 * size + 1)) - size;
        const auto minor = [&](std::size_t m) {
            const auto& a = at[(m + 1) % 3];
            const auto& b = at[(m + 2) % 3];
            return a[0] * b[1] - a[1] * b[0];
        };
        const std::array<std::int64_t, 3> minors = {minor(0), minor(1), minor(2)};
        if (minors[0] + minors[1] + minors[2] <= 0) continue;  // not counterclockwise
        if (minors[1] == 0 || std::gcd(minors[0], minors[1]) != 1) continue;
        // heights[0] minors[0] + heights[1] minors[1] = wanted - heights[2] minors[2]
        const auto wanted = static_cast<std::int64_t>(random() % 3) - 1;
        std::array<std::int64_t, 3> heights{};
        heights[2] = at[2][0] * at[2][0] + at[2][1] * at[2][1];
        const __int128 right = wanted - static_cast<__int128>(heights[2]) * minors[2];
        const auto [x, y] = bezout(minors[0], minors[1]);
        heights[0] = static_cast<std::int64_t>(x * right % minors[1]);
        heights[1] = static_cast<std::int64_t>(
            (right - static_cast<__int128>(heights[0]) * minors[0]) / minors[1]);
        if (std::abs(heights[1]) > std::int64_t{1} << 50) continue;  // no double
        std::array<power::Site, 4> s{};
        for (std::size_t m = 0; m < 3; ++m) {
            const auto [px, py] = at[m];
            s[m] = {static_cast<double>(px), static_cast<double>(py),
                    static_cast<double>(px * px + py * py - heights[m])};
        }
        const auto verdict = power::in_circle_filter(s[0], s[1], s[2], s[3], 4.0);
        ++(verdict.is_certain() ? certain : uncertain);
        if (verdict.is_certain()) {
            ASSERT_EQ(verdict.sign(), wanted) << size;
        }
    }
    EXPECT_GT(certain, 10'000);
    EXPECT_GT(uncertain, 10'000);
}

/// Each of the two is answered as it is alone, in every lane; on random sites nearly all are.
template <class S>
void expect_two_at_once() {
    std::mt19937_64 random(2);
    int certain = 0;
    constexpr int trials = 20'000;
    for (int trial = 0; trial < trials; ++trial) {
        const double unit = std::ldexp(1.0, static_cast<int>(random() % 40) - 20);
        S s[7];
        for (S& site : s) site = site_of<S>(random, trial % 2 == 0 ? 1 << 20 : 4, unit);
        const auto answers =
            power::in_circles_filter(std::array<const S*, 3>{&s[0], &s[1], &s[2]},
                                     std::array<const S*, 3>{&s[3], &s[4], &s[5]}, s[6]);
        const auto first = power::in_circle_filter(s[0], s[1], s[2], s[6]);
        const auto second = power::in_circle_filter(s[3], s[4], s[5], s[6]);
        ASSERT_EQ(answers.has_value(), first.is_certain() && second.is_certain());
        if (!answers) continue;
        certain += trial % 2 == 0;
        ASSERT_EQ((*answers)[0], first.sign() > 0);
        ASSERT_EQ((*answers)[1], second.sign() > 0);
    }
    EXPECT_GT(certain, trials / 2 * 99 / 100);
}

TEST(TwoCircles, OfPoints) {
    expect_two_at_once<Point>();
}
TEST(TwoCircles, OfDiscs) {
    expect_two_at_once<Site>();
}
TEST(TwoCircles, OfWeights) {
    expect_two_at_once<power::Site>();
}

}  // namespace
}  // namespace signum
