// What a validation asks grows with the sites, not with their square; and of sites in general
// position the filters leave nothing to the rationals. Counted, so that no clock is asked.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <tuple>
#include <vector>

#include "../../tool/generate/generate.hpp"
#include "../../triangulation/triangulate.hpp"
#include "../../triangulation/validate.hpp"
#include "../thoroughness.hpp"

namespace signum {
namespace {

// Exact numbers take their time under the sanitizers.
const int most_sites = is_fast ? 10000 : 1000;

struct Family {
    const char* name;
    /// A site of n, from its number and three random numbers in [0, 1).
    Site (*draw)(int i, int n, double u, double v, double w);
    /// Questions a site.
    double bound = 50;
};

Site at_angle(double turns, double distance, double radius) {
    const double angle = 2 * std::numbers::pi * turns;
    return {distance * std::cos(angle), distance * std::sin(angle), radius};
}

const std::array families = {
    // Squares of which a ring's outermost hide nearly all.
    Family{"ring", [](int, int, double u, double, double w) { return at_angle(u, 300, 60 * w); }},
    // One site has all others for neighbours; half of them it hides.
    Family{"hub",
           [](int i, int, double u, double v, double) {
               return i == 0       ? Site{0, 0, 1000}
                      : i % 2 == 0 ? at_angle(u, 1000.5, 1)
                                   : at_angle(u, 999 * v, 0.01);
           }},
    Family{"nested",
           [](int, int, double u, double v, double w) {
               return Site{u, v, 0.3 * w};
           }},
    Family{"identical",
           [](int, int, double, double, double) {
               return Site{1, 2, 3};
           }},
    // In the power metric the first site hides two of three, most of them far away. On a line each
    // round of the order in which they are looked for goes all the way, and rounds are as many as
    // the logarithm.
    Family{"far",
           [](int i, int n, double, double, double) {
               return Site{1.0 * i, 0.25 * (i % 2), n - i - 0.5 * (i % 3)};
           },
           80},
    // Beside their radii, three of which there are, all distances are nothing in doubles.
    Family{"heavy",
           [](int i, int, double u, double, double) {
               return Site{i % 100 * 0x1p-40, i / 100 * 0x1p-40, 1.0 + std::floor(3 * u)};
           }},
    Family{"tiny",
           [](int i, int, double u, double, double) {
               return Site{i % 100 * 0x1p-1074, i / 100 * 0x1p-1074,
                           0x1p-600 * (1.0 + std::floor(3 * u))};
           }},
    Family{"chain", [](int i, int, double, double, double) {
               return i % 3 == 0   ? Site{1.0 * i, 0, 0}
                      : i % 3 == 1 ? Site{1.0 * i, 0, 4}
                                   : Site{1.0 * i, -5, 1};
           }}};

std::vector<Site> draw(const Family& family, int n) {
    std::mt19937_64 bits(7);
    const auto real = [&] { return static_cast<double>(bits() >> 11) * 0x1p-53; };
    std::vector<Site> sites;
    for (int i = 0; i < n; ++i) {
        const double u = real();
        const double v = real();
        const double w = real();
        sites.push_back(family.draw(i, n, u, v, w));
    }
    return sites;
}

/// Questions a site.
double effort(const std::vector<Site>& sites, Metric metric) {
    const Validation v = validate(triangulate(sites, metric).arrays(), sites);
    EXPECT_TRUE(v.canonical) << v.message;
    return static_cast<double>(v.filtered + v.multiprecision) / static_cast<double>(sites.size());
}

class ValidateFamily : public testing::TestWithParam<std::tuple<Metric, Family>> {};

TEST_P(ValidateFamily, AsksInProportionToTheSites) {
    const auto& [metric, family] = GetParam();
    for (int n = most_sites; n >= 100; n /= 10)
        EXPECT_LT(effort(draw(family, n), metric), family.bound) << n << " sites";
}

INSTANTIATE_TEST_SUITE_P(
    , ValidateFamily, testing::Combine(testing::ValuesIn(all_metrics), testing::ValuesIn(families)),
    [](const testing::TestParamInfo<std::tuple<Metric, Family>>& info) {
        return std::string(name_of(std::get<0>(info.param))) + "_" + std::get<1>(info.param).name;
    });

class ValidateDistribution : public testing::TestWithParam<std::tuple<Metric, Distribution>> {};

TEST_P(ValidateDistribution, AsksInProportionToTheSites) {
    const auto [metric, distribution] = GetParam();
    for (const double largest : {0.0, 40.0}) {
        const std::vector<Site> sites =
            generate(distribution, {.count = most_sites, .radius_to = largest});
        EXPECT_LT(effort(sites, metric), 50) << "radii up to " << largest;
    }
}

INSTANTIATE_TEST_SUITE_P(, ValidateDistribution,
                         testing::Combine(testing::ValuesIn(all_metrics),
                                          testing::ValuesIn(all_distributions)),
                         [](const testing::TestParamInfo<std::tuple<Metric, Distribution>>& info) {
                             return std::string(name_of(std::get<0>(info.param))) + "_" +
                                    std::string(name_of(std::get<1>(info.param)));
                         });

TEST(ValidateRandom, FiltersLeaveNothingToExactNumbers) {
    for (const Metric metric : all_metrics)
        for (const double largest : {0.0, 3.0}) {
            const std::vector<Site> sites =
                generate(Distribution::random, {.count = most_sites, .radius_to = largest});
            const Validation v = validate(triangulate(sites, metric).arrays(), sites);
            EXPECT_TRUE(v.canonical) << v.message;
            // The hull's first direction has no filter.
            EXPECT_LT(v.multiprecision, sites.size() / 50) << name_of(metric);
        }
}

}  // namespace
}  // namespace signum
