/// The oracle of moving power triangulations against cases done by hand, the static oracle at times
/// at which all positions are doubles, signs at many times, and invariances.

#include <gtest/gtest.h>
#include "kinetic.hpp"
#include "linear_form.hpp"
#include "oracle_test_support.hpp"
#include "power.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

namespace {

using namespace signum::oracle_test;
using namespace signum::oracle::kinetic;
using signum::oracle::Rational;
using Four = std::array<std::int32_t, 4>;
using Sites = std::vector<Site>;

Rational fraction(int p, int q) {
    return Rational(p) / Rational(q);
}

std::vector<double> times(const std::vector<Event>& events) {
    std::vector<double> result;
    for (const Event& event : events) result.push_back(event.nearest);
    return result;
}
std::vector<double> times(const Epochs& epochs) {
    std::vector<double> result;
    for (const Change& change : epochs.changes) result.push_back(change.event.nearest);
    return result;
}

std::set<std::vector<std::int32_t>> who(const Event& event) {
    std::set<std::vector<std::int32_t>> result;
    for (const Certificate& certificate : event.certificates) result.insert(certificate.sites);
    return result;
}

bool holds(const Event& event, const Rational& t) {
    return event.low <= t && t <= event.high;
}

Triangles without(const Triangles& a, const Triangles& b) {
    Triangles rest;
    std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(rest));
    return rest;
}

Sites moved(Sites sites, double x, double y) {
    for (Site& site : sites) site.x += x, site.y += y;
    return sites;
}
Sites together(Sites a, const Sites& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

/// Three on the unit circle and one that comes from below, at -2 when t is 0.
const Sites riser{{1, 0}, {-1, 0}, {0, 1}, {0, -2, 0, 1}};

TEST(OracleKinetic, AFlipAHullVertexAndOneThroughAnother) {
    const Epochs run = epochs(riser, fraction(1, 2), 4);
    EXPECT_TRUE(run.tied.empty());
    EXPECT_EQ(times(run), (std::vector<double>{1, 2, 3}));
    EXPECT_EQ(times(events(riser, fraction(1, 2), 4).events), (std::vector<double>{1, 2, 3}));
    ASSERT_EQ(run.changes.size(), 3u);

    const Triangles below{{0, 1, 3}, {0, 2, 1}}, in_circle{{0, 2, 3}, {1, 3, 2}};
    const Triangles in_hull{{0, 2, 3}, {0, 3, 1}, {1, 3, 2}},
        above{{0, 2, 1}, {0, 3, 2}, {1, 2, 3}};
    EXPECT_EQ(run.first, below);
    EXPECT_EQ(run.changes[0].before, below);
    EXPECT_EQ(run.changes[0].after, in_circle);
    EXPECT_EQ(run.changes[1].before, in_circle);
    EXPECT_EQ(run.changes[1].after, in_hull);
    EXPECT_EQ(run.changes[2].before, in_hull);
    EXPECT_EQ(run.changes[2].after, above);

    EXPECT_FALSE(run.changes[0].several);
    EXPECT_EQ(run.changes[0].event.certificates, (std::vector<Certificate>{{{0, 1, 2, 3}, 1, -1}}));
    EXPECT_FALSE(run.changes[1].several);
    EXPECT_EQ(run.changes[1].event.certificates, (std::vector<Certificate>{{{0, 1, 3}, 1, -1}}));
    EXPECT_TRUE(run.changes[2].several);
    EXPECT_EQ(who(run.changes[2].event),
              (std::set<std::vector<std::int32_t>>{{2, 3}, {0, 2, 3}, {1, 2, 3}, {0, 1, 2, 3}}));
    for (int i = 0; i < 3; ++i)
        EXPECT_TRUE(holds(run.changes[static_cast<std::size_t>(i)].event, i + 1));
}

TEST(OracleKinetic, TheEndsAreNotLookedAt) {
    EXPECT_EQ(times(epochs(riser, 1, 3)), (std::vector<double>{2}));
    EXPECT_EQ(times(epochs(riser, 2, 4)), (std::vector<double>{3}));
    EXPECT_THROW(epochs(riser, 1, 1), std::invalid_argument);
}

TEST(OracleKinetic, WhatIsTiedAtATime) {
    const Snapshot flip = faces_at(riser, 1);
    EXPECT_TRUE(flip.is_tied());
    EXPECT_EQ(flip.circles, (std::vector<Four>{{0, 1, 2, 3}}));
    EXPECT_TRUE(flip.triangles.empty());
    const Snapshot hull = faces_at(riser, 2);
    EXPECT_TRUE(hull.is_tied());
    EXPECT_EQ(hull.lines, (std::vector<Triangle>{{0, 1, 3}}));
    EXPECT_EQ(hull.triangles, (Triangles{{0, 2, 3}, {1, 3, 2}}));
    EXPECT_TRUE(faces_at(riser, 3).is_tied());
    EXPECT_FALSE(faces_at(riser, fraction(1, 3)).is_tied());
}

TEST(OracleKinetic, HiddenByAHeavyOneOnAnEdge) {
    // On the edges between the heavy one, whose height is -20, and those at ±10, whose height is
    // 100, the height is -20 + 12 |s|: below s² where |s| < 2.
    Sites sites{{0, 0}, {10, 0}, {0, 10}, {-10, 0}, {0, -10}, {-5, 0, 1, 0}};
    sites[0].w = 20;
    const Epochs run = epochs(sites, 1, 9);
    const Triangles hidden{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}};
    EXPECT_TRUE(run.tied.empty());  // four are always on one line, which does not matter
    EXPECT_EQ(times(run), (std::vector<double>{3, 7}));
    ASSERT_EQ(run.changes.size(), 2u);
    EXPECT_EQ(run.first,
              (Triangles{{0, 1, 2}, {0, 2, 5}, {0, 4, 1}, {0, 5, 4}, {2, 3, 5}, {3, 4, 5}}));
    EXPECT_EQ(run.changes[0].after, hidden);
    EXPECT_EQ(run.changes[1].before, hidden);
    EXPECT_EQ(run.changes[1].after,
              (Triangles{{0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 2}, {1, 2, 5}, {1, 5, 4}}));
    EXPECT_TRUE(run.changes[0].several);
    // Right through the heavy one at 5: that they coincide is seen, but changes nothing.
    const Candidates all = events(sites, 1, 9);
    EXPECT_TRUE(std::any_of(all.events.begin(), all.events.end(), [](const Event& event) {
        return event.nearest == 5 && who(event).count({0, 5}) == 1;
    }));
    EXPECT_EQ(faces_at(sites, 5).triangles, hidden);
    EXPECT_FALSE(faces_at(sites, 5).is_tied());
    EXPECT_NE(
        std::find(all.always.begin(), all.always.end(), std::vector<std::int32_t>{0, 1, 3, 5}),
        all.always.end());
}

