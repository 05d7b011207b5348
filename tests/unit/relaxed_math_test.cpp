/// This file is compiled as a careless user compiles: with every relaxation of IEEE arithmetic that
/// is not refused, for the machine at hand, contraction included (tests/CMakeLists.txt). The
/// filters that it inlines must still say nothing wrong, on input that nearly misses.

#include <cmath>
#include <cstddef>
#include <random>

#include <gmpxx.h>
#include <gtest/gtest.h>

#include "../../predicates/euclidean.hpp"
#include "../../predicates/power.hpp"
#include "../thoroughness.hpp"

namespace {

using signum::Decision;
using signum::Point;
using signum::Sign;
using signum::Site;
using signum::Stage;

const int rounds = signum::is_fast ? 40000 : 4000;

mpq_class square(const mpq_class& x) {
    return x * x;
}
mpq_class weight(const Point&) {
    return 0;
}
mpq_class weight(const signum::power::Site& s) {
    return s.w;
}
mpq_class weight(const Site& s) {
    return square(s.r);
}

/// The laws of the predicates, in rationals.
template <class S>
Sign exact_ccw(const S& a, const S& b, const S& c) {
    const mpq_class ax = mpq_class(a.x) - c.x;
    const mpq_class ay = mpq_class(a.y) - c.y;
    const mpq_class bx = mpq_class(b.x) - c.x;
    const mpq_class by = mpq_class(b.y) - c.y;
    return sgn(mpq_class(ax * by - ay * bx));
}

template <class S>
Sign exact_in_circle(const S& i, const S& j, const S& k, const S& q) {
    struct Row {
        mpq_class x, y, height;
    };
    const auto row = [&q](const S& m) -> Row {
        const mpq_class x = mpq_class(m.x) - q.x;
        const mpq_class y = mpq_class(m.y) - q.y;
        return {x, y, x * x + y * y - weight(m) + weight(q)};
    };
    const Row a = row(i);
    const Row b = row(j);
    const Row c = row(k);
    return sgn(mpq_class(a.height * (b.x * c.y - c.x * b.y) + b.height * (c.x * a.y - a.x * c.y) +
                         c.height * (a.x * b.y - b.x * a.y)));
}

template <class S>
Sign exact_nearer(const Point& p, const S& a, const S& b) {
    const auto distance = [&p](const S& s) -> mpq_class {
        return square(mpq_class(s.x) - p.x) + square(mpq_class(s.y) - p.y) - weight(s);
    };
    return sgn(mpq_class(distance(b) - distance(a)));
}

class RelaxedMath : public testing::Test {
 protected:
    double in(double low, double high) {
        return low + (high - low) * static_cast<double>(bits_() >> 11) * 0x1p-53;
    }
    /// Off the mark by 2^-70 (most often nothing is left of it) to 2^-34: from far below to far
    /// above what the filters can tell.
    double error() {
        const auto places = static_cast<int>(bits_() % 37);
        return std::ldexp(in(-1, 1), -34 - places);
    }
    Point on_circle(const Point& centre, double radius) {
        const double angle = in(0, 6.283185307179586);
        return {centre.x + radius * std::cos(angle) + error(),
                centre.y + radius * std::sin(angle) + error()};
    }

    void note(Stage stage) { ++(stage == Stage::filter ? filtered_ : unfiltered_); }
    /// Both sides of the filter's bound were visited.
    void expect_both_stages() const {
        EXPECT_GT(filtered_, std::size_t(rounds) / 50);
        EXPECT_GT(unfiltered_, std::size_t(rounds) / 50);
    }

