// All arithmetics: the exact ones build the same arrays, by insertion and by the sweep, and the
// stage that an arithmetic is named for is the one that answers; single precision gets wrong edges,
// and refuses what it cannot hold.

#include "../../triangulation/triangulate.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "../../triangulation/validate.hpp"

#include "../thoroughness.hpp"
#include "degenerate_sites.hpp"

namespace {

using namespace signum;
using Sites = std::vector<Site>;

const int share = is_fast ? 1 : 10;  // of the trials one in so many

constexpr Arithmetic others[] = {Arithmetic::interval, Arithmetic::sum, Arithmetic::multiprecision};

Sites grid(int side, double step, double third) {
    Sites sites;
    for (int x = 0; x < side; ++x)
        for (int y = 0; y < side; ++y)
            sites.push_back({x * step, y * step, (x * 5 + y * 3) % 4 * third});
    return sites;
}

/// Rounded points of a circle: nearly cocircular, all of them.
Sites circle(int count, double radius, double third) {
    Sites sites;
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * std::numbers::pi * i / count;
        sites.push_back({radius * std::cos(angle), radius * std::sin(angle), i % 3 * third});
    }
    return sites;
}

struct Build {
    Metric metric;
    Method method = Method::incremental;
};

class Arithmetics : public testing::TestWithParam<Build> {
 public:
    static Tessellation build(const Sites& sites, Arithmetic arithmetic) {
        Options options;
        options.arithmetic = arithmetic;
        options.method = GetParam().method;
        options.count = true;
        return triangulate(sites, GetParam().metric, options);
    }
    static void expect_agreement(const Sites& sites) {
        const Tessellation exact = build(sites, Arithmetic::exact);
        for (const Arithmetic arithmetic : others)
            ASSERT_EQ(build(sites, arithmetic).arrays(), exact.arrays()) << name_of(arithmetic);
    }
};

INSTANTIATE_TEST_SUITE_P(Builds, Arithmetics,
                         testing::Values(Build{Metric::power}, Build{Metric::euclidean},
                                         Build{Metric::manhattan}, Build{Metric::supremum},
                                         Build{Metric::manhattan, Method::sweep},
                                         Build{Metric::supremum, Method::sweep}),
                         [](const auto& info) {
                             return std::string(name_of(info.param.metric)) + "_" +
                                    std::string(name_of(info.param.method));
                         });

TEST_P(Arithmetics, ExactOnesAgreeInDegeneratePositions) {
    brute_force::Degenerate degenerate(11);
    for (int trial = 0; trial < 900 / share; ++trial) {
        Sites sites(static_cast<std::size_t>(1 + trial % 37));
        degenerate.fill(trial % brute_force::Degenerate::families, sites.data(), sites.size());
        // Thirds take the numbers out of small integers, and ties apart by a rounding.
        if (trial % 2 == 1)
            for (Site& s : sites) s = {s.x / 3, s.y / 3, s.r / 3};
        ASSERT_NO_FATAL_FAILURE(expect_agreement(sites)) << trial;
    }
}

TEST_P(Arithmetics, ExactOnesAgreeOnGridsAndCircles) {
    for (const double scale : {1.0, 1.0 / 3, 0x1p-530, 0x1.8p300})
        for (const double third : {0.0, 0.25 * scale}) {
            ASSERT_NO_FATAL_FAILURE(expect_agreement(grid(is_fast ? 9 : 5, scale, third))) << scale;
            ASSERT_NO_FATAL_FAILURE(expect_agreement(circle(is_fast ? 60 : 24, 100 * scale, third)))
                << scale;
        }
}

/// Of numbers that fill the doubles' range: what the window of a stage does not hold is decided in
/// rationals.
TEST_P(Arithmetics, ExactOnesAgreeOnHugeAndTinyNumbers) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> unit(-1, 1);
    const double scales[] = {std::numeric_limits<double>::max(),
                             0x1p1001,
                             1.0,
                             0x1p-520,
                             0x1p-1000,
                             std::numeric_limits<double>::denorm_min() * 64};
    for (int trial = 0; trial < 300 / share; ++trial) {
        const double scale = scales[trial % 6];
        const double other = trial % 5 == 0 ? scales[random() % 6] : scale;
        Sites sites(static_cast<std::size_t>(1 + trial % 23));
        for (Site& site : sites)
            site = {unit(random) * scale, unit(random) * other, unit(random) * scale};
        ASSERT_NO_FATAL_FAILURE(expect_agreement(sites)) << trial;
    }
}

/// Ties, near ties and neither.
std::vector<Sites> counted_sets() {
    return {grid(12, 1, 0), grid(12, 1, 0.25), grid(12, 1.0 / 3, 0.1), circle(100, 10, 0.1)};
}

TEST_P(Arithmetics, SumAsksEssaAlone) {
    for (const Sites& sites : counted_sets()) {
        const Statistics s = build(sites, Arithmetic::sum).statistics();
        EXPECT_GT(s.essa, sites.size());
        EXPECT_EQ(s.filtered + s.refined + s.exact + s.multiprecision, 0U);
    }
}

TEST_P(Arithmetics, IntervalAsksEssaWhereIntervalsLeaveItOpen) {
    for (const Sites& sites : counted_sets()) {
        const Statistics s = build(sites, Arithmetic::interval).statistics();
        EXPECT_GT(s.filtered, sites.size());
        EXPECT_GT(s.essa, 0U);
        EXPECT_EQ(s.refined + s.exact + s.multiprecision, 0U);
    }
}

TEST_P(Arithmetics, MultiprecisionAsksRationalsAlone) {
    for (const Sites& sites : counted_sets()) {
        const Statistics s = build(sites, Arithmetic::multiprecision).statistics();
        EXPECT_GT(s.multiprecision, sites.size());
        EXPECT_EQ(s.filtered + s.refined + s.exact + s.essa, 0U);
    }
}

