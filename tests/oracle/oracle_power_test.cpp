/// The oracle of the power metric against cases done by hand, invariances of the metric, radii that
/// are really reduced, and a plain look at the diagram. Every call checks the sphere (2n-2 faces,
/// matched edges, hidden sites are those below which another simplex passes) and throws otherwise.

#include <gtest/gtest.h>
#include "oracle_test_support.hpp"
#include "power.hpp"
#include "valid_power.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace signum::oracle_test;
using signum::Site;
using Weighted = signum::power::Site;

Tessellation power(const std::vector<Site>& sites) {
    return signum::oracle::power(sites);
}
Tessellation weights(const std::vector<Weighted>& sites) {
    return signum::oracle::power_weights(sites);
}
double weight(const Weighted& site) {
    return site.w;
}

TEST(OraclePower, NoSiteAndOneSite) {
    EXPECT_EQ(power({}), Tessellation{});
    EXPECT_EQ(power({{3, 4, 5}}), Tessellation{});
}

TEST(OraclePower, TwoSites) {
    EXPECT_EQ(power({{0, 0, 1}, {3, 1, 2}}), (Tessellation{{{-1, 0, 1}, {-1, 1, 0}}, {}}));
    // Nested discs: other than in the additive metrics, both have a cell.
    EXPECT_EQ(power({{0, 0, 9}, {1, 0, 1}}), (Tessellation{{{-1, 0, 1}, {-1, 1, 0}}, {}}));
}

TEST(OraclePower, EqualCentresLeaveTheHeaviestAndThenTheFirst) {
    EXPECT_EQ(power({{1, 1, 2}, {1, 1, 2}, {1, 1, 2}}), (Tessellation{{}, {{1, 0}, {2, 0}}}));
    EXPECT_EQ(power({{1, 1, 2}, {1, 1, 3}, {1, 1, -3}}), (Tessellation{{}, {{0, 1}, {2, 1}}}));
    EXPECT_EQ(power({{1, 1, 2}, {0, 0, 0}, {1, 1, 2}}),
              (Tessellation{{{-1, 0, 1}, {-1, 1, 0}}, {{2, 0}}}));
}

TEST(OraclePower, CollinearCentres) {
    const Tessellation chain{{{-1, 0, 1}, {-1, 1, 0}, {-1, 1, 2}, {-1, 2, 1}}, {}};
    EXPECT_EQ(power({{0, 0, 1}, {1, 0, 1}, {2, 0, 1}}), chain);
    EXPECT_EQ(power({{0, 0, 1}, {1, 1, 1}, {3, 3, 1}}), chain);
    // The middle one is too light: -4, 1, 0 are the heights at 0, 1, 2. Both others are as near.
    EXPECT_EQ(power({{0, 0, 2}, {1, 0, 0}, {2, 0, 2}}),
              (Tessellation{{{-1, 0, 2}, {-1, 2, 0}}, {{1, 0}}}));
    // Heights -1, 0, 1: a tie. The middle one is the lightest, the last in the order, and hidden.
    EXPECT_EQ(weights({{0, 0, 1}, {1, 0, 1}, {2, 0, 3}}),
              (Tessellation{{{-1, 0, 2}, {-1, 2, 0}}, {{1, 2}}}));
    // Heights 0, 0, 0: the tie falls to (0, 0), the lightest, and it is at the end of the line.
    EXPECT_EQ(weights({{0, 0, 0}, {1, 0, 1}, {2, 0, 4}}),
              (Tessellation{{{-1, 0, 1}, {-1, 1, 0}, {-1, 1, 2}, {-1, 2, 1}}, {}}));
}

TEST(OraclePower, CollinearOnTheHullOnly) {
    // 1 lies on the segment from 0 to 2; equal weights keep it.
    EXPECT_EQ(
        power({{0, 0, 1}, {1, 0, 1}, {2, 0, 1}, {1, 5, 1}}),
        (Tessellation{{{-1, 0, 3}, {-1, 1, 0}, {-1, 2, 1}, {-1, 3, 2}, {0, 1, 3}, {1, 2, 3}}, {}}));
}

TEST(OraclePower, SquareOfFourEqualPoints) {
    // (1,1) is the last in the order: its lifted point is raised above the plane of the others.
    EXPECT_EQ(
        power({{0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}}),
        (Tessellation{{{-1, 0, 2}, {-1, 1, 0}, {-1, 2, 3}, {-1, 3, 1}, {0, 1, 2}, {1, 3, 2}}, {}}));
    // Four lifted points in a plane again (weights x² + y² + 1 + x - 2y), but now (0,1) is the
    // last.
    EXPECT_EQ(
        weights({{0, 0, 1}, {1, 0, 3}, {0, 1, 0}, {1, 1, 2}}),
        (Tessellation{{{-1, 0, 2}, {-1, 1, 0}, {-1, 2, 3}, {-1, 3, 1}, {0, 1, 3}, {0, 3, 2}}, {}}));
}

