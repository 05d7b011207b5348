/// The oracles of the supremum and the Manhattan metric against cases done by hand, invariances of
/// the metrics, radii that are really reduced, and a plain look at the diagram. Every call checks
/// the sphere (2n-2 faces of the n visible sites, matched edges; hidden sites are those whose
/// centre another site is nearer to) and throws otherwise.

#include <gtest/gtest.h>
#include "oracle_test_support.hpp"
#include "rectangular.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace signum::oracle_test;
using signum::Site;

Tessellation supremum(const std::vector<Site>& sites) {
    return signum::oracle::supremum(sites);
}
Tessellation manhattan(const std::vector<Site>& sites) {
    return signum::oracle::manhattan(sites);
}
double radius(const Site& site) {
    return site.r;
}

/// Quarter turn, counterclockwise.
std::vector<Site> turned(std::vector<Site> sites) {
    for (Site& s : sites) s = {-s.y, s.x, s.r};
    return sites;
}

/// (x, y) -> (x + y, y - x): a Manhattan problem becomes one of the supremum metric.
std::vector<Site> diagonal(std::vector<Site> sites) {
    for (Site& s : sites) s = {s.x + s.y, s.y - s.x, s.r};
    return sites;
}

double supremum_distance(const Site& s, double x, double y) {
    return std::max(std::abs(x - s.x), std::abs(y - s.y)) - s.r;
}
double manhattan_distance(const Site& s, double x, double y) {
    return std::abs(x - s.x) + std::abs(y - s.y) - s.r;
}

class OracleRectangular : public testing::TestWithParam<bool> {
 public:
    Tessellation tessellation(const std::vector<Site>& sites) const {
        return GetParam() ? supremum(sites) : manhattan(sites);
    }
};

INSTANTIATE_TEST_SUITE_P(Metrics, OracleRectangular, testing::Values(true, false),
                         [](const auto& info) {
                             return std::string(info.param ? "Supremum" : "Manhattan");
                         });

TEST_P(OracleRectangular, NoSiteAndOneSite) {
    EXPECT_EQ(tessellation({}), Tessellation{});
    EXPECT_EQ(tessellation({{3, 4, 5}}), Tessellation{});
    EXPECT_EQ(tessellation({{3, 4, -5}}), Tessellation{});
}

TEST_P(OracleRectangular, TwoSites) {
    const Tessellation pair{{{-1, 0, 1}, {-1, 1, 0}}, {}};
    EXPECT_EQ(tessellation({{0, 0, 1}, {7, 1, 2}}), pair);  // apart
    EXPECT_EQ(tessellation({{0, 0, 1}, {3, 0, 2}}), pair);  // touching
    EXPECT_EQ(tessellation({{0, 0, 2}, {2, 0, 1}}), pair);  // intersecting
    EXPECT_EQ(tessellation({{0, 0, -7}, {1, 0, -7}}), pair);
}

TEST_P(OracleRectangular, EqualAndNestedSites) {
    EXPECT_EQ(tessellation({{1, 1, 2}, {1, 1, 2}, {1, 1, 2}}),
              (Tessellation{{}, {{1, 0}, {2, 0}}}));
    EXPECT_EQ(tessellation({{1, 1, 2}, {1, 1, 3}, {1, 1, -9}}),
              (Tessellation{{}, {{0, 1}, {2, 1}}}));
    EXPECT_EQ(tessellation({{0, 0, 9}, {1, 0, 1}}), (Tessellation{{}, {{1, 0}}}));
    // Touching the container from inside, in a corner of the square, or with a whole side.
    EXPECT_EQ(tessellation({{1, 0, 1}, {0, 0, 2}}), (Tessellation{{}, {{0, 1}}}));
    EXPECT_EQ(tessellation({{0, 0, 2}, {0, -1, 1}}), (Tessellation{{}, {{1, 0}}}));
    // In one container and then in the next: the visible one is named.
    EXPECT_EQ(tessellation({{0, 0, 1}, {0, 0, 3}, {0, 0, 2}}),
              (Tessellation{{}, {{0, 1}, {2, 1}}}));
    // As near to both; the larger is the earlier, and of equal ones the left.
    EXPECT_EQ(tessellation({{2, 0, 2}, {-2, 0, 2}, {0, 0, -1}}),
              (Tessellation{{{-1, 0, 1}, {-1, 1, 0}}, {{2, 1}}}));
    EXPECT_EQ(tessellation({{2, 0, 2}, {-3, 0, 3}, {0, 0, -1}}),
              (Tessellation{{{-1, 0, 1}, {-1, 1, 0}}, {{2, 1}}}));
}

