/// Tessellations from parts are those from the whole: of sites made to be on cuts, to reach across
/// them, to hide one another from beyond them, and to be tied everywhere.

#include <cmath>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "../../tool/generate/generate.hpp"
#include "../../triangulation/construction/construct.hpp"
#include "../../triangulation/triangulate.hpp"
#include "../thoroughness.hpp"
#include "adversarial_sites.hpp"
#include "degenerate_sites.hpp"
#include "sites_across_cuts.hpp"

namespace signum {
namespace {

using brute_force::Random;

/// Compares those of cuts in 1 to `levels` levels with that of one insertion after the other, which
/// is known to be that of oracles.
void expect_the_same(const StridedSites& sites, Metric metric, int levels,
                     const std::string& what) {
    const Tessellation whole = triangulation::construct_in_parts(metric, sites, {}, 0);
    for (int level = 1; level <= levels; ++level)
        for (const std::uint64_t seed : {1, 7})
            ASSERT_EQ(
                triangulation::construct_in_parts(metric, sites, {.seed = seed}, level).arrays(),
                whole.arrays())
                << what << ", " << level << " levels, seed " << seed;
}

class Parts : public testing::TestWithParam<Metric> {};

TEST_P(Parts, OfFewDegenerateSites) {
    for (int trial = 0; trial < 400 * thoroughness; ++trial) {
        brute_force::Degenerate degenerate(static_cast<std::uint64_t>(trial));
        std::vector<Site> sites(static_cast<std::size_t>(degenerate.random().between(1, 40)));
        degenerate.fill(trial % brute_force::Degenerate::families, sites.data(), sites.size());
        expect_the_same(sites, GetParam(), 3, "trial " + std::to_string(trial));
        if (HasFatalFailure()) return;
    }
}

/// Small integers with giants among them: so many sites that parts have an inside of their own.
TEST_P(Parts, OfManyDegenerateSites) {
    for (int trial = 0; trial < 15 * thoroughness; ++trial) {
        const std::vector<Site> sites = brute_force::integers_and_giants(trial);
        expect_the_same(sites, GetParam(), 4, "trial " + std::to_string(trial));
        if (HasFatalFailure()) return;
    }
}

/// One half of the sites weighs so much more than the other that it takes from it what lies far
/// beyond the cut, and hides what is there.
TEST_P(Parts, WhereOneSideHidesTheOther) {
    for (int trial = 0; trial < 15 * thoroughness; ++trial) {
        std::vector<Site> sites = brute_force::one_side_hides_the_other(trial);
        expect_the_same(sites, GetParam(), 4, "trial " + std::to_string(trial));
        const bool has_weights = traits_of(GetParam()).has_weights;
        if (has_weights)
            for (Site& site : sites) site.r *= -site.r;
        expect_the_same({sites, has_weights}, GetParam(), 4,
                        "trial " + std::to_string(trial) + ", weights");
        if (HasFatalFailure()) return;
    }
}

TEST_P(Parts, OfHostileFamilies) {
    for (const adversarial::Family& family : adversarial::families) {
        expect_the_same(family.make(is_fast ? 4000 : 800), GetParam(), 4, std::string(family.name));
        if (HasFatalFailure()) return;
    }
}

TEST_P(Parts, OfDistributions) {
    for (const Distribution distribution : all_distributions)
        for (const double radius : {0.0, 0.5, 9.0}) {
            expect_the_same(generate(distribution, {.count = is_fast ? 6000 : 1500,
                                                    .radius_from = radius / 3,
                                                    .radius_to = radius}),
                            GetParam(), 4, std::string(name_of(distribution)));
            if (HasFatalFailure()) return;
        }
}

/// Huge and tiny: beyond the filters' windows, and beyond a double's range in between.
TEST_P(Parts, OfAnyMagnitude) {
    for (int exponent = -1060; exponent <= 1012; exponent += exponent == -1060 ? 40 : 37) {
        const std::vector<Site> sites = brute_force::sites_of_magnitude(exponent, 400);
        expect_the_same(sites, GetParam(), 2, "2^" + std::to_string(exponent));
        if (HasFatalFailure()) return;
    }
}

/// Ordinary sites, and as many in a crowd around one of them that is that much smaller: offsets
/// there are far below what a coordinate elsewhere is rounded to, and their products underflow.
TEST_P(Parts, OfACrowdOfAnyMagnitude) {
    for (int exponent = -1060; exponent < 0; exponent += 53)
        for (const double radius : {0.0, 1.0}) {
            Random random(6);
            std::vector<Site> sites;
            for (int i = 0; i < 400; ++i) {
                const int scale = i % 2 == 0 ? exponent : -5;
                sites.push_back({std::ldexp(random.between(-1000, 1000), scale),
                                 std::ldexp(random.between(-1000, 1000), scale),
                                 radius * std::ldexp(random.between(0, 20), scale)});
            }
            expect_the_same(sites, GetParam(), 3, "2^" + std::to_string(exponent));
            if (HasFatalFailure()) return;
        }
}

INSTANTIATE_TEST_SUITE_P(, Parts, testing::ValuesIn(all_metrics),
                         [](const testing::TestParamInfo<Metric>& info) {
                             return std::string(name_of(info.param));
                         });

/// The same bytes, however many threads.
class Threads : public testing::TestWithParam<std::tuple<Metric, Distribution>> {};

TEST_P(Threads, TellTheSame) {
    const auto [metric, distribution] = GetParam();
    const std::vector<Site> sites =
        generate(distribution, {.count = is_fast ? 60'000 : 20'000, .radius_to = 0.5});
    const Tessellation one = triangulate(sites, metric, {.threads = 1});
    for (const int threads : {2, 3, 7, 16})
        ASSERT_EQ(triangulate(sites, metric, {.threads = threads}).arrays(), one.arrays())
            << threads << " threads";
}

INSTANTIATE_TEST_SUITE_P(, Threads,
                         testing::Combine(testing::ValuesIn(all_metrics),
                                          testing::ValuesIn(all_distributions)),
                         [](const testing::TestParamInfo<Threads::ParamType>& info) {
                             return std::string(name_of(std::get<0>(info.param))) + "_" +
                                    std::string(name_of(std::get<1>(info.param)));
                         });

}  // namespace
}  // namespace signum
