/// Tessellations whose sites move, beside the oracle's at every event, and beside triangulations of
/// where the sites are at any time.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "../../triangulation/moving/kinetic_tessellation.hpp"
#include "../../triangulation/triangulate.hpp"
#include "../../triangulation/validate.hpp"
#include "../oracle/kinetic.hpp"
#include "../thoroughness.hpp"
#include "moving_systems.hpp"

namespace signum {
namespace {

namespace brute = oracle::kinetic;

std::vector<brute::Site> of_oracle(const std::vector<MovingSite>& sites) {
    std::vector<brute::Site> result;
    for (const MovingSite& m : sites) result.push_back({m.x, m.y, m.vx, m.vy, m.time, m.r, 0.0});
    return result;
}

/// At every epoch between two events of the oracle, and right after those that are doubles.
TEST(Kinetic, EqualsTheOracleAfterEveryEvent) {
    int changes = 0;
    int tied = 0;
    for (int trial = 0; trial < 50 * thoroughness; ++trial) {
        Systems systems(static_cast<std::uint64_t>(700 + trial));
        const int kind = trial % Systems::kinds;
        const auto sites = systems.make(kind, 3 + trial / Systems::kinds % 6);
        SCOPED_TRACE("kind " + std::to_string(kind) + " trial " + std::to_string(trial) + ": " +
                     text(sites));
        const Fall fall = trial % 4 == 3 ? Fall{systems.pick(1, 4), systems.pick(1, 4)} : Fall{};
        const brute::Epochs epochs = brute::epochs(of_oracle(sites), 0, 6, {fall.x, fall.y});
        if (!epochs.tied.empty()) {
            ++tied;
            continue;
        }
        KineticTessellation moving(sites, 0.0, fall);
        ASSERT_EQ(moving.faces(), epochs.first);
        for (std::size_t k = 0; k < epochs.changes.size(); ++k) {
            const brute::Change& change = epochs.changes[k];
            // A double right after it, before the next one.
            const oracle::Rational high = change.event.high;
            const oracle::Rational until = k + 1 < epochs.changes.size()
                                               ? epochs.changes[k + 1].event.low
                                               : oracle::Rational(6);
            double time = static_cast<double>(high);
            while (oracle::Rational(time) < high) time = std::nextafter(time, 10.0);
            if (oracle::Rational(time) >= until || time < moving.time()) continue;
            moving.advance(time);
            ASSERT_EQ(moving.faces(), change.after) << "after " << time;
            ++changes;
        }
        // Nobody meets anybody there, and only three can all be on one line.
        if (kind == Systems::anywhere && sites.size() > 3) {
            EXPECT_EQ(moving.statistics().rebuilds, 1);
        }
    }
    EXPECT_GT(changes, 60 * thoroughness);
    EXPECT_LT(tied, 25 * thoroughness);
}

const int trials = (is_fast ? 6 : 2) * Systems::kinds;

std::set<Edge> edges_of(const std::vector<Face>& faces) {
    std::set<Edge> result;
    for (const Face& face : faces)
        for (std::size_t k = 0; k < 3; ++k)
            result.insert(
                {std::min(face[k], face[(k + 1) % 3]), std::max(face[k], face[(k + 1) % 3])});
    return result;
}

/// All the sites of a system at once; every step is looked at. Whether a step was tied.
bool expect_right(const KineticTessellation& moving, const std::vector<MovingSite>& sites,
                  bool is_compared) {
    const double t = moving.time();
    const std::vector<Site> now = places(sites, t);
    const Tessellation result = moving.tessellation();
    EXPECT_TRUE(std::ranges::equal(result.sites(), now));
    const Validation validation = validate(result);
    EXPECT_TRUE(validation.valid) << validation.message;
    const Tessellation fresh = triangulate(now, Metric::power);
    const std::vector<Face> faces = moving.faces();
    if (faces == finite_faces(fresh)) {
        EXPECT_EQ(result.arrays().faces.size(), fresh.arrays().faces.size());
        return false;
    }
    const brute::Snapshot snapshot = brute::faces_at(of_oracle(sites), t);
    EXPECT_TRUE(snapshot.is_tied()) << "neither tied nor equal";
    // What is tied depends on nothing but the sites and the time.
    if (is_compared) {
        EXPECT_EQ(faces, KineticTessellation(sites, t).faces());
    }
    return true;
}

TEST(Kinetic, IsValidAndCanonicalAtDyadicTimes) {
    int tied = 0;
    for (int trial = 0; trial < trials; ++trial) {
        Systems systems(static_cast<std::uint64_t>(9000 + trial));
        const int kind = trial % Systems::kinds;
        // Of what is tied at every look, the oracle tells so in rationals.
        const int most = kind == Systems::tied_for_ever ? 12 : 30;
        const auto sites = systems.make(kind, 3 + (trial * 7) % most);
        KineticTessellation moving(0.0);
        std::set<Edge> edges;
        bool told_twice = false;
        moving.watch([&](Index a, Index b, bool comes) {
            told_twice |= comes ? !edges.insert({a, b}).second : edges.erase({a, b}) == 0;
        });
        for (const MovingSite& site : sites) moving.insert(site);
        for (int step = 0; step <= 5 * 64; step += 3) {
            moving.advance(step / 64.0);
            tied += static_cast<int>(expect_right(moving, sites, step % 4 == 0));
            if (!moving.faces().empty()) {
                EXPECT_EQ(edges, edges_of(moving.faces()));
            }
            ASSERT_FALSE(told_twice);
            ASSERT_FALSE(HasFailure()) << "kind " << kind << " trial " << trial << " at "
                                       << moving.time() << ": " << text(sites);
        }
    }
    EXPECT_GT(tied, 20);
}

/// Sites come and go, and change their ways, at dyadic times.
TEST(Kinetic, StaysRightWhileSitesComeAndGo) {
    for (int trial = 0; trial < trials; ++trial) {
        Systems systems(static_cast<std::uint64_t>(5000 + trial));
        const int kind = trial % Systems::kinds;
        std::vector<MovingSite> sites = systems.make(kind, 4 + trial % 20);
        const std::vector<MovingSite> more = systems.make((kind + trial / 10) % Systems::kinds, 60);
        KineticTessellation moving(sites, 0.0);
        std::size_t next = 0;
        for (int step = 1; step <= 60; ++step) {
            const double t = step / 16.0;
            moving.advance(t);
            const auto any = systems.random.below(static_cast<int>(sites.size()));
            MovingSite site = more[next++ % more.size()];
            site.time = t;
            switch (step % 3) {
                case 0:
                    ASSERT_EQ(moving.insert(site), static_cast<Index>(sites.size()));
                    sites.push_back(site);
                    break;
                case 1: {
                    // Where it is, another way.
                    const MovingSite was = sites[static_cast<std::size_t>(any)];
                    site.x = was.x + was.vx * (t - was.time);
                    site.y = was.y + was.vy * (t - was.time);
                    moving.change(any, site);
                    sites[static_cast<std::size_t>(any)] = site;
                    break;
                }
                default:
                    // Somewhere else.
                    moving.erase(any);
                    ASSERT_FALSE(moving.contains(any));
                    ASSERT_EQ(moving.insert(site), any);
                    sites[static_cast<std::size_t>(any)] = site;
            }
            expect_right(moving, sites, true);
            ASSERT_FALSE(HasFailure())
                << "kind " << kind << " trial " << trial << " at " << t << ": " << text(sites);
        }
    }
}

/// Right after events at places that are no doubles: what is nearly tied there may be rounded to
/// the wrong side, and result is still one of the places as they are rounded.
TEST(Kinetic, ResultsAreValidWherePlacesAreRounded) {
    int looks = 0;
    int hidden = 0;
    for (int trial = 0; trial < 40; ++trial) {
        Systems systems(static_cast<std::uint64_t>(300 + trial));
        auto sites = systems.make(trial % 3 == 0 ? 0 : 1, 6 + trial % 20);
        // Far off, doubles are too coarse to tell what happens within a step of 2^-30.
        const double far = trial % 2 == 0 ? 0.0 : 0x1p20;
        for (MovingSite& site : sites) {
            site.x = far + site.x / 3.0;
            site.vx = site.vx / 7.0;
            site.vy = site.vy / 7.0;
            site.time = site.time / 3.0;
        }
        KineticTessellation moving(sites, 0.0);
        for (int step = 0; step < 60; ++step) {
            const auto event = moving.next_event();
            if (!event || *event > 100.0) break;
            moving.advance(*event);
            const Tessellation result = moving.tessellation();
            const Validation validation = validate(result);
            ASSERT_TRUE(validation.valid) << validation.message << " trial " << trial << " at "
                                          << moving.time() << ": " << text(sites);
            ++looks;
            hidden += static_cast<int>(!result.hidden().empty());
        }
    }
    EXPECT_GT(looks, 1000);
    EXPECT_GT(hidden, 100);
}

/// Five on one power circle for ever, of which a face turns over at 0: the edge through which the
/// fifth leaves it is tied for ever, and the site across comes last in the order.
TEST(Kinetic, AFaceOfSitesThatAreTiedForEverDoesNotTurnOver) {
    const std::vector<MovingSite> sites = {{-3, 0, 0, 0, 3, 0},
                                           {-1, -1, -1, 1, 2, 0},
                                           {0.5, 0, 0, 0, 0.5, 0},
                                           {0, 2, 0, 2, 0, 0},
                                           {-1, 0, -1, 1, 1, 0}};
    std::array<std::size_t, 5> order = {0, 1, 2, 3, 4};
    do {
        std::vector<MovingSite> in_order;
        for (const std::size_t k : order) in_order.push_back(sites[k]);
        KineticTessellation moving(-0.125);
        for (const MovingSite& site : in_order) moving.insert(site);
        for (const double t : {-0.0625, 0.125, 1.0}) {
            moving.advance(t);
            ASSERT_EQ(moving.faces(), KineticTessellation(in_order, t).faces()) << t;
        }
    } while (std::ranges::next_permutation(order).found);
}

}  // namespace
}  // namespace signum
