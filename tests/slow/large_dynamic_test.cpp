// A million insertions, deletions and changes of radius on ten thousand live sites, in every metric
// and on every distribution: now and then, and in the end, the tessellation is the one that the
// live sites make when they are built anew.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <tuple>
#include <vector>

#include "../../tool/generate/generate.hpp"
#include "../../triangulation/dynamic.hpp"
#include "../../triangulation/triangulate.hpp"

namespace signum {
namespace {

// Per case: so many operations after the first insertions, on about so many live sites, far enough
// below the next power of two, where the memory would grow and all be built anew.
#if defined(__SANITIZE_ADDRESS__) || !defined(__OPTIMIZE__)
constexpr int operations = 20'000;
constexpr int live_sites = 1'500;
#else
constexpr int operations = 1'000'000;
constexpr int live_sites = 10'000;
#endif
constexpr int checkpoints = 10;

struct Family {
    const char* name;
    Distribution distribution;
    std::int64_t supply;     ///< sites to draw from; of few, many equal ones are alive together
    double radius;           ///< the largest, in mean distances of neighbours
    bool are_radii_rounded;  ///< to multiples of a quarter of the largest: ties where centres allow
};
void PrintTo(const Family& family, std::ostream* out) {
    *out << family.name;
}

const Family families[] = {
    {"random", Distribution::random, operations, 0.5, false},
    {"random_of_small_radii", Distribution::random, operations, 0.01, false},
    {"grid", Distribution::grid, live_sites, 0.5, true},
    {"circle", Distribution::circle, operations, 0.5, false},
    {"square", Distribution::square, 2 * live_sites, 0.5, true},
};

std::vector<Site> supply_of(const Family& family) {
    const bool is_curve =
        family.distribution == Distribution::circle || family.distribution == Distribution::square;
    const double spacing = is_curve ? 2100.0 / live_sites : 700.0 / std::sqrt(1.0 * live_sites);
    GenerateOptions options;
    options.count = family.supply;
    options.radius_to = family.radius * spacing;
    options.seed = 23;
    std::vector<Site> sites = generate(family.distribution, options);
    const double step = options.radius_to / 4;
    if (family.are_radii_rounded)
        for (Site& s : sites) s.r = step * std::round(s.r / step);
    return sites;
}

class LargeDynamic : public testing::TestWithParam<std::tuple<Metric, Family>> {};

TEST_P(LargeDynamic, IsWhatAFreshBuildMakes) {
    const auto& [metric, family] = GetParam();
    const std::vector<Site> supply = supply_of(family);
    std::mt19937_64 random(47);
    const auto any = [&]() -> const Site& { return supply[random() % supply.size()]; };

    DynamicTessellation dynamic(metric);
    std::vector<std::optional<Site>> site_of;  // by handle
    std::vector<Index> live;
    const auto insert = [&](const Site& site) {
        const Index handle = dynamic.insert(site);
        const auto place = static_cast<std::size_t>(handle);
        if (place >= site_of.size()) site_of.resize(place + 1);
        ASSERT_FALSE(site_of[place]);
        site_of[place] = site;
        live.push_back(handle);
    };
    while (live.size() < live_sites) ASSERT_NO_FATAL_FAILURE(insert(any()));
    const std::size_t rebuilds = dynamic.rebuilds();

    for (int operation = 1; operation <= operations; ++operation) {
        const std::uint64_t kind = random() % 3;
        if (kind == 0 || live.empty()) {
            ASSERT_NO_FATAL_FAILURE(insert(any()));
        } else {
            Index& chosen = live[random() % live.size()];
            std::optional<Site>& site = site_of[static_cast<std::size_t>(chosen)];
            if (kind == 1) {
                dynamic.erase(chosen);
                site.reset();
                chosen = live.back();
                live.pop_back();
            } else {
                site->r = any().r;
                dynamic.change(chosen, site->r);
            }
        }
        if (operation % (operations / checkpoints) != 0) continue;
        std::vector<Site> sites;
        for (const std::optional<Site>& site : site_of)
            if (site) sites.push_back(*site);
        ASSERT_TRUE(dynamic.tessellation().arrays() == triangulate(sites, metric).arrays())
            << "after " << operation << " operations";
    }
    EXPECT_EQ(dynamic.rebuilds(), rebuilds);
}

INSTANTIATE_TEST_SUITE_P(All, LargeDynamic,
                         testing::Combine(testing::ValuesIn(all_metrics),
                                          testing::ValuesIn(families)),
                         [](const auto& info) {
                             return std::string(name_of(std::get<0>(info.param))) + "_" +
                                    std::get<1>(info.param).name;
                         });

}  // namespace
}  // namespace signum
