// The sweep of the plane builds what insertion builds, in the supremum and Manhattan metrics:
// faces, neighbours and hidden sites, on sets meant to break it. (Small sets are compared with the
// oracle in additive_canonical_test.)

#include "../../predicates/rectangular/front.hpp"
#include "../../triangulation/triangulate.hpp"

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "../../tool/generate/generate.hpp"

#include "../thoroughness.hpp"
#include "degenerate_sites.hpp"

namespace {

using namespace signum;
using Sites = std::vector<Site>;

const int share = is_fast ? 1 : 10;  // of the trials one in so many

Options sweeping() {
    Options options;
    options.method = Method::sweep;
    return options;
}

class Swept : public testing::TestWithParam<Metric> {
 public:
    static void expect_insertion(const Sites& sites) {
        const Tessellation inserted = triangulate(sites, GetParam());
        const Tessellation swept = triangulate(sites, GetParam(), sweeping());
        ASSERT_EQ(swept.arrays(), inserted.arrays());
        // A site is reached once, and every face but those at the end is a circle event.
        const std::uint64_t events = swept.statistics().events;
        ASSERT_GE(events, sites.size());
        ASSERT_LE(events, sites.size() + swept.faces().size());
    }
};
INSTANTIATE_TEST_SUITE_P(Metrics, Swept, testing::Values(Metric::supremum, Metric::manhattan),
                         [](const auto& info) { return std::string(name_of(info.param)); });

TEST_P(Swept, EqualsInsertionInDegeneratePositions) {
    brute_force::Degenerate degenerate(5);
    for (int trial = 0; trial < 6000 / share; ++trial) {
        Sites sites(static_cast<std::size_t>(1 + trial % 97));
        degenerate.fill(trial % brute_force::Degenerate::families, sites.data(), sites.size());
        ASSERT_NO_FATAL_FAILURE(expect_insertion(sites)) << trial;
    }
}

TEST_P(Swept, EqualsInsertionOnAllDistributions) {
    for (const Distribution distribution :
         {Distribution::random, Distribution::circle, Distribution::square, Distribution::grid})
        for (const double radius : {0.0, 0.1, 10.0, 100.0})
            for (const double perturb : {0.0, 1e-9, 1.0}) {
                GenerateOptions options;
                options.count = 3000 / share;
                options.radius_to = radius;
                options.perturb = perturb;
                ASSERT_NO_FATAL_FAILURE(expect_insertion(generate(distribution, options)));
            }
}

/// Of numbers that fill the doubles' range, and whose sums therefore do not fit.
TEST_P(Swept, EqualsInsertionOnHugeAndTinyNumbers) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> unit(-1, 1);
    const double scales[] = {std::numeric_limits<double>::max(), 0x1p1001, 1.0, 0x1p-1000,
                             std::numeric_limits<double>::denorm_min() * 64};
    for (int trial = 0; trial < 1500 / share; ++trial) {
        const double scale = scales[trial % 5];
        const double other = trial % 3 == 0 ? scales[random() % 5] : scale;
        Sites sites(static_cast<std::size_t>(1 + trial % 200));
        for (Site& site : sites)
            site = {unit(random) * scale, unit(random) * other, unit(random) * scale};
        ASSERT_NO_FATAL_FAILURE(expect_insertion(sites)) << trial;
    }
}

TEST_P(Swept, ArithmeticAndCountingChangeNothing) {
    GenerateOptions generated;
    generated.count = 400;
    generated.radius_to = 30;
    for (const Distribution distribution : {Distribution::random, Distribution::grid}) {
        const Sites sites = generate(distribution, generated);
        Options options = sweeping();
        options.count = true;
        const Tessellation exact = triangulate(sites, GetParam(), options);
        EXPECT_GT(exact.statistics().filtered, sites.size());
        options.arithmetic = Arithmetic::multiprecision;
        const Tessellation rational = triangulate(sites, GetParam(), options);
        EXPECT_EQ(rational.arrays(), exact.arrays());
        EXPECT_EQ(rational.statistics().filtered, 0U);
        EXPECT_GT(rational.statistics().multiprecision, sites.size());
    }
}

