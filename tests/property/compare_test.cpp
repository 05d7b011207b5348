// compare_edges() calls an edge wrong where no order of ties makes the oracle show it, and
// different where some order does and the canonical one does not.

#include "../../voronoi/compare.hpp"
#include "../../triangulation/triangulate.hpp"

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "../by_metric.hpp"
#include "../oracle/valid_edges.hpp"
#include "../thoroughness.hpp"
#include "degenerate_sites.hpp"

namespace {

using namespace signum;
using Sites = std::vector<Site>;

/// Of the trials one in so many: the oracles take long there.
const int share = is_fast ? 1 : 10;

/// Discs that shrink in this order, each by an ever higher power of the one before; or the first
/// two by high powers, the others by steps.
std::vector<std::int64_t> powers_of(const oracle::Ranks& ranks, bool pair_first) {
    const auto n = static_cast<std::int64_t>(ranks.size());
    std::vector<std::int64_t> powers;
    for (const std::size_t rank : ranks) {
        const std::int64_t left = n - static_cast<std::int64_t>(rank);
        powers.push_back(!pair_first ? std::int64_t{1} << 2 * (left - 1)
                         : rank > 1  ? left
                                     : (rank == 0 ? 16 : 4) * n);
    }
    return powers;
}

std::string text(const Sites& sites) {
    std::string result;
    for (const Site& s : sites)
        result += testing::PrintToString(s.x) + " " + testing::PrintToString(s.y) + " " +
                  testing::PrintToString(s.r) + "\n";
    return result;
}

/// A tessellation of these edges, as far as a comparison sees: none is there.
Tessellation with_edges(const Tessellation& other, const std::vector<Edge>& edges) {
    TessellationArrays arrays = other.arrays();
    arrays.faces.clear();
    arrays.neighbours.clear();
    for (const auto& [a, b] : edges) arrays.faces.push_back({infinite, a, b});
    return {std::move(arrays), Sites(other.sites().begin(), other.sites().end()), {}};
}

std::vector<Edge> every_pair(std::size_t n) {
    std::vector<Edge> pairs;
    for (Index a = 0; a < static_cast<Index>(n); ++a)
        for (Index b = a + 1; b < static_cast<Index>(n); ++b) pairs.push_back({a, b});
    return pairs;
}

std::vector<Edge> finite_edges(const Tessellation& t) {
    std::vector<Edge> edges = t.edges();
    std::erase_if(edges, [](const Edge& e) { return e[0] == infinite; });
    return edges;
}

class Compare : public testing::TestWithParam<Metric> {
 protected:
    /// Compares all pairs of sites with the oracle's word.
    void expect_oracle(const Sites& sites, bool all_orders) {
        const auto of = [&](const oracle::Ranks& ranks) {
            return by_metric::tessellation(GetParam(), sites, ranks, powers_of(ranks, !all_orders));
        };
        const oracle::Edges valid = all_orders ? oracle::valid_edges(of, sites.size())
                                               : oracle::valid_edges_of_pairs(of, sites.size());
        const Tessellation canonical = triangulate(sites, GetParam());
        const std::vector<Edge> own = finite_edges(canonical);
        std::vector<Edge> wrong;
        std::vector<Edge> different;
        for (const Edge& pair : every_pair(sites.size()))
            if (!valid.contains(pair)) {
                wrong.push_back(pair);
            } else if (!std::binary_search(own.begin(), own.end(), pair)) {
                different.push_back(pair);
            }
        const EdgeComparison result =
            compare_edges(with_edges(canonical, every_pair(sites.size())), canonical);
        ASSERT_EQ(result.wrong, wrong) << text(sites);
        ASSERT_EQ(result.different, different) << text(sites);
        different_ += different.size();
        hidden_ += canonical.hidden().size();
    }

