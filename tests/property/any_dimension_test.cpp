/// Tessellations in one to six dimensions beside brute force in rationals, beside those of the
/// plane and of space, and in any order of the sites.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>
#include <span>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "../../triangulation/any_dimension/triangulate.hpp"
#include "../../triangulation/triangulate.hpp"
#include "../oracle/oracle_test_support.hpp"
#include "../oracle/power_space.hpp"
#include "../thoroughness.hpp"
#include "any_dimension_sites.hpp"

namespace signum {
namespace {

using namespace any_dimension_test;
using oracle_test::Random;

template <int D>
TessellationOf<D> tessellation_of(const Sites<D>& sites, std::uint64_t seed = 1) {
    Options options;
    options.seed = seed;
    return triangulate<D>(sites, options);
}

template <int D>
void expect_as_brute_force(const Sites<D>& sites, std::uint64_t seed) {
    std::vector<oracle::SpaceSite<D>> plain;
    for (const auto& s : sites) plain.push_back({s.centre, s.w});
    const auto expected = oracle::power_space<D>(plain);
    const TessellationOf<D> result = tessellation_of<D>(sites, seed);
    ASSERT_EQ(result.dimension, expected.dimension);
    ASSERT_EQ(result.sites, static_cast<std::int64_t>(sites.size()));
    std::vector<oracle::SpaceTuple<D + 1>> cells;
    std::vector<oracle::SpaceTuple<D>> facets;
    for (CellOf<D> cell : result.cells) {
        std::sort(cell.begin(), cell.begin() + result.dimension + 1);
        if (cell[0] >= 0) {
            cells.push_back(cell);
        } else if (result.dimension > 0) {
            oracle::SpaceTuple<D> facet;
            std::copy(cell.begin() + 1, cell.end(), facet.begin());
            facets.push_back(facet);
        }
    }
    std::ranges::sort(cells);
    std::ranges::sort(facets);
    ASSERT_EQ(cells, expected.cells);
    ASSERT_EQ(facets, expected.facets);
    std::vector<std::array<std::int32_t, 2>> hidden;
    for (const Hidden& each : result.hidden) hidden.push_back({each.site, each.by});
    ASSERT_EQ(hidden, expected.hidden);
}

template <int D>
void expect_small_sets(int trials, int most) {
    Random random(40 + D);
    std::array<int, D + 1> dimensions{};
    std::size_t hidden = 0;
    for (int trial = 0; trial < trials; ++trial) {
        const Sites<D> sites = small_set<D>(random, most);
        ASSERT_NO_FATAL_FAILURE(expect_as_brute_force<D>(sites, static_cast<std::uint64_t>(trial)))
            << "trial " << trial;
        const auto result = tessellation_of<D>(sites);
        ++dimensions[static_cast<std::size_t>(result.dimension)];
        hidden += result.hidden.size();
    }
    for (const int times : dimensions) EXPECT_GT(times, trials / 100);
    EXPECT_GT(hidden, static_cast<std::size_t>(trials / 10));
}

TEST(AnyDimension, SmallSetsOnALine) {
    expect_small_sets<1>(1000 * thoroughness, 9);
}
TEST(AnyDimension, SmallSetsInThePlane) {
    expect_small_sets<2>(500 * thoroughness, 9);
}
TEST(AnyDimension, SmallSetsInSpace) {
    expect_small_sets<3>(400 * thoroughness, 9);
}
TEST(AnyDimension, SmallSetsInFourDimensions) {
    expect_small_sets<4>(200 * thoroughness, 9);
}
TEST(AnyDimension, SmallSetsInFiveDimensions) {
    expect_small_sets<5>(60 * thoroughness, 9);
}
TEST(AnyDimension, SmallSetsInSixDimensions) {
    expect_small_sets<6>(40 * thoroughness, 9);
}

/// The same arrays as triangulation/space/triangulate.hpp gives.
void expect_as_in_space(const Sites<3>& sites) {
    std::vector<power::Site3> weighted;
    for (const auto& s : sites) weighted.push_back({s.centre[0], s.centre[1], s.centre[2], s.w});
    const SpaceTessellation expected = triangulate(std::span<const power::Site3>(weighted));
    const TessellationOf<3> result = tessellation_of<3>(sites);
    ASSERT_EQ(result.dimension, expected.dimension);
    ASSERT_EQ(result.cells, expected.cells);
    ASSERT_EQ(result.neighbours, expected.neighbours);
    ASSERT_EQ(result.hidden, expected.hidden);
}

TEST(AnyDimension, InSpaceItIsTheTessellationOfSpace) {
    Random random(47);
    for (int trial = 0; trial < 300 * thoroughness; ++trial)
        ASSERT_NO_FATAL_FAILURE(expect_as_in_space(small_set<3>(random, 30)));
    ASSERT_NO_FATAL_FAILURE(expect_as_in_space(lattice<3>(6)));
    ASSERT_NO_FATAL_FAILURE(expect_as_in_space(random_sites<3>(random, 200 * thoroughness, 0.0)));
    ASSERT_NO_FATAL_FAILURE(expect_as_in_space(random_sites<3>(random, 200 * thoroughness, 0.03)));
    // On a sphere, in a plane that is not along the axes, on a line.
    Sites<3> sphere;
    Sites<3> plane;
    Sites<3> line;
    for (int i = 0; i < 100 * thoroughness; ++i) {
        const double z = 2.0 * random.unit() - 1.0;
        const double turn = 7.0 * random.unit();
        const double r = std::sqrt(1.0 - z * z);
        sphere.push_back({{r * std::cos(turn), r * std::sin(turn), z}, 0.0});
        const double x = random.unit();
        const double y = random.unit();
        plane.push_back({{x, y, x + y}, 0.01 * random.unit()});
        line.push_back({{x, 2.0 * x, -x}, 0.001 * random.unit()});
    }
    ASSERT_NO_FATAL_FAILURE(expect_as_in_space(sphere));
    ASSERT_NO_FATAL_FAILURE(expect_as_in_space(plane));
    ASSERT_NO_FATAL_FAILURE(expect_as_in_space(line));
}

/// The same arrays as triangulation/triangulate.hpp gives, where the sites are not on one line.
void expect_as_in_the_plane(const Sites<2>& sites) {
    std::vector<power::Site> weighted;
    for (const auto& s : sites) weighted.push_back({s.centre[0], s.centre[1], s.w});
    const Tessellation expected =
        triangulate(std::span<const power::Site>(weighted), Metric::power);
    const TessellationOf<2> result = tessellation_of<2>(sites);
    ASSERT_EQ(result.hidden, expected.arrays().hidden);
    if (result.dimension < 2) return;
    ASSERT_EQ(result.cells, expected.arrays().faces);
    ASSERT_EQ(result.neighbours, expected.arrays().neighbours);
}

TEST(AnyDimension, InThePlaneItIsThePlanes) {
    Random random(48);
    for (int trial = 0; trial < 300 * thoroughness; ++trial)
        ASSERT_NO_FATAL_FAILURE(expect_as_in_the_plane(small_set<2>(random, 40)));
    ASSERT_NO_FATAL_FAILURE(expect_as_in_the_plane(lattice<2>(15)));
    ASSERT_NO_FATAL_FAILURE(
        expect_as_in_the_plane(random_sites<2>(random, 300 * thoroughness, 0.0)));
    ASSERT_NO_FATAL_FAILURE(
        expect_as_in_the_plane(random_sites<2>(random, 300 * thoroughness, 0.01)));
}

/// Whatever the order, and however the sites are numbered where no two are alike.
template <int D>
void expect_one_result(const Sites<D>& sites) {
    const TessellationOf<D> expected = tessellation_of<D>(sites);
    for (std::uint64_t seed = 2; seed < 4; ++seed)
        ASSERT_EQ(tessellation_of<D>(sites, seed), expected);
    std::vector<std::size_t> order(sites.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::shuffle(order.begin(), order.end(), std::mt19937_64(5));
    Sites<D> shuffled;
    for (const std::size_t i : order) shuffled.push_back(sites[i]);
    const auto sorted = [](std::vector<CellOf<D>> cells) {
        for (CellOf<D>& cell : cells) std::ranges::sort(cell);
        std::ranges::sort(cells);
        return cells;
    };
    const TessellationOf<D> other = tessellation_of<D>(shuffled);
    std::vector<CellOf<D>> renumbered = other.cells;
    for (CellOf<D>& cell : renumbered)
        for (Index& v : cell)
            if (v >= 0) v = static_cast<Index>(order[static_cast<std::size_t>(v)]);
    ASSERT_EQ(sorted(renumbered), sorted(expected.cells));
    ASSERT_EQ(other.hidden.size(), expected.hidden.size());
}

TEST(AnyDimension, LargerSetsHaveOneResult) {
    Random random(49);
    ASSERT_NO_FATAL_FAILURE(expect_one_result<4>(lattice<4>(is_fast ? 3 : 2)));
    ASSERT_NO_FATAL_FAILURE(expect_one_result<5>(lattice<5>(2)));
    ASSERT_NO_FATAL_FAILURE(expect_one_result<6>(lattice<6>(is_fast ? 2 : 1)));
    ASSERT_NO_FATAL_FAILURE(expect_one_result<4>(random_sites<4>(random, 20 * thoroughness, 0.1)));
    ASSERT_NO_FATAL_FAILURE(expect_one_result<5>(random_sites<5>(random, 9 * thoroughness, 0.1)));
    ASSERT_NO_FATAL_FAILURE(expect_one_result<6>(random_sites<6>(random, 5 * thoroughness, 0.1)));
}

TEST(AnyDimension, NoSiteAndOne) {
    EXPECT_EQ(tessellation_of<4>({}), TessellationOf<4>{});
    const TessellationOf<4> one = tessellation_of<4>({{{1.0, 2.0, 3.0, 4.0}, 5.0}});
    EXPECT_EQ(one.dimension, 0);
    EXPECT_EQ(one.cells, (std::vector<CellOf<4>>{{-1, -2, -2, -2, -2}, {0, -2, -2, -2, -2}}));
    EXPECT_EQ(one.neighbours, (std::vector<CellOf<4>>{{1, -2, -2, -2, -2}, {0, -2, -2, -2, -2}}));
}

TEST(AnyDimension, WhatCannotBeIsRefused) {
    const auto refused = [](const Sites<4>& sites, const Options& options = {}) -> std::string {
        try {
            static_cast<void>(triangulate<4>(sites, options));
        } catch (const std::invalid_argument& error) {
            return error.what();
        }
        return "";
    };
    Sites<4> sites = lattice<4>(2);
    sites[5].centre[3] = NAN;
    EXPECT_EQ(refused(sites), "site 5 is not finite");
    sites[5].centre[3] = 0.0;
    sites[3].w = HUGE_VAL;
    EXPECT_EQ(refused(sites), "site 3 is not finite");
    Options options;
    options.arithmetic = Arithmetic::naive;
    EXPECT_EQ(refused(lattice<4>(2), options),
              "tessellations in any dimension have exact arithmetic alone");
    Random random(50);
    std::stop_source source;
    source.request_stop();
    options = {};
    options.stop = source.get_token();
    const Sites<2> many = random_sites<2>(random, 5000, 0.0);
    EXPECT_THROW(static_cast<void>(triangulate<2>(many, options)), Stopped);
    options = {};
    double last = 0.0;
    options.progress = [&](double share) { last = share; };
    static_cast<void>(triangulate<2>(many, options));
    EXPECT_GT(last, 0.4);
}

}  // namespace
}  // namespace signum
