/// The order of faces along the curve: the same tessellation as by index, in an order that depends
/// on the sites alone.

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "../../tool/generate/generate.hpp"
#include "../../triangulation/structure/spatial_order.hpp"
#include "../../triangulation/triangulate.hpp"
#include "../../triangulation/validate.hpp"

namespace signum {
namespace {

std::vector<Site> sites_of(int family, std::int64_t count) {
    const double spacing = 700.0 / std::sqrt(static_cast<double>(std::max<std::int64_t>(count, 1)));
    if (family < static_cast<int>(all_distributions.size()))
        return generate(all_distributions[static_cast<std::size_t>(family)],
                        {.count = count, .radius_to = family % 2 == 0 ? spacing : 0.0});
    if (family == 8) return generate_hard({.count = count});
    std::vector<Site> sites = generate(Distribution::random, {.count = count});
    if (family == 9)  // on a line, many of them in one place
        for (Site& site : sites) site.x = site.y = std::floor(site.x / 8.0);
    if (family == 10)  // a crowd, and one far away
        for (std::size_t i = 1; i < sites.size(); ++i) sites[i].x *= 0x1p-60, sites[i].y *= 0x1p-60;
    return sites;
}
constexpr int families = 11;

/// From the definition: infinity, or else the first along the curve first, and so sorted.
void expect_in_order(const Tessellation& tessellation, const std::string& what) {
    const auto ranks = triangulation::ranks_along_curve(tessellation.sites(), Workers(1));
    std::vector<Face> by_rank;
    for (const Face& face : tessellation.faces()) {
        Face of = face;
        for (Index& v : of) v = v == infinite ? infinite : ranks[static_cast<std::size_t>(v)];
        EXPECT_EQ(std::ranges::min(of), of[0]) << what;
        by_rank.push_back(of);
    }
    EXPECT_TRUE(std::ranges::is_sorted(by_rank)) << what;
}

TEST(Order, AlongTheCurveIsThatByIndexRearranged) {
    for (const Metric metric : all_metrics)
        for (int family = 0; family < families; ++family)
            for (const std::int64_t count : {0, 1, 2, 3, 40, 3000}) {
                const std::string what = std::string(name_of(metric)) + " " +
                                         std::to_string(family) + " " + std::to_string(count);
                const std::vector<Site> sites = sites_of(family, count);
                const Tessellation by_index = triangulate(sites, metric);
                const Tessellation along = triangulate(sites, metric, {.order = Order::curve});
                EXPECT_EQ(along.arrays().order, Order::curve);
                EXPECT_EQ(ordered_by_index(along.arrays()), by_index.arrays()) << what;
                expect_in_order(along, what);
                const Validation said = validate(along.arrays(), sites);
                EXPECT_TRUE(said.valid && said.canonical) << what << ": " << said.message;
            }
}

TEST(Order, IsTheSameForEveryMethodSeedAndNumberOfThreads) {
    for (const Metric metric : all_metrics)
        for (int family = 0; family < families; ++family) {
            const std::vector<Site> sites = sites_of(family, 40'000);
            const Options options{.order = Order::curve, .threads = 1};
            const TessellationArrays one = triangulate(sites, metric, options).arrays();
            for (const int threads : {2, 3, 7})
                EXPECT_EQ(triangulate(sites, metric,
                                      {.seed = 7, .order = Order::curve, .threads = threads})
                              .arrays(),
                          one)
                    << name_of(metric) << " " << family << " " << threads;
        }
    const std::vector<Site> sites = sites_of(0, 2000);
    for (const Metric metric : all_metrics)
        for (const Method method : all_methods)
            if (builds(method, metric)) {
                EXPECT_EQ(
                    triangulate(sites, metric, {.method = method, .order = Order::curve}).arrays(),
                    triangulate(sites, metric, {.order = Order::curve}).arrays());
            }
}

TEST(Order, DoesNotDependOnTheRoundingMode) {
    const std::vector<Site> sites = sites_of(0, 3000);
    const auto ranks = [&] {
        return triangulate(sites, Power{}, {.order = Order::curve}).arrays();
    };
    const TessellationArrays to_nearest = ranks();
    for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
        std::fesetround(mode);
        const TessellationArrays rounded = ranks();
        std::fesetround(FE_TONEAREST);
        EXPECT_EQ(rounded, to_nearest);
    }
}

/// Arrays in one order that say they are in the other one.
TEST(Order, IsJudged) {
    const std::vector<Site> sites = sites_of(0, 500);
    for (const Metric metric : all_metrics)
        for (const Order order : all_orders) {
            TessellationArrays arrays = triangulate(sites, metric, {.order = order}).arrays();
            arrays.order = order == Order::index ? Order::curve : Order::index;
            const Validation said = validate(arrays, sites);
            EXPECT_TRUE(said.valid && !said.canonical) << said.message;
        }
}

/// Sites that were given in another order have the same faces, one after the other, where no two
/// lie in one place.
TEST(Order, DoesNotDependOnTheNumbersOfSites) {
    const std::vector<Site> sites = sites_of(0, 3000);
    std::vector<std::size_t> shuffled(sites.size());
    std::iota(shuffled.begin(), shuffled.end(), std::size_t{0});
    std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937(1));
    std::vector<Site> others;
    for (const std::size_t i : shuffled) others.push_back(sites[i]);
    const Tessellation a = triangulate(sites, Euclidean{}, {.order = Order::curve});
    const Tessellation b = triangulate(others, Euclidean{}, {.order = Order::curve});
    ASSERT_EQ(a.faces().size(), b.faces().size());
    for (std::size_t f = 0; f < a.faces().size(); ++f)
        for (std::size_t k = 0; k < 3; ++k) {
            const Index v = b.faces()[f][k];
            ASSERT_EQ(a.faces()[f][k],
                      v == infinite ? infinite
                                    : static_cast<Index>(shuffled[static_cast<std::size_t>(v)]));
        }
}

}  // namespace
}  // namespace signum