TEST(OracleKinetic, TwoThatMeetHidden) {
    Sites sites{{0, 0}, {10, 0}, {0, 10}, {-10, 0}, {0, -10}, {-0.5, 0.5, 1, 0}, {0.5, 0.5, -1, 0}};
    sites[0].w = 20;
    EXPECT_EQ(times(events(sites, fraction(2, 5), fraction(3, 5)).events),
              (std::vector<double>{0.5}));
    EXPECT_TRUE(epochs(sites, fraction(2, 5), fraction(3, 5)).changes.empty());
    EXPECT_FALSE(faces_at(sites, fraction(1, 2)).is_tied());
}

TEST(OracleKinetic, AVertexOfThreeEdgesComesAndGoes) {
    // The circle of the corners has its centre at (0, -2) and radius 10. A site of weight -84 is
    // visible as long as it is nearer than 4 to the centre.
    Sites sites{{-8, -8}, {8, -8}, {0, 8}, {-5, -2, 1, 0}};
    sites[3].w = -84;
    const Epochs run = epochs(sites, fraction(1, 4), fraction(39, 4));
    EXPECT_EQ(times(run), (std::vector<double>{1, 9}));
    ASSERT_EQ(run.changes.size(), 2u);
    EXPECT_EQ(run.first, (Triangles{{0, 1, 2}}));
    EXPECT_EQ(run.changes[0].after, (Triangles{{0, 1, 3}, {0, 3, 2}, {1, 2, 3}}));
    EXPECT_EQ(run.changes[1].after, (Triangles{{0, 1, 2}}));
    EXPECT_FALSE(run.changes[0].several);
    // The weight of a radius is its square.
    for (Site& site : sites) site.w += 100;
    sites[3].w = 0, sites[3].r = 4;
    const Epochs same = epochs(sites, fraction(1, 4), fraction(39, 4));
    EXPECT_EQ(times(same), times(run));
    EXPECT_EQ(same.changes[0].after, run.changes[0].after);
}