    std::size_t different_ = 0;
    std::size_t hidden_ = 0;
    /// The oracles of the other metrics are slow.
    int effort() const { return GetParam() == Metric::power ? 5 : 1; }
};

TEST_P(Compare, EqualsTheOracleInAllOrdersOfFewSites) {
    brute_force::Degenerate degenerate(41);
    for (int trial = 0; trial < 54 * effort() / share; ++trial) {
        Sites sites(static_cast<std::size_t>(2 + trial / brute_force::Degenerate::families % 3));
        degenerate.fill(trial % brute_force::Degenerate::families, sites.data(), sites.size());
        ASSERT_NO_FATAL_FAILURE(expect_oracle(sites, true));
    }
}

TEST_P(Compare, EqualsTheOracleOnDegenerateSites) {
    brute_force::Degenerate degenerate(42);
    for (int trial = 0; trial < 54 * effort() / share; ++trial) {
        Sites sites(static_cast<std::size_t>(4 + trial / brute_force::Degenerate::families % 4));
        degenerate.fill(trial % brute_force::Degenerate::families, sites.data(), sites.size());
        ASSERT_NO_FATAL_FAILURE(expect_oracle(sites, false));
    }
    EXPECT_GT(different_, 0U);
    EXPECT_GT(hidden_, 0U);
}

/// Rationals, where integers of 128 bits do not do.
class CompareSquares : public Compare {};

TEST_P(CompareSquares, EqualsTheOracleWhereNumbersSpanManyBits) {
    brute_force::Degenerate degenerate(43);
    for (int trial = 0; trial < 54 * effort() / share; ++trial) {
        Sites sites(static_cast<std::size_t>(3 + trial / brute_force::Degenerate::families % 3));
        degenerate.fill(trial % brute_force::Degenerate::families, sites.data(), sites.size());
        sites.push_back({0x1p-200, 0.5, 0});
        ASSERT_NO_FATAL_FAILURE(expect_oracle(sites, false));
    }
}

INSTANTIATE_TEST_SUITE_P(Metrics, Compare, testing::ValuesIn(all_metrics),
                         [](const auto& info) { return std::string(name_of(info.param)); });
INSTANTIATE_TEST_SUITE_P(Metrics, CompareSquares,
                         testing::Values(Metric::manhattan, Metric::supremum),
                         [](const auto& info) { return std::string(name_of(info.param)); });

TEST(CompareEdges, AChordOfACocircularCellIsDifferentAndNotWrong) {
    const Sites square = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {3, 1, 0}};
    for (const Metric metric : {Metric::power, Metric::euclidean}) {
        const Tessellation canonical = triangulate(square, metric);
        const std::vector<Edge> own = finite_edges(canonical);
        const Edge drawn = {0, 2};
        const Edge other = {1, 3};
        const bool first = std::binary_search(own.begin(), own.end(), drawn);
        const EdgeComparison result =
            compare_edges(with_edges(canonical, {{0, 1}, {0, 2}, {0, 4}, {1, 3}}), canonical);
        EXPECT_EQ(result.edges, 4);
        EXPECT_EQ(result.wrong, (std::vector<Edge>{{0, 4}}));
        EXPECT_EQ(result.different, (std::vector<Edge>{first ? other : drawn}));
    }
}

TEST(CompareEdges, OfTwoEqualSitesEitherMayBeShown) {
    const Sites sites = {{0, 0, 0}, {0, 0, 0}, {2, 0, 0}, {0, 2, 0}};
    for (const Metric metric : all_metrics) {
        const Tessellation canonical = triangulate(sites, metric);
        const EdgeComparison result =
            compare_edges(with_edges(canonical, {{0, 1}, {0, 2}, {1, 2}}), canonical);
        EXPECT_EQ(result.wrong, (std::vector<Edge>{{0, 1}})) << name_of(metric);
        EXPECT_EQ(result.different, (std::vector<Edge>{{1, 2}})) << name_of(metric);
    }
}

TEST(CompareEdges, SeveralEdgesOfOnePairAreCounted) {
    const Sites sites = {{0, 0, 10}, {20, 0, 10}, {10, 0, 1}};
    const Tessellation canonical = triangulate(sites, Euclidean{});
    const std::vector<Edge> own = finite_edges(canonical);
    ASSERT_EQ(std::count(own.begin(), own.end(), Edge{0, 1}), 2);
    const EdgeComparison result =
        compare_edges(with_edges(canonical, {{0, 1}, {0, 1}, {0, 1}, {0, 1}}), canonical);
    EXPECT_TRUE(result.wrong.empty());
    EXPECT_EQ(result.different, (std::vector<Edge>{{0, 1}, {0, 1}}));
}

TEST(CompareEdges, ExactTessellationsHaveNoWrongEdges) {
    for (const Metric metric : all_metrics) {
        Sites sites;
        for (int i = 0; i < 400; ++i)
            sites.push_back({0.1 * (i % 20), 0.1 * (i / 20), 0.001 * (i % 7)});
        const Tessellation canonical = triangulate(sites, metric);
        const EdgeComparison same = compare_edges(canonical, canonical);
        EXPECT_TRUE(same.wrong.empty() && same.different.empty());
        EXPECT_EQ(same.edges, static_cast<std::int64_t>(finite_edges(canonical).size()));
    }
}

TEST(CompareEdges, OtherSitesOrAnotherMetricAreRefused) {
    const Sites sites = {{0, 0, 0}, {1, 0, 0}};
    const Sites others = {{0, 0, 0}, {2, 0, 0}};
    const Tessellation t = triangulate(sites, Power{});
    EXPECT_THROW((void)compare_edges(t, triangulate(others, Power{})), std::invalid_argument);
    EXPECT_THROW((void)compare_edges(t, triangulate(sites, Euclidean{})), std::invalid_argument);
}

}  // namespace
