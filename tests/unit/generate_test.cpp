#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "../../core/index.hpp"
#include "../../tool/generate/generate.hpp"

namespace signum {
namespace {

constexpr Distribution all[] = {Distribution::random, Distribution::circle, Distribution::square,
                                Distribution::grid};

/// How many different centres there are.
std::size_t different(const std::vector<Site>& sites) {
    std::set<std::pair<double, double>> centres;
    for (const Site& site : sites) centres.insert({site.x, site.y});
    return centres.size();
}

bool is_in_square(const Site& site) {
    return site.x >= 0 && site.x <= 700 && site.y >= 0 && site.y <= 700;
}

TEST(Generate, GivesTheSameDoublesEverywhere) {
    // Written down once; they may not depend on platform, library or optimization.
    const std::vector<Site> sites =
        generate(Distribution::random, {.count = 2, .radius_from = -1, .radius_to = 2});
    EXPECT_EQ(sites,
              (std::vector<Site>{{93.71365080877284, 95.48492545633806, -0.33821805050310916},
                                 {315.85043269117665, 14.716959891708914, 1.8237936702585844}}));
    const std::vector<Site> circle = generate(Distribution::circle, {.count = 1, .perturb = 0.5});
    EXPECT_EQ(circle, (std::vector<Site>{{7.195829351140874, 420.83221323841036, 0}}));
}

TEST(Generate, GivesAsManyAsAskedForInTheSquare) {
    for (const Distribution distribution : all) {
        for (const std::int64_t count : {0, 1, 2, 5, 1000}) {
            const std::vector<Site> sites = generate(distribution, {.count = count});
            EXPECT_EQ(std::ssize(sites), count);
            EXPECT_TRUE(std::all_of(sites.begin(), sites.end(), is_in_square));
        }
    }
}

TEST(Generate, PutsSitesWhereTheDistributionSays) {
    for (const Site& site : generate(Distribution::circle, {.count = 1000})) {
        EXPECT_NEAR(std::hypot(site.x - 350, site.y - 350), 350, 1e-10);
    }
    for (const Site& site : generate(Distribution::square, {.count = 1000})) {
        EXPECT_TRUE(site.x == 0 || site.x == 700 || site.y == 0 || site.y == 700);
    }
    // A grid of squares: differences are exact.
    const std::vector<Site> grid = generate(Distribution::grid, {.count = 12});
    const double step = grid[1].x;
    EXPECT_NEAR(3 * step, 700, 1e-3);
    for (int i = 0; i < 12; ++i) {
        EXPECT_EQ(grid[static_cast<std::size_t>(i)], (Site{i % 4 * step, i / 4 * step, 0}));
    }
}

TEST(Generate, FillsAllSidesAndQuadrants) {
    int quadrants[4] = {};
    for (const Site& site : generate(Distribution::circle, {.count = 4000})) {
        ++quadrants[(site.x > 350 ? 1 : 0) + (site.y > 350 ? 2 : 0)];
    }
    int sides[4] = {};
    for (const Site& site : generate(Distribution::square, {.count = 4000})) {
        ++sides[site.y == 0 ? 0 : site.x == 700 ? 1 : site.y == 700 ? 2 : 3];
    }
    for (int i = 0; i < 4; ++i) {
        EXPECT_NEAR(quadrants[i], 1000, 150);
        EXPECT_NEAR(sides[i], 1000, 150);
    }
}

TEST(Generate, KeepsCentresWhenRadiiChange) {
    const std::vector<Site> small = generate(Distribution::random, {.count = 100});
    const std::vector<Site> large = generate(
        Distribution::random, {.count = 100, .radius_from = 5, .radius_to = 9, .perturb = 2});
    const std::vector<Site> other = generate(Distribution::random, {.count = 100, .seed = 2});
    for (std::size_t i = 0; i < 100; ++i) {
        EXPECT_GE(large[i].x, small[i].x);
        EXPECT_LE(large[i].x, small[i].x + 2);
        EXPECT_GE(large[i].y, small[i].y);
        EXPECT_LE(large[i].y, small[i].y + 2);
        EXPECT_GE(large[i].r, 5);
        EXPECT_LE(large[i].r, 9);
        EXPECT_EQ(small[i].r, 0);
        EXPECT_NE(other[i].x, small[i].x);
    }
}

TEST(Generate, MakesHardSitesOfBothDimensions) {
    const std::vector<Site> sites = generate_hard({.count = 2000, .seed = 5});
    EXPECT_EQ(std::ssize(sites), 2000);
    EXPECT_EQ(sites, generate_hard({.count = 2000, .seed = 5}));
    EXPECT_NE(sites, generate_hard({.count = 2000, .seed = 6}));
    const std::size_t places = different(sites);
    EXPECT_GT(places, 1000);
    EXPECT_LT(places, 1950);  // copies
    const std::vector<Site> moved = generate_hard({.count = 2000, .perturb = 1, .seed = 5});
    for (std::size_t i = 0; i < sites.size(); ++i) {
        EXPECT_TRUE(std::isfinite(sites[i].x) && std::isfinite(sites[i].y));
        EXPECT_LE(std::abs(moved[i].x - sites[i].x), 1.0 + std::abs(sites[i].x) * 0x1p-52);
        EXPECT_EQ(moved[i].r, sites[i].r);
        EXPECT_GE(sites[i].r, 0);
    }
    EXPECT_EQ(std::ssize(generate_hard_in_space({.count = 33})), 33);
    EXPECT_THROW(static_cast<void>(generate_hard({.count = -1})), std::invalid_argument);
}

TEST(Generate, HasANameForEachDistribution) {
    std::set<std::string_view> names;
    for (const Distribution each : all_distributions) {
        names.insert(name_of(each));
        EXPECT_EQ(generate(each, {.count = 0}).size(), 0U);
        EXPECT_EQ(generate(each, {.count = 2501}).size(), 2501U);
    }
    EXPECT_EQ(names.size(), all_distributions.size());
}

/// Where the first site of the pattern that holds site i would be without its pattern: a multiple
/// of the pitch.
double centre_of_pattern(double coordinate, double pitch) {
    return pitch * std::floor(coordinate / pitch + 0.5);
}

TEST(Generate, PutsSitesOfSpaceWhereTheDistributionSays) {
    std::set<std::string_view> names;
    for (const SpaceDistribution each : all_space_distributions) {
        names.insert(name_of(each));
        for (const std::int64_t count : {0, 1, 2, 9, 2501}) {
            const std::vector<Site3> sites = generate(each, {.count = count});
            EXPECT_EQ(std::ssize(sites), count);
            EXPECT_EQ(sites, generate(each, {.count = count}));
            for (const auto& [x, y, z, r] : sites) {
                for (const double coordinate : {x, y, z}) {
                    EXPECT_GE(coordinate, 0);
                    EXPECT_LE(coordinate, 700);
                }
                EXPECT_EQ(r, 0);
            }
        }
    }
    EXPECT_EQ(names.size(), all_space_distributions.size());
    int octants[8] = {};
    for (const auto& [x, y, z, r] : generate(SpaceDistribution::sphere, {.count = 8000})) {
        EXPECT_NEAR(std::hypot(x - 350, y - 350, z - 350), 350, 1e-10);
        ++octants[(x > 350 ? 1 : 0) + (y > 350 ? 2 : 0) + (z > 350 ? 4 : 0)];
    }
    for (const int each : octants) EXPECT_NEAR(each, 1000, 150);
    int faces[6] = {};
    for (const auto& [x, y, z, r] : generate(SpaceDistribution::cube, {.count = 6000})) {
        const double place[3] = {x, y, z};
        bool is_on_a_face = false;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (place[axis] != 0 && place[axis] != 700) continue;
            is_on_a_face = true;
            ++faces[2 * axis + (place[axis] == 0 ? 0 : 1)];
        }
        EXPECT_TRUE(is_on_a_face);
    }
    for (const int each : faces) EXPECT_NEAR(each, 1000, 150);
    // A grid of cubes: differences are exact.
    const std::vector<Site3> grid = generate(SpaceDistribution::grid, {.count = 28});
    const double step = grid[1].x;
    EXPECT_NEAR(3 * step, 700, 1e-3);
    for (int i = 0; i < 28; ++i) {
        EXPECT_EQ(grid[static_cast<std::size_t>(i)],
                  (Site3{i % 4 * step, i / 4 % 4 * step, i / 16 * step, 0}));
    }
}

TEST(Generate, GivesTheSameDoublesOfSpaceEverywhere) {
    // Written down once; they may not depend on platform, library or optimization.
    EXPECT_EQ(generate(SpaceDistribution::sphere, {.count = 1, .radius_from = 1, .radius_to = 2}),
              (std::vector<Site3>{
                  {331.5707597598486, 169.06032252984, 50.966228962069806, 1.2205939831656303}}));
    EXPECT_EQ(
        generate(SpaceDistribution::cube, {.count = 1, .perturb = 0.5}),
        (std::vector<Site3>{{0.008573467584059191, 562.5490950884716, 95.82724536308142, 0}}));
}

TEST(Generate, KeepsCentresOfSpaceWhenRadiiChange) {
    const std::vector<Site3> small = generate(SpaceDistribution::random, {.count = 100});
    const std::vector<Site3> large = generate(
        SpaceDistribution::random, {.count = 100, .radius_from = 5, .radius_to = 9, .perturb = 2});
    for (std::size_t i = 0; i < 100; ++i) {
        EXPECT_GE(large[i].z, small[i].z);
        EXPECT_LE(large[i].z, small[i].z + 2);
        EXPECT_GE(large[i].r, 5);
        EXPECT_LE(large[i].r, 9);
    }
    EXPECT_THROW(static_cast<void>(generate(SpaceDistribution::grid, {.count = -1})),
                 std::invalid_argument);
}

TEST(Generate, LatticeIsExactlyCocircular) {
    const std::vector<Site> sites = generate(Distribution::lattice, {.count = 2000});
    for (const Site& site : sites) {
        const auto x = static_cast<std::int64_t>(site.x - centre_of_pattern(site.x, 0x1p13));
        const auto y = static_cast<std::int64_t>(site.y - centre_of_pattern(site.y, 0x1p13));
        EXPECT_EQ(x * x + y * y, 5928325);
    }
    EXPECT_EQ(different(sites), 2000U);
}

TEST(Generate, TangentDiscsTouchACircle) {
    const std::vector<Site> sites = generate(Distribution::tangent, {.count = 2000});
    for (const Site& site : sites) {
        const auto x = static_cast<std::int64_t>(site.x - centre_of_pattern(site.x, 0x1p15));
        const auto y = static_cast<std::int64_t>(site.y - centre_of_pattern(site.y, 0x1p15));
        const auto reach = static_cast<std::int64_t>(site.r) + 10000;
        EXPECT_EQ(x * x + y * y, reach * reach);
        EXPECT_GE(site.r, 0);
    }
    EXPECT_EQ(different(sites), 2000U);
}

TEST(Generate, OffsetHasExactDifferencesAndRoundedSums) {
    const std::vector<Site> sites = generate(Distribution::offset, {.count = 100});
    EXPECT_EQ(sites[99].x - sites[0].x, 9 * 0x1p-12);
    EXPECT_EQ(sites[99].y - sites[0].y, 9 * 0x1p-12);
    EXPECT_NE((sites[1].x + sites[1].y) - sites[1].y, sites[1].x);
    EXPECT_EQ(different(sites), 100U);
}

TEST(Generate, RingsLieSideBySide) {
    for (const Site& site : generate(Distribution::rings, {.count = 4000})) {
        const double x = std::fmod(site.x, 350) - 175;
        const double y = std::fmod(site.y, 350) - 175;
        EXPECT_NEAR(std::hypot(x, y), 175, 1e-10);
    }
}

TEST(Generate, RefusesOptionsOutOfRange) {
    const double nan = std::nan("");
    for (const GenerateOptions& options :
         {GenerateOptions{.count = -1}, GenerateOptions{.count = max_sites + 1},
          GenerateOptions{.count = 1, .radius_from = 1},
          GenerateOptions{.count = 1, .radius_to = nan},
          GenerateOptions{.count = 1, .radius_from = -1e308, .radius_to = 1e308},
          GenerateOptions{.count = 1, .perturb = -1},
          GenerateOptions{.count = 1, .perturb = nan}}) {
        EXPECT_THROW(static_cast<void>(generate(Distribution::random, options)),
                     std::invalid_argument);
    }
}

}  // namespace
}  // namespace signum
