// The properties of chapter 3 of the thesis, in the metrics with additive weights: the empty
// inscribed circle, nearest neighbours, the hull, the counts, and what changes nothing.

#include "../../triangulation/triangulate.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "../../predicates/euclidean.hpp"
#include "../../predicates/manhattan.hpp"
#include "../../predicates/supremum.hpp"
#include "../../tool/generate/generate.hpp"
#include "../../triangulation/structure/tie_order.hpp"

namespace {

using namespace signum;
using Sites = std::vector<Site>;

std::size_t at(Index i) {
    return static_cast<std::size_t>(i);
}

template <class Metric, Arithmetic arithmetic>
struct PredicatesOf;
template <Arithmetic arithmetic>
struct PredicatesOf<Euclidean, arithmetic> : euclidean::Perturbed<arithmetic> {
    static double distance(double x, double y) { return std::hypot(x, y); }
};
template <Arithmetic arithmetic>
struct PredicatesOf<Manhattan, arithmetic> : manhattan::Perturbed<arithmetic> {
    static double distance(double x, double y) { return std::fabs(x) + std::fabs(y); }
};
template <Arithmetic arithmetic>
struct PredicatesOf<Supremum, arithmetic> : supremum::Perturbed<arithmetic> {
    static double distance(double x, double y) { return std::max(std::fabs(x), std::fabs(y)); }
};

/// Sites of which few, a third or most are hidden, and a grid of two alternating radii.
std::vector<Sites> families(std::size_t n) {
    std::mt19937_64 random(17);
    std::uniform_real_distribution<double> unit(0, 1);
    const double spacing = 1 / std::sqrt(static_cast<double>(n));
    std::vector<Sites> result;
    for (const double radius : {0.3, 1.5, 6.0}) {
        Sites sites(n);
        for (Site& s : sites) s = {unit(random), unit(random), radius * spacing * unit(random)};
        result.push_back(sites);
    }
    Sites grid(n);
    for (std::size_t i = 0; i < n; ++i)
        grid[i] = {static_cast<double>(i % 16), static_cast<double>(i / 16),
                   0.25 * static_cast<double>((i + i / 16) % 2)};
    result.push_back(grid);
    return result;
}

template <class Metric>
class AdditiveProperties : public testing::Test {};
using Metrics = testing::Types<Euclidean, Manhattan, Supremum>;
TYPED_TEST_SUITE(AdditiveProperties, Metrics);

TYPED_TEST(AdditiveProperties, VerticesEdgesFaces) {
    for (const Sites& sites : families(300)) {
        const Tessellation t = triangulate(sites, TypeParam{});
        const std::size_t visible = sites.size() - t.hidden().size();
        EXPECT_EQ(t.edges().size(), 3 * visible - 3);
        EXPECT_EQ(t.faces().size(), 2 * visible - 2);
        std::vector<char> met(sites.size() + 1, 0);
        for (const Face& face : t.faces())
            for (const Index v : face) met[at(v + 1)] = 1;
        EXPECT_EQ(std::count(met.begin(), met.end(), 1), static_cast<std::ptrdiff_t>(visible) + 1);
    }
}

/// No site comes nearer to a vertex than the three of its face, hidden ones included.
TYPED_TEST(AdditiveProperties, InscribedCirclesAreEmpty) {
    using Predicates = PredicatesOf<TypeParam, Arithmetic::multiprecision>;
    for (const Sites& sites : families(64)) {
        std::vector<triangulation::RankedSite> ranked;
        for (const Site& site : sites) ranked.push_back({site, 0});
        std::vector<Index> numbers(sites.size());
        std::iota(numbers.begin(), numbers.end(), 0);
        triangulation::rank(ranked, numbers, Workers(1));
        const Tessellation t = triangulate(sites, TypeParam{});
        for (const Face& v : t.faces()) {
            const auto site = [&](Index i) -> const Site& { return sites[at(i)]; };
            const auto rank = [&](Index i) { return ranked[at(i)].rank; };
            for (Index q = 0; q < static_cast<Index>(sites.size()); ++q) {
                if (q == v[0] || q == v[1] || q == v[2]) continue;
                const Decision conflict =
                    v[0] == infinite
                        ? Predicates::in_circle_infinite(site(v[2]), site(v[1]), site(q),
                                                         {rank(v[2]), rank(v[1]), rank(q)})
                        : Predicates::in_circle(site(v[0]), site(v[1]), site(v[2]), site(q),
                                                {rank(v[0]), rank(v[1]), rank(v[2]), rank(q)});
                ASSERT_LT(conflict.sign, 0) << q;
            }
        }
    }
}

/// Every visible site has an edge to the visible one nearest to it: least distance of centres less
/// the other's radius.
TYPED_TEST(AdditiveProperties, NearestNeighboursAreJoined) {
    using Predicates = PredicatesOf<TypeParam, Arithmetic::exact>;
    for (const Sites& sites : families(300)) {
        const Tessellation t = triangulate(sites, TypeParam{});
        for (Index i = 0; i < static_cast<Index>(sites.size()); ++i) {
            const std::vector<Index> neighbours = t.neighbours(i);
            if (neighbours.empty()) continue;
            const auto distance = [&](Index j) {
                return Predicates::distance(sites[at(i)].x - sites[at(j)].x,
                                            sites[at(i)].y - sites[at(j)].y) -
                       sites[at(j)].r;
            };
            double nearest = HUGE_VAL;
            for (Index j = 0; j < static_cast<Index>(sites.size()); ++j)
                if (j != i && !t.neighbours(j).empty()) nearest = std::min(nearest, distance(j));
            double joined = HUGE_VAL;
            for (const Index j : neighbours)
                if (j != infinite) joined = std::min(joined, distance(j));
            ASSERT_LE(joined, nearest + 1e-12) << i;
        }
    }
}

/// Whether site i reaches farthest in some direction, with room to spare (+1), in none (-1), or
/// nearly so (0).
int on_hull(const Sites& sites, std::size_t i, Euclidean /*metric*/) {
    // Others cover arcs of directions: those within acos(-(r - r_i) / |c - c_i|) of c - c_i.
    constexpr double turn = 2 * std::numbers::pi;
    std::vector<std::pair<double, double>> arcs;
    for (std::size_t j = 0; j < sites.size(); ++j) {
        if (j == i) continue;
        const double x = sites[j].x - sites[i].x;
        const double y = sites[j].y - sites[i].y;
        const double share = (sites[i].r - sites[j].r) / std::hypot(x, y);
        if (share >= 1) continue;
        if (share <= -1) return -1;
        const double half = std::acos(share);
        double from = std::atan2(y, x) - half;
        from -= turn * std::floor(from / turn);
        arcs.emplace_back(from, from + 2 * half);
        arcs.emplace_back(from - turn, from + 2 * half - turn);
    }
    std::sort(arcs.begin(), arcs.end());
    double covered = 0;
    double widest = -1;
    for (const auto& [from, to] : arcs) {
        if (from > covered) widest = std::max(widest, std::min(from, turn) - covered);
        covered = std::max(covered, to);
    }
    widest = std::max(widest, turn - covered);
    return widest > 1e-9 ? 1 : widest < -1e-9 || covered > turn + 1e-9 ? -1 : 0;
}
/// A staircase: no other site reaches farther in both of two neighbouring directions.
template <class Directions>
int on_staircase(const Sites& sites, std::size_t i) {
    for (int d = 0; d < 4; ++d) {
        const auto reach = [&](const Site& s, int side) {
            return Directions::x[side & 3] * s.x + Directions::y[side & 3] * s.y + s.r;
        };
        const bool stands = std::none_of(sites.begin(), sites.end(), [&](const Site& other) {
            return reach(other, d) > reach(sites[i], d) &&
                   reach(other, d + 1) > reach(sites[i], d + 1);
        });
        if (stands) return 1;
    }
    return -1;
}
int on_hull(const Sites& sites, std::size_t i, Supremum /*metric*/) {
    return on_staircase<rectangular::Supremum>(sites, i);
}
int on_hull(const Sites& sites, std::size_t i, Manhattan /*metric*/) {
    return on_staircase<rectangular::Manhattan>(sites, i);
}

/// The sites with unbounded cells are those of the hull of discs, or of the rectangular hull.
TYPED_TEST(AdditiveProperties, UnboundedCellsAreThoseOfTheHull) {
    int unbounded = 0;
    const std::vector<Sites> sets = families(300);
    for (std::size_t family = 0; family + 1 < sets.size();
         ++family) {  // but the grid, full of ties
        const Sites& sites = sets[family];
        const Tessellation t = triangulate(sites, TypeParam{});
        for (std::size_t i = 0; i < sites.size(); ++i) {
            const int expected = on_hull(sites, i, TypeParam{});
            if (expected == 0) continue;
            const std::vector<Index> neighbours = t.neighbours(static_cast<Index>(i));
            const bool is_unbounded = !neighbours.empty() && neighbours.front() == infinite;
            ASSERT_EQ(is_unbounded, expected > 0) << "family " << family << ", site " << i;
            unbounded += static_cast<int>(is_unbounded);
        }
    }
    EXPECT_GT(unbounded, 20);
}

/// A constant on all radii and a power of two on everything are exact here.
TYPED_TEST(AdditiveProperties, LargerRadiiAndScaleChangeNothing) {
    for (Sites sites : families(256)) {
        for (Site& s : sites)
            s = {std::round(s.x * 4096), std::round(s.y * 4096), std::round(s.r * 4096)};
        const Tessellation expected = triangulate(sites, TypeParam{});
        for (const double constant : {1024.0, -1e6}) {
            Sites changed = sites;
            for (Site& s : changed) s.r += constant;
            EXPECT_EQ(triangulate(changed, TypeParam{}).arrays(), expected.arrays());
        }
        for (const double factor : {0x1p-900, 0x1p900}) {
            Sites changed = sites;
            for (Site& s : changed) s = {s.x * factor, s.y * factor, s.r * factor};
            EXPECT_EQ(triangulate(changed, TypeParam{}).arrays(), expected.arrays());
        }
    }
}

/// The mirror image at the diagonal and a quarter turn: the metrics know no difference. Ties do,
/// which look at coordinates.
TYPED_TEST(AdditiveProperties, AQuarterTurnChangesNothing) {
    const std::vector<Sites> sets = families(256);
    for (std::size_t family = 0; family + 1 < sets.size(); ++family) {
        Sites turned = sets[family];
        for (Site& s : turned) s = {-s.y, s.x, s.r};
        EXPECT_EQ(triangulate(turned, TypeParam{}).arrays(),
                  triangulate(sets[family], TypeParam{}).arrays());
    }
}

/// With equal radii the Euclidean tessellation is Delaunay's, ties included. One smaller disc,
/// hidden in both metrics, makes the general insertion do it.
TEST(AdditiveProperties, EuclideanOfEqualRadiiIsPowerOfEqualWeights) {
    for (Sites sites : families(400)) {
        for (Site& s : sites) s.r = 0.125;
        for (const bool general : {false, true}) {
            if (general) sites.push_back({sites[0].x, sites[0].y, 0.0625});
            const Tessellation discs = triangulate(sites, Euclidean{});
            const Tessellation power = triangulate(sites, Power{});
            EXPECT_EQ(discs.metric(), Metric::euclidean);
            EXPECT_EQ(discs.arrays().faces, power.arrays().faces);
            EXPECT_EQ(discs.arrays().neighbours, power.arrays().neighbours);
            EXPECT_EQ(discs.arrays().hidden, power.arrays().hidden);
        }
    }
}

/// The work of an insertion does not grow with the number of sites, on a circle neither: there
/// cells of squares are long and thin, and a site across the circle is a neighbour of the one
/// inserted last.
TYPED_TEST(AdditiveProperties, CallsPerSiteStayLevel) {
    for (const Distribution distribution :
         {Distribution::random, Distribution::circle, Distribution::square})
        for (const std::int64_t count : {1000, 50'000}) {
            GenerateOptions generated;
            generated.count = count;
            generated.radius_to = 1e-4;
            Options options;
            options.count = true;
            const Statistics statistics =
                triangulate(generate(distribution, generated), TypeParam{}, options).statistics();
            const std::uint64_t calls = statistics.filtered + statistics.exact + statistics.essa;
            EXPECT_LT(calls, 100 * static_cast<std::uint64_t>(count));
        }
}

}  // namespace
