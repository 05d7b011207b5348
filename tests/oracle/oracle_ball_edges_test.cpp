/// The edges of balls in space against cases by hand, the triangles of Delaunay cells, and against
/// their ends, which are the vertices.

#include <gtest/gtest.h>
#include "ball_edges.hpp"
#include "balls_space.hpp"
#include "oracle_test_support.hpp"
#include "power_space.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace {

using namespace signum::oracle_test;
using signum::Site3;
using signum::oracle::ball_edges;
using signum::oracle::BallEdge;
using signum::oracle::exact_ball;
using signum::oracle::SpaceBall;

using Balls = std::vector<SpaceBall<3>>;
using Edges = std::vector<BallEdge>;

Balls exact(const std::vector<Site3>& sites) {
    Balls balls;
    for (const Site3& site : sites) balls.push_back(exact_ball(site));
    return balls;
}

Edges edges_of(const std::vector<Site3>& sites) {
    return ball_edges(exact(sites));
}

TEST(OracleBallEdges, ByHand) {
    EXPECT_TRUE(edges_of({}).empty());
    EXPECT_TRUE(edges_of({{0, 0, 0, 0}, {1, 0, 0, 0}}).empty());
    // A line, a branch of a hyperbola, and a circle around the axis of the balls.
    const Edges whole{{{0, 1, 2}, 1, 2, false}};
    EXPECT_EQ(edges_of({{0, 0, 0, 0}, {1, 0, 0, 0}, {0, 1, 0, 0}}), whole);
    EXPECT_EQ(edges_of({{0, 0, 0, 0}, {1, 0, 0, 0.5}, {0, 1, 0, 0}}), whole);
    EXPECT_EQ(edges_of({{-4, 0, 0, 3}, {0, 0, 0, 1}, {4, 0, 0, 3}}),
              (Edges{{{0, 1, 2}, 1, 0, true}}));
    // All touch the plane z = 0 in points of a line: a parabola.
    EXPECT_EQ(edges_of({{-2, 0, 2, 2}, {0, 0, 1, 1}, {3, 0, 2, 2}}), whole);
    // Too large in the middle; a line of points; hidden ones.
    EXPECT_TRUE(edges_of({{-4, 0, 0, 1}, {0, 0, 0, 3}, {4, 0, 0, 1}}).empty());
    EXPECT_TRUE(edges_of({{-4, 0, 0, 1}, {0, 0, 0, 1}, {4, 0, 0, 1}}).empty());
    EXPECT_EQ(edges_of({{0, 0, 0, 0.5}, {1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 0, 0}}), whole);
}

TEST(OracleBallEdges, OfACubeLeaveThroughItsFaces) {
    std::vector<Site3> corners;
    for (const double x : {0, 1})
        for (const double y : {0, 1})
            for (const double z : {0, 1}) corners.push_back({x, y, z, 0.25});
    const Edges edges = edges_of(corners);
    ASSERT_EQ(edges.size(), 6U);
    for (const BallEdge& edge : edges) EXPECT_EQ(edge, (BallEdge{edge.balls, 1, 1, false}));
    EXPECT_EQ(edges[0].balls, (std::vector<std::int32_t>{0, 1, 2, 3}));
}

TEST(OracleBallEdges, AnEllipseAndWhatCutsIt) {
    // The circle y² + z² = 9, x = 0 of spheres with radius 2.
    const std::vector<Site3> axis{{-4, 0, 0, 3}, {0, 0, 0, 1}, {4, 0, 0, 3}};
    const auto arcs = [&](const std::vector<Site3>& others) {
        std::vector<Site3> sites = axis;
        sites.insert(sites.end(), others.begin(), others.end());
        for (const BallEdge& edge : edges_of(sites))
            if (edge.balls[0] == 0 && edge.balls[1] == 1 && edge.balls[2] == 2) return edge;
        return BallEdge{};
    };
    EXPECT_EQ(arcs({{0, 50, 0, 1}}), (BallEdge{{0, 1, 2}, 1, 0, true}));
    EXPECT_EQ(arcs({{0, 50, 0, 45.5}}), (BallEdge{{0, 1, 2}, 1, 0, false}));  // a bite
    EXPECT_EQ(arcs({{0, 50, 0, 45}}), (BallEdge{{0, 1, 2}, 1, 0, false}));    // a touch
    EXPECT_EQ(arcs({{0, 0, 50, 45}}), (BallEdge{{0, 1, 2}, 1, 0, false}));
    EXPECT_EQ(arcs({{0, 3, 50, 45}}), (BallEdge{{0, 1, 2}, 1, 0, true}));
    EXPECT_EQ(arcs({{0, 50, 0, 45.5}, {0, -50, 0, 45.5}}), (BallEdge{{0, 1, 2}, 2, 0, false}));
    EXPECT_EQ(arcs({{0, 50, 0, 45.5}, {0, 0, 50, 45.5}}), (BallEdge{{0, 1, 2}, 2, 0, false}));
    EXPECT_EQ(arcs({{0, 50, 0, 45}, {0, -50, 0, 45}, {0, 0, 50, 45}, {0, 0, -50, 45}}),
              (BallEdge{{0, 1, 2}, 4, 0, false}));
    EXPECT_EQ(arcs({{0, 50, 0, 52}}), BallEdge{});
    // A fourth on the axis that touches all along, and one that is too large.
    EXPECT_EQ(arcs({{2.25, 0, 0, 1.75}}), (BallEdge{{0, 1, 2, 3}, 1, 0, true}));
    EXPECT_EQ(arcs({{2.25, 0, 0, 2}}), BallEdge{});
    EXPECT_EQ(arcs({{2.25, 0, 0, 1.5}}), (BallEdge{{0, 1, 2}, 1, 0, true}));
}