TEST(OracleKinetic, TwoFlipsAtOneTime) {
    const Sites sites = together(riser, moved(riser, 100, 37));
    const Epochs run = epochs(sites, fraction(1, 2), fraction(3, 2));
    const auto flip = std::find_if(run.changes.begin(), run.changes.end(),
                                   [](const Change& c) { return holds(c.event, 1); });
    ASSERT_NE(flip, run.changes.end());
    EXPECT_TRUE(flip->several);
    EXPECT_EQ(without(flip->before, flip->after),
              (Triangles{{0, 1, 3}, {0, 2, 1}, {4, 5, 7}, {4, 6, 5}}));
    EXPECT_EQ(without(flip->after, flip->before),
              (Triangles{{0, 2, 3}, {1, 3, 2}, {4, 6, 7}, {5, 7, 6}}));
}

TEST(OracleKinetic, TwoTimesWithOneDouble) {
    Sites late = moved(riser, 100, 37);
    late[3].t0 = 0x1p-60;
    const Epochs run = epochs(together(riser, late), fraction(1, 2), fraction(3, 2));
    std::vector<Change> at_one;
    for (const Change& change : run.changes)
        if (change.event.nearest == 1) at_one.push_back(change);
    ASSERT_EQ(at_one.size(), 2u);
    EXPECT_LT(at_one[0].event.high, at_one[1].event.low);
    EXPECT_EQ(who(at_one[0].event), (std::set<std::vector<std::int32_t>>{{0, 1, 2, 3}}));
    EXPECT_EQ(who(at_one[1].event), (std::set<std::vector<std::int32_t>>{{4, 5, 6, 7}}));
}

TEST(OracleKinetic, TimesThatDifferLittleOfPolynomialsThatShareAnother) {
    // The last of the second four is on their circle at 1 + 2^-50 and at 3, that of the first four
    // at 1 and 3.
    const double d = 1 - 0x1p-51;
    const Sites second{{d, 0}, {-d, 0}, {0, d}, {0, 0, 0, 1, 2 + 0x1p-51}};
    const Candidates all = events(together(moved(riser, 100, 37), second), fraction(1, 2), 4);
    std::vector<double> first, other;
    for (const Event& event : all.events) {
        if (who(event).count({0, 1, 2, 3}) == 1) first.push_back(event.nearest);
        if (who(event).count({4, 5, 6, 7}) == 1) other.push_back(event.nearest);
    }
    EXPECT_EQ(first, (std::vector<double>{1, 3}));
    EXPECT_EQ(other, (std::vector<double>{1 + 0x1p-50, 3}));
}

TEST(OracleKinetic, FourTimesOfOnePolynomial) {
    // With u = t - 5 the circle through (u, 0), (-u, 0) and (0, 1) meets the axis in (0, -u²), too.
    // (0, 4 u + 3) is there when u is -3 and -1, and at (0, 1) when u is -1/2; the first two
    // coincide when it is 0.
    const Sites sites{{0, 0, 1, 0, 5}, {0, 0, -1, 0, 5}, {0, 1}, {0, 3, 0, 4, 5}};
    const Candidates all = events(sites, 1, 6);
    std::vector<double> found;
    for (const Event& event : all.events)
        if (who(event).count({0, 1, 2, 3}) == 1) found.push_back(event.nearest);
    EXPECT_EQ(found, (std::vector<double>{2, 4, 4.5, 5}));
}