TEST(OraclePower, HiddenByThreeTogether) {
    // No single disc contains disc 3, yet its cell is empty.
    EXPECT_EQ(power({{0, 0, 2.2}, {4, 0, 2.2}, {2, 3, 2.2}, {2, 0.9375, 0.3}}),
              (Tessellation{{{-1, 0, 2}, {-1, 1, 0}, {-1, 2, 1}, {0, 1, 2}}, {{3, 2}}}));
}

TEST(OraclePower, TheWeightIsTheExactSquareOfTheRadius) {
    EXPECT_EQ(power({{5, 5, 1.1}, {5, 5, -1.1}}), (Tessellation{{}, {{1, 0}}}));
    EXPECT_EQ(power({{0, 0, 1e-200}, {0, 0, 2e-200}}), (Tessellation{{}, {{0, 1}}}));
    EXPECT_EQ(power({{0, 0, 1e200}, {0, 0, -2e200}}), (Tessellation{{}, {{0, 1}}}));
    // r² = 1 + 2^-50 + 2^-102 is larger than 1² + (2^-25)² by the last term: the diagonal joins
    // (0,0) to (1,1). Rounded, it leaves a tie, and the lightest site (1,1) loses its diagonal.
    const double r = 1 + 0x1p-51, rounded = 1 + 0x1p-50;
    const Faces hull{{-1, 0, 2}, {-1, 1, 0}, {-1, 2, 3}, {-1, 3, 1}};
    EXPECT_EQ(power({{0, 0, r}, {1, 0, 1}, {0, 1, 0x1p-25}, {1, 1, 0}}),
              (Tessellation{{hull[0], hull[1], hull[2], hull[3], {0, 1, 3}, {0, 3, 2}}, {}}));
    EXPECT_EQ(weights({{0, 0, rounded}, {1, 0, 1}, {0, 1, 0x1p-50}, {1, 1, 0}}),
              (Tessellation{{hull[0], hull[1], hull[2], hull[3], {0, 1, 2}, {1, 3, 2}}, {}}));
}

