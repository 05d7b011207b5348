/// What is wrong and what is only different among cells of space, beside brute force.

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <span>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "../../predicates/power.hpp"
#include "../../predicates/space.hpp"
#include "../../predicates/space/ccw.hpp"
#include "../../triangulation/space/compare.hpp"
#include "../oracle/oracle_test_support.hpp"
#include "../oracle/power_space.hpp"
#include "../thoroughness.hpp"

namespace signum {
namespace {

using oracle_test::Random;
using Sites = std::vector<power::Site3>;

Sites small_integers(Random& random, std::size_t count, int extent, int weights) {
    Sites sites(count);
    for (power::Site3& s : sites) {
        s = {1.0 * random.below(extent), 1.0 * random.below(extent), 1.0 * random.below(extent),
             1.0 * random.below(weights)};
    }
    return sites;
}

Sign turn_of(const SpaceCell& cell, const Sites& sites) {
    const auto at = [&](std::size_t m) {
        return centre3(sites[static_cast<std::size_t>(cell[m])]);
    };
    return predicates::decide<Arithmetic::multiprecision, predicates::Ccw3>(at(0), at(1), at(2),
                                                                            at(3))
        .sign;
}

/// Law 1 by every site.
bool is_valid(const SpaceCell& cell, const Sites& sites) {
    if (turn_of(cell, sites) <= 0) return false;
    const auto at = [&](std::size_t m) { return sites[static_cast<std::size_t>(cell[m])]; };
    return std::ranges::none_of(sites, [&](const power::Site3& q) {
        return predicates::decide<Arithmetic::multiprecision, power::InSphere>(at(0), at(1), at(2),
                                                                               at(3), q)
                   .sign > 0;
    });
}

/// All quadruples, those that turn positively in the order of cells: as if they were a
/// tessellation.
SpaceTessellation all_quadruples(const Sites& sites) {
    SpaceTessellation result;
    result.dimension = 3;
    result.sites = static_cast<std::int64_t>(sites.size());
    const auto n = static_cast<Index>(sites.size());
    for (Index a = 0; a < n; ++a)
        for (Index b = a + 1; b < n; ++b)
            for (Index c = b + 1; c < n; ++c)
                for (Index d = c + 1; d < n; ++d) {
                    SpaceCell cell = {a, b, c, d};
                    if (turn_of(cell, sites) < 0) std::swap(cell[2], cell[3]);
                    result.cells.push_back(cell);
                }
    result.neighbours.assign(result.cells.size(), {0, 0, 0, 0});
    return result;
}

TEST(CompareCells, IsBruteForceOnAllQuadruples) {
    Random random(7);
    std::size_t wrong = 0;
    std::size_t different = 0;
    std::size_t trials = 0;
    for (int trial = 0; trial < 150 * thoroughness; ++trial) {
        const Sites sites = small_integers(random, 5 + static_cast<std::size_t>(random.below(6)),
                                           2 + random.below(4), 1 + random.below(6));
        const SpaceTessellation canonical = triangulate(std::span<const power::Site3>(sites));
        if (canonical.dimension < 3) continue;
        ++trials;
        const SpaceTessellation all = all_quadruples(sites);
        const CellComparison found = compare_cells(all, canonical, sites);
        ASSERT_EQ(found.cells, static_cast<std::int64_t>(all.cells.size()));
        for (const SpaceCell& cell : all.cells) {
            const bool valid = is_valid(cell, sites);
            const bool there = std::ranges::count(canonical.cells, cell) > 0;
            ASSERT_EQ(std::ranges::count(found.wrong, cell), valid ? 0 : 1);
            ASSERT_EQ(std::ranges::count(found.different, cell), valid && !there ? 1 : 0);
        }
        ASSERT_TRUE(std::ranges::is_sorted(found.wrong));
        ASSERT_TRUE(std::ranges::is_sorted(found.different));
        wrong += found.wrong.size();
        different += found.different.size();

        const CellComparison own = compare_cells(canonical, canonical, sites);
        ASSERT_TRUE(own.wrong.empty() && own.different.empty());
    }
    EXPECT_GT(trials, 75U);
    EXPECT_GT(wrong, 1000U);
    EXPECT_GT(different, 100U);
}

TEST(CompareCells, FindsNothingWrongInOtherOrdersOfTies) {
    Random random(11);
    std::size_t different = 0;
    for (int trial = 0; trial < 100 * thoroughness; ++trial) {
        const std::size_t count = 6 + static_cast<std::size_t>(random.below(4));
        Sites sites = small_integers(random, count, 3, 1 + random.below(3));
        if (trial % 2 == 0)  // flat, in a plane along no axis
            for (power::Site3& s : sites) s.z = s.x + s.y;
        const SpaceTessellation canonical = triangulate(std::span<const power::Site3>(sites));
        if (canonical.dimension < 2) continue;
        std::vector<oracle::SpaceSite<3>> same;
        for (const auto& [x, y, z, w] : sites) same.push_back({{x, y, z}, w});
        oracle::Ranks ranks(count);
        std::iota(ranks.begin(), ranks.end(), 0);
        for (std::size_t m = count; m > 1; --m)
            std::swap(ranks[m - 1],
                      ranks[static_cast<std::size_t>(random.below(static_cast<int>(m)))]);
        SpaceTessellation other = canonical;
        other.cells.clear();
        for (SpaceCell cell : oracle::power_space<3>(same, ranks).cells) {
            if (canonical.dimension == 3 && turn_of(cell, sites) < 0) std::swap(cell[2], cell[3]);
            other.cells.push_back(cell);
        }
        other.neighbours.assign(other.cells.size(), {0, 0, 0, 0});
        const CellComparison found = compare_cells(other, canonical, sites);
        ASSERT_TRUE(found.wrong.empty());
        different += found.different.size();
    }
    EXPECT_GT(different, 100U);
}

TEST(CompareCells, IsThatOfThePlaneOnFlatSites) {
    Random random(13);
    std::size_t wrong = 0;
    std::size_t different = 0;
    for (int trial = 0; trial < 100 * thoroughness; ++trial) {
        Sites sites = small_integers(random, 4 + static_cast<std::size_t>(random.below(6)),
                                     2 + random.below(4), 1 + random.below(6));
        for (power::Site3& s : sites) s.z = 5.0;
        const auto in_plane = [&](Index i) {
            const power::Site3& s = sites[static_cast<std::size_t>(i)];
            return power::Site{s.x, s.y, s.w};
        };
        // The same plane along other axes.
        Sites turned = sites;
        if (trial % 3 > 0)
            for (power::Site3& s : turned)
                s = trial % 3 == 1 ? power::Site3{s.z, s.x, s.y, s.w}
                                   : power::Site3{s.y, s.z, s.x, s.w};
        const SpaceTessellation canonical = triangulate(std::span<const power::Site3>(turned));
        if (canonical.dimension != 2) continue;
        SpaceTessellation all;
        all.dimension = 2;
        all.sites = canonical.sites;
        const auto n = static_cast<Index>(sites.size());
        for (Index a = 0; a < n; ++a)
            for (Index b = a + 1; b < n; ++b)
                for (Index c = b + 1; c < n; ++c) all.cells.push_back({a, b, c, no_vertex});
        all.neighbours.assign(all.cells.size(), {0, 0, 0, no_vertex});
        const CellComparison found = compare_cells(all, canonical, turned);
        for (const SpaceCell& cell : all.cells) {
            power::Site i = in_plane(cell[0]);
            power::Site j = in_plane(cell[1]);
            const power::Site k = in_plane(cell[2]);
            const Sign turn = ccw(i, j, k);
            if (turn < 0) std::swap(i, j);
            bool valid = turn != 0;
            for (Index q = 0; q < n && valid; ++q)
                valid = power::in_circle(i, j, k, in_plane(q)) <= 0;
            const bool there = std::ranges::count(canonical.cells, cell) > 0;
            ASSERT_EQ(std::ranges::count(found.wrong, cell), valid ? 0 : 1);
            ASSERT_EQ(std::ranges::count(found.different, cell), valid && !there ? 1 : 0);
        }
        wrong += found.wrong.size();
        different += found.different.size();
    }
    EXPECT_GT(wrong, 500U);
    EXPECT_GT(different, 50U);
}

TEST(CompareCells, JudgesSitesOnALineAndInOnePlace) {
    const auto judged = [](const Sites& sites, int dimension, const SpaceCell& cell) {
        const SpaceTessellation canonical = triangulate(std::span<const power::Site3>(sites));
        EXPECT_EQ(canonical.dimension, dimension);
        SpaceTessellation other = canonical;
        other.cells = {cell};
        other.neighbours = {{0, 0, 0, 0}};
        const CellComparison found = compare_cells(other, canonical, sites);
        return std::array{found.wrong.size(), found.different.size()};
    };
    using Counts = std::array<std::size_t, 2>;
    const Sites line = {{0, 0, 5, 0}, {1, 1, 6, 0}, {3, 3, 8, 0}, {3, 3, 8, 0}};
    EXPECT_EQ(judged(line, 1, {0, 1, no_vertex, no_vertex}), (Counts{0, 0}));
    EXPECT_EQ(judged(line, 1, {0, 2, no_vertex, no_vertex}), (Counts{1, 0}));
    EXPECT_EQ(judged(line, 1, {1, 3, no_vertex, no_vertex}), (Counts{0, 1}));
    EXPECT_EQ(judged(line, 1, {2, 3, no_vertex, no_vertex}), (Counts{1, 0}));
    const Sites place = {{7, 7, 7, 1}, {7, 7, 7, 2}, {7, 7, 7, 2}};
    EXPECT_EQ(judged(place, 0, {0, no_vertex, no_vertex, no_vertex}), (Counts{1, 0}));
    EXPECT_EQ(judged(place, 0, {1, no_vertex, no_vertex, no_vertex}), (Counts{0, 0}));
    EXPECT_EQ(judged(place, 0, {2, no_vertex, no_vertex, no_vertex}), (Counts{0, 1}));
}

TEST(CompareCells, CountsMoreThanThereShouldBeAsDifferent) {
    const std::vector<Point3> sites = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const SpaceTessellation canonical = triangulate(std::span<const Point3>(sites));
    SpaceTessellation twice = canonical;
    twice.cells.push_back({0, 1, 2, 3});
    twice.neighbours.push_back({0, 0, 0, 0});
    const CellComparison found = compare_cells(twice, canonical, sites);
    EXPECT_EQ(found.cells, 2);
    EXPECT_TRUE(found.wrong.empty());
    EXPECT_EQ(found.different, (std::vector<SpaceCell>{{0, 1, 2, 3}}));
}

TEST(CompareCells, RefusesWhatDoesNotBelongTogether) {
    const std::vector<Point3> sites = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const std::vector<Point3> flat = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    const SpaceTessellation good = triangulate(std::span<const Point3>(sites));
    const SpaceTessellation of_flat = triangulate(std::span<const Point3>(flat));
    EXPECT_THROW((void)compare_cells(good, of_flat, sites), std::invalid_argument);
    EXPECT_THROW((void)compare_cells(of_flat, good, sites), std::invalid_argument);
    const std::span<const Point3> three = std::span(sites).first(3);
    EXPECT_THROW((void)compare_cells(good, good, three), std::invalid_argument);
    SpaceTessellation beyond = good;
    beyond.cells.back()[3] = 4;
    EXPECT_THROW((void)compare_cells(beyond, good, sites), std::invalid_argument);
    beyond = good;
    beyond.neighbours.back()[3] = no_vertex;
    EXPECT_THROW((void)compare_cells(good, beyond, sites), std::invalid_argument);
}

TEST(FacetTies, AreCounted) {
    // The corners of a cube: whatever its cells are, the sphere of each touches all.
    std::vector<Point3> cube;
    for (int m = 0; m < 8; ++m) cube.push_back({1.0 * (m & 1), 1.0 * (m >> 1 & 1), 1.0 * (m >> 2)});
    const FacetTies all = ties_of(triangulate(std::span<const Point3>(cube)), cube);
    EXPECT_GE(all.facets, 4);
    EXPECT_EQ(all.ties, all.facets);
    cube[7] = {1.25, 1.5, 1.75};
    cube.push_back({0.4, 0.3, 0.2});
    const FacetTies some = ties_of(triangulate(std::span<const Point3>(cube)), cube);
    EXPECT_LT(some.ties, some.facets);
}

}  // namespace
}  // namespace signum
