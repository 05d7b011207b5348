/// What a construction knows of sites on a grid: the unit of the grid, and that in_circle is then
/// decided by its filter, zeros too; and the filter of two circles at once.

#include <array>
#include <cmath>
#include <random>
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