TEST_P(OracleRectangular, CollinearSites) {
    // Equal discs on a line in any direction: a chain.
    const Tessellation chain{{{-1, 0, 1}, {-1, 1, 0}, {-1, 1, 2}, {-1, 2, 1}}, {}};
    EXPECT_EQ(tessellation({{0, 0, 1}, {3, 0, 1}, {6, 0, 1}}), chain);
    EXPECT_EQ(tessellation({{0, 0, 1}, {0, 3, 1}, {0, 6, 1}}), chain);
    EXPECT_EQ(tessellation({{0, 0, 1}, {3, 3, 1}, {6, 6, 1}}), chain);
    EXPECT_EQ(tessellation({{0, 0, 1}, {3, -3, 1}, {6, -6, 1}}), chain);
}

TEST(OracleSupremum, ASmallSquareBetweenTwoLargeOnes) {
    // The middle cell is bounded; both ends of the bisectors (0,1) and (1,2) belong to the third.
    EXPECT_EQ(supremum({{0, 0, 5}, {8, 0, 1}, {16, 0, 5}}),
              (Tessellation{{{-1, 0, 2}, {-1, 2, 0}, {0, 1, 2}, {0, 2, 1}}, {}}));
}

TEST(OracleSupremum, OneUnboundedCellSeveralTimesAroundTheHull) {
    EXPECT_EQ(supremum({{0, 0, 10}, {0, 9, 2}, {0, -9, 2}}),
              (Tessellation{{{-1, 0, 1}, {-1, 0, 2}, {-1, 1, 0}, {-1, 2, 0}}, {}}));
    EXPECT_EQ(supremum({{0, 0, 10}, {0, 9, 2}, {0, -9, 2}, {9, 0, 2}, {-9, 0, 2}}),
              (Tessellation{{{-1, 0, 1},
                             {-1, 0, 2},
                             {-1, 0, 3},
                             {-1, 0, 4},
                             {-1, 1, 0},
                             {-1, 2, 0},
                             {-1, 3, 0},
                             {-1, 4, 0}},
                            {}}));
}

TEST(OracleSupremum, FourCornersOfASquare) {
    // Around the middle (1/2 + x, 1/2 + y) the distances are 1/2 + max(±x, ±y) plus infinitesimals:
    // max(x, y) + e0 for (0,0), max(-x, -y) + e3 for (1,1), max(-x, y) + e1 for (1,0), max(x, -y) +
    // e2 for (0,1), with e3 >> e1 >> e2 >> e0. Where the first two are equal, x + y = e3 - e0; at
    // x = y both are (e3 + e0) / 2 and the others (e3 - e0) / 2 + e1 or e2: farther. So (0,0) meets
    // (1,1). Raising (1,1) alone would not decide: e1 and e2 against e0 do.
    EXPECT_EQ(
        supremum({{0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}}),
        (Tessellation{{{-1, 0, 2}, {-1, 1, 0}, {-1, 2, 3}, {-1, 3, 1}, {0, 1, 3}, {0, 3, 2}}, {}}));
    // The same square at another size, and with its sites in another order.
    EXPECT_EQ(
        supremum({{8, 8, 0}, {0, 8, 0}, {8, 0, 0}, {0, 0, 0}}),
        (Tessellation{{{-1, 0, 2}, {-1, 1, 0}, {-1, 2, 3}, {-1, 3, 1}, {0, 1, 3}, {0, 3, 2}}, {}}));
}

