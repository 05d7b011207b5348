/// The stretches of edges against the hyperbola that they come from.

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "../../voronoi/conic.hpp"
#include "../../voronoi/curve.hpp"

namespace signum {
namespace {

/// x = a cosh t, y = b sinh t, moved and turned.
HyperbolaCurve some_hyperbola(double a, double b) {
    return {{3, -2}, {0.6, 0.8}, {-0.8, 0.6}, a, b};
}

Conic arc(const HyperbolaCurve& curve, double from, double to) {
    const auto pieces = stretch(curve, from, curve.at(from), to, curve.at(to));
    EXPECT_EQ(pieces.size(), 1U);
    return pieces.at(0);
}

/// How far a point is from the hyperbola, by its equation.
double off(const HyperbolaCurve& curve, Point p) {
    const double x =
        (p.x - curve.middle.x) * curve.forward.x + (p.y - curve.middle.y) * curve.forward.y;
    const double y =
        (p.x - curve.middle.x) * curve.upward.x + (p.y - curve.middle.y) * curve.upward.y;
    return std::abs(x - std::copysign(curve.a * std::hypot(1, y / curve.b), curve.a));
}

/// Whether a point is on the side of the inner centre.
bool inside(const HyperbolaCurve& curve, Point p) {
    const double x =
        (p.x - curve.middle.x) * curve.forward.x + (p.y - curve.middle.y) * curve.forward.y;
    const double y =
        (p.x - curve.middle.x) * curve.upward.x + (p.y - curve.middle.y) * curve.upward.y;
    return std::abs(x) > std::abs(curve.a) * std::hypot(1, y / curve.b);
}

TEST(Conic, AllPointsAreOnTheHyperbola) {
    for (const double a : {2.0, -0.3, 1e-9})
        for (const double b : {1.0, 40.0, 1e-3}) {
            const HyperbolaCurve curve = some_hyperbola(a, b);
            const Conic whole = arc(curve, 0, 2.9);
            EXPECT_GT(whole.weight, 1);
            for (int i = 0; i <= 50; ++i)
                EXPECT_LT(off(curve, whole.at(i / 50.0)),
                          1e-13 * (40 + b) / b * std::abs(a) + 1e-13 * b + 1e-13);
        }
}

TEST(Conic, PartsAndHalvesAreTheSameCurve) {
    const HyperbolaCurve curve = some_hyperbola(2, 1);
    const Conic whole = arc(curve, 0.2, 3.4);
    const auto [first, second] = whole.halves();
    EXPECT_EQ(first.to, second.from);
    EXPECT_EQ(first.from, whole.from);
    EXPECT_EQ(second.to, whole.to);
    const Conic part = whole.part(0.2, 0.9);
    EXPECT_EQ(part.from, whole.at(0.2));
    EXPECT_EQ(part.to, whole.at(0.9));
    for (const Conic& conic : {first, second, part, whole.part(0, 0.5), whole.reversed()})
        for (int i = 0; i <= 20; ++i) EXPECT_LT(off(curve, conic.at(i / 20.0)), 1e-13);
    EXPECT_EQ(whole.part(0, 1), whole);
    EXPECT_EQ(whole.reversed().reversed(), whole);
    EXPECT_NEAR(whole.part(0, 0.5).weight, first.weight, 1e-15);
}

TEST(Conic, LongArcsBecomeSeveral) {
    const HyperbolaCurve curve = some_hyperbola(1, 2);
    const auto pieces = stretch(curve, -20, curve.at(-20), 33, curve.at(33));
    ASSERT_EQ(pieces.size(), 10U);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        EXPECT_LT(pieces[i].weight, 11);
        if (i > 0) {
            EXPECT_EQ(pieces[i].from, pieces[i - 1].to);
        }
    }
    EXPECT_EQ(pieces[3].to, (Point{3.6, -1.2}));  // where it turns
    EXPECT_TRUE(stretch(curve, 2, curve.at(2), 2, curve.at(2)).empty());
    EXPECT_TRUE(stretch(curve, 3, curve.at(3), 2, curve.at(2)).empty());
}

TEST(Conic, ParameterIsTheInverse) {
    for (const double a : {2.0, -7.0, 1e-6, 0.0})
        for (const double b : {1.0, 1e-4, 50.0})
            for (double t = -6; t <= 6; t += 0.37) {
                const HyperbolaCurve curve = some_hyperbola(a, b);
                const Point p = curve.at(t);
                const Point again = curve.at(curve.parameter(p));
                EXPECT_NEAR(again.x, p.x, 1e-11 * (1 + std::abs(p.x)));
                EXPECT_NEAR(again.y, p.y, 1e-11 * (1 + std::abs(p.y)));
            }
}

TEST(Conic, BulgeIsTheFarthestFromTheChord) {
    const Conic whole = arc(some_hyperbola(2, 1), -3, -0.1);
    const Point chord = {whole.to.x - whole.from.x, whole.to.y - whole.from.y};
    double farthest = 0;
    for (int i = 0; i <= 10000; ++i) {
        const Point p = whole.at(i / 10000.0);
        farthest = std::max(
            farthest, std::abs((p.x - whole.from.x) * chord.y - (p.y - whole.from.y) * chord.x) /
                          std::hypot(chord.x, chord.y));
    }
    EXPECT_NEAR(whole.bulge(), farthest, 1e-12);
    EXPECT_EQ(Conic::straight({0, 0}, {1, 5}).bulge(), 0);
}

TEST(Conic, SamplesAndParabolasKeepToTheTolerance) {
    for (const double b : {1.0, 0.01}) {
        const HyperbolaCurve curve = some_hyperbola(2, b);
        const Conic whole = arc(curve, -3.5, 0);
        for (const double tolerance : {0.1, 1e-3, 1e-6}) {
            std::vector<Point> points = {whole.from};
            sample(whole, tolerance, points);
            EXPECT_EQ(points.back(), whole.to);
            EXPECT_LT(points.size(), 10 / std::sqrt(tolerance));
            for (std::size_t i = 1; i < points.size(); ++i) {
                const Point middle = {(points[i].x + points[i - 1].x) / 2,
                                      (points[i].y + points[i - 1].y) / 2};
                // Along the axis it may be more where the arc is steep.
                EXPECT_LT(off(curve, middle), 3 * tolerance / b);
            }
            for (const Conic& part : parabolas(whole, tolerance)) {
                EXPECT_LE(part.distance_from_parabola(), tolerance);
                // Points of the parabola are that near to the hyperbola, in one direction.
                const Point up = {part.control.x - (part.from.x + part.to.x) / 2,
                                  part.control.y - (part.from.y + part.to.y) / 2};
                const double height = std::hypot(up.x, up.y);
                double farthest = 0;
                for (int i = 1; i < 16; ++i) {
                    const double s = i / 16.0;
                    const double u = 1 - s;
                    const Point on = {
                        u * u * part.from.x + 2 * u * s * part.control.x + s * s * part.to.x,
                        u * u * part.from.y + 2 * u * s * part.control.y + s * s * part.to.y};
                    const auto at = [&](double shift) -> Point {
                        return {on.x + shift * up.x / height, on.y + shift * up.y / height};
                    };
                    double low = 0;
                    double high = tolerance * (1 + 1e-6) + 1e-9;
                    EXPECT_NE(inside(curve, at(low)), inside(curve, at(high)));
                    for (int step = 0; step < 40; ++step) {
                        const double middle = (low + high) / 2;
                        (inside(curve, at(middle)) == inside(curve, at(low)) ? low : high) = middle;
                    }
                    farthest = std::max(farthest, low);
                }
                EXPECT_LE(farthest, part.distance_from_parabola() * (1 + 1e-6) + 1e-9);
                EXPECT_GE(farthest, 0.9 * part.distance_from_parabola() - 1e-9);
            }
        }
    }
}

TEST(Conic, SamplesAreTheSameAtEveryScale) {
    const Conic whole = arc(some_hyperbola(2, 1), -3.5, 0);
    std::vector<Point> points;
    sample(whole, 1e-6, points);
    for (const int exponent : {-1000, -540, 530, 900, 1000}) {
        const auto scaled = [&](Point p) -> Point {
            return {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)};
        };
        const Conic other = {scaled(whole.from), scaled(whole.control), scaled(whole.to),
                             whole.weight};
        EXPECT_EQ(other.bulge(), std::ldexp(whole.bulge(), exponent));
        std::vector<Point> others;
        sample(other, std::ldexp(1e-6, exponent), others);
        ASSERT_EQ(others.size(), points.size()) << exponent;
        EXPECT_EQ(others[1], scaled(points[1]));
        EXPECT_NEAR(other.length(), std::ldexp(whole.length(), exponent),
                    std::ldexp(1e-9, exponent) * whole.length());
    }
}

