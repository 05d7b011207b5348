// nearest(), locate() and neighbours() in all metrics, against brute force in rationals: ties,
// hidden sites, grids, few sites; triangulate() for a metric known at run time.

#include "../../triangulation/triangulate.hpp"
#include "../by_metric.hpp"
#include "../thoroughness.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmpxx.h>
#include <gtest/gtest.h>

namespace signum {
namespace {

using Sites = std::vector<Site>;

const int share = is_fast ? 1 : 5;  // of the questions one in so many

std::size_t at(Index i) {
    return static_cast<std::size_t>(i);
}

/// The sign of √a - √b - d for a, b >= 0.
int sign_of_roots(const mpq_class& a, const mpq_class& b, const mpq_class& d) {
    if (d < 0) return -sign_of_roots(b, a, -d);
    // √a against √b + d.
    const mpq_class rest = a - b - d * d;
    return rest < 0 ? -1 : sgn(mpq_class(rest * rest - 4 * d * d * b));
}

/// The sign of b's distance from p less that of a: +1 where p is nearer to a.
int nearer(Metric metric, Point p, const Site& a, const Site& b) {
    const auto length = [&](const Site& s) {
        const mpq_class x = abs(mpq_class(mpq_class(p.x) - mpq_class(s.x)));
        const mpq_class y = abs(mpq_class(mpq_class(p.y) - mpq_class(s.y)));
        return by_metric::length_or_square(metric, x, y);
    };
    const mpq_class to_a = length(a);
    const mpq_class to_b = length(b);
    const mpq_class ra(a.r);
    const mpq_class rb(b.r);
    if (metric == Metric::power) return sgn(mpq_class(to_b - rb * rb - to_a + ra * ra));
    if (metric == Metric::euclidean) return sign_of_roots(to_b, to_a, rb - ra);
    return sgn(mpq_class(to_b - rb - to_a + ra));
}

/// Of all sites the nearest; of several the first by falling radius (weight), rising x, y, index.
Index nearest_by_force(Metric metric, const Sites& sites, Point p) {
    const auto key = [&](const Site& s) {
        const double weight = metric == Metric::power ? std::fabs(s.r) : s.r;
        return std::array<double, 3>{-weight, s.x, s.y};
    };
    Index best = sites.empty() ? -1 : 0;
    for (std::size_t i = 1; i < sites.size(); ++i) {
        const Site& s = sites[i];
        const Site& b = sites[at(best)];
        const int sign = nearer(metric, p, s, b);
        if (sign > 0 || (sign == 0 && key(s) < key(b))) best = static_cast<Index>(i);
    }
    return best;
}

class Nearest : public testing::TestWithParam<Metric> {
 protected:
    static void expect_nearest(const Tessellation& t, const Sites& sites, Point p) {
        const Index expected = nearest_by_force(GetParam(), sites, p);
        ASSERT_EQ(t.nearest(p), expected) << p.x << " " << p.y;
        const Index face = t.locate(p);
        if (t.faces().empty()) {
            ASSERT_EQ(face, -1);
        } else {
            ASSERT_GE(face, 0);
            ASSERT_LT(at(face), t.faces().size());
            const Face& f = t.faces()[at(face)];
            const bool is_at_nearest = std::find(f.begin(), f.end(), expected) != f.end();
            ASSERT_TRUE(is_at_nearest || GetParam() == Metric::power);
        }
    }
    std::mt19937_64 random{3};
    double integer(int from, int to) {
        return static_cast<double>(std::uniform_int_distribution<int>(from, to)(random));
    }
    double real(double from, double to) {
        return std::uniform_real_distribution<double>(from, to)(random);
    }
};

TEST_P(Nearest, WhereTiesAbound) {
    for (int trial = 0; trial < 150; ++trial) {
        const int box = 1 + trial % 9;
        Sites sites(at(static_cast<Index>(integer(0, 14))));
        for (Site& s : sites) {
            s = {integer(0, box), integer(0, box), integer(0, trial / 9 % 4)};
            if (trial % 7 == 0) s.y = s.x;
            if (trial % 11 == 0) s.y = 0;
        }
        const Tessellation t = triangulate(sites, GetParam());
        for (double x = -1; x <= box + 1; x += 0.5)
            ASSERT_NO_FATAL_FAILURE(expect_nearest(t, sites, {x, integer(-2, 2 * box + 2) / 2}));
        for (const Site& s : sites) ASSERT_NO_FATAL_FAILURE(expect_nearest(t, sites, {s.x, s.y}));
    }
}

TEST_P(Nearest, FarAway) {
    for (int trial = 0; trial < 60; ++trial) {
        Sites sites(at(static_cast<Index>(integer(1, 12))));
        for (Site& s : sites) s = {real(-5, 5), real(-5, 5), real(-2, 2)};
        const Tessellation t = triangulate(sites, GetParam());
        for (const Point p : {Point{0, 0}, Point{-1e300, 1e300}, Point{0x1p-1074, -0x1p-1074},
                              Point{1.7e308, -1.7e308}, Point{0.5, 1e10}, Point{1e17, 1e17}})
            ASSERT_NO_FATAL_FAILURE(expect_nearest(t, sites, p));
    }
}

TEST_P(Nearest, SitesThatHideOthers) {
    for (int trial = 0; trial < 8; ++trial) {
        Sites sites(200);
        for (Site& s : sites) s = {real(0, 100), real(0, 100), std::pow(real(0, 2.6), 3)};
        const Tessellation t = triangulate(sites, GetParam());
        EXPECT_FALSE(t.hidden().empty());
        for (const Hidden& h : t.hidden()) {
            const Site& s = sites[at(h.site)];
            ASSERT_EQ(t.nearest({s.x, s.y}), h.by);
            ASSERT_TRUE(t.neighbours(h.site).empty());
        }
        for (int question = 0; question < 20; ++question)
            ASSERT_NO_FATAL_FAILURE(expect_nearest(t, sites, {real(-20, 120), real(-20, 120)}));
    }
}

TEST_P(Nearest, Grids) {
    for (const double radius : {0.0, 0.25, 1.0}) {
        Sites sites;
        for (int i = 0; i < 900; ++i)
            sites.push_back({static_cast<double>(i % 30), static_cast<double>(i / 30),
                             (i + i / 30) % 2 * radius});
        std::shuffle(sites.begin(), sites.end(), random);
        const Tessellation t = triangulate(sites, GetParam());
        for (int question = 0; question < 60 / share; ++question)
            ASSERT_NO_FATAL_FAILURE(
                expect_nearest(t, sites, {integer(-2, 62) / 2, integer(-2, 62) / 2}));
    }
}

TEST_P(Nearest, OneSiteAndTwo) {
    for (const Sites& sites : {Sites{}, Sites{{1, 2, 3}}, Sites{{1, 2, 3}, {1, 2, 3}},
                               Sites{{1, 2, 0}, {1, 2, 3}, {1, 2, 1}}, Sites{{0, 0, 1}, {4, 0, 1}},
                               Sites{{0, 0, 1}, {4, 3, 2}}, Sites{{0, 0, 1}, {1, 0, 9}}}) {
        const Tessellation t = triangulate(sites, GetParam());
        for (double x = -2; x < 6; x += 0.5)
            for (double y = -2; y < 6; y += 1)
                ASSERT_NO_FATAL_FAILURE(expect_nearest(t, sites, {x, y}));
        EXPECT_THROW(static_cast<void>(t.nearest({NAN, 0})), std::invalid_argument);
        EXPECT_THROW(static_cast<void>(t.locate({0, HUGE_VAL})), std::invalid_argument);
    }
}

TEST_P(Nearest, IsTheSameMetricAtRunTime) {
    Sites sites(100);
    for (Site& s : sites) s = {integer(0, 12), integer(0, 12), integer(0, 2)};
    const Tessellation t = triangulate(sites, GetParam());
    EXPECT_EQ(t.metric(), GetParam());
    with_metric(GetParam(),
                [&](auto metric) { EXPECT_EQ(t.arrays(), triangulate(sites, metric).arrays()); });
    // Every edge is seen from both of its ends, as often as there are edges.
    std::vector<Edge> edges;
    for (std::size_t i = 0; i < sites.size(); ++i)
        for (const Index v : t.neighbours(static_cast<Index>(i)))
            if (v < static_cast<Index>(i)) edges.push_back({v, static_cast<Index>(i)});
    std::sort(edges.begin(), edges.end());
    EXPECT_EQ(edges, t.edges());
}

INSTANTIATE_TEST_SUITE_P(Metrics, Nearest, testing::ValuesIn(all_metrics),
                         [](const auto& info) { return std::string(name_of(info.param)); });

}  // namespace
}  // namespace signum
