// A hundred thousand sites of every distribution in the metrics with additive weights, validated
// from scratch; a million of them, inserted and swept; naive arithmetic, which has to end.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

#include "../../tool/generate/generate.hpp"
#include "../../triangulation/triangulate.hpp"
#include "../../triangulation/validate.hpp"

namespace signum {
namespace {

#if defined(__SANITIZE_ADDRESS__) || !defined(__OPTIMIZE__)
constexpr std::int64_t million = 50'000;
constexpr std::int64_t hundred_thousand = 5'000;
#else
constexpr std::int64_t million = 1'000'000;
constexpr std::int64_t hundred_thousand = 100'000;
#endif

struct Kind {
    const char* name;
    Distribution distribution;
    double radius;        ///< the largest, in mean distances of neighbours
    double least_hidden;  ///< the share of hidden sites that is expected in every metric
    double most_hidden;
};
const Kind kinds[] = {
    {"random", Distribution::random, 0.1, 0, 0.05},
    {"hidden", Distribution::random, 1.6, 0.2, 0.5},
    {"circle", Distribution::circle, 0.01, 0, 0.05},
    {"square", Distribution::square, 0.01, 0, 0.05},
    {"grid", Distribution::grid, 0, 0, 0},
    {"grid_of_two_radii", Distribution::grid, 0, 0, 0},
};

std::vector<Site> sites_of(const Kind& kind, std::int64_t count) {
    const double spacing = 700.0 / std::sqrt(static_cast<double>(count));
    const bool is_curve =
        kind.distribution == Distribution::circle || kind.distribution == Distribution::square;
    GenerateOptions options;
    options.count = count;
    options.radius_to = kind.radius * (is_curve ? 2100.0 / static_cast<double>(count) : spacing);
    options.seed = 17;
    std::vector<Site> sites = generate(kind.distribution, options);
    if (std::string(kind.name) == "grid_of_two_radii")
        for (std::size_t i = 0; i < sites.size(); i += 2) sites[i].r = 0.25 * spacing;
    return sites;
}

template <class Metric>
class LargeAdditive : public testing::Test {};
using Metrics = testing::Types<Euclidean, Manhattan, Supremum>;
TYPED_TEST_SUITE(LargeAdditive, Metrics);

TYPED_TEST(LargeAdditive, AHundredThousandValidated) {
    for (const Kind& kind : kinds) {
        const auto sites = sites_of(kind, hundred_thousand);
        Options options;
        options.seed = 3;
        const Tessellation t = triangulate(sites, TypeParam{}, options);
        const double hidden =
            static_cast<double>(t.hidden().size()) / static_cast<double>(sites.size());
        EXPECT_GE(hidden, kind.least_hidden) << kind.name;
        EXPECT_LE(hidden, kind.most_hidden) << kind.name;
        const Validation v = validate(t.arrays(), sites);
        EXPECT_TRUE(v.valid && v.canonical) << kind.name << ": " << v.message;
    }
}

TYPED_TEST(LargeAdditive, AMillionSitesInTwoOrdersAndSwept) {
    for (const Kind& kind : kinds) {
        const auto sites = sites_of(kind, million);
        Options options;
        const Tessellation t = triangulate(sites, TypeParam{}, options);
        EXPECT_EQ(t.faces().size(), 2 * (sites.size() - t.hidden().size()) - 2) << kind.name;
        options.seed = 99;
        EXPECT_EQ(triangulate(sites, TypeParam{}, options).arrays(), t.arrays()) << kind.name;
        if (std::is_same_v<TypeParam, Euclidean>) continue;
        options.method = Method::sweep;
        EXPECT_EQ(triangulate(sites, TypeParam{}, options).arrays(), t.arrays()) << kind.name;
    }
}

TYPED_TEST(LargeAdditive, NaiveArithmeticEnds) {
    int ended = 0;
    for (const Kind& kind : kinds) {
        const auto sites = sites_of(kind, hundred_thousand);
        Options options;
        options.arithmetic = Arithmetic::naive;
        try {
            ended += static_cast<int>(triangulate(sites, TypeParam{}, options).sites().size() ==
                                      sites.size());
        } catch (const BrokenStructure& broken) {
            ++ended;
            EXPECT_FALSE(std::string(broken.what()).empty());
        }
    }
    EXPECT_EQ(ended, 6);
}

}  // namespace
}  // namespace signum