TEST(OracleKinetic, ACircleThatIsTouched) {
    const Sites sites{{1, 0}, {-1, 0}, {0, 1}, {-2, -1, 1, 0}};
    const Candidates all = events(sites, fraction(1, 2), fraction(7, 2));
    ASSERT_EQ(times(all.events), (std::vector<double>{2}));
    EXPECT_EQ(all.events[0].certificates, (std::vector<Certificate>{{{0, 1, 2, 3}, 1, 1}}));
    EXPECT_EQ(faces_at(sites, 2).circles, (std::vector<Four>{{0, 1, 2, 3}}));
    const Epochs run = epochs(sites, fraction(1, 2), fraction(7, 2));
    EXPECT_TRUE(run.changes.empty());
    EXPECT_EQ(run.first, (Triangles{{0, 1, 3}, {0, 2, 1}}));
}

TEST(OracleKinetic, IrrationalTimes) {
    // (t, -t) leaves the circles of radius 1 and 2.
    Sites sites{{1, 0}, {-1, 0}, {0, 1}, {0, 0, 1, -1}};
    const Epochs small = epochs(sites, fraction(1, 4), 2);
    EXPECT_EQ(times(small), (std::vector<double>{std::sqrt(0.5)}));
    const Event& event = small.changes.at(0).event;
    EXPECT_LT(event.low * event.low, fraction(1, 2));
    EXPECT_GT(event.high * event.high, fraction(1, 2));
    for (std::size_t i = 0; i < 3; ++i) sites[i].x *= 2, sites[i].y *= 2;
    EXPECT_EQ(times(epochs(sites, fraction(1, 4), 2)), (std::vector<double>{std::sqrt(2.0)}));
}

TEST(OracleKinetic, OneIrrationalTimeOfTwoPolynomials) {
    // The second four grow: their polynomial is a multiple of (1 + t)² (t² - 1/2).
    const Sites first{{1, 0}, {-1, 0}, {0, 1}, {0, 0, 1, -1}};
    const Sites second{{1, 0, 1, 0}, {-1, 0, -1, 0}, {0, 1, 0, 1}, {0.5, -0.5, 1, -1}};
    const Epochs run = epochs(together(first, moved(second, 100, 37)), fraction(1, 4), 2);
    std::vector<Change> found;
    for (const Change& change : run.changes)
        if (change.event.nearest == std::sqrt(0.5)) found.push_back(change);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(who(found[0].event),
              (std::set<std::vector<std::int32_t>>{{0, 1, 2, 3}, {4, 5, 6, 7}}));
}

TEST(OracleKinetic, HalvesGoToEven) {
    Sites sites = riser;
    for (const auto& [t0, time] : {std::pair{0x1p-53, 1.0},
                                   {0x3p-53, 1 + 0x1p-51},
                                   {0x1.8p-53, 1 + 0x1p-52},
                                   {-0x1p-54, 1.0}}) {
        sites[3].t0 = t0;
        EXPECT_EQ(times(epochs(sites, fraction(1, 2), fraction(3, 2))),
                  (std::vector<double>{time}));
    }
}

TEST(OracleKinetic, ThreeAloneTurnRound) {
    const Sites sites{{0, 0}, {2, 0}, {1, -1, 0, 1}};
    const Epochs run = epochs(sites, 0, 2);
    EXPECT_EQ(times(run), (std::vector<double>{1}));
    EXPECT_EQ(run.first, (Triangles{{0, 2, 1}}));
    EXPECT_EQ(run.changes.at(0).after, (Triangles{{0, 1, 2}}));
}

TEST(OracleKinetic, AHiddenOneLeavesTheHull) {
    // On the edge from (-2, 0) to (2, 0) the height is 4: above it, 5, a site of weight -5 at
    // (0, 0). It is hidden inside the hull: there the height is 4 - 3 y.
    Sites sites{{-2, 0}, {2, 0}, {0, 1}, {0, 0.25, 0, -0.25}};
    sites[3].w = -5;
    const Epochs run = epochs(sites, 0, 2);
    EXPECT_EQ(times(run), (std::vector<double>{1}));
    EXPECT_EQ(run.first, (Triangles{{0, 1, 2}}));
    EXPECT_EQ(run.changes.at(0).after, (Triangles{{0, 1, 2}, {0, 3, 1}}));
    EXPECT_EQ(who(run.changes.at(0).event), (std::set<std::vector<std::int32_t>>{{0, 1, 3}}));
    EXPECT_TRUE(faces_at(sites, 1).is_tied());
}

