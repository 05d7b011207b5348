/// Triangulations of moving sites at moments: right after the times at which they change, roots of
/// degree up to 4 that no double is, beside the oracle's.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <gmpxx.h>
#include <gtest/gtest.h>

#include "../../triangulation/insertion/insert.hpp"
#include "../../triangulation/moving/moving_kernel.hpp"
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

/// Sites that fly along as one, on a small grid, so that many are tied for ever; and the
/// determinants of them as the tie rule lifts them: by a number that is far larger for the later
/// one, and far smaller than all differences.
class Tied {
 public:
    Tied(int number, Random& random) {
        for (int n = 0; n < number; ++n) {
            const double x = random.below(4);
            const double y = random.below(4);
            const double r = random.below(3);
            moving_.push_back({x, y, 3.0, -1.0, random.below(2) == 0 ? r : -r, 0.5});
        }
        const auto place = [&](int n) {
            const auto before = [&](int m) {
                const double of_m = std::fabs(moving_[m].r);
                const double of_n = std::fabs(moving_[n].r);
                return of_m > of_n || (of_m == of_n && m < n);
            };
            int rank = 0;
            for (int m = 0; m < number; ++m) rank += before(m) ? 1 : 0;
            return rank;
        };
        for (int n = 0; n < number; ++n) {
            const MovingSite& m = moving_[n];
            mpq_class lift = 1;
            mpq_div_2exp(lift.get_mpq_t(), lift.get_mpq_t(), 64 * (number - place(n)));
            height_.push_back(mpq_class(m.x * m.x + m.y * m.y - m.r * m.r) + lift);
        }
    }

    const std::vector<MovingSite>& moving() const { return moving_; }
    int turn(int i, int j, int k) const { return sgn(area(i, j, k)); }
    /// Whether q, lifted, is below the plane through i, j and k, which turn left.
    bool conflicts(int i, int j, int k, int q) const {
        return area(i, j, k) * height_[q] <
               area(q, j, k) * height_[i] + area(i, q, k) * height_[j] + area(i, j, q) * height_[k];
    }
    /// Whether q, lifted, is below the line through a and b, all on one line.
    bool conflicts_on_line(int a, int b, int q) const {
        const bool along_x = moving_[a].x != moving_[b].x;
        const auto at = [&](int n) { return mpq_class(along_x ? moving_[n].x : moving_[n].y); };
        const mpq_class length = at(b) - at(a);
        const mpq_class below =
            (at(b) - at(q)) * height_[a] + (at(q) - at(a)) * height_[b] - length * height_[q];
        return sgn(below) * sgn(length) > 0;
    }
    bool is_nearer(int q, int a, int b) const {
        const auto distance = [&](int n) {
            return mpq_class(height_[n] - 2 * mpq_class(moving_[q].x * moving_[n].x +
                                                        moving_[q].y * moving_[n].y));
        };
        return distance(a) < distance(b);
    }

 private:
    mpq_class area(int i, int j, int k) const {
        const MovingSite& a = moving_[i];
        const MovingSite& b = moving_[j];
        const MovingSite& c = moving_[k];
        return mpq_class((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
    }

    std::vector<MovingSite> moving_;
    std::vector<mpq_class> height_;
};

TEST(MovingKernel, TiesForEverAreThoseOfLiftedSites) {
    Random random(1902);
    int on_line = 0;
    for (int trial = 0; trial < 3000; ++trial) {
        const Tied tied(4, random);
        const Sites all{tied.moving(), {}};
        const Moment moment(0.25 * random.below(9));
        roots::Tally tally;
        MovingKernel kernel(all, moment, tally);
        ASSERT_EQ(kernel.is_nearer(0, 1, 2), tied.is_nearer(0, 1, 2)) << trial;
        const int turn = tied.turn(0, 1, 2);
        ASSERT_EQ(kernel.ccw(0, 1, 2), turn) << trial;
        if (turn != 0) {
            const int j = turn > 0 ? 1 : 2;
            ASSERT_EQ(kernel.conflicts(0, j, 3 - j, 3), tied.conflicts(0, j, 3 - j, 3)) << trial;
        } else if (kernel.compare_along(0, 1) != 0) {
            ++on_line;
            ASSERT_EQ(kernel.conflicts_on_line(0, 1, 2), tied.conflicts_on_line(0, 1, 2)) << trial;
        }
    }
    EXPECT_GT(on_line, 300);
}

}  // namespace
}  // namespace signum::kinetic