TEST(Conic, MomentsAreThoseOfAFinePolygon) {
    for (const double range : {1e-6, 0.01, 0.2, 0.26, 1.0, 5.0}) {
        const HyperbolaCurve curve = some_hyperbola(2, 1);
        const Conic whole = arc(curve, 0.1, 0.1 + range);
        for (const Point origin : {Point{0, 0}, whole.from, Point{50, -7}}) {
            Conic::Moments sum = {0, 0, 0};
            constexpr int count = 4096;
            for (int i = 0; i < count; ++i) {
                const Conic chord =
                    Conic::straight(whole.at(1.0 * i / count), whole.at((i + 1.0) / count));
                const Conic::Moments of = chord.moments(origin);
                sum.area += of.area;
                sum.x += of.x;
                sum.y += of.y;
            }
            const Conic::Moments of = whole.moments(origin);
            const double size = std::pow(whole.length(), 2);
            EXPECT_NEAR(of.area, sum.area, 1e-6 * size + 1e-12);
            EXPECT_NEAR(of.x, sum.x, 1e-6 * (size * 60) + 1e-10);
            EXPECT_NEAR(of.y, sum.y, 1e-6 * (size * 60) + 1e-10);
            const Conic::Moments back = whole.reversed().moments(origin);
            EXPECT_NEAR(back.area, -of.area, 1e-13 * (1 + std::abs(of.area)));
        }
    }
    // The series and the formulas meet.
    for (const double weight : {std::cosh(0.2499), std::cosh(0.2501)}) {
        const Conic conic = {{0, 0}, {1, 1}, {2, 0}, weight};
        EXPECT_NEAR(conic.moments({0, 0}).area, -0.6749, 2e-4);
    }
}

