/// Never slow: the calls that a construction makes grow with the sites, not with their square, on
/// few sites as on many. Counted, so that no clock is asked: predicates, and comparisons of two
/// distances, one for each neighbour that a walk looks at.

#include <string>
#include <tuple>

#include <gtest/gtest.h>

#include "../../generate/generate.hpp"
#include "../../triangulation/triangulate.hpp"
#include "adversarial_sites.hpp"

namespace signum {
namespace {

#ifdef __SANITIZE_ADDRESS__
constexpr bool is_sanitized = true;
#else
constexpr bool is_sanitized = false;
#endif

/// Calls a site.
double calls(const std::vector<Site>& sites, Metric metric, Method method) {
    const Statistics s = triangulate(sites, metric, {.method = method, .count = true}).statistics();
    const std::uint64_t stages = s.filtered + s.refined + s.essa + s.multiprecision;
    return static_cast<double>(stages + s.nearer) / static_cast<double>(sites.size());
}

class Growth : public testing::TestWithParam<std::tuple<Metric, Distribution>> {};

TEST_P(Growth, CallsAreProportionalToSites) {
    const auto [metric, distribution] = GetParam();
    for (const std::int64_t n : {100, 300, 900, 3000, 20000}) {
        const std::vector<Site> sites = generate(distribution, {.count = n});
        const Statistics calls = triangulate(sites, metric, {.count = true}).statistics();
        // Random sites take 10; stars of many sites, on circles and squares, a few times as many.
        EXPECT_LT(calls.in_circle, 50 * static_cast<std::uint64_t>(n)) << n << " sites";
    }
}

INSTANTIATE_TEST_SUITE_P(, Growth,
                         testing::Combine(testing::ValuesIn(all_metrics),
                                          testing::ValuesIn(all_distributions)),
                         [](const testing::TestParamInfo<Growth::ParamType>& info) {
                             return std::string(name_of(std::get<0>(info.param))) + "_" +
                                    std::string(name_of(std::get<1>(info.param)));
                         });

class AdversarialGrowth : public testing::TestWithParam<std::tuple<Metric, adversarial::Family>> {};

TEST_P(AdversarialGrowth, CallsASiteStayBounded) {
    const auto& [metric, family] = GetParam();
    const bool has_sweep = metric == Metric::manhattan || metric == Metric::supremum;
    for (const int n : {10'000, 100'000}) {
        if (is_sanitized && n > 10'000) break;
        const std::vector<Site> sites = family.make(n);
        // Quadratic were n/20 calls and more.
        EXPECT_LT(calls(sites, metric, Method::incremental), 160) << n << " sites";
        if (has_sweep && n == 10'000) {
            EXPECT_LT(calls(sites, metric, Method::sweep), 160) << n << " sites";
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
