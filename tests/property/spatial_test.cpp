/// Tessellations of space beside brute force in rationals, in any order of the sites; the laws of
/// the arrays.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <span>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "../../predicates/space/ccw.hpp"
#include "../../predicates/space/nearer.hpp"
#include "../../predicates/space/ties.hpp"
#include "../../triangulation/space/triangulate.hpp"
#include "../oracle/oracle_test_support.hpp"
#include "../oracle/power_space.hpp"
#include "../thoroughness.hpp"

namespace signum {
namespace {

using oracle_test::Random;
using Sites = std::vector<Site3>;

SpaceTessellation tessellation_of(const Sites& sites, std::uint64_t seed = 1) {
    Options options;
    options.seed = seed;
    SpaceTessellation result = triangulate(std::span<const Site3>(sites), Power{}, options);
    // Points have roads of their own.
    if (std::ranges::all_of(sites, [](const Site3& s) { return s.r == 0.0; })) {
        std::vector<Point3> points;
        for (const Site3& s : sites) points.push_back(centre3(s));
        EXPECT_EQ(triangulate(std::span<const Point3>(points), Power{}, options), result);
    }
    return result;
}

/// Laws 1 and 2 of the arrays.
void expect_laws(const SpaceTessellation& result, const Sites& sites) {
    const auto size = static_cast<std::size_t>(result.dimension + 1);
    ASSERT_EQ(result.cells.size(), result.neighbours.size());
    ASSERT_TRUE(std::ranges::is_sorted(result.cells));
    ASSERT_EQ(std::ranges::adjacent_find(result.cells), result.cells.end());
    for (std::size_t c = 0; c < result.cells.size(); ++c) {
        const SpaceCell& cell = result.cells[c];
        for (std::size_t k = size; k < 4; ++k) {
            ASSERT_EQ(cell[k], no_vertex);
            ASSERT_EQ(result.neighbours[c][k], no_vertex);
        }
        ASSERT_EQ(std::min_element(cell.begin(), cell.begin() + result.dimension + 1),
                  cell.begin());
        if (size == 4) {
            ASSERT_LT(cell[1], std::min(cell[2], cell[3]));
            const auto at = [&](std::size_t k) {
                return centre3(sites[static_cast<std::size_t>(cell[k])]);
            };
            if (cell[0] >= 0) {
                ASSERT_GT(ccw(at(0), at(1), at(2), at(3)), 0);
            }
        } else {
            ASSERT_TRUE(std::is_sorted(cell.begin(), cell.begin() + result.dimension + 1));
        }
        for (std::size_t k = 0; k < size; ++k) {
            // Across from a vertex all the others are there, and the way back leads here.
            const Index n = result.neighbours[c][k];
            ASSERT_GE(n, 0);
            const SpaceCell& other = result.cells[static_cast<std::size_t>(n)];
            std::size_t back = 4;
            for (std::size_t m = 0; m < size; ++m) {
                const bool is_shared =
                    std::ranges::find(cell, other[m]) != cell.end() && other[m] != cell[k];
                if (!is_shared) {
                    ASSERT_EQ(back, 4U);
                    back = m;
                }
            }
            ASSERT_LT(back, 4U);
            ASSERT_EQ(result.neighbours[static_cast<std::size_t>(n)][back], static_cast<Index>(c));
            // Beyond the hull's facet there is nobody.
            if (size == 4 && cell[0] < 0 && k == 0) {
                const auto at = [&](Index v) {
                    return centre3(sites[static_cast<std::size_t>(v)]);
                };
                ASSERT_GT(ccw(at(other[back]), at(cell[1]), at(cell[3]), at(cell[2])), 0);
            }
        }
    }
}

void expect_as_brute_force(const Sites& sites, std::uint64_t seed) {
    std::vector<oracle::SpaceSite<3>> plain;
    for (const Site3& s : sites) plain.push_back({{s.x, s.y, s.z}, s.r * s.r});
    const auto expected = oracle::power_space<3>(plain);
    const SpaceTessellation result = tessellation_of(sites, seed);
    ASSERT_EQ(result.dimension, expected.dimension);
    ASSERT_EQ(result.sites, static_cast<std::int64_t>(sites.size()));
    std::vector<SpaceCell> cells;
    std::vector<std::array<Index, 3>> facets;
    for (SpaceCell cell : result.cells) {
        std::sort(cell.begin(), cell.begin() + result.dimension + 1);
        if (cell[0] >= 0)
            cells.push_back(cell);
        else if (result.dimension > 0)
            facets.push_back({cell[1], cell[2], cell[3]});
    }
    std::ranges::sort(cells);
    std::ranges::sort(facets);
    ASSERT_EQ(cells, (std::vector<SpaceCell>(expected.cells.begin(), expected.cells.end())));
    ASSERT_EQ(facets,
              (std::vector<std::array<Index, 3>>(expected.facets.begin(), expected.facets.end())));
    std::vector<std::array<std::int32_t, 2>> hidden;
    for (const Hidden& each : result.hidden) hidden.push_back({each.site, each.by});
    ASSERT_EQ(hidden, expected.hidden);
    ASSERT_NO_FATAL_FAILURE(expect_laws(result, sites));
}

/// Coordinates of a few values, so that all is tied, nested, flat or double; or none.
Sites small_set(Random& random) {
    const int kind = random.below(6);
    const auto one = [&] {
        switch (kind) {
            case 0:
                return 1.0 * random.below(2);
            case 1:
                return 1.0 * random.below(3);
            case 2:
                return 0.1 * random.below(4);
            case 3:
                return std::ldexp(1.0 * random.below(3), 300);
            default:
                return random.unit();
        }
    };
    const int flat = random.below(8);
    const int weights = random.below(3);
    Sites sites;
    for (int n = random.below(9); n >= 0; --n) {
        Site3 s{one(), one(), one(), 0.0};
        if (flat <= 2) s.z = flat == 0 ? 0.5 : flat == 1 ? s.x : s.x + s.y;
        if (flat == 1 || flat == 3) s.y = 2.0 * s.x;
        if (flat == 3) s.z = s.x;
        if (flat == 4 && random.below(2) == 0 && !sites.empty()) s = sites.front();
        if (weights == 1) s.r = 1.0 * random.below(3);
        // Of a radius that is a float the square is a double.
        if (weights == 2)
            s.r = random.below(2) == 0
                      ? 0.0
                      : static_cast<float>(0.5 * std::ldexp(one(), kind == 3 ? -300 : 0));
        if (kind == 3) s.r *= 0x1p300;
        sites.push_back(s);
    }
    return sites;
}

TEST(Spatial, SmallSetsAreAsBruteForceSays) {
    Random random(31);
    std::array<int, 5> dimensions{};
    for (int trial = 0; trial < 1500 * thoroughness; ++trial) {
        const Sites sites = small_set(random);
        ASSERT_NO_FATAL_FAILURE(expect_as_brute_force(sites, static_cast<std::uint64_t>(trial)));
        ++dimensions[static_cast<std::size_t>(tessellation_of(sites).dimension + 1)];
    }
    for (std::size_t d = 1; d < 5; ++d) EXPECT_GT(dimensions[d], 50) << d;
}

TEST(Spatial, NoSiteAndOne) {
    EXPECT_EQ(tessellation_of({}), SpaceTessellation{});
    const SpaceTessellation one = tessellation_of({{1.0, 2.0, 3.0, 0.0}});
    EXPECT_EQ(one.dimension, 0);
    EXPECT_EQ(one.cells, (std::vector<SpaceCell>{{-1, -2, -2, -2}, {0, -2, -2, -2}}));
    EXPECT_EQ(one.neighbours, (std::vector<SpaceCell>{{1, -2, -2, -2}, {0, -2, -2, -2}}));
}

/// Larger sets: the laws, and one result whatever the order.
void expect_one_result(const Sites& sites) {
    const SpaceTessellation expected = tessellation_of(sites);
    ASSERT_NO_FATAL_FAILURE(expect_laws(expected, sites));
    for (std::uint64_t seed = 2; seed < 5; ++seed)
        ASSERT_EQ(tessellation_of(sites, seed), expected);
    // Sites of one place are told apart by their numbers; these are all different.
    std::vector<std::size_t> order(sites.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::shuffle(order.begin(), order.end(), std::mt19937_64(5));
    Sites shuffled;
    for (const std::size_t i : order) shuffled.push_back(sites[i]);
    const SpaceTessellation other = tessellation_of(shuffled);
    ASSERT_EQ(other.cells.size(), expected.cells.size());
    std::vector<SpaceCell> renumbered;
    for (SpaceCell cell : other.cells) {
        for (Index& v : cell)
            if (v >= 0) v = static_cast<Index>(order[static_cast<std::size_t>(v)]);
        std::ranges::sort(cell);
        renumbered.push_back(cell);
    }
    std::vector<SpaceCell> cells;
    for (SpaceCell cell : expected.cells) {
        std::ranges::sort(cell);
        cells.push_back(cell);
    }
    std::ranges::sort(renumbered);
    std::ranges::sort(cells);
    ASSERT_EQ(renumbered, cells);
    std::set<std::pair<Index, Index>> hidden;
    for (const Hidden& each : other.hidden)
        hidden.emplace(order[static_cast<std::size_t>(each.site)],
                       order[static_cast<std::size_t>(each.by)]);
    ASSERT_EQ(hidden.size(), expected.hidden.size());
    for (const Hidden& each : expected.hidden) ASSERT_TRUE(hidden.contains({each.site, each.by}));
}

Sites lattice(int side) {
    Sites sites;
    for (int i = 0; i < side * side * side; ++i)
        sites.push_back({1.0 * (i % side), 1.0 * (i / side % side), 1.0 * (i / side / side), 0.0});
    return sites;
}

TEST(Spatial, LargerSetsHaveOneResult) {
    Random random(32);
    const auto draw = [&](auto&& one) {
        Sites sites;
        for (int i = 0; i < 1000 * thoroughness; ++i) sites.push_back(one());
        return sites;
    };
    const auto unit = [&] { return random.unit(); };
    ASSERT_NO_FATAL_FAILURE(expect_one_result(lattice(9)));
    ASSERT_NO_FATAL_FAILURE(expect_one_result(draw([&] {
        return Site3{unit(), unit(), unit(), 0.0};
    })));
    const Sites balls = draw([&] { return Site3{unit(), unit(), unit(), 0.15 * unit()}; });
    EXPECT_GT(tessellation_of(balls).hidden.size(), 20U);
    ASSERT_NO_FATAL_FAILURE(expect_one_result(balls));
    // On a sphere, and in a plane that is not along the axes.
    ASSERT_NO_FATAL_FAILURE(expect_one_result(draw([&] {
        const double z = 2.0 * unit() - 1.0;
        const double turn = 7.0 * unit();
        const double r = std::sqrt(1.0 - z * z);
        return Site3{r * std::cos(turn), r * std::sin(turn), z, 0.0};
    })));
    ASSERT_NO_FATAL_FAILURE(expect_one_result(draw([&] {
        const double x = unit();
        const double y = unit();
        return Site3{x, y, x + y, 0.1 * unit()};
    })));
}

/// Around one site, or one edge, are more vertices than fit in the table by which cells are linked.
TEST(Spatial, LargeStarsHaveOneResult) {
    Random random(33);
    Sites wheel = {{0.0, 0.0, -1.0, 0.0}, {0.0, 0.0, 1.0, 0.0}};
    Sites centred = {{0.0, 0.0, 0.0, 0.0}};
    for (int i = 0; i < 300; ++i) {
        const double turn = 7.0 * random.unit();
        wheel.push_back({std::cos(turn), std::sin(turn), 0.0, 0.0});
        const double z = 2.0 * random.unit() - 1.0;
        const double r = std::sqrt(1.0 - z * z);
        centred.push_back({r * std::cos(turn), r * std::sin(turn), z, 0.0});
    }
    ASSERT_NO_FATAL_FAILURE(expect_one_result(wheel));
    ASSERT_NO_FATAL_FAILURE(expect_one_result(centred));
    // A giant that hides most of what it covers, inserted early or late.
    Sites covered = lattice(8);
    for (Site3& site : covered) site.r = 0.25;
    covered.push_back({3.5, 3.5, 3.5, 3.25});
    EXPECT_GT(tessellation_of(covered).hidden.size(), 50U);
    ASSERT_NO_FATAL_FAILURE(expect_one_result(covered));
}

/// Who is nearest to a hidden site, beside asking all: around hubs, in crowds of sites that are as
/// near, and where who hid it became hidden too.
TEST(Spatial, HiddenSitesHaveTheNearestVisibleOne) {
    Random random(36);
    const auto towards = [&](double distance) {
        const double z = 2.0 * random.unit() - 1.0;
        const double turn = 7.0 * random.unit();
        const double r = distance * std::sqrt(1.0 - z * z);
        return Site3{r * std::cos(turn), r * std::sin(turn), distance * z, 0.0};
    };
    Sites hub = {{0.0, 0.0, 0.0, 1.0}};
    for (int i = 0; i < 2000; ++i) {
        hub.push_back(towards(1.5 + 1e-3 * random.unit()));
        hub.push_back(towards(0.6 * random.unit()));
    }
    Sites growing;
    for (int i = 0; i < 500; ++i) growing.push_back({0.25 * random.below(8), 0.0, 0.0, 0.1 * i});
    Sites tied = lattice(6);
    for (Site3& s : tied) s.r = random.below(4);
    for (int i = 0; i < 600; ++i) {
        tied.push_back(
            {0.5 * random.below(11), 0.5 * random.below(11), 0.5 * random.below(11), 0.0});
        tied.push_back({random.unit(), random.unit(), 5.0 * random.unit(), 0.5 * random.unit()});
    }
    for (const Sites& sites : {hub, growing, tied}) {
        const SpaceTessellation result = tessellation_of(sites);
        std::vector<bool> is_hidden(sites.size(), false);
        for (const Hidden& each : result.hidden)
            is_hidden[static_cast<std::size_t>(each.site)] = true;
        EXPECT_GT(result.hidden.size(), sites.size() / 4);
        for (const Hidden& each : result.hidden) {
            const Point3 p = centre3(sites[static_cast<std::size_t>(each.site)]);
            std::size_t best = sites.size();
            for (std::size_t i = 0; i < sites.size(); ++i) {
                if (is_hidden[i]) continue;
                const int sign = best == sites.size()
                                     ? 1
                                     : power::nearer_decision(p, sites[i], sites[best]).sign;
                if (sign > 0 ||
                    (sign == 0 && power::precedes(sites[i], static_cast<Index>(i), sites[best],
                                                  static_cast<Index>(best))))
                    best = i;
            }
            ASSERT_EQ(each.by, static_cast<Index>(best)) << each.site;
        }
    }
}

/// The same combinatorics on every lattice: where determinants of doubles are exact, and where they
/// are not.
TEST(Spatial, LatticesOfAllUnitsAreOne) {
    const Sites sites = lattice(6);
    const SpaceTessellation expected = tessellation_of(sites);
    for (const double unit : {0x1p-20, 3.0, 0x1.123456789p+4, 0x1p-149, 0x1p-160, 0x1p140, 0x1p300})
        for (const double corner : {0.0, -7.0, 1048576.0}) {
            Sites moved = sites;
            for (Site3& s : moved)
                s = {unit * (s.x + corner), unit * (s.y - corner), unit * (s.z + corner), 0.0};
            ASSERT_EQ(tessellation_of(moved), expected) << unit << ' ' << corner;
        }
}

SpaceTessellation naive(const Sites& sites) {
    Options options;
    options.arithmetic = Arithmetic::naive;
    return triangulate(std::span<const Site3>(sites), Power{}, options);
}

TEST(Spatial, NaiveArithmeticIsRightWhereNothingIsClose) {
    Random random(34);
    Sites sites;
    for (int i = 0; i < 2000; ++i)
        sites.push_back({random.unit(), random.unit(), random.unit(), 0.05 * random.unit()});
    EXPECT_EQ(naive(sites), tessellation_of(sites));
}

/// It may be wrong, or break and say so; it ends.
TEST(Spatial, NaiveArithmeticEnds) {
    Random random(35);
    std::map<std::string, int> broken;
    int wrong = 0;
    for (int trial = 0; trial < 300 * thoroughness; ++trial) {
        Sites sites = small_set(random);
        if (trial % 3 == 1) {
            // In a plane, or almost: by rounding a site lies beyond all facets of a sliver.
            const double a = 2.0 * random.unit() - 1.0;
            const double b = 2.0 * random.unit() - 1.0;
            sites.resize(static_cast<std::size_t>(5 + random.below(6)));
            for (Site3& s : sites) {
                s = {random.unit(), random.unit(), 0.0, 0.0};
                s.z = trial % 6 == 1 ? a * s.x + b * s.y : s.x + s.y;
            }
        }
        if (trial % 3 == 0) {
            const double step = 0.1 + random.unit();
            sites = lattice(5);
            for (Site3& s : sites)
                s = {step * s.x + 0.7, step * s.y + 0.7 * s.x, step * s.z + 0.3 * s.y, 0.0};
        }
        try {
            const SpaceTessellation result = naive(sites);
            wrong += result == tessellation_of(sites) ? 0 : 1;
            std::set<Index> told;
            for (const SpaceCell& cell : result.cells) told.insert(cell.begin(), cell.end());
            told.erase(infinite);
            told.erase(no_vertex);
            for (const Hidden& each : result.hidden) ASSERT_TRUE(told.insert(each.site).second);
            ASSERT_EQ(told.size(), sites.size()) << trial;
        } catch (const BrokenStructure& error) {
            ++broken[error.what()];
        }
    }
    EXPECT_GT(wrong, 0);
    // Regions that are no balls, walks in circles, sites beyond all facets, sites lost …
    EXPECT_GE(broken.size(), is_fast ? 5U : 1U);
}

TEST(Spatial, PointsAndWeightsAreSitesToo) {
    const Sites sites = lattice(4);
    std::vector<Point3> points;
    std::vector<power::Site3> weights;
    for (const Site3& s : sites) {
        points.push_back(centre3(s));
        weights.push_back({s.x, s.y, s.z, -7.5});
    }
    const SpaceTessellation expected = tessellation_of(sites);
    EXPECT_EQ(triangulate(points), expected);
    EXPECT_EQ(triangulate(weights), expected);
    // 27 cubes of six cells at most and five at least.
    const auto finite =
        std::ranges::count_if(expected.cells, [](const SpaceCell& cell) { return cell[0] >= 0; });
    EXPECT_GE(finite, 27 * 5);
    EXPECT_LE(finite, 27 * 6);
}

/// All lengths halved, and weights quartered, change nothing; where weights are about as large as
/// doubles are, determinants overflow before that, and their bounds do not.
TEST(Spatial, WeightsUpToTheLargestDoubleAreOrdinary) {
    Random random(83);
    for (int round = 0; round < 400; ++round) {
        std::vector<power::Site3> huge(static_cast<std::size_t>(6 + random.below(50)));
        const auto place = [&] { return 0.25 * (random.below(17) - 8); };
        for (power::Site3& s : huge)
            s = {place(), place(), place(),
                 std::ldexp(2.0 * random.unit() - 1.0, 1024 - random.below(3))};
        std::vector<power::Site3> usual = huge;
        for (power::Site3& s : usual)
            s = {std::ldexp(s.x, -20), std::ldexp(s.y, -20), std::ldexp(s.z, -20),
                 std::ldexp(s.w, -40)};
        ASSERT_EQ(triangulate(std::span<const power::Site3>(huge)),
                  triangulate(std::span<const power::Site3>(usual)))
            << round;
    }
}

TEST(Spatial, RadiiUpToTheLargestDoubleAreOrdinary) {
    Random random(89);
    constexpr double largest = std::numeric_limits<double>::max();
    for (int round = 0; round < 400; ++round) {
        Sites huge(static_cast<std::size_t>(6 + random.below(30)));
        Sites usual(huge.size());
        // All weigh the same, or some nothing beside others.
        const bool are_equal = random.below(2) == 0;
        for (std::size_t i = 0; i < huge.size(); ++i) {
            const auto place = [&] { return 0.25 * (random.below(17) - 8); };
            const double part = are_equal || random.below(2) == 0 ? 1.0 : 0.5;
            usual[i] = {place(), place(), place(), part * 0x1p40};
            huge[i] = usual[i];
            huge[i].r = random.below(2) == 0 ? part * largest : -part * largest;
        }
        ASSERT_EQ(triangulate(std::span<const Site3>(huge)),
                  triangulate(std::span<const Site3>(usual)))
            << round;
    }
}

TEST(Spatial, WhatCannotBeIsRefused) {
    const auto refused = [](const Sites& sites, const Options& options = {}) -> std::string {
        try {
            static_cast<void>(triangulate(std::span<const Site3>(sites), Power{}, options));
        } catch (const std::exception& error) {
            return error.what();
        }
        return "";
    };
    Sites sites = lattice(2);
    sites[5].y = NAN;
    EXPECT_EQ(refused(sites), "site 5 is not finite");
    sites[5].y = 0.0;
    sites[3].r = HUGE_VAL;
    EXPECT_EQ(refused(sites), "site 3 is not finite");
    Options options;
    options.arithmetic = Arithmetic::interval;
    EXPECT_EQ(refused(lattice(2), options),
              "tessellations of space know exact and naive arithmetic");
    std::stop_source source;
    source.request_stop();
    options = {};
    options.stop = source.get_token();
    EXPECT_THROW(
        static_cast<void>(triangulate(std::span<const Site3>(lattice(20)), Power{}, options)),
        Stopped);
    options = {};
    double last = 0.0;
    options.progress = [&](double share) {
        EXPECT_GE(share, last);
        last = share;
    };
    EXPECT_EQ(refused(lattice(20), options), "");
    EXPECT_GT(last, 0.4);
}

}  // namespace
}  // namespace signum
