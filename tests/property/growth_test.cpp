/// Never slow: the calls that a construction makes grow with the sites, not with their square, on
/// few sites as on many. Counted, so that no clock is asked: predicates, and comparisons of two
/// distances, one for each neighbour that a walk looks at.

#include <array>
#include <cmath>
#include <span>
#include <string>
#include <tuple>

#include <gtest/gtest.h>

#include "../../tool/generate/generate.hpp"
#include "../../triangulation/triangulate.hpp"
#include "../../triangulation/validate.hpp"
#include "../thoroughness.hpp"
#include "adversarial_sites.hpp"

namespace signum {
namespace {

/// Calls a site.
double calls(const std::vector<Site>& sites, Metric metric, Method method) {
    const Statistics s = triangulate(sites, metric, {.method = method, .count = true}).statistics();
    return static_cast<double>(s.ccw + s.in_circle + s.nearer + s.others) /
           static_cast<double>(sites.size());
}

/// Quadratic were n/20 calls a site and more; random sites take 10 of in_circle.
constexpr double bound = 120;

/// The sizes tested, where there is no time all but the last.
std::span<const int> sizes() {
    static constexpr std::array<int, 2> all = {10'000, 100'000};
    return std::span(all).first(is_fast ? 2 : 1);
}

class Growth : public testing::TestWithParam<std::tuple<Metric, Distribution>> {};

TEST_P(Growth, CallsASiteStayBounded) {
    const auto [metric, distribution] = GetParam();
    for (const int n : sizes())
        EXPECT_LT(calls(generate(distribution, {.count = n}), metric, Method::incremental), bound)
            << n << " sites";
}

INSTANTIATE_TEST_SUITE_P(, Growth,
                         testing::Combine(testing::ValuesIn(all_metrics),
                                          testing::ValuesIn(all_distributions)),
                         [](const testing::TestParamInfo<Growth::ParamType>& info) {
                             return std::string(name_of(std::get<0>(info.param))) + "_" +
                                    std::string(name_of(std::get<1>(info.param)));
                         });

/// Weights that are squared lengths, far greater than any coordinate, and one cell in which half of
/// the sites are hidden.
TEST(GrowthOfJudgement, ComparisonsASiteStayBounded) {
    for (const int n : sizes()) {
        constexpr double unit = 0x1p28;
        const int most = static_cast<int>(std::sqrt(n / 2) / 2);
        std::vector<power::Site> sites;
        for (int i = -most; i <= most; ++i)
            for (int j = -most; j <= most; ++j)
                sites.push_back({i * unit, j * unit, (i * i + j * j + (i == 0 && j == 0)) * unit});
        for (int i = 0; i < n / 2; ++i) sites.push_back({static_cast<double>(i), 0, 0});
        const Validation judged = validate(triangulate(sites, Power{}));
        EXPECT_TRUE(judged.valid);
        EXPECT_LT(static_cast<double>(judged.filtered + judged.multiprecision), bound * n);
    }
}

class AdversarialGrowth : public testing::TestWithParam<std::tuple<Metric, adversarial::Family>> {};

TEST_P(AdversarialGrowth, CallsASiteStayBounded) {
    const auto& [metric, family] = GetParam();
    for (const int n : sizes()) {
        const std::vector<Site> sites = family.make(n);
        EXPECT_LT(calls(sites, metric, Method::incremental), bound) << n << " sites";
        if (traits_of(metric).has_sweep && n == 10'000) {
            EXPECT_LT(calls(sites, metric, Method::sweep), bound) << n << " sites";
        }
    }
}

INSTANTIATE_TEST_SUITE_P(, AdversarialGrowth,
                         testing::Combine(testing::ValuesIn(all_metrics),
                                          testing::ValuesIn(adversarial::families)),
                         [](const testing::TestParamInfo<AdversarialGrowth::ParamType>& info) {
                             return std::string(name_of(std::get<0>(info.param))) + "_" +
                                    std::string(std::get<1>(info.param).name);
                         });

}  // namespace
}  // namespace signum
