/// Triangulations of moving sites at moments: right after the times at which they change, roots of
/// degree up to 4 that no double is, beside the oracle's.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "../../kinetic/moving_kernel.hpp"
#include "../../triangulation/insertion/insert.hpp"
#include "../oracle/kinetic.hpp"
#include "../oracle/oracle_test_support.hpp"

namespace signum::kinetic {
namespace {

namespace brute = oracle::kinetic;
using oracle_test::Random;
using triangulation::Insertion;
using triangulation::Topology;

struct Both {
    std::vector<MovingSite> moving;
    std::vector<brute::Site> of_oracle;
};
/// Dyadic numbers; of every third set some have no weight.
Both any(int number, Random& random, bool weighted) {
    Both sites;
    const auto pick = [&](double size) { return size * (random.below(4096) - 2048) / 2048.0; };
    for (int i = 0; i < number; ++i) {
        const double r = weighted && i % 2 == 0 ? std::fabs(pick(2.0)) : 0.0;
        sites.moving.push_back({pick(8.0), pick(8.0), pick(1.0), pick(1.0), r, pick(0.5)});
        const MovingSite& m = sites.moving.back();
        sites.of_oracle.push_back({m.x, m.y, m.vx, m.vy, m.time, m.r, 0.0});
    }
    return sites;
}

/// Right after the moment that `set` sets.
template <class Set>
brute::Triangles triangles_at(const std::vector<MovingSite>& sites, const Set& set) {
    const Sites all{sites, {}};
    Moment moment(0.0);
    set(moment, all);
    roots::Tally tally;
    MovingKernel kernel(all, moment, tally);
    const auto number = static_cast<Index>(sites.size());
    Index third = 2;
    while (third < number && kernel.ccw(0, 1, third) == 0) ++third;
    std::vector<Index> hidden_by(sites.size(), -1);
    Topology topology(sites.size());
    const bool left = kernel.ccw(0, 1, third) > 0;
    Insertion<MovingKernel> insertion(topology, kernel, hidden_by, 0, left ? 1 : third,
                                      left ? third : 1);
    for (Index q = 2; q < number; ++q)
        if (q != third) insertion.insert(q);
    brute::Triangles result;
    for (Index f = 0; f < topology.faces(); ++f) {
        if (topology.is_vacant(f) || topology.is_infinite(f)) continue;
        brute::Triangle corners;
        std::ranges::copy(topology.vertices(f), corners.begin());
        std::rotate(corners.begin(), std::ranges::min_element(corners), corners.end());
        result.push_back(corners);
    }
    std::ranges::sort(result);
    return result;
}

brute::Triangles triangles(const std::vector<MovingSite>& sites, double time) {
    return triangles_at(sites, [&](Moment& moment, const Sites&) { moment.set(time); });
}
/// The triangles right after the first root of the certificate that rounds to a double.
brute::Triangles triangles_after(const std::vector<MovingSite>& sites,
                                 const Certificate& certificate, double nearest) {
    const CertificateForm form(certificate, {sites, {}});
    const roots::Polynomial p(form, 0.0);
    for (const roots::Root& root : p.real_roots())
        if (p.nearest_double(root) == nearest)
            return triangles_at(sites, [&](Moment& moment, const Sites& all) {
                moment.set(all, {root, certificate});
            });
    ADD_FAILURE() << "no root at " << nearest;
    return {};
}

TEST(MovingKernel, TriangulatesRightAfterEveryEvent) {
    Random random(1901);
    int changes = 0;
    for (int trial = 0; trial < 40; ++trial) {
        SCOPED_TRACE(trial);
        const auto [sites, of_oracle] = any(3 + trial % 5, random, trial % 3 != 0);
        const brute::Epochs epochs = brute::epochs(of_oracle, 0, 20);
        ASSERT_TRUE(epochs.tied.empty());
        ASSERT_EQ(triangles(sites, 0.0), epochs.first);
        for (const brute::Change& change : epochs.changes) {
            const auto& of = change.event.certificates.back().sites;
            const double time = change.event.nearest;
            ++changes;
            Certificate certificate{{of[0], of[1], of[2], of[2]}, Certificate::Kind::left_turn};
            if (of.size() == 4) certificate = {{of[0], of[1], of[2], of[3]}};
            ASSERT_EQ(triangles_after(sites, certificate, time), change.after);
        }
    }
    EXPECT_GT(changes, 200);
}

/// A square that flies along turns as one: its diagonal is that of the order by numbers.
TEST(MovingKernel, TiesForEverAreDecidedByWeightAndNumber) {
    std::vector<MovingSite> square;
    for (const auto& [x, y] : {std::array{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}})
        square.push_back({x, y, 3.0, -1.0, 0.5, 0.0});
    const brute::Triangles expected = triangles(square, 0.0);
    ASSERT_EQ(expected.size(), 2U);
    for (const double time : {0.125, 1.0, 1e9}) EXPECT_EQ(triangles(square, time), expected);
    // The last in the order is reduced most and gets no diagonal.
    for (const brute::Triangle& triangle : expected)
        EXPECT_EQ(std::ranges::count(triangle, 0) + std::ranges::count(triangle, 2), 2);
}

}  // namespace
}  // namespace signum::kinetic
