/// The Voronoi diagram of balls against brute force in rationals, and larger ones against what any
/// diagram obeys.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "../../spatial/ball_diagram.hpp"
#include "../../spatial/triangulate.hpp"
#include "../oracle/ball_edges.hpp"
#include "../oracle/balls_space.hpp"
#include "../thoroughness.hpp"
#include "ball_families.hpp"

namespace signum {
namespace {

using Balls = std::vector<Site3>;

std::string text_of(const Balls& balls) {
    std::string result;
    for (const Site3& b : balls) {
        char buffer[160];
        std::snprintf(buffer, sizeof buffer, "{%a, %a, %a, %a},\n", b.x, b.y, b.z, b.r);
        result += buffer;
    }
    return result;
}

using List = std::vector<Index>;
List list_of(std::span<const Index> list) {
    return {list.begin(), list.end()};
}

/// Of each curve: how many arcs, how many of their ends are at infinity, and whether it is one
/// closed edge.
struct Arcs {
    int arcs = 0;
    int ends_at_infinity = 0;
    bool is_closed = false;
    friend bool operator==(const Arcs&, const Arcs&) = default;
};
using Curves = std::map<List, Arcs>;
void PrintTo(const Arcs& a, std::ostream* out) {
    *out << a.arcs << " arcs, " << a.ends_at_infinity << " infinite" << (a.is_closed ? ", closed" : "");
}
Curves curves_of(const BallDiagram& d) {
    Curves curves;
    for (std::size_t e = 0; e < d.edges.size(); ++e) {
        Arcs& arcs = curves[list_of(d.edges[e])];
        ++arcs.arcs;
        for (const Index end : d.ends[e]) arcs.ends_at_infinity += end == infinite;
        arcs.is_closed |= d.ends[e][0] == no_end;
    }
    return curves;
}

/// The arrays are sorted, and an end is a vertex that the edge's balls touch.
void expect_order(const BallDiagram& d) {
    for (std::size_t v = 1; v < d.vertices.size(); ++v) {
        const List before = list_of(d.vertices[v - 1]), now = list_of(d.vertices[v]);
        EXPECT_TRUE(before < now || (before == now && d.turns[v - 1] > d.turns[v]));
    }
    for (std::size_t e = 0; e < d.edges.size(); ++e) {
        const List balls = list_of(d.edges[e]);
        if (e > 0) {
            const List before = list_of(d.edges[e - 1]);
            EXPECT_TRUE(before < balls || (before == balls && d.ends[e - 1] <= d.ends[e]));
        }
        EXPECT_LE(d.ends[e][0], d.ends[e][1]);
        for (const Index end : d.ends[e]) {
            if (end < 0) continue;
            const auto touching = d.vertices[static_cast<std::size_t>(end)];
            EXPECT_TRUE(std::includes(touching.begin(), touching.end(), balls.begin(), balls.end()));
        }
    }
}

/// Between the doubles beside it: how it is rounded is the matter of touching_spheres().
void expect_near(double rounded, const oracle::Surd& x) {
    const double below = std::nextafter(rounded, -HUGE_VAL);
    const double above = std::nextafter(rounded, HUGE_VAL);
    if (std::isfinite(below)) {
        EXPECT_LT(oracle::Surd(oracle::exactly(below)), x);
    }
    if (std::isfinite(above)) {
        EXPECT_LT(x, oracle::Surd(oracle::exactly(above)));
    }
}

void expect_as_oracle(const Balls& balls) {
    SCOPED_TRACE(text_of(balls));
    const BallDiagram d = ball_diagram(balls);
    std::vector<oracle::SpaceBall<3>> exact;
    for (const Site3& b : balls) exact.push_back(oracle::exact_ball(b));
    const std::vector<bool> hidden = oracle::hidden_balls<3>(exact);
    std::size_t number_of_hidden = 0;
    for (std::size_t i = 0; i < balls.size(); ++i) {
        if (!hidden[i]) continue;
        ASSERT_LT(number_of_hidden, d.hidden.size());
        const Hidden& ours = d.hidden[number_of_hidden++];
        EXPECT_EQ(ours.site, static_cast<Index>(i));
        std::size_t by = 0;
        while (hidden[by] || !oracle::contains<3>(exact[by], exact[i])) ++by;
        EXPECT_EQ(ours.by, static_cast<Index>(by));
    }
    EXPECT_EQ(number_of_hidden, d.hidden.size());

    std::map<std::pair<List, Sign>, Site3> ours;
    for (std::size_t v = 0; v < d.vertices.size(); ++v)
        ours.insert({{list_of(d.vertices[v]), -d.turns[v]}, d.spheres[v]});
    const auto vertices = oracle::ball_vertices<3>(exact);
    EXPECT_EQ(d.vertices.size(), vertices.size());
    for (const auto& vertex : vertices) {
        const auto& [c, rho, orientation] = vertex.sphere;
        const auto mine = ours.find({vertex.balls, orientation});
        ASSERT_TRUE(mine != ours.end()) << ::testing::PrintToString(vertex.balls);
        expect_near(mine->second.x, c[0]);
        expect_near(mine->second.y, c[1]);
        expect_near(mine->second.z, c[2]);
        expect_near(mine->second.r, rho);
    }

    Curves curves;
    for (const oracle::BallEdge& edge : oracle::ball_edges(exact))
        curves[edge.balls] = {edge.arcs, edge.ends_at_infinity, edge.is_closed};
    EXPECT_EQ(curves_of(d), curves);
    expect_order(d);
}

class BallDiagramOf : public ::testing::TestWithParam<ball_families::Family> {};

TEST_P(BallDiagramOf, IsTheOracles) {
    Random g(17);
    const int trials = static_cast<int>(GetParam().share * 4 * thoroughness);
    for (int trial = 0; trial < trials && !HasFailure(); ++trial) {
        Balls balls;
        const int n = 3 + g.below(6);
        while (static_cast<int>(balls.size()) < n)
            for (const AnyBall& b : GetParam().draw(g, 3))
                if (static_cast<int>(balls.size()) < n) balls.push_back(site_of(b, Site3()));
        expect_as_oracle(balls);
    }
}

INSTANTIATE_TEST_SUITE_P(Families, BallDiagramOf, ::testing::ValuesIn(ball_families::families),
                         [](const auto& tested) { return tested.param.name; });

}  // namespace
}  // namespace signum