TEST(OraclePower, EveryFiniteDouble) {
    const double big = 1.7976931348623157e308, tiny = 4.9406564584124654e-324;
    EXPECT_EQ(
        power({{-big, -big, big}, {big, -big, tiny}, {0, big, -tiny}, {tiny, 0, 0}}),
        (Tessellation{{{-1, 0, 2}, {-1, 1, 0}, {-1, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}, {}}));
    EXPECT_EQ(power({{0, 0, 0}, {tiny, 0, 0}, {0, tiny, 0}}).faces.size(), 4U);
    EXPECT_EQ(power({{0, 0, big}, {tiny, 0, big}, {0, tiny, big}}).faces.size(), 4U);
    EXPECT_THROW(power({{0, 0, std::numeric_limits<double>::infinity()}}), std::invalid_argument);
    EXPECT_THROW(power({{0, std::nan(""), 0}}), std::invalid_argument);
}

TEST(OraclePower, SpheresOfTinyIntegers) {
    Random random(101);
    std::size_t hidden = 0;
    for (int i = 0; i < 12000; ++i) {
        const auto sites = integer_sites<Site>(random, 1 + random.below(8), 2 + random.below(5),
                                               1 + random.below(4));
        ASSERT_NO_THROW(hidden += power(sites).hidden.size()) << "input " << i;
    }
    EXPECT_GT(hidden, 10000U);
}

TEST(OraclePower, PermutationsGiveTheSameTessellation) {
    Random random(102);
    for (int i = 0; i < 1500; ++i) {
        const auto sites = integer_sites<Weighted>(random, 1 + random.below(8), 4, 3);
        const auto other = shuffled(sites, random);
        ASSERT_EQ(renamed(weights(sites), ranks(sites, weight)),
                  renamed(weights(other), ranks(other, weight)))
            << "input " << i;
    }
}

TEST(OraclePower, RadiiThatAreReallyReduced) {
    // The weight of rank k of n loses 2^-8(n-k): ample against coefficients of at most 16.
    Random random(103);
    for (int i = 0; i < 4000; ++i) {
        const int n = 1 + random.below(5);
        const auto sites = integer_sites<Weighted>(random, n, 5, 1 + random.below(8));
        const auto rank = ranks(sites, weight);
        auto reduced = sites;
        for (std::size_t k = 0; k < reduced.size(); ++k) {
            const double before = reduced[k].w;
            const double loss = std::ldexp(1.0, -8 * (n - rank[k]));
            reduced[k].w -= loss;
            ASSERT_EQ(before - reduced[k].w, loss);
        }
        ASSERT_EQ(weights(sites), weights(reduced)) << "input " << i;
    }
}

TEST(OraclePower, Invariances) {
    Random random(104);
    for (int i = 0; i < 800; ++i) {
        const auto sites = integer_sites<Weighted>(random, 1 + random.below(8), 5, 5);
        const auto expected = weights(sites);
        auto heavier = sites;
        for (Weighted& s : heavier) s.w += 17;
        ASSERT_EQ(weights(heavier), expected) << "heavier " << i;
        auto moved = sites;
        for (Weighted& s : moved) s.x += 1000, s.y -= 77;
        ASSERT_EQ(weights(moved), expected) << "moved " << i;

        const auto discs = integer_sites<Site>(random, 1 + random.below(8), 8, 8);
        const auto unscaled = power(discs);
        for (const int exponent : {1000, 1, -300, -1060}) {
            auto scaled = discs;
            for (Site& s : scaled) {
                s.x = std::ldexp(s.x, exponent);
                s.y = std::ldexp(s.y, exponent);
                s.r = std::ldexp(s.r, exponent);
            }
            ASSERT_EQ(power(scaled), unscaled) << "scaled by 2^" << exponent << ", " << i;
        }
    }
}

std::string wrong(const Tessellation& t, const std::vector<Weighted>& sites,
                  const signum::oracle::Neighbours& neighbours = {}) {
    return signum::oracle::what_is_wrong(t, neighbours, std::span<const Weighted>(sites));
}

TEST(OraclePower, IsValidHoweverTiesAreDecided) {
    Random random(107);
    int others = 0;
    for (int i = 0; i < 200; ++i) {
        std::vector<Weighted> sites;
        for (int k = 0, n = 1 + random.below(7); k < n; ++k)
            sites.push_back({1.0 * random.below(3), 1.0 * random.below(i % 4 == 0 ? 1 : 3),
                             1.0 * random.below(2)});
        signum::oracle::Ranks ranks(sites.size());
        for (std::size_t k = 0; k < ranks.size(); ++k) ranks[k] = k;
        ranks = shuffled(ranks, random);
        const Tessellation t = signum::oracle::power_weights(sites, ranks);
        ASSERT_EQ(wrong(t, sites), "") << i;
        others += static_cast<int>(t != weights(sites));
    }
    EXPECT_GT(others, 50);
}

TEST(OraclePower, SaysWhatIsWrong) {
    const std::vector<Weighted> square = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, -2}};
    const Tessellation t = {{{-1, 0, 3}, {-1, 1, 0}, {-1, 2, 1}, {-1, 3, 2}, {0, 1, 2}, {0, 2, 3}},
                            {{4, 0}}};
    EXPECT_EQ(wrong(t, square), "");
    const signum::oracle::Neighbours neighbours = {{5, 3, 1}, {4, 0, 2}, {4, 1, 3},
                                                   {5, 2, 0}, {2, 5, 1}, {3, 0, 4}};
    EXPECT_EQ(wrong(t, square, neighbours), "");
    auto other_neighbours = neighbours;
    std::swap(other_neighbours[4][0], other_neighbours[4][1]);
    EXPECT_EQ(wrong(t, square, other_neighbours), "a neighbour does not share the edge");
    const auto changed = [&](auto change) {
        Tessellation result = t;
        change(result);
        return wrong(result, square);
    };
    EXPECT_EQ(changed([](auto& w) { w.hidden.clear(); }),
              "hidden sites have no face, others have one");
    EXPECT_EQ(changed([](auto& w) { w.hidden.push_back({4, 1}); }), "hidden twice");
    EXPECT_EQ(changed([](auto& w) { w.hidden[0][1] = 4; }), "hidden by a hidden one");
    EXPECT_EQ(changed([](auto& w) { w.faces.pop_back(); }), "an edge is one of a single face");
    EXPECT_EQ(changed([](auto& w) { w.faces.push_back(w.faces[5]); }),
              "two faces have an edge on the same side");
    EXPECT_EQ(changed([](auto& w) {
                  for (auto& face : w.faces) std::swap(face[0], face[1]);
              }),
              "a face is not counterclockwise");
    EXPECT_EQ(changed([](auto& w) {
                  w.faces = {{-1, 0, 2}, {-1, 1, 0}, {-1, 2, 1}, {0, 1, 2}};
                  w.hidden.push_back({3, 0});
              }),
              "the areas of faces are not that of the hull");
    auto others = square;
    others[4].w = -1;
    EXPECT_EQ(wrong(t, others), "a site is in conflict with a face");
    others[4] = {0.5, 1, -9};
    EXPECT_EQ(wrong(t, others), "");
    others[4].x = 1.5;
    EXPECT_EQ(wrong(t, others), "hidden by one that is not the nearest");
    const std::vector<Weighted> line = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    const Tessellation chain = {{{-1, 0, 1}, {-1, 1, 0}, {-1, 1, 2}, {-1, 2, 1}}, {}};
    EXPECT_EQ(wrong(chain, line, {{1, 2, 1}, {0, 0, 3}, {3, 3, 0}, {2, 1, 2}}), "");
    EXPECT_EQ(wrong(chain, line, {{1, 1, 1}, {0, 0, 0}, {3, 3, 3}, {2, 2, 2}}),
              "another neighbour on a line");
    // Two faces at infinity beside the others, between a site within and its twin.
    auto twins = square;
    twins[4].w = 0;
    twins.push_back(twins[4]);
    Tessellation beside = {{{-1, 0, 3},
                            {-1, 1, 0},
                            {-1, 2, 1},
                            {-1, 3, 2},
                            {0, 1, 4},
                            {0, 4, 3},
                            {1, 2, 4},
                            {2, 3, 4}},
                           {{5, 4}}};
    EXPECT_EQ(wrong(beside, twins), "");
    beside.hidden.clear();
    beside.faces.push_back({-1, 4, 5});
    beside.faces.push_back({-1, 5, 4});
    EXPECT_EQ(wrong(beside, twins), "an edge of the hull has both ends in one place");
    // A pentagram around its middle, twice: areas add up to more than the hull.
    std::vector<Weighted> star;
    for (const auto& [x, y] : {std::pair{0, 10}, {-10, 3}, {-6, -8}, {6, -8}, {10, 3}, {0, 0}})
        star.push_back({1.0 * x, 1.0 * y, 0});
    Tessellation wound;
    for (int i = 0; i < 5; ++i) {
        wound.faces.push_back({5, 2 * i % 5, (2 * i + 2) % 5});
        wound.faces.push_back({-1, (2 * i + 2) % 5, 2 * i % 5});
    }
    EXPECT_EQ(wrong(wound, star), "the areas of faces are not that of the hull");
}