TEST(OracleManhattan, FourCornersOfASquare) {
    // In u, v: (0,0) touches the left side of the square, (1,1) the right, (1,0) the bottom, (0,1)
    // the top. Reduced radii make the gap between left and right wider by e0 + e3, the other by
    // e1 + e2, which is less: the nearer pair (1,0), (0,1) meets.
    EXPECT_EQ(
        manhattan({{0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}}),
        (Tessellation{{{-1, 0, 2}, {-1, 1, 0}, {-1, 2, 3}, {-1, 3, 1}, {0, 1, 2}, {1, 3, 2}}, {}}));
}

TEST(OracleSupremum, FourPointsInTheMiddlesOfTheSides) {
    // In the order (-1,0), (0,-1), (0,1), (1,0): the last makes the horizontal gap the wider one,
    // so (0,1) and (0,-1) meet.
    EXPECT_EQ(
        supremum({{1, 0, 1}, {0, 1, 1}, {-1, 0, 1}, {0, -1, 1}}),
        (Tessellation{{{-1, 0, 3}, {-1, 1, 0}, {-1, 2, 1}, {-1, 3, 2}, {0, 1, 3}, {1, 2, 3}}, {}}));
    // The vertical sites are smaller, and the gaps are as wide: now the last is (0,4), the second
    // but last (0,-4), and the horizontal pair meets.
    EXPECT_EQ(
        supremum({{5, 0, 2}, {0, 4, 1}, {-5, 0, 2}, {0, -4, 1}}),
        (Tessellation{{{-1, 0, 3}, {-1, 1, 0}, {-1, 2, 1}, {-1, 3, 2}, {0, 1, 2}, {0, 2, 3}}, {}}));
}

TEST(OracleSupremum, AlignedSitesHaveOneCircleOnly) {
    // Every square of side 5 that stands on 0 and 1 and has 2 on its top touches all three, from
    // [-3,2]x[0,5] to [0,5]x[0,5]. Reduced, 1 is the lower one and 0 must be beside the square:
    // only the last one remains. A point in the first one makes no difference to the face.
    EXPECT_EQ(supremum({{0, 0, 0}, {2, 0, 0}, {1, 5, 0}}),
              (Tessellation{{{-1, 0, 2}, {-1, 1, 0}, {-1, 2, 1}, {0, 1, 2}}, {}}));
    const auto left = supremum({{0, 0, 0}, {2, 0, 0}, {1, 5, 0}, {-2, 2.5, 0}});
    EXPECT_TRUE(std::count(left.faces.begin(), left.faces.end(), Face{0, 1, 2}));
    const auto right = supremum({{0, 0, 0}, {2, 0, 0}, {1, 5, 0}, {4, 2.5, 0}});
    EXPECT_FALSE(std::count(right.faces.begin(), right.faces.end(), Face{0, 1, 2}));
}

