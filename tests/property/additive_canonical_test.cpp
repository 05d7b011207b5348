// Tessellations of discs, squares and diamonds: equal to the oracle's on small sets full of ties,
// the same for every order, seed, method and arithmetic.

#include "../../triangulation/triangulate.hpp"

#include <algorithm>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "../oracle/euclidean.hpp"
#include "../oracle/rectangular.hpp"
#include "../thoroughness.hpp"
#include "degenerate_sites.hpp"

namespace {

using namespace signum;
using Sites = std::vector<Site>;

/// Of the trials one in so many: the oracles take long there.
const int share = is_fast ? 1 : 20;

template <class Metric>
oracle::Tessellation oracle_of(const Sites& sites) {
    if constexpr (std::is_same_v<Metric, Euclidean>) {
        return oracle::euclidean(sites);
    } else if constexpr (std::is_same_v<Metric, Supremum>) {
        return oracle::supremum(sites);
    } else {
        return oracle::manhattan(sites);
    }
}

std::string text(const Sites& sites) {
    std::string result;
    for (const Site& s : sites)
        result += testing::PrintToString(s.x) + " " + testing::PrintToString(s.y) + " " +
                  testing::PrintToString(s.r) + "\n";
    return result;
}

/// Every face shares the edge opposite each vertex with the neighbour that is given for it.
void expect_neighbours(const Tessellation& t) {
    ASSERT_EQ(t.neighbours().size(), t.faces().size());
    for (std::size_t f = 0; f < t.faces().size(); ++f)
        for (std::size_t k = 0; k < 3; ++k) {
            const Index from = t.faces()[f][(k + 1) % 3];
            const Index to = t.faces()[f][(k + 2) % 3];
            const auto g = static_cast<std::size_t>(t.neighbours()[f][k]);
            bool shared = false;
            for (std::size_t m = 0; m < 3; ++m)
                shared |= t.faces()[g][(m + 1) % 3] == to && t.faces()[g][(m + 2) % 3] == from &&
                          t.neighbours()[g][m] == static_cast<Index>(f);
            ASSERT_TRUE(shared) << "face " << f << " edge " << k;
        }
}

template <class Metric>
class AdditiveCanonical : public testing::Test {
 public:
    static constexpr bool has_sweep = !std::is_same_v<Metric, Euclidean>;

    static Tessellation build(const Sites& sites, std::uint64_t seed = 1) {
        Options options;
        options.seed = seed;
        return triangulate(sites, Metric{}, options);
    }
    static Tessellation sweep(const Sites& sites) {
        Options options;
        options.method = Method::sweep;
        return triangulate(sites, Metric{}, options);
    }

    /// The Euclidean oracle compares enclosures and is slow.
    static constexpr int effort = std::is_same_v<Metric, Euclidean> ? 1 : 3;

