// The vertices of the power diagram are the exact ones, rounded once: against rationals, with the
// rounding done on integers here.

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "../../triangulation/triangulate.hpp"
#include "../../triangulation/vertices.hpp"

#include "rounded.hpp"

namespace signum {
namespace {

struct Exact {
    mpq_class x;
    mpq_class y;
    mpq_class w;
};

/// The point p with 2(c_m - c_i)·p = (|c_m|² - w_m) - (|c_i|² - w_i) for m = j, k, by Cramer.
DiagramVertex expected_vertex(const Exact& i, const Exact& j, const Exact& k) {
    const auto height = [](const Exact& s) { return mpq_class(s.x * s.x + s.y * s.y - s.w); };
    const mpq_class ax = 2 * (j.x - i.x);
    const mpq_class ay = 2 * (j.y - i.y);
    const mpq_class bx = 2 * (k.x - i.x);
    const mpq_class by = 2 * (k.y - i.y);
    const mpq_class a = height(j) - height(i);
    const mpq_class b = height(k) - height(i);
    const mpq_class determinant = ax * by - ay * bx;
    const mpq_class x = (a * by - b * ay) / determinant;
    const mpq_class y = (ax * b - bx * a) / determinant;
    const mpq_class rho = (x - k.x) * (x - k.x) + (y - k.y) * (y - k.y) - k.w;
    return {rounded(x), rounded(y), rounded(rho)};
}

bool same(double a, double b) {
    return (std::isnan(a) && std::isnan(b)) || a == b;
}

class VerticesTest : public testing::Test {
 protected:
    std::mt19937_64 random_{3};
    int faces_ = 0;
    int not_finite_ = 0;
    int denormals_ = 0;

    int below(int count) { return static_cast<int>(random_() % static_cast<std::uint64_t>(count)); }
    double real() { return static_cast<double>(random_() >> 11) * 0x1p-53; }