TEST(OracleKinetic, TiedForEver) {
    Sites square{{0, 0, 1, 2}, {1, 0, 1, 2}, {0, 1, 1, 2}, {1, 1, 1, 2}};
    square[3] = {3, 5, 1, 2, 2};  // the same motion, told from 2
    const Epochs run = epochs(square, 0, 1);
    EXPECT_EQ(run.tied, (std::vector<Four>{{0, 1, 2, 3}}));
    EXPECT_TRUE(run.changes.empty());
    EXPECT_EQ(events(square, 0, 1).always, (std::vector<std::vector<std::int32_t>>{{0, 1, 2, 3}}));
    EXPECT_TRUE(events(square, 0, 1).events.empty());
    // A site in the middle of them: their circle is no longer empty.
    square.push_back({0.5, 0.5, 1, 2});
    const Epochs star = epochs(square, 0, 1);
    EXPECT_TRUE(star.tied.empty());
    EXPECT_EQ(star.first.size(), 4u);
    // As long as it is there; when it leaves, they are tied.
    square.back().vx = 2;
    EXPECT_EQ(epochs(square, 0, 2).tied, (std::vector<Four>{{0, 1, 2, 3}}));
    // Three on a side of the hull for ever do not matter.
    const Sites side{{0, 0}, {1, 0}, {2, 0}, {1, 5, 1, 0}};
    EXPECT_TRUE(epochs(side, 0, 9).tied.empty());
    EXPECT_EQ(epochs(side, 0, 9).first, (Triangles{{0, 1, 3}, {1, 2, 3}}));
    EXPECT_EQ(faces_at(side, 3).lines, (std::vector<Triangle>{{0, 1, 2}}));
    // All on one line: no triangle ever.
    const Sites line{{0, 0, 1, 1}, {1, 1, 0, 0}, {2, 2, -1, -1}, {3, 3, 1, 1}};
    EXPECT_TRUE(epochs(line, 0, 9).tied.empty());
    EXPECT_TRUE(epochs(line, 0, 9).changes.empty());
}

TEST(OracleKinetic, FewSites) {
    EXPECT_TRUE(epochs(Sites{}, 0, 1).changes.empty());
    EXPECT_TRUE(epochs(Sites{{0, 0, 1, 1}}, 0, 1).changes.empty());
    const Candidates two = events(Sites{{0, 0, 1, 1}, {1, 1, -1, -1}}, 0, 1);
    EXPECT_EQ(times(two.events), (std::vector<double>{0.5}));
    EXPECT_EQ(events(Sites{{0, 0, 1, 1}, {0, 0, 1, 1}}, 0, 1).always,
              (std::vector<std::vector<std::int32_t>>{{0, 1}}));
}

// --- random systems

double part(Random& random, int parts) {
    return static_cast<double>(random.below(parts)) / parts;
}

/// Multiples of 2^-10: at multiples of 2^-5 in [0, 1] the positions are doubles.
Sites generic(Random& random, int n) {
    Sites sites;
    for (int i = 0; i < n; ++i) {
        Site site;
        site.x = part(random, 1024), site.y = part(random, 1024);
        site.vx = 2 * part(random, 1024) - 1, site.vy = 2 * part(random, 1024) - 1;
        site.t0 = part(random, 4);
        site.w = 0.25 * part(random, 256);
        sites.push_back(site);
    }
    return sites;
}

/// Few different numbers: ties at many times, some of them for ever.
Sites integers(Random& random, int n) {
    Sites sites;
    for (int i = 0; i < n; ++i) {
        Site site;
        site.x = random.below(4), site.y = random.below(4);
        site.vx = random.below(5) - 2, site.vy = random.below(5) - 2;
        site.r = random.below(2);
        sites.push_back(site);
    }
    return sites;
}

std::size_t edges(const Triangles& triangles) {
    std::set<std::pair<std::int32_t, std::int32_t>> edges;
    for (const Triangle& t : triangles)
        for (std::size_t i = 0; i < 3; ++i) edges.insert(std::minmax(t[i], t[(i + 1) % 3]));
    return edges.size();
}
std::size_t corners(const Triangles& triangles) {
    std::set<std::int32_t> corners;
    for (const Triangle& t : triangles) corners.insert(t.begin(), t.end());
    return corners.size();
}

