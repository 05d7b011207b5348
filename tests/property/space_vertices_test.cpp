/// Vertices of power diagrams in space: at equal power distance from their sites, each number the
/// nearest double. Judged in rationals by another road: by elimination, and by the neighbours of
/// the double.

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "../../triangulation/space/vertices.hpp"
#include "../oracle/oracle_test_support.hpp"
#include "../thoroughness.hpp"

#include <boost/multiprecision/gmp.hpp>

namespace signum {
namespace {

using oracle_test::Random;
using Rational = boost::multiprecision::mpq_rational;

/// Place and power distance by elimination: unknowns p and s = |p|² - rho with 2 c·p - s = |c|² -
/// w.
std::array<Rational, 4> exact_vertex(const std::array<power::Site3, 4>& sites) {
    Rational rows[4][5];
    for (std::size_t m = 0; m < 4; ++m) {
        const Rational c[3] = {sites[m].x, sites[m].y, sites[m].z};
        for (std::size_t k = 0; k < 3; ++k) rows[m][k] = 2 * c[k];
        rows[m][3] = -1;
        rows[m][4] = c[0] * c[0] + c[1] * c[1] + c[2] * c[2] - Rational(sites[m].w);
    }
    for (std::size_t k = 0; k < 4; ++k) {
        std::size_t pivot = k;
        while (rows[pivot][k] == 0) ++pivot;
        std::swap(rows[pivot], rows[k]);
        for (std::size_t m = 0; m < 4; ++m) {
            if (m == k) continue;
            const Rational factor = rows[m][k] / rows[k][k];
            for (std::size_t n = k; n < 5; ++n) rows[m][n] -= factor * rows[k][n];
        }
    }
    std::array<Rational, 4> p;
    for (std::size_t k = 0; k < 4; ++k) p[k] = rows[k][4] / rows[k][k];
    return {p[0], p[1], p[2], p[0] * p[0] + p[1] * p[1] + p[2] * p[2] - p[3]};
}

/// Whether a double is nearest to a number: within both half-way points to its neighbours.
void expect_nearest(double rounded, const Rational& exact) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    ASSERT_TRUE(std::isfinite(rounded));
    const Rational twice = 2 * exact;
    const double below = std::nextafter(rounded, -infinity);
    const double above = std::nextafter(rounded, infinity);
    ASSERT_GE(twice, Rational(below) + Rational(rounded));
    ASSERT_LE(twice, Rational(above) + Rational(rounded));
    std::int64_t bits = 0;
    static_assert(sizeof bits == sizeof rounded);
    std::memcpy(&bits, &rounded, sizeof bits);
    if (bits % 2 != 0) {
        ASSERT_NE(twice, Rational(below) + Rational(rounded));
        ASSERT_NE(twice, Rational(above) + Rational(rounded));
    }
}

TEST(SpaceVertices, AreTheNearestDoubles) {
    Random random(41);
    std::size_t judged = 0;
    for (int trial = 0; trial < 60 * thoroughness; ++trial) {
        const int kind = trial % 5;
        const auto one = [&] {
            switch (kind) {
                case 0:
                    return 1.0 * random.below(4);
                case 1:
                    return 0.1 * random.below(4) + 1048576.0;
                case 2:
                    return std::ldexp(random.unit(), random.below(300) - 150);
                case 3:
                    return std::ldexp(random.unit(), -500);
                default:
                    return random.unit();
            }
        };
        std::vector<power::Site3> sites;
        for (int i = 0; i < 12; ++i) {
            const double weight = kind == 2 || kind == 3 ? 0.0 : 0.3 * random.unit();
            sites.push_back({one(), one(), one(), weight});
        }
        const SpaceTessellation tessellation = triangulate(std::span<const power::Site3>(sites));
        const std::vector<SpaceVertex> result =
            vertices(tessellation, std::span<const power::Site3>(sites));
        ASSERT_EQ(result.size(), tessellation.cells.size());
        for (std::size_t c = 0; c < result.size(); ++c) {
            const SpaceCell& cell = tessellation.cells[c];
            if (cell[0] < 0 || tessellation.dimension < 3) {
                ASSERT_TRUE(std::isnan(result[c].x) && std::isnan(result[c].rho));
                continue;
            }
            std::array<power::Site3, 4> corners;
            for (std::size_t k = 0; k < 4; ++k)
                corners[k] = sites[static_cast<std::size_t>(cell[k])];
            const std::array<Rational, 4> exact = exact_vertex(corners);
            ASSERT_NO_FATAL_FAILURE(expect_nearest(result[c].x, exact[0]));
            ASSERT_NO_FATAL_FAILURE(expect_nearest(result[c].y, exact[1]));
            ASSERT_NO_FATAL_FAILURE(expect_nearest(result[c].z, exact[2]));
            ASSERT_NO_FATAL_FAILURE(expect_nearest(result[c].rho, exact[3]));
            ++judged;
        }
    }
    EXPECT_GT(judged, 1000U);
}

TEST(SpaceVertices, OfAllKindsOfSites) {
    const std::vector<Site3> balls = {
        {0.0, 0.0, 0.0, 1.0}, {2.0, 0.0, 0.0, 1.0}, {0.0, 2.0, 0.0, 1.0}, {0.0, 0.0, 2.0, 1.0}};
    std::vector<Point3> points;
    for (const Site3& s : balls) points.push_back({s.x, s.y, s.z});
    const auto of_points = vertices(triangulate(std::span<const Point3>(points)), points);
    const auto of_balls = vertices(triangulate(std::span<const Site3>(balls)), balls);
    ASSERT_EQ(of_points.size(), 5U);
    const SpaceVertex& last = of_points.back();
    EXPECT_EQ((std::array{last.x, last.y, last.z, last.rho}), (std::array{1.0, 1.0, 1.0, 3.0}));
    EXPECT_EQ(of_balls.back().rho, 2.0);
}

TEST(SpaceVertices, BeyondTheDoublesAndOfWrongArrays) {
    const std::vector<Point3> far = {
        {0.0, 0.0, 0.0}, {1e300, 0.0, 0.0}, {0.0, 1e300, 0.0}, {0.0, 0.0, 1e300}};
    const SpaceVertex last = vertices(triangulate(std::span<const Point3>(far)), far).back();
    EXPECT_EQ(last.x, 5e299);
    EXPECT_TRUE(std::isnan(last.rho));
    SpaceTessellation wrong = triangulate(std::span<const Point3>(far));
    wrong.cells.back()[2] = 7;
    EXPECT_THROW(static_cast<void>(vertices(wrong, far)), std::invalid_argument);
    wrong.sites = 3;
    EXPECT_THROW(static_cast<void>(vertices(wrong, far)), std::invalid_argument);
}

}  // namespace
}  // namespace signum
