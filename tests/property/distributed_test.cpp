/// Tessellations from parts that tell one another what they must know are those of the whole: in
/// every metric, of sites made to be on cuts, to reach across them, to hide one another from beyond
/// them, and to be tied everywhere; with more parts than sites, and parts without any.

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "../../tool/generate/generate.hpp"
#include "../../triangulation/triangulate.hpp"
#include "../thoroughness.hpp"
#include "adversarial_sites.hpp"
#include "degenerate_sites.hpp"
#include "in_parts.hpp"
#include "sites_across_cuts.hpp"

namespace signum {
namespace {

using brute_force::Random;

/// Whether the sites have a structure that parts can share: faces that are not all at infinity, in
/// the power metric, or any.
bool has_structure(const TessellationArrays& whole) {
    if (whole.faces.empty()) return false;
    return !traits_of(whole.metric).edges_are_straight || whole.faces.back()[0] != infinite;
}

void expect_the_same(const StridedSites& sites, Metric metric, std::span<const std::size_t> parts,
                     const std::string& what, std::int64_t first_id = 0) {
    const TessellationArrays whole = triangulate(sites, metric, {.threads = 1}).arrays();
    std::vector<distributed::Placed> placed;
    for (std::size_t i = 0; i < sites.size(); ++i)
        placed.push_back({sites[i], first_id + static_cast<std::int64_t>(i)});
    for (const std::size_t count : parts) {
        if (!has_structure(whole)) {
            EXPECT_THROW(static_cast<void>(distributed::settle_in_parts(
                             placed, {metric, whole.weight_is}, count)),
                         distributed::NoStructure)
                << what;
            continue;
        }
        distributed::WholeParts found =
            distributed::settle_in_parts(placed, {metric, whole.weight_is}, count);
        const auto renumber = [&](std::int64_t& id) { id -= id < 0 ? 0 : first_id; };
        for (auto& face : found.faces) std::ranges::for_each(face, renumber);
        for (auto& [face, corner, neighbour] : found.adjacencies) {
            std::ranges::for_each(face, renumber);
            std::ranges::for_each(neighbour, renumber);
        }
        for (auto& [site, by] : found.hidden) {
            renumber(site);
            renumber(by);
        }
        ASSERT_EQ(found.faces.size(), whole.faces.size()) << what << ", " << count;
        ASSERT_EQ(distributed::arrays_of(found, whole.sites, metric, whole.weight_is), whole)
            << what << ", " << count << " parts";
    }
}

constexpr std::size_t few[] = {1, 2, 3, 5, 60};
constexpr std::size_t some[] = {2, 3, 4, 7};

class Distributed : public testing::TestWithParam<Metric> {};

TEST_P(Distributed, OfFewDegenerateSites) {
    for (int trial = 0; trial < 100 * thoroughness; ++trial) {
        brute_force::Degenerate degenerate(static_cast<std::uint64_t>(trial));
        std::vector<Site> sites(static_cast<std::size_t>(degenerate.random().between(1, 40)));
        degenerate.fill(trial % brute_force::Degenerate::families, sites.data(), sites.size());
        expect_the_same(sites, GetParam(), few, "trial " + std::to_string(trial));
        if (HasFatalFailure()) return;
    }
}

/// Small integers with giants among them, and weights: so many sites that parts have an inside of
/// their own.
TEST_P(Distributed, OfManyDegenerateSites) {
    for (int trial = 0; trial < 6 * thoroughness; ++trial) {
        const std::vector<Site> sites = brute_force::integers_and_giants(trial);
        expect_the_same(sites, GetParam(), some, "trial " + std::to_string(trial),
                        std::int64_t{trial % 2} << 40);
        if (HasFatalFailure()) return;
    }
}

/// One half of the sites weighs so much more than the other that it takes from it what lies far
/// beyond the cut, and hides what is there: more giants than those that all parts know.
TEST_P(Distributed, WhereOneSideHidesTheOther) {
    for (int trial = 0; trial < 3 * thoroughness; ++trial) {
        std::vector<Site> sites = brute_force::one_side_hides_the_other(trial);
        expect_the_same(sites, GetParam(), some, "trial " + std::to_string(trial));
        const bool has_weights = traits_of(GetParam()).has_weights;
        if (has_weights)
            for (Site& site : sites) site.r *= -site.r;
        expect_the_same({sites, has_weights}, GetParam(), some,
                        "trial " + std::to_string(trial) + ", weights");
        if (HasFatalFailure()) return;
    }
}

TEST_P(Distributed, BehindLargeDiscs) {
    for (int trial = 0; trial < 4 * thoroughness; ++trial) {
        const std::vector<Site> sites = brute_force::cluster_behind_large_discs(trial);
        expect_the_same(sites, GetParam(), some, "trial " + std::to_string(trial));
        if (HasFatalFailure()) return;
    }
}

/// Discs between two greater ones: each takes the middle of an edge and no vertex.
TEST_P(Distributed, WhereMiddlesOfEdgesAreTaken) {
    for (int trial = 0; trial < 10 * thoroughness; ++trial) {
        Random random(static_cast<std::uint64_t>(trial));
        std::vector<Site> sites;
        for (int i = 0; i < 12; ++i)
            sites.push_back({random.between(0, 400) * 0.25, random.between(0, 400) * 0.25,
                             random.between(20, 60) * 0.25});
        for (int i = 0; i < 200; ++i) {
            const Site& a = sites[static_cast<std::size_t>(random.between(0, 11))];
            const Site& b = sites[static_cast<std::size_t>(random.between(0, 11))];
            const double at = random.between(0, 64) * 0x1p-6;
            sites.push_back(
                {a.x + at * (b.x - a.x), a.y + at * (b.y - a.y), random.between(-8, 8) * 0.0625});
        }
        expect_the_same(sites, GetParam(), some, "trial " + std::to_string(trial));
        if (HasFatalFailure()) return;
    }
}

TEST_P(Distributed, OfHostileFamilies) {
    for (const adversarial::Family& family : adversarial::families) {
        expect_the_same(family.make(is_fast ? 300 : 150), GetParam(), some,
                        std::string(family.name));
        if (HasFatalFailure()) return;
    }
}

TEST_P(Distributed, OfDistributions) {
    for (const Distribution distribution : all_distributions)
        for (const double radius : {0.0, 0.5, 9.0}) {
            expect_the_same(generate(distribution, {.count = is_fast ? 2000 : 500,
                                                    .radius_from = radius / 3,
                                                    .radius_to = radius}),
                            GetParam(), some, std::string(name_of(distribution)));
            if (HasFatalFailure()) return;
        }
}

/// Huge and tiny: beyond the filters' windows, and beyond a double's range in between.
TEST_P(Distributed, OfAnyMagnitude) {
    for (int exponent = -1060; exponent <= 1012; exponent += exponent == -1060 ? 40 : 111) {
        const std::vector<Site> sites = brute_force::sites_of_magnitude(exponent, 300);
        expect_the_same(sites, GetParam(), some, "2^" + std::to_string(exponent));
        if (HasFatalFailure()) return;
    }
}

/// Few others are told, and few questions asked: some ten sites along each border.
TEST_P(Distributed, TellsLittle) {
    const int count = 20'000;
    const auto sites = generate(Distribution::random, {.count = count, .radius_to = 1.0});
    std::vector<distributed::Placed> placed;
    for (std::size_t i = 0; i < sites.size(); ++i)
        placed.push_back({sites[i], static_cast<std::int64_t>(i)});
    const auto told = distributed::settle_in_parts(placed, {GetParam()}, 4).told;
    EXPECT_LT(told.sites, 6000U);
    EXPECT_LT(told.rounds, 12U);
    EXPECT_LT(told.faces + told.edges, 4000U);
}

INSTANTIATE_TEST_SUITE_P(, Distributed, testing::ValuesIn(all_metrics),
                         [](const testing::TestParamInfo<Metric>& info) {
                             return std::string(name_of(info.param));
                         });

}  // namespace
}  // namespace signum