TEST_P(Arithmetics, IntervalsDecideNearlyAllOnRandomSites) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> place(0, 700);
    std::uniform_real_distribution<double> radius(1, 10);
    Sites sites(1000 / share);
    for (Site& site : sites) site = {place(random), place(random), radius(random)};
    const Statistics s = build(sites, Arithmetic::interval).statistics();
    // Sides of one site, equal to themselves, and ends of the front are ties.
    EXPECT_LT(s.essa, s.filtered / 20);
    ASSERT_NO_FATAL_FAILURE(expect_agreement(sites));
}

/// Out of the window of products multiprecision takes over; sums of forms have none.
TEST_P(Arithmetics, MultiprecisionTakesOverOutOfTheWindow) {
    const bool has_window =
        GetParam().metric == Metric::power || GetParam().metric == Metric::euclidean;
    Sites sites = grid(4, 0x1p300, 0x1p298);
    sites.push_back({0x1p-300, 0x1p-310, 0});
    sites.push_back({0x1p300, 0x1p-310, 0});
    for (const Arithmetic arithmetic : {Arithmetic::interval, Arithmetic::sum}) {
        const Statistics s = build(sites, arithmetic).statistics();
        EXPECT_EQ(s.multiprecision > 0, has_window) << name_of(arithmetic);
    }
    ASSERT_NO_FATAL_FAILURE(expect_agreement(sites));
}

TEST_P(Arithmetics, RoundedOnesAskNoOtherStage) {
    for (const Arithmetic arithmetic : {Arithmetic::naive, Arithmetic::single}) {
        const Statistics s = build(grid(12, 1, 0.25), arithmetic).statistics();
        EXPECT_EQ(s.refined + s.exact + s.essa + s.multiprecision, 0U) << name_of(arithmetic);
        EXPECT_GT(s.filtered, 0U);
    }
}

TEST_P(Arithmetics, JudgingIsNoneOfConstructions) {
    EXPECT_THROW((void)build({{0, 0, 1}, {5, 0, 1}, {0, 7, 2}}, Arithmetic::judging),
                 std::invalid_argument);
}

TEST_P(Arithmetics, SingleRefusesWhatFloatsDoNotHold) {
    const Sites sites = {{0, 0, 1}, {5, 0, 1}, {0, 1e39, 1}};
    try {
        (void)build(sites, Arithmetic::single);
        FAIL();
    } catch (const std::invalid_argument& error) {
        EXPECT_EQ(std::string(error.what()), "site 2 is beyond single precision, 3.4e38");
    }
    EXPECT_EQ(build({{0, 0, 1}, {5, 0, 1}, {0, 3e38, 1}}, Arithmetic::single).hidden().size(), 0U);
}

/// Sites that agree in floats are the same one.
TEST_P(Arithmetics, SingleRoundsTheSites) {
    const Sites sites = {{0, 0, 1}, {5, 0, 1}, {0, 7, 1}, {5 + 1e-12, 0, 1}};
    EXPECT_EQ(build(sites, Arithmetic::naive).hidden().size(), 0U);
    const Tessellation rounded = build(sites, Arithmetic::single);
    ASSERT_EQ(rounded.hidden().size(), 1U);
    EXPECT_EQ(rounded.hidden()[0], (Hidden{3, 1}));
}

class OnACircle : public testing::TestWithParam<Metric> {};
INSTANTIATE_TEST_SUITE_P(Metrics, OnACircle, testing::Values(Metric::power, Metric::euclidean),
                         [](const auto& info) { return std::string(name_of(info.param)); });

TEST_P(OnACircle, SingleGetsWrongEdges) {
    Sites sites = circle(400, 350, 0);
    for (std::size_t i = 0; i < sites.size(); ++i) sites[i].r = 1 + static_cast<double>(i % 7) / 64;
    const auto is_valid = [&](Arithmetic arithmetic) {
        const Tessellation t = triangulate(sites, GetParam(), {.arithmetic = arithmetic});
        return validate(t.arrays(), sites).valid;
    };
    EXPECT_TRUE(is_valid(Arithmetic::exact));
    EXPECT_TRUE(is_valid(Arithmetic::interval));
    EXPECT_TRUE(is_valid(Arithmetic::sum));
    EXPECT_FALSE(is_valid(Arithmetic::single));
}

TEST(Arithmetic, HasNames) {
    std::string names;
    for (const Arithmetic arithmetic : all_arithmetics)
        names += std::string(name_of(arithmetic)) + " ";
    EXPECT_EQ(names, "exact naive single interval sum multiprecision ");
    EXPECT_TRUE(is_exact(Arithmetic::exact));
    EXPECT_TRUE(is_exact(Arithmetic::interval));
    EXPECT_TRUE(is_exact(Arithmetic::sum));
    EXPECT_TRUE(is_exact(Arithmetic::multiprecision));
    EXPECT_FALSE(is_exact(Arithmetic::naive));
    EXPECT_FALSE(is_exact(Arithmetic::single));
}

TEST(Arithmetic, FlipsHaveTheExactOneAlone) {
    const Sites sites = {{0, 0, 1}, {5, 0, 1}, {0, 7, 2}};
    for (const Arithmetic arithmetic : all_arithmetics) {
        const Options options = {.arithmetic = arithmetic, .method = Method::flips};
        if (arithmetic == Arithmetic::exact) {
            EXPECT_EQ(triangulate(sites, Power{}, options).faces().size(), 4U);
        } else {
            EXPECT_THROW((void)triangulate(sites, Power{}, options), std::invalid_argument);
        }
    }
}

}  // namespace
