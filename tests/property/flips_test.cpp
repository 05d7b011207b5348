// Two roads to the power tessellation: flips from the Delaunay triangulation, and insertion. They
// share predicates, and arrive at the same arrays.

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "../../triangulation/triangulate.hpp"

#include "../thoroughness.hpp"
#include "degenerate_sites.hpp"

namespace signum {
namespace {

class Flips : public testing::Test {
 protected:
    std::mt19937_64 random_{31};
    double real() { return static_cast<double>(random_() >> 11) * 0x1p-53; }
    int below(int count) { return static_cast<int>(random_() % static_cast<std::uint64_t>(count)); }

    static Options flips() {
        Options options;
        options.method = Method::flips;
        return options;
    }
    template <class S>
    static std::string text(const std::vector<S>& sites) {
        std::string result;
        for (const auto& [x, y, third] : sites)
            result += "{" + std::to_string(x) + ", " + std::to_string(y) + ", " +
                      std::to_string(third) + "}, ";
        return result;
    }
    template <class S>
    std::uint64_t expect_same(const std::vector<S>& sites) {
        const Tessellation inserted = triangulate(sites, Power{});
        const Tessellation flipped = triangulate(sites, Power{}, flips());
        EXPECT_TRUE(flipped.arrays() == inserted.arrays()) << text(sites);
        return flipped.statistics().flips;
    }
};

TEST_F(Flips, ArriveWhereInsertionDoes) {
    std::uint64_t flips = 0;
    for (int round = 0; round < 500 * thoroughness; ++round) {
        std::vector<Site> sites(static_cast<std::size_t>(1 + below(50)));
        const double spacing = 1 / std::sqrt(static_cast<double>(sites.size()));
        const double radius = spacing * std::pow(10.0, 3 * real() - 2);  // 0.01 to 10
        for (Site& s : sites) {
            const double angle = 6.3 * real();
            switch (round % 3) {
                case 0:
                    s = {real(), real(), radius * real()};
                    break;
                case 1:
                    s = {std::cos(angle), std::sin(angle), radius * real()};
                    break;
                default:
                    s = {1.0 * below(8), 1.0 * below(8), 8 * radius * real()};
            }
        }
        flips += expect_same(sites);
        ASSERT_FALSE(HasFailure());
    }
    EXPECT_GT(flips, 500U * thoroughness);
}

/// Ties of all kinds: equal times, collinear sites that sink at once, equal centres.
TEST_F(Flips, ArriveThereOnDegenerateSites) {
    for (int round = 0; round < 1500 * thoroughness; ++round) {
        std::vector<Site> sites(static_cast<std::size_t>(1 + below(24)));
        if (round % 2 == 0) {
            brute_force::Degenerate(random_()).fill(round / 2 % brute_force::Degenerate::families,
                                                    sites.data(), sites.size());
        } else {
            const int extent = 1 + below(6);
            const int largest = 1 + below(5);
            for (Site& s : sites)
                s = {1.0 * below(extent), 1.0 * below(extent), below(largest) / 2.0};
        }
        expect_same(sites);
        ASSERT_FALSE(HasFailure());
    }
}

TEST_F(Flips, TakeWeightsOfAnySign) {
    for (int round = 0; round < 300 * thoroughness; ++round) {
        std::vector<power::Site> sites(static_cast<std::size_t>(1 + below(30)));
        for (power::Site& s : sites)
            s = {1.0 * below(30), 1.0 * below(30),
                 round % 2 == 0 ? 100.0 * (real() - 0.5) : 1.0 * (below(9) - 4)};
        expect_same(sites);
        ASSERT_FALSE(HasFailure());
    }
}

TEST_F(Flips, ExtremesOfADouble) {
    for (const double scale : {0x1p500, 0x1p-500, 0x1p-1074, 0x1p1000}) {
        std::vector<Site> sites(20);
        for (Site& s : sites) s = {scale * below(100), scale * below(100), scale * below(30)};
        expect_same(sites);
    }
    std::vector<Site> mixed = {{0, 0, 1},     {1e300, 1, 1e200},  {1e-300, 1e-300, 2},
                               {5, 1e150, 3}, {-1e300, 4, 1e299}, {7, -1e-200, 0}};
    expect_same(mixed);
}

/// Bit patterns: numbers of all sizes at once, whose times agree in hundreds of bits.
TEST_F(Flips, RawDoubles) {
    const auto raw = [&] {
        for (;;) {
            const auto value = std::bit_cast<double>(random_());
            if (std::isfinite(value)) return value;
        }
    };
    std::uint64_t flips = 0;
    for (int round = 0; round < 20 * thoroughness; ++round) {
        const auto count = static_cast<std::size_t>(1 + below(100));
        std::vector<Site> discs(count);
        std::vector<power::Site> weighted(count);
        for (Site& s : discs) s = {raw(), raw(), raw()};
        for (power::Site& s : weighted) s = {raw(), raw(), raw()};
        flips += expect_same(discs) + expect_same(weighted);
        ASSERT_FALSE(HasFailure());
    }
    EXPECT_GT(flips, 1000U * thoroughness);
}

TEST_F(Flips, AreLinearInTheSites) {
    for (const double radius : {0.6, 1.5}) {
        double per_site[2] = {};
        for (const int count : {4000, 20'000}) {
            std::vector<Site> sites(static_cast<std::size_t>(count));
            for (Site& s : sites) s = {real(), real(), radius / std::sqrt(1.0 * count) * real()};
            per_site[count == 4000 ? 0 : 1] =
                static_cast<double>(expect_same(sites)) / static_cast<double>(count);
        }
        EXPECT_GT(per_site[0], 0.01);
        EXPECT_NEAR(per_site[1] / per_site[0], 1, 0.2);
    }
}

/// Theorem of the thesis: discs that do not intersect are no obstruction to one another.
TEST_F(Flips, InOrderOfDiscoveryForDiscsApart) {
    int flipped = 0;
    for (int round = 0; round < 60 * thoroughness; ++round) {
        std::vector<Site> sites;
        for (int attempt = 0; attempt < 150; ++attempt) {
            const Site s = {real(), real(), 0.12 * real()};
            if (std::ranges::none_of(sites, [&](const Site& o) {
                    return std::hypot(s.x - o.x, s.y - o.y) <= s.r + o.r;
                }))
                sites.push_back(s);
        }
        const FlipOutcome outcome = flip_from_delaunay(sites);
        ASSERT_FALSE(outcome.obstruction) << text(sites);
        EXPECT_TRUE(outcome.tessellation.arrays() == triangulate(sites, Power{}).arrays());
        flipped += static_cast<int>(outcome.tessellation.statistics().flips);
    }
    EXPECT_GT(flipped, 20 * thoroughness);
}

/// Where they do intersect the queue may stop, and says so; the order of time does not.
TEST_F(Flips, InOrderOfDiscoveryMayBeObstructed) {
    int obstructions = 0;
    int arrived = 0;
    for (int round = 0; round < 400 * thoroughness; ++round) {
        std::vector<Site> sites(40);
        for (Site& s : sites) s = {1.0 * below(64), 1.0 * below(64), 1.0 * below(32)};
        const FlipOutcome outcome = flip_from_delaunay(sites);
        const Tessellation inserted = triangulate(sites, Power{});
        if (outcome.obstruction) {
            ++obstructions;
            EXPECT_TRUE(outcome.tessellation.faces().empty());
            for (const Index v : *outcome.obstruction) {
                EXPECT_GE(v, -1);
                EXPECT_LT(v, 40);
            }
        } else {
            ++arrived;
            EXPECT_TRUE(outcome.tessellation.arrays() == inserted.arrays());
        }
        expect_same(sites);
        ASSERT_FALSE(HasFailure()) << text(sites);
    }
    EXPECT_GT(obstructions, 0);
    EXPECT_GT(arrived, obstructions);
}

TEST_F(Flips, BelongToThePowerMetricAndToExactArithmetic) {
    const std::vector<Site> sites = {{0, 0, 1}, {1, 0, 2}, {0, 1, 3}};
    EXPECT_THROW(static_cast<void>(triangulate(sites, Euclidean{}, flips())),
                 std::invalid_argument);
    EXPECT_THROW(static_cast<void>(triangulate(sites, Supremum{}, flips())), std::invalid_argument);
    Options naive = flips();
    naive.arithmetic = Arithmetic::naive;
    EXPECT_THROW(static_cast<void>(triangulate(sites, Power{}, naive)), std::invalid_argument);
    std::stop_source stop;
    stop.request_stop();
    Options stopped = flips();
    stopped.stop = stop.get_token();
    std::vector<Site> many(9000);
    for (Site& s : many) s = {real(), real(), 0.01 * real()};
    EXPECT_THROW(static_cast<void>(triangulate(many, Power{}, stopped)), Stopped);
}

/// Centres moved by (p, q) and weights changed by 2px + 2qy: every power changes by the same
/// function of the point, and no cell does (thesis, 5.8). In integers, so exactly.
TEST_F(Flips, NoMethodSeesAShift) {
    for (int round = 0; round < 60 * thoroughness; ++round) {
        std::vector<power::Site> sites(60);
        for (power::Site& s : sites)
            s = {1.0 * below(1 << 20), 1.0 * below(1 << 20), 1e3 * below(1 << 25)};
        const double p = below(1 << 10) - 512;
        const double q = below(1 << 10) - 512;
        const double constant = below(1 << 20);
        std::vector<power::Site> shifted = sites;
        for (power::Site& s : shifted)
            s = {s.x + p, s.y + q, s.w + 2 * p * s.x + 2 * q * s.y + constant};
        for (const Options& options : {Options{}, flips()}) {
            const Tessellation a = triangulate(sites, Power{}, options);
            const Tessellation b = triangulate(shifted, Power{}, options);
            ASSERT_EQ(a.arrays().faces, b.arrays().faces);
            ASSERT_EQ(a.arrays().neighbours, b.arrays().neighbours);
            EXPECT_GT(a.faces().size(), 20U);
        }
    }
}

}  // namespace
}  // namespace signum