TEST_P(OracleRectangular, EveryFiniteDouble) {
    const double big = 1.7976931348623157e308, tiny = 4.9406564584124654e-324;
    const auto scaled = [](double unit, double r) {  // (0,0), (1,0), (0,1) with equal radii
        return std::vector<Site>{{0, 0, r}, {unit, 0, r}, {0, unit, r}};
    };
    EXPECT_EQ(tessellation(scaled(tiny, 0)), tessellation(scaled(1, 0)));
    EXPECT_EQ(tessellation(scaled(tiny, big)), tessellation(scaled(1, 0)));
    EXPECT_EQ(tessellation(scaled(big, -big)), tessellation(scaled(1, 0)));
    EXPECT_EQ(tessellation({{-big, -big, big}, {big, -big, big}, {0, big, big}}),
              (Tessellation{{{-1, 0, 2}, {-1, 1, 0}, {-1, 2, 1}, {0, 1, 2}}, {}}));
    // The distance of the two centres is 2 big (4 big in the Manhattan metric): just touching from
    // inside, or apart.
    EXPECT_EQ(tessellation({{-big, -big, big}, {big, big, -big}}).hidden.size(),
              GetParam() ? 1U : 0U);
    EXPECT_EQ(
        tessellation({{-big, -big, big}, {big, std::nextafter(big, 0.0), -big}}).hidden.size(),
        GetParam() ? 1U : 0U);
    EXPECT_EQ(
        tessellation({{-big, -big, std::nextafter(big, 0.0)}, {big, big, -big}}).hidden.size(), 0U);
    EXPECT_THROW(tessellation({{0, 0, std::numeric_limits<double>::infinity()}}),
                 std::invalid_argument);
    EXPECT_THROW(tessellation({{std::nan(""), 0, 0}}), std::invalid_argument);
}

TEST_P(OracleRectangular, SpheresOfTinyIntegers) {
    Random random(201);
    std::size_t hidden = 0;
    for (int i = 0; i < 1000; ++i) {
        const auto sites = integer_sites<Site>(random, 1 + random.below(8), 2 + random.below(7),
                                               1 + random.below(4));
        ASSERT_NO_THROW(hidden += tessellation(sites).hidden.size()) << "input " << i;
    }
    EXPECT_GT(hidden, 800U);
}

TEST_P(OracleRectangular, PermutationsGiveTheSameTessellation) {
    Random random(202);
    for (int i = 0; i < 200; ++i) {
        const auto sites = integer_sites<Site>(random, 1 + random.below(7), 5, 3);
        const auto other = shuffled(sites, random);
        ASSERT_EQ(renamed(tessellation(sites), ranks(sites, radius)),
                  renamed(tessellation(other), ranks(other, radius)))
            << "input " << i;
    }
}

TEST_P(OracleRectangular, RadiiThatAreReallyReduced) {
    // The radius of rank k of n loses 2^-8(n-k): ample, since no coefficient is more than 2.
    Random random(203);
    for (int i = 0; i < 500; ++i) {
        const int n = 1 + random.below(5);
        const auto sites = integer_sites<Site>(random, n, 2 + random.below(6), 1 + random.below(3));
        const auto rank = ranks(sites, radius);
        auto reduced = sites;
        for (std::size_t k = 0; k < reduced.size(); ++k) {
            const double loss = std::ldexp(1.0, -8 * (n - rank[k]));
            reduced[k].r -= loss;
            ASSERT_EQ(sites[k].r - reduced[k].r, loss);
        }
        ASSERT_EQ(tessellation(sites), tessellation(reduced)) << "input " << i;
    }
}

TEST_P(OracleRectangular, Invariances) {
    Random random(204);
    for (int i = 0; i < 120; ++i) {
        const auto sites = integer_sites<Site>(random, 1 + random.below(6), 6, 4);
        const auto expected = tessellation(sites);
        auto changed = sites;
        for (Site& s : changed) s.r -= 17;
        ASSERT_EQ(tessellation(changed), expected) << "smaller " << i;
        changed = sites;
        for (Site& s : changed) s.x += 1000, s.y -= 77;
        ASSERT_EQ(tessellation(changed), expected) << "moved " << i;
        for (const int exponent : {1020, 1, -300, -1074}) {
            changed = sites;
            for (Site& s : changed) {
                s.x = std::ldexp(s.x, exponent);
                s.y = std::ldexp(s.y, exponent);
                s.r = std::ldexp(s.r, exponent);
            }
            ASSERT_EQ(tessellation(changed), expected) << "scaled by 2^" << exponent << ", " << i;
        }
    }
}

