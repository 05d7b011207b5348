#include "../../tool/study/margin.hpp"

#include <cmath>
#include <iterator>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "../../triangulation/triangulate.hpp"

namespace {

using namespace signum;
using study::Margins;
using Sites = std::vector<Site>;

Margins margins(const Sites& sites, Metric metric) {
    return study::margins_of(triangulate(sites, metric));
}

TEST(Margin, OfASquareIsATie) {
    for (const Metric metric : all_metrics) {
        const Margins m = margins({{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}, metric);
        EXPECT_EQ(m.edges, 1) << name_of(metric);
        EXPECT_EQ(m.ties, 1) << name_of(metric);
        EXPECT_FALSE(m.least) << name_of(metric);
    }
}

// The site across moves by e out of the circle (square) of the others: the determinant is of order
// e, its terms of order 1.
TEST(Margin, IsTheRelativeDistanceFromATie) {
    for (const double e : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15}) {
        const Site diamond[] = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1 - e, 0}};
        const Site corners[] = {{1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1 + e, -1 - e, 0}};
        for (const Metric metric : all_metrics)
            for (const double larger : {0.0, 0.25}) {
                const auto& from = metric == Metric::manhattan ? corners : diamond;
                Sites sites(std::begin(from), std::end(from));
                // Every second site grows, and steps back in the additive metrics.
                for (const std::size_t m : {std::size_t{0}, std::size_t{2}}) {
                    sites[m].r = larger;
                    if (metric == Metric::power) continue;
                    sites[m].x +=
                        (sites[m].x > 0 ? larger : -larger) / (metric == Metric::manhattan ? 2 : 1);
                    if (metric == Metric::manhattan)
                        sites[m].y += (sites[m].y > 0 ? larger : -larger) / 2;
                }
                const Margins m = margins(sites, metric);
                ASSERT_EQ(m.edges, 1) << name_of(metric) << e;
                ASSERT_EQ(m.ties, 0) << name_of(metric) << e;
                if (metric == Metric::power && larger > 0) continue;  // no tie is near
                EXPECT_GT(*m.least, e / 1000) << name_of(metric) << e;
                EXPECT_LT(*m.least, e) << name_of(metric) << e;
            }
    }
}

TEST(Margin, IsTheSameAtEveryScale) {
    Sites sites;
    for (int i = 0; i < 200; ++i)
        sites.push_back({std::fmod(i * 0.7548776662466927, 1.0),
                         std::fmod(i * 0.5698402909980532, 1.0), 0.001 * (i % 9)});
    for (const Metric metric : all_metrics) {
        const Margins plain = margins(sites, metric);
        EXPECT_EQ(plain.edges, plain.ties + std::accumulate(plain.powers.begin(),
                                                            plain.powers.end(), std::int64_t{0}));
        EXPECT_GT(plain.edges, 300);
        for (const int exponent : {-700, -100, 100, 700}) {
            Sites scaled = sites;
            for (Site& s : scaled)
                s = {std::ldexp(s.x, exponent), std::ldexp(s.y, exponent),
                     std::ldexp(s.r, exponent)};
            const Margins other = margins(scaled, metric);
            ASSERT_EQ(other.edges, plain.edges) << name_of(metric);
            EXPECT_NEAR(*other.least / *plain.least, 1.0, 0.01) << name_of(metric) << exponent;
        }
    }
}

TEST(Margin, OfFewSitesThereIsNone) {
    EXPECT_EQ(margins({}, Metric::power).edges, 0);
    EXPECT_EQ(margins({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, Metric::power).edges, 0);
}

}  // namespace