/// No directed edge twice, and as many vertices, edges and triangles as a disc has.
void expect_disc(const Triangles& triangles) {
    std::set<std::pair<std::int32_t, std::int32_t>> directed;
    for (const Triangle& t : triangles)
        for (std::size_t i = 0; i < 3; ++i)
            EXPECT_TRUE(directed.emplace(t[i], t[(i + 1) % 3]).second);
    if (triangles.empty()) return;
    EXPECT_EQ(corners(triangles) + triangles.size(), edges(triangles) + 1);
}

/// The triangles at t, nothing where t may be the time of a change.
const Triangles* triangles_at(const Epochs& run, const Rational& t) {
    const Triangles* now = &run.first;
    for (const Change& change : run.changes) {
        if (holds(change.event, t)) return nullptr;
        if (t > change.event.high) now = &change.after;
    }
    return now;
}

void expect_chain(const Epochs& run) {
    const Triangles* now = &run.first;
    for (std::size_t i = 0; i < run.changes.size(); ++i) {
        const Change& change = run.changes[i];
        EXPECT_EQ(change.before, *now);
        EXPECT_NE(change.before, change.after);
        now = &change.after;
        expect_disc(change.after);
        if (i > 0) {
            EXPECT_LT(run.changes[i - 1].event.high, change.event.low);
        }
    }
    expect_disc(run.first);
}

/// The static oracle on positions that must be doubles.
Triangles triangles_of_the_static_oracle(const Sites& sites, double t) {
    std::vector<signum::Site> discs;
    std::vector<signum::power::Site> weighted;
    for (const Site& site : sites) {
        const double x = site.x + site.vx * (t - site.t0), y = site.y + site.vy * (t - site.t0);
        discs.push_back({x, y, site.r});
        weighted.push_back({x, y, site.w});
    }
    const bool by_radius =
        std::any_of(sites.begin(), sites.end(), [](const Site& site) { return site.r != 0; });
    const Tessellation all =
        by_radius ? signum::oracle::power(discs) : signum::oracle::power_weights(weighted);
    Triangles triangles;
    for (const Face& face : all.faces)
        if (face[0] >= 0) triangles.push_back(face);
    return triangles;
}

TEST(OracleKinetic, EqualsTheStaticOracle) {
    Random random(701);
    int compared = 0, tied = 0;
    for (int i = 0; i < 60; ++i) {
        const bool is_generic = i % 2 == 0;
        const Sites sites = is_generic ? generic(random, 3 + random.below(6))
                                       : integers(random, 3 + random.below(6));
        for (int k = 0; k < 6; ++k) {
            const double t = part(random, is_generic ? 32 : 4);
            const Snapshot faces = faces_at(sites, signum::oracle::exactly(t));
            if (!faces.circles.empty()) {
                ++tied;
                continue;
            }
            ++compared;
            ASSERT_EQ(faces.triangles, triangles_of_the_static_oracle(sites, t)) << i;
        }
    }
    EXPECT_GT(compared, 200);
    EXPECT_GT(tied, 20);
}

TEST(OracleKinetic, FlipsOfGenericSystems) {
    Random random(702);
    int flips = 0, vertices = 0, turns = 0, hidden_leave = 0, idle = 0;
    for (int i = 0; i < 12; ++i) {
        const int n = 5 + i % 4;
        const Sites sites = generic(random, n);
        const Epochs run = epochs(sites, 0, 1);
        ASSERT_TRUE(run.tied.empty());
        expect_chain(run);
        idle += static_cast<int>(events(sites, 0, 1).events.size() - run.changes.size());
        for (const Change& change : run.changes) {
            if (change.several) continue;
            const Certificate& certificate = change.event.certificates[0];
            EXPECT_EQ(certificate.before * certificate.after, -1);
            const auto more =
                static_cast<int>(change.after.size()) - static_cast<int>(change.before.size());
            const auto comes =
                static_cast<int>(corners(change.after)) - static_cast<int>(corners(change.before));
            // What goes and comes has the certificate's sites as its corners.
            Triangles differing = without(change.before, change.after);
            const Triangles coming = without(change.after, change.before);
            differing.insert(differing.end(), coming.begin(), coming.end());
            std::set<std::int32_t> of;
            for (const Triangle& t : differing) of.insert(t.begin(), t.end());
            EXPECT_EQ(std::vector<std::int32_t>(of.begin(), of.end()), certificate.sites);
            if (certificate.sites.size() == 3) {
                EXPECT_EQ(std::abs(more), 1);
                EXPECT_TRUE(comes == 0 || comes == more);
                ++(comes == 0 ? turns : hidden_leave);
            } else {
                EXPECT_EQ(certificate.sites.size(), 4u);
                EXPECT_EQ(more, 2 * comes);
                EXPECT_EQ(differing.size(), 4u);
                ++(comes == 0 ? flips : vertices);
            }
        }
    }
    EXPECT_GT(flips, 50);
    EXPECT_GT(vertices, 10);
    EXPECT_GT(turns, 20);
    EXPECT_GT(idle, 100);
    EXPECT_GT(hidden_leave, 0);
}