TEST(OracleBallEdges, OfPointsAreTheTrianglesOfDelaunayCells) {
    Random random(5);
    for (int trial = 0; trial < 25; ++trial) {
        const int n = 4 + random.below(4);
        std::vector<signum::oracle::SpaceSite<3>> points;
        std::vector<Site3> sites;
        for (int i = 0; i < n; ++i) {
            auto& point = points.emplace_back();
            for (double& x : point.c) x = random.unit();
            sites.push_back({point.c[0], point.c[1], point.c[2], 0.25});
        }
        const auto t = signum::oracle::power_space<3>(points);
        ASSERT_EQ(t.dimension, 3);
        std::map<std::vector<std::int32_t>, int> ends;  // how many of the two are at infinity
        for (const auto& cell : t.cells)
            for (std::size_t without = 0; without < 4; ++without) {
                std::vector<std::int32_t> triangle(cell.begin(), cell.end());
                triangle.erase(triangle.begin() + static_cast<std::ptrdiff_t>(without));
                ends[triangle] = 0;
            }
        for (const auto& facet : t.facets) ends[{facet.begin(), facet.end()}] = 1;
        Edges expected;
        for (const auto& [triangle, at_infinity] : ends)
            expected.push_back({triangle, 1, at_infinity, false});
        ASSERT_EQ(edges_of(sites), expected);
    }
}

TEST(OracleBallEdges, AreTheSameInOtherOrders) {
    // Ties everywhere; and every arc that does not go to infinity ends in a vertex.
    Random random(7);
    std::size_t tied = 0;
    for (int trial = 0; trial < 40; ++trial) {
        std::vector<Site3> sites;
        for (int n = 5 + random.below(5); n > 0; --n) {
            const double x = random.below(2), y = random.below(3), z = random.below(2);
            sites.push_back({x, y, z, 0.25 * random.below(1 + trial % 3)});
        }
        std::vector<std::int32_t> order(sites.size());
        std::iota(order.begin(), order.end(), 0);
        order = shuffled(order, random);
        std::vector<Site3> moved;
        for (const std::int32_t i : order) moved.push_back(sites[static_cast<std::size_t>(i)]);
        // Of equal sites the first is visible: compare by their numbers of places.
        const auto of_sites = [](const std::vector<Site3>& all) {
            std::multiset<std::vector<std::array<double, 4>>> edges;
            for (const BallEdge& edge : edges_of(all)) {
                std::vector<std::array<double, 4>> balls;
                for (const std::int32_t i : edge.balls) {
                    const Site3& site = all[static_cast<std::size_t>(i)];
                    balls.push_back({site.x, site.y, site.z, site.r});
                }
                std::sort(balls.begin(), balls.end());
                balls.push_back(
                    {1.0 * edge.arcs, 1.0 * edge.ends_at_infinity, 1.0 * edge.is_closed});
                edges.insert(std::move(balls));
            }
            return edges;
        };
        ASSERT_EQ(of_sites(moved), of_sites(sites));

        std::set<std::vector<std::int32_t>> vertices;
        for (const auto& vertex : signum::oracle::ball_vertices<3>(exact(sites)))
            vertices.insert(vertex.balls);
        for (const BallEdge& edge : edges_of(sites)) {
            tied += edge.balls.size() > 3;
            const bool has_ends = !edge.is_closed && 2 * edge.arcs > edge.ends_at_infinity;
            ASSERT_EQ(has_ends, std::any_of(vertices.begin(), vertices.end(), [&](const auto& v) {
                          return std::includes(v.begin(), v.end(), edge.balls.begin(),
                                               edge.balls.end());
                      }));
        }
    }
    EXPECT_GT(tied, 10U);
}

TEST(OracleBallEdges, EndInVertices) {
    Random random(6);
    std::size_t vertices = 0, twice = 0, closed = 0, two_arcs = 0;
    for (int trial = 0; trial < 60; ++trial) {
        const int n = 3 + random.below(6);
        const double radius = 0.2 * (trial % 4);
        std::vector<Site3> sites;
        for (int i = 0; i < n; ++i) {
            const double x = random.unit(), y = random.unit(), z = random.unit();
            sites.push_back({x, y, z * (trial % 3 == 0 ? 0.1 : 1), random.unit() * radius});
        }
        if (trial % 2 == 0) sites.push_back({0.5, 0.5, 0, -0.3});
        const Balls balls = exact(sites);
        // Without ties each three of a vertex's four balls have an arc that ends there.
        std::map<std::vector<std::int32_t>, int> at_vertices, of_arcs;
        const auto found = signum::oracle::ball_vertices<3>(balls);
        std::set<std::vector<std::int32_t>> different;
        for (const auto& vertex : found) {
            ASSERT_EQ(vertex.balls.size(), 4U);
            for (std::size_t without = 0; without < 4; ++without) {
                auto triple = vertex.balls;
                triple.erase(triple.begin() + static_cast<std::ptrdiff_t>(without));
                ++at_vertices[triple];
            }
            twice += !different.insert(vertex.balls).second;
        }
        for (const BallEdge& edge : ball_edges(balls)) {
            closed += edge.is_closed;
            two_arcs += edge.arcs > 1;
            ASSERT_TRUE(!edge.is_closed || edge.ends_at_infinity == 0);
            const int ends = edge.is_closed ? 0 : 2 * edge.arcs - edge.ends_at_infinity;
            if (ends > 0) of_arcs[edge.balls] = ends;
        }
        ASSERT_EQ(of_arcs, at_vertices);
        vertices += found.size();
    }
    EXPECT_GT(vertices, 200U);
    EXPECT_GT(twice, 5U);
    EXPECT_GT(closed, 1U);
    EXPECT_GT(two_arcs, 5U);
}

}  // namespace