    static void expect_oracle(const Sites& sites) {
        const oracle::Tessellation expected = oracle_of<Metric>(sites);
        for (std::uint64_t seed = 0; seed < (has_sweep ? 3 : 2); ++seed) {
            const Tessellation t = seed == 2 ? sweep(sites) : build(sites, seed);
            ASSERT_EQ(std::vector<Face>(t.faces().begin(), t.faces().end()), expected.faces)
                << text(sites);
            std::vector<std::array<std::int32_t, 2>> hidden;
            for (const Hidden& h : t.hidden()) hidden.push_back({h.site, h.by});
            ASSERT_EQ(hidden, expected.hidden) << text(sites);
            ASSERT_NO_FATAL_FAILURE(expect_neighbours(t)) << text(sites);
        }
    }
};
using Metrics = testing::Types<Euclidean, Manhattan, Supremum>;
TYPED_TEST_SUITE(AdditiveCanonical, Metrics);

/// Sets of up to ten sites in which ties abound.
Sites tied_sites(std::mt19937_64& random, int trial) {
    const auto integer = [&](int from, int to) {
        return static_cast<double>(std::uniform_int_distribution<int>(from, to)(random));
    };
    Sites sites(static_cast<std::size_t>(integer(1, 10)));
    const int box = 1 + trial % 12;
    const int largest = trial / 12 % 5;
    const bool line = trial % 7 == 0;
    for (Site& site : sites) {
        site = {integer(0, box), integer(0, box), integer(0, largest)};
        if (line) site.y = site.x;
    }
    return sites;
}

TYPED_TEST(AdditiveCanonical, EqualsTheOracleWhereTiesAbound) {
    std::mt19937_64 random(1);
    for (int trial = 0; trial < 600 * this->effort / share; ++trial)
        ASSERT_NO_FATAL_FAILURE(this->expect_oracle(tied_sites(random, trial)));
}

TYPED_TEST(AdditiveCanonical, EqualsTheOracleInDegeneratePositions) {
    brute_force::Degenerate degenerate(8);
    for (int trial = 0; trial < 900 * this->effort / share; ++trial) {
        Sites sites(static_cast<std::size_t>(3 + trial % 6));
        degenerate.fill(trial % brute_force::Degenerate::families, sites.data(), sites.size());
        ASSERT_NO_FATAL_FAILURE(this->expect_oracle(sites));
    }
}

TYPED_TEST(AdditiveCanonical, EqualsTheOracleOnRandomAndNestedSites) {
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> place(0, 10);
    for (int trial = 0; trial < 200 * this->effort / share; ++trial) {
        Sites sites(static_cast<std::size_t>(2 + trial % 9));
        for (Site& site : sites)
            site = {place(random), place(random), place(random) * (trial % 4) / 8 - 1};
        ASSERT_NO_FATAL_FAILURE(this->expect_oracle(sites));
    }
}

TYPED_TEST(AdditiveCanonical, EveryOrderOfFiveSites) {
    std::mt19937_64 random(3);
    for (int trial = 0; trial < 20 * this->effort / std::min(share, 10); ++trial) {
        Sites sites = tied_sites(random, trial);
        sites.resize(5, {1, 1, 0});
        std::vector<std::size_t> order(sites.size());
        std::iota(order.begin(), order.end(), 0U);
        do {
            Sites permuted;
            for (const std::size_t i : order) permuted.push_back(sites[i]);
            ASSERT_NO_FATAL_FAILURE(this->expect_oracle(permuted));
        } while (trial % 6 == 0 && std::next_permutation(order.begin(), order.end()));
    }
}

TYPED_TEST(AdditiveCanonical, SeedAndArithmeticChangeNothing) {
    std::mt19937_64 random(4);
    for (int family = 0; family < 4; ++family) {
        Sites sites(400 / std::min(share, 4));
        std::uniform_real_distribution<double> place(0, 100);
        for (std::size_t i = 0; i < sites.size(); ++i) {
            Site& s = sites[i];
            if (family == 0) s = {place(random), place(random), place(random) / 20};
            if (family == 1) s = {static_cast<double>(i % 20), static_cast<double>(i / 20), 0};
            if (family == 2)
                s = {static_cast<double>(i % 20), static_cast<double>(i / 20),
                     0.25 * static_cast<double>((i + i / 20) % 2)};
            if (family == 3) s = {place(random), place(random), place(random) / 2};
        }
        const Tessellation expected = this->build(sites);
        ASSERT_NO_FATAL_FAILURE(expect_neighbours(expected));
        for (std::uint64_t seed : {0U, 7U, 99U})
            ASSERT_EQ(this->build(sites, seed).arrays(), expected.arrays()) << family;
        Options options;
        options.arithmetic = Arithmetic::multiprecision;
        ASSERT_EQ(triangulate(sites, TypeParam{}, options).arrays(), expected.arrays()) << family;
        if (this->has_sweep) {
            options.method = Method::sweep;
            ASSERT_EQ(triangulate(sites, TypeParam{}, options).arrays(), expected.arrays())
                << family;
            ASSERT_EQ(this->sweep(sites).arrays(), expected.arrays()) << family;
        }
        // A constant on all radii and a power of two on everything are exact and change nothing.
        Sites larger = sites;
        for (Site& s : larger) s = {s.x * 8, s.y * 8, s.r * 8};
        ASSERT_EQ(this->build(larger).arrays(), expected.arrays()) << family;
        if (family != 0 && family != 3) {
            for (Site& s : larger) s.r += 16;
            ASSERT_EQ(this->build(larger).arrays(), expected.arrays()) << family;
        }
    }
}

TYPED_TEST(AdditiveCanonical, NaiveArithmeticEnds) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> jitter(-1e-15, 1e-15);
    int done = 0;
    for (int trial = 0; trial < 40; ++trial) {
        Sites sites(300);
        for (std::size_t i = 0; i < sites.size(); ++i)
            sites[i] = {static_cast<double>(i % 17) / 3 + jitter(random),
                        static_cast<double>(i / 17) / 3 + jitter(random), 0.1};
        Options options;
        options.arithmetic = Arithmetic::naive;
        if (this->has_sweep && trial % 2 == 1) options.method = Method::sweep;
        try {
            done += static_cast<int>(triangulate(sites, TypeParam{}, options).faces().size() > 0);
        } catch (const BrokenStructure& broken) {
            ++done;
            EXPECT_NE(std::string(broken.what()), "");
        }
    }
    EXPECT_EQ(done, 40);
}

TEST(AdditiveCanonical, DiamondsAreSquaresInDiagonalCoordinates) {
    std::mt19937_64 random(6);
    int compared = 0;
    for (int trial = 0; trial < 200; ++trial) {
        Sites diamonds(60);
        for (Site& s : diamonds)
            s = {static_cast<double>(random() % 1048576), static_cast<double>(random() % 1048576),
                 static_cast<double>(random() % 65536)};
        Sites squares;
        for (const Site& s : diamonds) squares.push_back({s.x + s.y, s.y - s.x, s.r});
        Options options;
        options.count = true;
        const Tessellation a = triangulate(diamonds, Manhattan{}, options);
        const Tessellation b = triangulate(squares, Supremum{}, options);
        // The tie rule orders sites by their own coordinates, so that only ties may differ.
        if (a.statistics().ties + b.statistics().ties != 0) continue;
        ++compared;
        ASSERT_EQ(a.arrays().faces, b.arrays().faces);
        ASSERT_EQ(a.arrays().neighbours, b.arrays().neighbours);
    }
    EXPECT_GT(compared, 100);
}

TEST(AdditiveCanonical, WeightsAreRefused) {
    const std::vector<power::Site> sites = {{0, 0, 1}, {1, 0, 1}};
    EXPECT_THROW((void)triangulate(sites, Supremum{}), std::invalid_argument);
}

}  // namespace
