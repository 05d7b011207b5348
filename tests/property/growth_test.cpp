/// Never slow: the calls that a construction makes grow with the sites, not with their square, on
/// few sites as on many. Counted, so that no clock is asked.

#include <string>
#include <tuple>

#include <gtest/gtest.h>

#include "../../generate/generate.hpp"
#include "../../triangulation/triangulate.hpp"

namespace signum {
namespace {

using Case = std::tuple<Metric, Distribution>;

class Growth : public testing::TestWithParam<Case> {};

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
                         [](const testing::TestParamInfo<Case>& info) {
                             return std::string(name_of(std::get<0>(info.param))) + "_" +
                                    std::string(name_of(std::get<1>(info.param)));
                         });

}  // namespace
}  // namespace signum