TEST(OracleKinetic, ManyTimes) {
    Random random(703);
    int tied_for_ever = 0, compared = 0, changed = 0;
    for (int i = 0; i < 40; ++i) {
        const bool is_generic = i % 4 == 0;
        const Sites sites =
            is_generic ? generic(random, 5 + i % 3) : integers(random, 4 + random.below(4));
        const Epochs run = epochs(sites, 0, 1);
        if (!run.tied.empty()) {
            ++tied_for_ever;
            continue;
        }
        expect_chain(run);
        changed += static_cast<int>(run.changes.size());
        for (int k = 1; k < 120; ++k) {
            const Rational t = fraction(k, 120);
            const Triangles* now = triangles_at(run, t);
            if (now == nullptr) continue;
            const Snapshot faces = faces_at(sites, t);
            if (!faces.circles.empty()) continue;  // one that is only touched
            ++compared;
            ASSERT_EQ(faces.triangles, *now) << i << " at " << k << "/120";
        }
    }
    EXPECT_GT(compared, 3000);
    EXPECT_GT(changed, 100);
    EXPECT_GT(tied_for_ever, 0);
}

/// Of rows (1, x, y, x² + y² - w), expanded along the first column.
int sign_of_four(const Sites& sites, const std::vector<std::int32_t>& four, const Rational& t) {
    using signum::oracle::exactly;
    std::array<std::array<Rational, 3>, 4> rows;
    for (std::size_t i = 0; i < 4; ++i) {
        const Site& site = sites[static_cast<std::size_t>(four[i])];
        const Rational passed = t - exactly(site.t0);
        const Rational x = exactly(site.x) + exactly(site.vx) * passed;
        const Rational y = exactly(site.y) + exactly(site.vy) * passed;
        rows[i] = {x, y, x * x + y * y - exactly(site.w) - exactly(site.r) * exactly(site.r)};
    }
    Rational sum = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        std::array<std::size_t, 3> o{};
        for (std::size_t k = 0, next = 0; k < 4; ++k)
            if (k != i) o[next++] = k;
        const auto &a = rows[o[0]], &b = rows[o[1]], &c = rows[o[2]];
        const Rational minor = a[0] * (b[1] * c[2] - b[2] * c[1]) -
                               a[1] * (b[0] * c[2] - b[2] * c[0]) +
                               a[2] * (b[0] * c[1] - b[1] * c[0]);
        // (1, 0, 0, 0) as the last row has the sign -1: so in_circle is -(this determinant).
        sum += i % 2 == 0 ? minor : Rational(-minor);
    }
    return -sum.sign();
}

