#include "../../tool/study/timing.hpp"

#include <numeric>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace {

using namespace signum::study;

TEST(Timing, MedianAndInterval) {
    const Interval one = median_of({3.0});
    EXPECT_EQ(one.median, 3.0);
    EXPECT_EQ(one.low, 3.0);
    EXPECT_EQ(one.runs, 1U);
    EXPECT_EQ(median_of({4, 1, 3, 2}).median, 2.5);
    // Six values: the extremes hold the median with 1 - 2/64; with nine the second and the eighth
    // do.
    const Interval six = median_of({6, 5, 4, 3, 2, 1});
    EXPECT_EQ(six.low, 1);
    EXPECT_EQ(six.high, 6);
    const Interval nine = median_of({9, 8, 7, 6, 5, 4, 3, 2, 1});
    EXPECT_EQ(nine.low, 2);
    EXPECT_EQ(nine.high, 8);
}

TEST(Timing, TheIntervalHoldsTheTrueMedian) {
    std::mt19937_64 random(1);
    std::exponential_distribution<double> value(1.0);
    const double truth = 0.6931471805599453;
    for (const std::size_t runs : {6U, 11U, 21U}) {
        int held = 0;
        for (int trial = 0; trial < 4000; ++trial) {
            std::vector<double> values(runs);
            for (double& v : values) v = value(random);
            const Interval interval = median_of(values);
            held += static_cast<int>(interval.low <= truth && truth <= interval.high);
        }
        EXPECT_GT(held, 3800) << runs;
    }
}

TEST(Timing, ContestantsTakeTurns) {
    std::vector<int> order;
    const std::vector<Contestant> contestants = {[&] {
                                                     order.push_back(0);
                                                     return 2.0;
                                                 },
                                                 [&] {
                                                     order.push_back(1);
                                                     return 6.0;
                                                 }};
    const Race result = race(contestants, {.least_rounds = 3, .most_rounds = 3, .seconds = 0});
    EXPECT_EQ(order, (std::vector<int>{0, 1, 1, 0, 0, 1}));
    EXPECT_EQ(result.seconds[1].median, 6.0);
    EXPECT_EQ(result.ratios[1].median, 3.0);
    EXPECT_EQ(result.ratios[0].low, 1.0);
    EXPECT_EQ(result.seconds[0].runs, 3U);
}

}  // namespace
