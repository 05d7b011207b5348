#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <set>

#include <gtest/gtest.h>

#include "../../tool/generate/hard.hpp"

namespace signum::hard {
namespace {

template <std::size_t d>
using Eight = std::array<Ball<d>, 8>;

template <std::size_t d>
std::int64_t integer_of(double number) {
    EXPECT_EQ(number, std::nearbyint(number));
    EXPECT_LT(std::abs(number), 0x1p53);
    return static_cast<std::int64_t>(number);
}
template <std::size_t d>
std::int64_t inner(const Ball<d>& a, const Ball<d>& b) {
    std::int64_t sum = 0;
    for (std::size_t k = 0; k < d; ++k)
        sum += integer_of<d>(a.centre[k]) * integer_of<d>(b.centre[k]);
    return sum;
}

/// The distance from the origin to the ball, or in the power metric the power of the origin.
template <std::size_t d>
std::int64_t from_origin(Kind kind, const Ball<d>& ball) {
    std::int64_t sum = 0;
    std::int64_t most = 0;
    for (const double x : ball.centre) {
        sum += std::abs(integer_of<d>(x));
        most = std::max(most, std::abs(integer_of<d>(x)));
    }
    const std::int64_t size = integer_of<d>(ball.size);
    if (kind == Kind::supremum) return most - size;
    if (kind == Kind::manhattan) return sum - size;
    const std::int64_t square = inner(ball, ball);
    if (kind == Kind::points || kind == Kind::weights) return square - size;
    if (kind == Kind::radii) return square - size * size;
    const std::int64_t root = std::llround(std::sqrt(static_cast<double>(square)));
    EXPECT_EQ(root * root, square);
    return root - size;
}

template <std::size_t d>
void expect_tangent() {
    for (const Kind kind : all_kinds) {
        Moves<d> moves(7);
        std::set<std::int64_t> spheres;
        for (int trial = 0; trial < 50; ++trial) {
            Eight<d> balls;
            moves.tangent(kind, balls);
            for (const Ball<d>& ball : balls)
                EXPECT_EQ(from_origin(kind, ball), from_origin(kind, balls[0])) << name_of(kind);
            spheres.insert(from_origin(kind, balls[0]));
        }
        EXPECT_GT(spheres.size(), 10) << name_of(kind);
    }
}
TEST(Hard, TangentBallsTouchOneSphere) {
    expect_tangent<2>();
    expect_tangent<3>();
}

template <std::size_t d>
void expect_nested() {
    Moves<d> moves(8);
    for (int trial = 0; trial < 50; ++trial) {
        Eight<d> balls;
        moves.nest(Kind::euclidean, balls);
        for (std::size_t m = 1; m < balls.size(); ++m) {
            Ball<d> step = balls[m];
            for (std::size_t k = 0; k < d; ++k) step.centre[k] -= balls[m - 1].centre[k];
            step.size = balls[m - 1].size - balls[m].size;
            EXPECT_EQ(from_origin(Kind::euclidean, step), 0);
            EXPECT_GT(step.size, 0);
        }
    }
}
TEST(Hard, NestedBallsTouchTheOneBeforeFromInside) {
    expect_nested<2>();
    expect_nested<3>();
}

/// All (c, r) lie in one plane, in space in one hyperplane, that touches balls from one side.
template <std::size_t d>
void expect_in_line() {
    Moves<d> moves(9);
    for (int trial = 0; trial < 50; ++trial) {
        Eight<d> balls;
        moves.in_line(Kind::points, balls);
        for (const Ball<d>& ball : balls) EXPECT_EQ(ball.size, 0);
        // Through the origin goes a line or plane that has all centres: three of them, or two, span
        // nothing.
        const auto x = [&](std::size_t m, std::size_t k) { return balls[m].centre[k]; };
        for (std::size_t m = 0; m + 2 < balls.size(); ++m) {
            if constexpr (d == 2)
                EXPECT_EQ(x(m, 0) * x(m + 1, 1), x(m, 1) * x(m + 1, 0));
            else
                EXPECT_EQ(x(m, 0) * (x(m + 1, 1) * x(m + 2, 2) - x(m + 1, 2) * x(m + 2, 1)) -
                              x(m, 1) * (x(m + 1, 0) * x(m + 2, 2) - x(m + 1, 2) * x(m + 2, 0)) +
                              x(m, 2) * (x(m + 1, 0) * x(m + 2, 1) - x(m + 1, 1) * x(m + 2, 0)),
                          0);
        }
    }
}
TEST(Hard, CentresLieOnOneLineOrPlane) {
    expect_in_line<2>();
    expect_in_line<3>();
}

TEST(Hard, TheFourthPointIsPutOnTheCircleOfThree) {
    Moves<2> moves(10);
    std::array<Ball<2>, 4> balls = {{{{0, 0}, 0}, {{6, 0}, 0}, {{2, 5}, 0}, {{9, 9}, 0}}};
    moves.put_on_circle_of_three(balls);
    EXPECT_EQ(balls[3], (Ball<2>{{4, 5}, 0}));
}

TEST(Hard, PatternsAreIntegersUntilUlpsMoveThem) {
    Moves<3> moves(11);
    for (int trial = 0; trial < 2000; ++trial) {
        std::array<Ball<3>, 3> balls;  // too few for a circle of three, which rounds
        moves.any_pattern(all_kinds[static_cast<std::size_t>(trial) % 6], balls);
        for (const Ball<3>& ball : balls) {
            for (const double x : ball.centre) integer_of<3>(x);
            integer_of<3>(ball.size);
        }
        const std::array<Ball<3>, 3> before = balls;
        moves.move_by_ulps(Kind::radii, balls, 2, 4);
        int moved = 0;
        for (std::size_t m = 0; m < 3; ++m)
            for (std::size_t k = 0; k < 4; ++k) {
                const double from = k < 3 ? before[m].centre[k] : before[m].size;
                const double to = k < 3 ? balls[m].centre[k] : balls[m].size;
                moved += from != to ? 1 : 0;
                if (from != 0.0) {
                    EXPECT_LE(std::abs(to - from), 8 * 0x1p-52 * std::abs(from));  // perhaps twice
                }
            }
        EXPECT_LE(moved, 2);
    }
}

TEST(Hard, GivesTheSameDoublesEverywhere) {
    // Written down once; they may not depend on platform, library or optimization.
    Moves<2> moves(12);
    std::array<Ball<2>, 2> balls;
    moves.any_pattern(Kind::euclidean, balls);
    moves.move_by_ulps(Kind::euclidean, balls, 2, 4);
    moves.scale(Kind::euclidean, balls, -3);
    EXPECT_EQ(balls[0], (Ball<2>{{0x1.1fcd3p+19, -0x1p-31}, 0x1.ed5fcp+18}));
    EXPECT_EQ(balls[1], (Ball<2>{{0x1.8ab3p+15, -0x1.0722000000003p+16}, 0}));
    std::array<Ball<2>, 1> raw;
    moves.raw(Kind::points, raw);
    EXPECT_EQ(raw[0], (Ball<2>{{-0x1.78308c728386dp+410, 0x1.85fb6ba3edf49p+867}, 0}));
}

}  // namespace
}  // namespace signum::hard
