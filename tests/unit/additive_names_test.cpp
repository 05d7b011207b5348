// The functions that users call have the same names and meanings in the three additive metrics.

#include <gtest/gtest.h>

#include "../../predicates/euclidean.hpp"
#include "../../predicates/manhattan.hpp"
#include "../../predicates/supremum.hpp"

namespace {

using signum::Sign;
using signum::Site;

/// Sites on a circle around (0, 0): three of distance 5 in the metric, the fourth at `fourth`.
struct Example {
    Site i, j, k, far;
};

#define SIGNUM_NAMES_TEST(metric, ...)                                                      \
    TEST(AdditiveNames, metric) {                                                           \
        using namespace signum::metric;                                                     \
        const Example e{__VA_ARGS__};                                                       \
        ASSERT_TRUE(exists(e.i, e.j, e.k));                                                 \
        EXPECT_FALSE(exists(e.j, e.i, e.k));                                                \
        const auto moved = [&](double by) { return Site{e.far.x, e.far.y, e.far.r + by}; }; \
        EXPECT_EQ(in_circle(e.i, e.j, e.k, e.far), 0);                                      \
        EXPECT_EQ(in_circle(e.i, e.j, e.k, moved(0x1p-40)), 1);                             \
        EXPECT_EQ(in_circle(e.i, e.j, e.k, moved(-0x1p-40)), -1);                           \
        EXPECT_EQ(in_circle_perturbed(e.i, e.j, e.k, e.far, {0, 1, 2, 3}), -1);             \
        EXPECT_EQ(nearer({0, 0}, moved(1), e.i), 1);                                        \
        EXPECT_EQ(nearer({0, 0}, moved(-1), e.i), -1);                                      \
        EXPECT_TRUE(hidden(moved(-1), e.far));                                              \
        EXPECT_TRUE(hidden(e.far, e.far));                                                  \
        EXPECT_FALSE(hidden(e.far, moved(-1)));                                             \
        /* Sites on the left of a -> b, on the common line, beyond. */                      \
        const Site a{0, 0, 1};                                                              \
        const Site b{8, 1, 1};                                                              \
        EXPECT_EQ(in_circle_infinite(a, b, {4, 30, 1}), -1);                                \
        EXPECT_EQ(in_circle_infinite(a, b, {4, -30, 1}), 1);                                \
        EXPECT_EQ(in_circle_infinite_perturbed(a, b, {4, -30, 1}, {0, 1, 2}), 1);           \
    }

SIGNUM_NAMES_TEST(euclidean, {6, 0, 1}, {0, 7, 2}, {-5, 0, 0}, {3, -4, 0})
SIGNUM_NAMES_TEST(supremum, {6, 1, 1}, {1, 7, 2}, {-5, -1, 0}, {2, -5, 0})
SIGNUM_NAMES_TEST(manhattan, {4, 2, 1}, {-3, 4, 2}, {-2, -3, 0}, {3, -2, 0})

/// The hull edge's own line, or the border of its quadrant, is touched.
TEST(AdditiveNames, TouchingAtInfinityIsZero) {
    EXPECT_EQ(signum::euclidean::in_circle_infinite({0, 0, 1}, {8, 0, 2}, {16, 0, 3}), 0);
    EXPECT_EQ(signum::supremum::in_circle_infinite({0, 0, 1}, {8, 2, 1}, {4, 1, 0}), 0);
    EXPECT_EQ(signum::supremum::in_circle_infinite({0, 0, 1}, {8, 2, 1}, {4, 0.5, 0}), 1);
}

}  // namespace