TEST(OracleKinetic, SignsOfAllFoursAtManyTimes) {
    Random random(704);
    int changes = 0;
    for (int i = 0; i < 8; ++i) {
        const Sites sites = i % 2 == 0 ? generic(random, 6) : integers(random, 6);
        const Candidates all = events(sites, 0, 1);
        const std::set<std::vector<std::int32_t>> always(all.always.begin(), all.always.end());
        for (std::int32_t a = 0; a < 6; ++a)
            for (std::int32_t b = a + 1; b < 6; ++b)
                for (std::int32_t c = b + 1; c < 6; ++c)
                    for (std::int32_t d = c + 1; d < 6; ++d) {
                        const std::vector<std::int32_t> four{a, b, c, d};
                        // The signs that the events say, from one to the next.
                        std::vector<std::pair<const Event*, Certificate>> its;
                        for (const Event& event : all.events)
                            for (const Certificate& certificate : event.certificates)
                                if (certificate.sites == four) its.push_back({&event, certificate});
                        int last = 0;
                        for (int k = 1; k < 64; ++k) {
                            const Rational t = fraction(k, 64);
                            const int sign = sign_of_four(sites, four, t);
                            if (last * sign < 0) ++changes;
                            last = sign;
                            if (always.count(four) == 1) {
                                ASSERT_EQ(sign, 0);
                                continue;
                            }
                            bool at_event = false;
                            int told = its.empty() ? sign : its.front().second.before;
                            for (const auto& [event, certificate] : its) {
                                if (holds(*event, t)) at_event = true;
                                if (event->high < t) told = certificate.after;
                            }
                            if (!at_event) {
                                ASSERT_EQ(sign, told);
                                ASSERT_NE(sign, 0);
                            }
                        }
                    }
    }
    EXPECT_GT(changes, 50);
}

void expect_same_changes(const Epochs& a, const Epochs& b) {
    EXPECT_EQ(a.tied, b.tied);
    EXPECT_EQ(a.first, b.first);
    ASSERT_EQ(times(a), times(b));
    for (std::size_t i = 0; i < a.changes.size(); ++i) {
        EXPECT_EQ(a.changes[i].event.certificates, b.changes[i].event.certificates);
        EXPECT_EQ(a.changes[i].before, b.changes[i].before);
        EXPECT_EQ(a.changes[i].after, b.changes[i].after);
    }
}

TEST(OracleKinetic, Invariances) {
    Random random(705);
    for (int i = 0; i < 6; ++i) {
        const Sites sites = i % 2 == 0 ? generic(random, 6) : integers(random, 6);
        const Epochs run = epochs(sites, 0, 1);

        // All drift together, and all weigh more.
        Sites drifting = sites;
        for (Site& site : drifting) {
            site.vx += 3, site.vy -= 2;
            site.x += 3 * site.t0, site.y -= 2 * site.t0;
            site.w += 1;
        }
        expect_same_changes(run, epochs(drifting, 0, 1));

        // Far smaller.
        Sites scaled = sites;
        for (Site& site : scaled) {
            for (double* number : {&site.x, &site.y, &site.vx, &site.vy, &site.r})
                *number = std::ldexp(*number, -500);
            site.w = std::ldexp(site.w, -1000);
        }
        expect_same_changes(run, epochs(scaled, 0, 1));

        // All fall: who starts later has that much more speed, and has fallen so far.
        Sites falling = sites;
        for (Site& site : falling) {
            site.vy -= 2 * site.t0;
            site.y -= site.t0 * site.t0;
        }
        expect_same_changes(run, epochs(falling, 0, 1, {0, -2}));

        // Backwards.
        Sites back = sites;
        for (Site& site : back) site.vx = -site.vx, site.vy = -site.vy, site.t0 = -site.t0;
        const Epochs reversed = epochs(back, -1, 0);
        EXPECT_EQ(reversed.tied, run.tied);
        ASSERT_EQ(reversed.changes.size(), run.changes.size());
        for (std::size_t k = 0; k < run.changes.size(); ++k) {
            const Change& one = run.changes[k];
            const Change& other = reversed.changes[run.changes.size() - 1 - k];
            EXPECT_EQ(other.event.nearest, -one.event.nearest);
            EXPECT_EQ(other.before, one.after);
            EXPECT_EQ(other.after, one.before);
        }
        if (!run.tied.empty()) continue;

        // In two parts, divided at a time at which nothing happens.
        const Rational middle = fraction(1009, 3001);
        const Epochs early = epochs(sites, 0, middle), late = epochs(sites, middle, 1);
        EXPECT_EQ(early.changes.size() + late.changes.size(), run.changes.size());
        EXPECT_EQ(late.first, early.changes.empty() ? early.first : early.changes.back().after);
    }
}

}  // namespace
