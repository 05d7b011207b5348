// Which way an edge leads to a vertex that is no pair of doubles, asked of vertices that are: there
// a double tells; and of those at infinity, whose direction is known.

#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "../../triangulation/triangulate.hpp"
#include "../../triangulation/vertices.hpp"
#include "../../voronoi/far_end.hpp"
#include "../../voronoi/vector.hpp"

#include "../thoroughness.hpp"

namespace signum {
namespace {

const int rounds = 250 * thoroughness;

/// Calls visit(a, b, apex, end, vertex) for all edges of all faces without infinity.
template <class Visit>
void for_each_end(const std::vector<Site>& sites, Metric metric, const Visit& visit) {
    const Tessellation tessellation = triangulate(sites, metric);
    const std::vector<DiagramVertex> of_face = vertices(tessellation);
    for (std::size_t f = 0; f < of_face.size(); ++f) {
        const Face& face = tessellation.faces()[f];
        if (face[0] == infinite) continue;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto site = [&](std::size_t place) -> const Site& {
                return sites[static_cast<std::size_t>(face[place % 3])];
            };
            visit(site(k), site(k + 1), site(k + 2), EndOfEdge::to, of_face[f]);
            visit(site(k + 1), site(k), site(k + 2), EndOfEdge::from, of_face[f]);
        }
    }
}

/// On which side of the way from a to b a point lies.
double side_of(const Site& a, const Site& b, Point p) {
    return cross({b.x - a.x, b.y - a.y}, {p.x - a.x, p.y - a.y});
}

TEST(FarEnd, IsWhereTheVertexLies) {
    std::mt19937_64 random(97);
    const auto below = [&](int bound) { return static_cast<int>(random() % bound); };
    int told = 0;
    for (int round = 0; round < rounds; ++round) {
        std::vector<Site> sites(static_cast<std::size_t>(3 + below(8)));
        for (Site& s : sites)
            s = {below(12) + 0.0, below(12) + 0.0, round % 3 == 0 ? 0.0 : below(5) + 0.0};
        for (const Metric metric : {Metric::power, Metric::euclidean})
            for_each_end(
                sites, metric,
                [&](const Site& a, const Site& b, const Site& apex, EndOfEdge end,
                    const DiagramVertex& vertex) {
                    const double side = side_of(a, b, {vertex.x, vertex.y});
                    if (!(std::abs(side) > 1e-6)) return;
                    ++told;
                    ASSERT_EQ(far_end(metric, WeightIs::radius, a, b, apex, end), side > 0 ? 1 : -1)
                        << name_of(metric) << " in round " << round;
                });
    }
    EXPECT_GT(told, 25 * rounds);
}

TEST(FarEnd, OfDiscsThatTouchOneLineIsAcrossIt) {
    std::mt19937_64 random(101);
    const auto below = [&](int bound) { return static_cast<int>(random() % bound); };
    int at_infinity = 0;
    for (int round = 0; round < rounds; ++round) {
        // From above, (t, t², r = t²) among them.
        std::vector<Site> sites(static_cast<std::size_t>(3 + below(6)));
        for (Site& s : sites) {
            s.x = below(20) - 10;
            s.y = s.r = round % 2 == 0 ? s.x * s.x : below(8);
        }
        for_each_end(sites, Euclidean{},
                     [&](const Site& a, const Site& b, const Site& apex, EndOfEdge end,
                         const DiagramVertex& vertex) {
                         if (std::isfinite(vertex.x)) return;
                         ++at_infinity;
                         const Point below_a = {a.x, a.y - 1};
                         ASSERT_EQ(far_end(Euclidean{}, WeightIs::radius, a, b, apex, end),
                                   side_of(a, b, below_a) > 0 ? 1 : -1)
                             << round;
                     });
    }
    EXPECT_GT(at_infinity, rounds / 2);
}

TEST(FarEnd, OfEqualDiscsInLineIsGivenByTheTurn) {
    // Above them the face reads from left to right.
    const Site left = {-300, -160, 0};
    const Site middle = {180, 96, 0};
    const Site right = {480, 256, 0};
    for (const double more : {0.0, 0x1p-1074}) {
        Site larger = right;
        larger.r = more;
        const auto of = [&](const Site& a, const Site& b, const Site& apex, EndOfEdge end) {
            return far_end(Euclidean{}, WeightIs::radius, a, b, apex, end);
        };
        EXPECT_EQ(of(left, middle, larger, EndOfEdge::to), 1);
        EXPECT_EQ(of(middle, larger, left, EndOfEdge::to), 1);
        EXPECT_EQ(of(larger, left, middle, EndOfEdge::to), -1);
        EXPECT_EQ(of(left, larger, middle, EndOfEdge::from), 1);
        EXPECT_EQ(of(left, larger, middle, EndOfEdge::to), -1);
        EXPECT_EQ(of(left, middle, larger, EndOfEdge::from), -1);
    }
}

}  // namespace
}  // namespace signum
