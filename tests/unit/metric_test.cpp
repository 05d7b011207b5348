/// The table of metrics, and the names under which it is found.

#include "../../triangulation/metric.hpp"

#include <set>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

namespace signum {
namespace {

TEST(Metric, IsFoundByItsNamesHoweverWritten) {
    EXPECT_EQ(metric_named("power"), Metric::power);
    EXPECT_EQ(metric_named("Laguerre"), Metric::power);
    EXPECT_EQ(metric_named("EUCLIDEAN"), Metric::euclidean);
    EXPECT_EQ(metric_named("L1"), Metric::manhattan);
    EXPECT_EQ(metric_named("city-block"), Metric::manhattan);
    EXPECT_EQ(metric_named("L_inf"), Metric::supremum);
    EXPECT_EQ(metric_named("l-inf"), Metric::supremum);
    EXPECT_EQ(metric_named("Chebyshev"), Metric::supremum);
    EXPECT_EQ(metric_named("l3"), std::nullopt);
    EXPECT_EQ(metric_named("euclid"), std::nullopt);
    EXPECT_EQ(metric_named(""), std::nullopt);
    EXPECT_EQ(metric_named("-"), std::nullopt);
}

TEST(Metric, NamesAreDifferent) {
    std::set<std::string_view> names;
    for (const MetricTraits& traits : metric_table) {
        EXPECT_TRUE(names.insert(traits.name).second) << traits.name;
        EXPECT_EQ(metric_named(traits.name), traits.metric);
        for (const std::string_view alias : traits.aliases) {
            if (alias.empty()) continue;
            EXPECT_TRUE(names.insert(alias).second) << alias;
            EXPECT_EQ(metric_named(alias), traits.metric) << alias;
        }
    }
}

TEST(Metric, BecomesTheTypeOfItsRow) {
    for (const Metric metric : all_metrics)
        with_metric(metric, [&]<class M>(M) {
            EXPECT_EQ(M::metric, metric);
            EXPECT_EQ(M::traits.name, name_of(metric));
        });
    EXPECT_THROW(with_metric(static_cast<Metric>(all_metrics.size()), [](auto) {}),
                 std::invalid_argument);
}

}  // namespace
}  // namespace signum