TEST_P(OracleRectangular, InvariancesWithoutTies) {
    Random random(205);
    for (int i = 0; i < 150; ++i) {
        const auto sites = generic_sites<Site>(random, 1 + random.below(7), 0.3);
        const auto expected = tessellation(sites);
        ASSERT_EQ(tessellation(turned(sites)), expected) << "turned " << i;
        ASSERT_EQ(tessellation(turned(turned(sites))), expected) << "turned twice " << i;
        auto flipped = sites;
        for (Site& s : flipped) s.x = -s.x;
        ASSERT_EQ(tessellation(flipped), mirrored(expected)) << "flipped " << i;
        ASSERT_EQ(manhattan(sites), supremum(diagonal(sites))) << i;
    }
}

TEST_P(OracleRectangular, InfiniteFacesAreWhatIsSeenFromFarAway) {
    // Far out on the diagonal of each quadrant, the nearest site changes only where a reach in the
    // one direction equals one in the other up to the shift t: look between all of those.
    Random random(206);
    std::size_t looked_at = 0, repeated = 0;
    for (int i = 0; i < 400; ++i) {
        std::vector<Site> sites;
        for (int k = 0, n = 2 + random.below(5); k < n; ++k) {
            const double x = random.below(100000), y = random.below(100000);
            sites.push_back({x, y, static_cast<double>(random.below(100000))});
        }
        const auto t = tessellation(sites);
        auto quadrant = GetParam() ? sites : diagonal(sites);  // turned: now the north-east
        std::vector<std::int32_t> cells;                       // unbounded, counterclockwise
        for (int d = 0; d < 4; ++d) {
            std::vector<double> shifts{-1e7, 1e7};
            for (const Site& a : quadrant)
                for (const Site& b : quadrant) shifts.push_back((a.y + a.r) - (b.x + b.r));
            std::sort(shifts.begin(), shifts.end());
            for (std::size_t k = 0; k + 1 < shifts.size(); ++k) {
                if (shifts[k] == shifts[k + 1]) continue;
                const double x = 0x1p30, y = x + (shifts[k] + shifts[k + 1]) / 2;
                std::size_t nearest = 0;
                for (std::size_t s = 1; s < sites.size(); ++s)
                    if (supremum_distance(quadrant[s], x, y) <
                        supremum_distance(quadrant[nearest], x, y))
                        nearest = s;
                const auto cell = static_cast<std::int32_t>(nearest);
                if (cells.empty() || cells.back() != cell) cells.push_back(cell);
            }
            quadrant = turned(turned(turned(quadrant)));
        }
        if (cells.size() > 1 && cells.front() == cells.back()) cells.pop_back();
        Faces expected, found;
        for (std::size_t k = 0; k < cells.size() && cells.size() > 1; ++k)
            expected.push_back({-1, cells[(k + 1) % cells.size()], cells[k]});
        std::sort(expected.begin(), expected.end());
        for (const Face& face : t.faces)
            if (face[0] < 0) found.push_back(face);
        ASSERT_EQ(found, expected) << "input " << i;
        looked_at += cells.size() > 1 ? 1 : 0;
        repeated += cells.size() > std::set(cells.begin(), cells.end()).size() ? 1 : 0;
    }
    EXPECT_GT(looked_at, 200U);
    EXPECT_GT(repeated, 5U);
}

TEST_P(OracleRectangular, WhatALookAtTheDiagramShows) {
    Random random(207);
    std::size_t seen = 0, faces = 0;
    for (int i = 0; i < 60; ++i) {
        const auto sites = generic_sites<Site>(random, 2 + random.below(7), 0.3);
        const auto t = tessellation(sites);
        bool agrees = false;
        seen += faces_seen(
            t, sites.size(),
            [&](std::size_t k, double x, double y) {
                return GetParam() ? supremum_distance(sites[k], x, y)
                                  : manhattan_distance(sites[k], x, y);
            },
            agrees);
        ASSERT_TRUE(agrees) << "input " << i;
        faces += finite_faces(t);
    }
    EXPECT_GT(10 * seen, 8 * faces);
}

}  // namespace