TEST(OraclePower, InvariancesWithoutTies) {
    Random random(105);
    for (int i = 0; i < 400; ++i) {
        auto sites = generic_sites<Weighted>(random, 1 + random.below(9), 0.3);
        const auto expected = weights(sites);
        auto turned = sites;
        for (Weighted& s : turned) s = {-s.y, s.x, s.w};
        auto flipped = sites;
        for (Weighted& s : flipped) s.x = -s.x;
        ASSERT_EQ(weights(turned), expected) << "turned " << i;
        ASSERT_EQ(weights(flipped), mirrored(expected)) << "flipped " << i;
    }
    // Shift invariance (thesis 5.8): translating by (p, q) and adding 2px + p² + 2qy + q² to the
    // weights adds a linear function to all distances. Faces stay; `by` and ties need not.
    for (int i = 0; i < 400; ++i) {
        std::vector<Weighted> sites;
        for (int k = 0, n = 1 + random.below(9); k < n; ++k) {
            const double x = random.below(1 << 20), y = random.below(1 << 20);
            sites.push_back({x, y, static_cast<double>(random.below(1 << 30)) * 256});
        }
        auto shifted = sites;
        const double p = random.below(1000), q = random.below(1000);
        for (Weighted& s : shifted)
            s = {s.x + p, s.y + q, s.w + 2 * p * s.x + p * p + 2 * q * s.y + q * q};
        ASSERT_EQ(weights(shifted).faces, weights(sites).faces) << "shifted " << i;
    }
}

TEST(OraclePower, WhatALookAtTheDiagramShows) {
    Random random(106);
    std::size_t seen = 0, faces = 0;
    for (int i = 0; i < 60; ++i) {
        const auto sites = generic_sites<Weighted>(random, 2 + random.below(8), 0.3);
        const auto t = weights(sites);
        bool agrees = false;
        seen += faces_seen(
            t, sites.size(),
            [&](std::size_t k, double x, double y) {
                const double dx = x - sites[k].x, dy = y - sites[k].y;
                return dx * dx + dy * dy - sites[k].w;
            },
            agrees);
        ASSERT_TRUE(agrees) << "input " << i;
        faces += finite_faces(t);
    }
    EXPECT_GT(10 * seen, 7 * faces);  // the others are too far away to be seen
}

}  // namespace