    template <class S>
    void check(const std::vector<S>& sites) {
        const Tessellation t = triangulate(sites, Power{});
        const std::vector<DiagramVertex> v = vertices(t);
        ASSERT_EQ(v.size(), t.faces().size());
        for (std::size_t f = 0; f < v.size(); ++f) {
            const Face& face = t.faces()[f];
            if (face[0] == infinite) {
                ASSERT_TRUE(std::isnan(v[f].x) && std::isnan(v[f].y) && std::isnan(v[f].rho));
                continue;
            }
            const auto exact = [&](int n) {
                const Site& s =
                    t.sites()[static_cast<std::size_t>(face[static_cast<std::size_t>(n)])];
                const mpq_class third(s.r);
                return Exact{s.x, s.y,
                             t.weight_is() == WeightIs::weight ? third : mpq_class(third * third)};
            };
            const DiagramVertex expected = expected_vertex(exact(0), exact(1), exact(2));
            const bool right = same(v[f].x, expected.x) && same(v[f].y, expected.y) &&
                               same(v[f].rho, expected.rho);
            if (!right) {
                for (const Index i : face) {
                    const Site& s = t.sites()[static_cast<std::size_t>(i)];
                    ADD_FAILURE() << std::hexfloat << s.x << ", " << s.y << ", " << s.r;
                }
                FAIL() << std::hexfloat << v[f].x << ", " << v[f].y << ", " << v[f].rho << ", not "
                       << expected.x << ", " << expected.y << ", " << expected.rho;
            }
            ++faces_;
            for (const double value : {v[f].x, v[f].y, v[f].rho}) {
                not_finite_ += static_cast<int>(std::isnan(value));
                denormals_ += static_cast<int>(value != 0.0 && std::fabs(value) < 0x1p-1022);
            }
        }
    }
};

TEST_F(VerticesTest, Random) {
    std::vector<Site> sites(2500);
    for (Site& s : sites) s = {700 * real(), 700 * real(), 10 * real()};
    check(sites);
    std::vector<Point> points(500);
    for (Point& p : points) p = {real() - 0.5, real() - 0.5};
    check(points);
    std::vector<power::Site> weights(1000);
    for (auto& s : weights) s = {real() - 0.5, real() - 0.5, 1e-3 * (real() - 0.5)};
    check(weights);
    EXPECT_GT(faces_, 6000);
}

TEST_F(VerticesTest, IntegersWithHalves) {
    for (int round = 0; round < 20; ++round) {
        std::vector<power::Site> sites(60);
        for (auto& s : sites) s = {1.0 * below(8), 1.0 * below(8), 1.0 * below(3)};
        check(sites);
        // Results have a half below the last place: x = (2^53 + odd) / 2 and alike.
        for (auto& s : sites) s = {s.x * 0x1p51 + below(4), s.y * 0x1p51 + below(4), 0.0};
        check(sites);
    }
    EXPECT_GT(faces_, 2000);
}

/// Bisectors x = (a + b)/2 and y = (c + d)/2 of doubles whose mean is half way between two doubles.
TEST_F(VerticesTest, ExactHalvesGoToEven) {
    for (int round = 0; round < 300; ++round) {
        const auto base = std::ldexp(1.0, below(100) - 50);
        const auto at = [&](int steps) { return base * (1.0 + 0x1p-52 * steps); };
        const int x = below(20);
        const int y = below(20);
        check(std::vector<Point>{
            {at(x), at(y)}, {at(x + 1 + 2 * below(3)), at(y)}, {at(x), at(y + 1 + 2 * below(3))}});
    }
    EXPECT_EQ(faces_, 300);
}

TEST_F(VerticesTest, NearlyDegenerate) {
    for (int round = 0; round < 60; ++round) {
        std::vector<Site> sites(30);
        const double angle = real();
        for (Site& s : sites) {
            const double t = real();
            switch (round % 3) {
                case 0:  // along a line
                    s = {t * std::cos(angle), t * std::sin(angle), 0.01 * below(2)};
                    break;
                case 1:  // around a circle
                    s = {1e6 + std::cos(6 * t), std::sin(6 * t), 1.0};
                    break;
                default:  // slivers over a wide range
                    s = {t, std::ldexp(real(), -below(60)), std::ldexp(real(), -below(60))};
            }
        }
        check(sites);
    }
    EXPECT_GT(faces_, 1000);
}

TEST_F(VerticesTest, EdgesOfTheWindow) {
    static constexpr int places[] = {-252, -210, -201, -200, -199, -150, 0,
                                     99,   100,  150,  199,  200,  201};
    for (int round = 0; round < 1500; ++round) {
        std::vector<power::Site> sites(3 + static_cast<std::size_t>(below(4)));
        const int place = places[below(13)];
        const bool mixed = below(2) == 0;
        for (auto& s : sites) {
            const auto number = [&](int factor) {
                const int at = mixed ? places[below(13)] : place;
                return std::ldexp(below(3) == 0 ? below(5) - 2.0 : 2 * real() - 1, factor * at);
            };
            s = {number(1), number(1), number(2)};
        }
        check(sites);
    }
    EXPECT_GT(faces_, 1500);
}

TEST_F(VerticesTest, HugeAndDenormal) {
    for (int round = 0; round < 300; ++round) {
        std::vector<Site> sites(8);
        for (Site& s : sites)
            s = {std::ldexp(2 * real() - 1, 1024), std::ldexp(2 * real() - 1, 1024),
                 below(2) * std::ldexp(real(), 1000)};
        check(sites);
        for (Site& s : sites) s = {0x1p-1074 * (below(41) - 20), 0x1p-1074 * (below(41) - 20), 0.0};
        check(sites);
        for (Site& s : sites)
            s = {std::ldexp(2 * real() - 1, -536), std::ldexp(2 * real() - 1, -536), 0.0};
        check(sites);
        for (Site& s : sites)
            s = {std::ldexp(2 * real() - 1, 511 + below(3)), std::ldexp(2 * real() - 1, 512), 0.0};
        check(sites);
    }
    EXPECT_GT(faces_, 4000);
    EXPECT_GT(not_finite_, 100);
    EXPECT_GT(denormals_, 100);
}

TEST_F(VerticesTest, FewSites) {
    check(std::vector<Site>{});
    check(std::vector<Site>{{1, 2, 3}});
    check(std::vector<Site>{{1, 2, 3}, {4, 5, 6}});
    check(std::vector<Site>{{0, 0, 1}, {1, 1, 1}, {2, 2, 1}});
    check(std::vector<Site>{{0, 0, 0}, {0x1p-200, 0, 0}, {0, 0x1p-200, 0}});
    EXPECT_EQ(faces_, 1);
}

}  // namespace
}  // namespace signum