TEST(Conic, LengthIsThatOfAFinePolygon) {
    EXPECT_DOUBLE_EQ(Conic::straight({0, 0}, {3, 4}).length(), 5);
    for (const double b : {1.0, 1e-5}) {  // one of them all but turns back
        const Conic whole = arc(some_hyperbola(2, b), 0, 3);
        double sum = 0;
        constexpr int count = 200'000;
        for (int i = 0; i < count; ++i) {
            const Point p = whole.at(1.0 * i / count);
            const Point q = whole.at((i + 1.0) / count);
            sum += std::hypot(p.x - q.x, p.y - q.y);
        }
        EXPECT_NEAR(whole.length(), sum, 1e-6 * sum);
    }
}

TEST(Conic, PartsInsideABox) {
    const Box box = {0, 0, 10, 10};
    const auto parts = [&](const Conic& conic) { return parts_inside(conic, box); };
    EXPECT_EQ(parts(Conic::straight({1, 1}, {2, 9})).size(), 1U);
    EXPECT_TRUE(parts(Conic::straight({-1, 1}, {-2, 9})).empty());
    EXPECT_TRUE(parts(Conic::straight({0, 1}, {0, 9})).empty());    // along the border
    EXPECT_TRUE(parts(Conic::straight({-5, 5}, {5, -5})).empty());  // through a corner
    const auto across = parts(Conic::straight({-10, 5}, {30, 5}));
    ASSERT_EQ(across.size(), 1U);
    EXPECT_DOUBLE_EQ(across[0].first, 0.25);
    EXPECT_DOUBLE_EQ(across[0].last, 0.5);
    // An arc that leaves the box and comes back.
    const Conic bow = {{2, 5}, {5, 18}, {8, 5}, 1.5};
    const auto twice = parts(bow);
    ASSERT_EQ(twice.size(), 2U);
    EXPECT_EQ(twice[0].first, 0);
    EXPECT_EQ(twice[1].last, 1);
    EXPECT_NEAR(bow.at(twice[0].last).y, 10, 1e-14);
    EXPECT_NEAR(bow.at(twice[1].first).y, 10, 1e-14);
    // One that touches the border from inside stays.
    const Conic touching = {{2, 8}, {5, 11}, {8, 8}, 2};
    EXPECT_EQ(touching.at(0.5).y, 10);
    double length = 0;
    for (const Inside& inside : parts(touching)) length += inside.last - inside.first;
    EXPECT_NEAR(length, 1, 1e-15);
    // And from outside is not there.
    EXPECT_TRUE(parts(Conic{{2, 12}, {5, 9}, {8, 12}, 2}).empty());
}

}  // namespace
}  // namespace signum