/// On a grid sums of forms are exact, and no tie goes further than the filter, but for the
/// questions of a site whether it is hidden and by whom; with radii of a third they are not.
TEST_P(Swept, StageOfTies) {
    Sites sites;
    for (int x = 0; x < 30; ++x)
        for (int y = 0; y < 30; ++y) sites.push_back({double(x), double(y), double((x + y) % 2)});
    Options options = sweeping();
    options.count = true;
    const Statistics on_grid = triangulate(sites, GetParam(), options).statistics();
    EXPECT_GT(on_grid.ties, 3000U);
    EXPECT_LE(on_grid.exact, 900U + on_grid.nearer);
    EXPECT_EQ(on_grid.essa, 0U);
    for (Site& site : sites) site.r += 1.0 / 3;
    const Statistics shifted = triangulate(sites, GetParam(), options).statistics();
    EXPECT_GT(shifted.ties, 3000U);
    EXPECT_GT(shifted.essa, 3000U);
}

TEST(Sweep, KnowsWhereSumsAreExact) {
    const auto exact = [](const Sites& sites) { return rectangular::sums_are_exact(sites); };
    EXPECT_TRUE(exact({}));
    EXPECT_TRUE(exact({{0, -0.0, 0}}));
    EXPECT_TRUE(exact({{3, 1e9, 0.25}, {-7, 5, 0}}));
    EXPECT_FALSE(exact({{0.1, 0, 0}}));
    EXPECT_TRUE(exact({{0x1p47, 1, 0}}));
    EXPECT_FALSE(exact({{0x1p48, 1, 0}}));
    EXPECT_TRUE(exact({{0x1p-1074, 0x1p-1030, 0}}));
    EXPECT_FALSE(exact({{0x1p-1074, 0x1p-1020, 0}}));
    EXPECT_FALSE(exact({{0x1p1023, 0, 0}}));
    // Where it says so, eight forms of the greatest numbers sum without rounding.
    std::mt19937_64 random(3);
    int said = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        const int bits = 40 + trial % 12;
        const auto number = [&] {
            return std::ldexp(static_cast<double>(random() >> (64 - bits)) + 0.5, trial % 100);
        };
        const Sites sites = {{number(), number(), number()}};
        if (!exact(sites)) continue;
        ++said;
        const Site& s = sites[0];
        double sum = 0;
        long double reference = 0;
        for (int form = 0; form < 8; ++form)
            for (const double term : {s.x, s.y, s.r}) {
                sum += term;
                reference += static_cast<long double>(term);
                ASSERT_EQ(static_cast<long double>(sum), reference);
            }
    }
    EXPECT_GT(said, 300);
    EXPECT_LT(said, 2000);
}

TEST(Sweep, RefusesOtherMetrics) {
    const Sites sites = {{0, 0, 1}, {3, 0, 1}, {0, 3, 0}};
    EXPECT_THROW((void)triangulate(sites, Power{}, sweeping()), std::invalid_argument);
    EXPECT_THROW((void)triangulate(sites, Euclidean{}, sweeping()), std::invalid_argument);
}

TEST(Sweep, StopsWhenAsked) {
    GenerateOptions generated;
    generated.count = 20'000;
    const Sites sites = generate(Distribution::random, generated);
    std::stop_source source;
    Options options = sweeping();
    options.stop = source.get_token();
    double last = 0;
    options.progress = [&](double share_done) {
        EXPECT_GE(share_done, last);
        last = share_done;
        if (share_done > 0.5) source.request_stop();
    };
    EXPECT_THROW((void)triangulate(sites, Supremum{}, options), Stopped);
    EXPECT_GT(last, 0.5);
}

}  // namespace