 private:
    std::mt19937_64 bits_{4711};
    std::size_t filtered_ = 0;
    std::size_t unfiltered_ = 0;
};

TEST_F(RelaxedMath, CcwIsExact) {
    for (int round = 0; round < rounds; ++round) {
        const Point a = {in(-8, 8), in(-8, 8)};
        const Point b = {in(-8, 8), in(-8, 8)};
        const double t = in(-1, 2);
        const Point c = {a.x + t * (b.x - a.x) + error(), a.y + t * (b.y - a.y) + error()};
        const Decision decision = signum::ccw_decision(a, b, c);
        note(decision.stage);
        ASSERT_EQ(decision.sign, exact_ccw(a, b, c)) << round;
        ASSERT_EQ(signum::ccw(a, b, c), decision.sign) << round;
    }
    expect_both_stages();
}

TEST_F(RelaxedMath, InCircleOfPointsIsExact) {
    for (int round = 0; round < rounds; ++round) {
        const Point centre = {in(-8, 8), in(-8, 8)};
        const double radius = std::ldexp(1.0, static_cast<int>(in(-8, 8)));
        const Point i = on_circle(centre, radius);
        const Point j = on_circle(centre, radius);
        const Point k = on_circle(centre, radius);
        const Point q = on_circle(centre, radius);
        if (signum::ccw(i, j, k) <= 0) continue;
        const Decision decision = signum::power::in_circle_decision(i, j, k, q);
        note(decision.stage);
        ASSERT_EQ(decision.sign, exact_in_circle(i, j, k, q)) << round;
    }
    expect_both_stages();
}

/// Sites at one power from a point: squared distance minus weight is the same for all.
TEST_F(RelaxedMath, InCircleOfWeightedSitesIsExact) {
    for (int round = 0; round < rounds; ++round) {
        const Point centre = {in(-8, 8), in(-8, 8)};
        const double power = in(0, 4);
        const auto touching = [&]() -> signum::power::Site {
            const double x = in(-8, 8);
            const double y = in(-8, 8);
            const double dx = x - centre.x;
            const double dy = y - centre.y;
            return {x, y, dx * dx + dy * dy - power + error()};
        };
        const auto i = touching();
        const auto j = touching();
        const auto k = touching();
        const auto q = touching();
        if (!signum::power::exists(i, j, k)) continue;
        const Decision decision = signum::power::in_circle_decision(i, j, k, q);
        note(decision.stage);
        ASSERT_EQ(decision.sign, exact_in_circle(i, j, k, q)) << round;
    }
    expect_both_stages();
}

TEST_F(RelaxedMath, InCircleOfDiscsIsExact) {
    for (int round = 0; round < rounds; ++round) {
        const Point centre = {in(-8, 8), in(-8, 8)};
        const auto touching = [&]() -> Site {
            const double x = in(-8, 8);
            const double y = in(-8, 8);
            return {x, y, std::hypot(x - centre.x, y - centre.y) + error()};
        };
        const auto i = touching();
        const auto j = touching();
        const auto k = touching();
        const auto q = touching();
        if (!signum::power::exists(i, j, k)) continue;
        const Decision decision = signum::power::in_circle_decision(i, j, k, q);
        note(decision.stage);
        ASSERT_EQ(decision.sign, exact_in_circle(i, j, k, q)) << round;
    }
    expect_both_stages();
}

/// p on the radical axis of a and b.
TEST_F(RelaxedMath, NearerIsExact) {
    for (int round = 0; round < rounds; ++round) {
        const Point p = {in(-8, 8), in(-8, 8)};
        const double power = in(-2, 2);
        const auto touching = [&]() -> signum::power::Site {
            const double x = in(-8, 8);
            const double y = in(-8, 8);
            const double dx = x - p.x;
            const double dy = y - p.y;
            return {x, y, dx * dx + dy * dy - power + error()};
        };
        const auto a = touching();
        const auto b = touching();
        const Decision decision = signum::power::nearer_decision(p, a, b);
        note(decision.stage);
        ASSERT_EQ(decision.sign, exact_nearer(p, a, b)) << round;
        const signum::power::Site twin = {a.x, a.y, a.w + error()};
        ASSERT_EQ(signum::power::hidden(twin, a), twin.w <= a.w) << round;
    }
    expect_both_stages();
}

/// At the hull edge a -> b only a site on its line can touch: a, b and q collinear by construction.
TEST_F(RelaxedMath, InCircleInfiniteIsExact) {
    for (int round = 0; round < rounds; ++round) {
        const double slope = std::ldexp(1.0, static_cast<int>(in(-4, 4)));
        const double power = in(-2, 2);
        const double middle = std::round(in(-512, 512));
        const auto touching = [&](double x) -> signum::power::Site {
            const double dx = x - middle;
            const double dy = slope * dx;
            return {x, slope * x, dx * dx + dy * dy - power + error()};
        };
        const double step = std::round(in(2, 512));
        const auto a = touching(middle - step);
        const auto b = touching(middle + step);
        const auto q = touching(middle - step + std::round(in(0.5, 1.5 * step)));
        if (signum::ccw({a.x, a.y}, {b.x, b.y}, {q.x, q.y}) != 0) continue;
        // q is in conflict where it lies above the line through the lifted a and b.
        const mpq_class t = (mpq_class(q.x) - a.x) / (mpq_class(b.x) - a.x);
        const auto height = [](const signum::power::Site& s) -> mpq_class {
            return square(mpq_class(s.x)) + square(mpq_class(s.y)) - mpq_class(s.w);
        };
        const mpq_class below = height(a) + t * (height(b) - height(a)) - height(q);
        ASSERT_EQ(signum::power::in_circle_infinite(a, b, q), sgn(below)) << round;
    }
}

/// Discs that touch one circle, or one line.
TEST_F(RelaxedMath, EuclideanPredicatesAreExact) {
    using Exact = signum::euclidean::Perturbed<>;
    using Rational = signum::euclidean::Perturbed<signum::Arithmetic::multiprecision>;
    for (int round = 0; round < rounds; ++round) {
        const Point centre = {in(-8, 8), in(-8, 8)};
        const double radius = in(0, 4);
        const double slope = in(-1, 1);
        const double length = std::sqrt(1 + slope * slope);
        const bool line = round % 2 == 0;
        const auto touching = [&]() -> Site {
            const double x = in(-8, 8);
            const double y = in(-8, 8);
            const double reach =
                line ? (slope * x - y) / length : std::hypot(x - centre.x, y - centre.y) - radius;
            return {x, y, reach + error()};
        };
        const Site i = touching();
        const Site j = touching();
        const Site k = touching();
        const Site q = touching();
        const auto expect = [&](const Decision& given, const Decision& expected) {
            note(given.stage);
            ASSERT_EQ(given.sign, expected.sign) << round;
        };
        // The order of the ranks does not matter where nothing is tied.
        const Decision exists = Exact::exists(i, j, k, {0, 1, 2});
        expect(exists, Rational::exists(i, j, k, {0, 1, 2}));
        expect(Exact::exists_twice(i, j, k, {0, 1, 2}), Rational::exists_twice(i, j, k, {0, 1, 2}));
        expect(Exact::precedes_on_bisector(i, j, k, q, {0, 1, 2, 3}),
               Rational::precedes_on_bisector(i, j, k, q, {0, 1, 2, 3}));
        expect(Exact::nearer(centre, i, j, {0, 1}), Rational::nearer(centre, i, j, {0, 1}));
        expect(Exact::hides(i, j, {0, 1}), Rational::hides(i, j, {0, 1}));
        if (Exact::hides(i, j, {0, 1}).sign < 0 && Exact::hides(j, i, {1, 0}).sign < 0)
            expect(Exact::in_circle_infinite(i, j, k, {0, 1, 2}),
                   Rational::in_circle_infinite(i, j, k, {0, 1, 2}));
        if (exists.sign > 0)
            expect(Exact::in_circle(i, j, k, q, {0, 1, 2, 3}),
                   Rational::in_circle(i, j, k, q, {0, 1, 2, 3}));
        if (HasFatalFailure()) return;
    }
    expect_both_stages();
}

}  // namespace
