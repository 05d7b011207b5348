/// The Voronoi diagram of balls against brute force in rationals, and larger ones against what any
/// diagram obeys.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <set>
#include <span>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <vector>

#include "../../predicates/space/ccw.hpp"
#include "../../predicates/space/euclidean.hpp"
#include "../../triangulation/space/triangulate.hpp"
#include "../../voronoi/balls/diagram.hpp"
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
    *out << a.arcs << " arcs, " << a.ends_at_infinity << " infinite"
         << (a.is_closed ? ", closed" : "");
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
            EXPECT_TRUE(
                std::includes(touching.begin(), touching.end(), balls.begin(), balls.end()));
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
    // Which ends an arc joins: vertices of the oracle's spheres, rising.
    std::vector<std::pair<List, std::array<Index, 2>>> arcs;
    const auto end_of = [&](const std::optional<oracle::TouchingSphere<3>>& sphere) -> Index {
        if (!sphere) return infinite;
        for (const auto& vertex : vertices) {
            if (!(vertex.sphere.c == sphere->c && vertex.sphere.rho == sphere->rho)) continue;
            for (std::size_t v = 0; v < d.vertices.size(); ++v)
                if (list_of(d.vertices[v]) == vertex.balls &&
                    -d.turns[v] == vertex.sphere.orientation)
                    return static_cast<Index>(v);
        }
        return no_end;
    };
    for (const oracle::BallEdge& edge : oracle::ball_edges(exact)) {
        curves[edge.balls] = {edge.arcs, edge.ends_at_infinity, edge.is_closed};
        if (edge.is_closed) arcs.push_back({edge.balls, {no_end, no_end}});
        for (const auto& [first, last] : edge.ends) {
            const std::array<Index, 2> ends = {end_of(first), end_of(last)};
            arcs.push_back({edge.balls, {std::min(ends[0], ends[1]), std::max(ends[0], ends[1])}});
        }
    }
    EXPECT_EQ(curves_of(d), curves);
    std::ranges::sort(arcs);
    std::vector<std::pair<List, std::array<Index, 2>>> our_arcs;
    for (std::size_t e = 0; e < d.edges.size(); ++e)
        our_arcs.emplace_back(list_of(d.edges[e]), d.ends[e]);
    EXPECT_EQ(our_arcs, arcs);
    expect_order(d);
}

class BallDiagramOf : public ::testing::TestWithParam<ball_families::Family> {};

TEST_P(BallDiagramOf, IsTheOracles) {
    Random g(17);
    const int trials = static_cast<int>(GetParam().share * 2 * thoroughness);
    for (int trial = 0; trial < trials && !HasFailure(); ++trial) {
        Balls balls;
        const int n = 3 + g.below(5);
        while (static_cast<int>(balls.size()) < n)
            for (const AnyBall& b : GetParam().draw(g, 3))
                if (static_cast<int>(balls.size()) < n) balls.push_back(site_of(b, Site3()));
        expect_as_oracle(balls);
    }
}

INSTANTIATE_TEST_SUITE_P(Families, BallDiagramOf, ::testing::ValuesIn(ball_families::families),
                         [](const auto& tested) { return tested.param.name; });

// ---- by hand -----------------------------------------------------------------------------------

TEST(BallDiagram, NoneOrFew) {
    EXPECT_EQ(ball_diagram({}), BallDiagram());
    const BallDiagram one = ball_diagram(Balls{{1, 2, 3, 4}});
    EXPECT_EQ(one.balls, 1);
    EXPECT_EQ(one.vertices.size() + one.edges.size() + one.hidden.size(), 0U);
    const BallDiagram two = ball_diagram(Balls{{0, 0, 0, 1}, {9, 0, 0, 2}, {0, 0, 0, 1}});
    EXPECT_EQ(two.edges.size(), 0U);
    EXPECT_EQ(two.hidden, (std::vector<Hidden>{{2, 0}}));
    EXPECT_THROW(static_cast<void>(ball_diagram(Balls{{0, 0, 0, HUGE_VAL}})),
                 std::invalid_argument);
    Options options;
    std::stop_source stop;
    stop.request_stop();
    options.stop = stop.get_token();
    EXPECT_THROW(static_cast<void>(ball_diagram(Balls{{0, 0, 0, 1}}, options)), Stopped);
}

TEST(BallDiagram, ThreeBallsHaveOneEdgeFromInfinityToInfinity) {
    const BallDiagram d = ball_diagram(Balls{{0, 0, 0, 1}, {5, 0, 0, 1}, {0, 5, 0, 2}});
    EXPECT_EQ(list_of(d.edges[0]), (List{0, 1, 2}));
    EXPECT_EQ(d.ends, (std::vector<std::array<Index, 2>>{{infinite, infinite}}));
    EXPECT_EQ(d.vertices.size(), 0U);
}

TEST(BallDiagram, ASmallBallBetweenTwoLargeOnesHasARing) {
    const Balls balls{{-5, 0, 0, 4}, {5, 0, 0, 4}, {0, 0, 0, 0.5}};
    const BallDiagram d = ball_diagram(balls);
    EXPECT_EQ(d.vertices.size(), 0U);
    ASSERT_EQ(d.edges.size(), 1U);
    EXPECT_EQ(d.ends[0], (std::array<Index, 2>{no_end, no_end}));
    expect_as_oracle(balls);
    // The same within a crowd that does not reach it.
    Balls crowd = balls;
    for (const double x : {-40.0, 40.0})
        for (const double y : {-40.0, 40.0})
            for (const double z : {-40.0, 40.0}) crowd.push_back({x, y, z, 1.0});
    const Curves curves = curves_of(ball_diagram(crowd));
    ASSERT_TRUE(curves.contains({0, 1, 2}));
    EXPECT_TRUE(curves.at({0, 1, 2}).is_closed);
}

TEST(BallDiagram, AGridHasACellOfEightBallsAVertex) {
    Balls balls;
    for (int x = 0; x < 5; ++x)
        for (int y = 0; y < 5; ++y)
            for (int z = 0; z < 5; ++z) balls.push_back({1.0 * x, 1.0 * y, 1.0 * z, 0.25});
    const BallDiagram d = ball_diagram(balls);
    EXPECT_EQ(d.vertices.size(), 64U);
    // Each square between two cubes, or on the outside.
    EXPECT_EQ(d.edges.size(), 240U);
    for (std::size_t v = 0; v < d.vertices.size(); ++v) EXPECT_EQ(d.vertices[v].size(), 8U);
    for (std::size_t e = 0; e < d.edges.size(); ++e) EXPECT_EQ(d.edges[e].size(), 4U);
    expect_order(d);
}

TEST(BallDiagram, OfFiveBallsTouchedInAPlaneFourHaveOneCurve) {
    const Balls balls{{3, -6, 6, 8}, {-6, -6, -3, 8}, {0, 0, 6, 5}, {0, -3, 0, 2}, {-6, 0, 0, 5}};
    const Curves curves = curves_of(ball_diagram(balls));
    EXPECT_EQ(curves.size(), 2U);
    EXPECT_TRUE(curves.contains({0, 1, 2, 4}));
    EXPECT_TRUE(curves.contains({0, 1, 3}));
    expect_as_oracle(balls);
}

// ---- small sets of other kinds
// -------------------------------------------------------------------

Balls few_giants(Random& g, int n) {
    Balls balls;
    for (int i = 0; i < n; ++i) {
        const bool is_giant = i < 2;
        const auto one = [&] { return (is_giant ? 12.0 : 4.0) * (2 * g.real() - 1); };
        const double x = one(), y = one(), z = one();
        balls.push_back({x, y, z, is_giant ? 6.0 + g.real() : g.real()});
    }
    return balls;
}
/// Small balls between two large ones, whose rings meet, touch or stand alone; on a grid.
Balls rings(Random& g, int n) {
    Balls balls{{-64, 0, 0, 60}, {64, 0, 0, 60.0 - g.below(3)}};
    while (static_cast<int>(balls.size()) < n)
        balls.push_back({0.5 * g.between(-2, 2), 2.0 * g.between(-4, 4), 2.0 * g.between(-4, 4),
                         0.5 * g.between(1, 4)});
    return balls;
}

TEST(BallDiagram, OfFewGiantsAmongSmallOnesIsTheOracles) {
    Random g(3);
    for (int trial = 0; trial < 12 * thoroughness && !HasFailure(); ++trial)
        expect_as_oracle(few_giants(g, 4 + g.below(4)));
}

TEST(BallDiagram, OfRingsIsTheOracles) {
    Random g(4);
    for (int trial = 0; trial < 20 * thoroughness && !HasFailure(); ++trial)
        expect_as_oracle(rings(g, 3 + g.below(6)));
}

// ---- what changes nothing
// ------------------------------------------------------------------------

Balls random_balls(Random& g, int n, double side, double most) {
    Balls balls;
    for (int i = 0; i < n; ++i) {
        const double x = g.real(), y = g.real(), z = g.real();
        // Of few bits, so that radii can be changed without rounding.
        balls.push_back(
            {side * x, side * y, side * z, 1.0 + std::round((most - 1) * 1024 * g.real()) / 1024});
    }
    return balls;
}

TEST(BallDiagram, AChangeOfAllRadiiChangesTheRadiiOfSpheresAlone) {
    Random g(5);
    for (int trial = 0; trial < 4 * thoroughness; ++trial) {
        Balls balls = trial % 2 == 0 ? random_balls(g, 60, 10, 3) : rings(g, 20);
        const BallDiagram before = ball_diagram(balls);
        for (Site3& b : balls) b.r -= 8.0;
        const BallDiagram after = ball_diagram(balls);
        EXPECT_EQ(before.vertices, after.vertices);
        EXPECT_EQ(before.turns, after.turns);
        EXPECT_EQ(before.edges, after.edges);
        EXPECT_EQ(before.ends, after.ends);
        EXPECT_EQ(before.hidden, after.hidden);
        for (std::size_t v = 0; v < before.spheres.size(); ++v)
            EXPECT_EQ(before.spheres[v].x, after.spheres[v].x);
    }
}

/// A list of balls by other names.
List renamed(std::span<const Index> list, const std::vector<Index>& names) {
    List result;
    for (const Index i : list) result.push_back(names[static_cast<std::size_t>(i)]);
    std::sort(result.begin(), result.end());
    return result;
}

TEST(BallDiagram, OrderAndMirrorOfTheInputChangeNothingElse) {
    Random g(6);
    for (int trial = 0; trial < 4 * thoroughness; ++trial) {
        const Balls balls = trial % 2 == 0 ? random_balls(g, 80, 11, 3) : rings(g, 20);
        std::vector<Index> names(balls.size());
        for (std::size_t i = 0; i < names.size(); ++i) names[i] = static_cast<Index>(i);
        for (std::size_t i = names.size(); i > 1; --i)
            std::swap(names[i - 1], names[static_cast<std::size_t>(g.below(static_cast<int>(i)))]);
        Balls shuffled;
        for (const Index i : names) {
            Site3 b = balls[static_cast<std::size_t>(i)];
            std::swap(b.x, b.z);  // a mirror image
            shuffled.push_back(b);
        }
        const BallDiagram d = ball_diagram(balls), other = ball_diagram(shuffled);
        std::map<List, int> vertices, others;
        for (std::size_t v = 0; v < d.vertices.size(); ++v) ++vertices[list_of(d.vertices[v])];
        for (std::size_t v = 0; v < other.vertices.size(); ++v)
            ++others[renamed(other.vertices[v], names)];
        // Of equal balls another one is the visible one.
        if (trial % 2 != 0 && !d.hidden.empty()) continue;
        EXPECT_EQ(vertices, others);
        Curves curves;
        for (const auto& [list, arcs] : curves_of(other)) curves[renamed(list, names)] = arcs;
        EXPECT_EQ(curves_of(d), curves);
    }
}

// ---- larger sets
// ---------------------------------------------------------------------------------

/// Every vertex is empty, by all balls; edges hang together with vertices; and each ball is in the
/// diagram or hidden.
void expect_laws(const Balls& balls, const BallDiagram& d) {
    expect_order(d);
    std::vector<int> ends(d.vertices.size());
    for (const auto& [one, other] : d.ends) {
        EXPECT_EQ(one == no_end, other == no_end);
        for (const Index end : {one, other})
            if (end >= 0) ++ends[static_cast<std::size_t>(end)];
    }
    std::vector<char> is_hidden(balls.size()), is_seen(balls.size());
    for (const Hidden& h : d.hidden) {
        is_hidden[static_cast<std::size_t>(h.site)] = 1;
        EXPECT_TRUE(euclidean::hidden(balls[static_cast<std::size_t>(h.site)],
                                      balls[static_cast<std::size_t>(h.by)]));
    }
    for (const Index i : d.edges.balls) is_seen[static_cast<std::size_t>(i)] = 1;
    for (std::size_t i = 0; i < balls.size(); ++i) EXPECT_FALSE(is_hidden[i] && is_seen[i]);
    for (std::size_t v = 0; v < d.vertices.size(); ++v) {
        const auto list = d.vertices[v];
        if (list.size() != 4 || d.turns[v] == 0) continue;
        EXPECT_EQ(ends[v], 4);
        const auto at = [&](std::size_t k) -> const Site3& {
            return balls[static_cast<std::size_t>(list[k])];
        };
        const Site3 &a = at(0), &b = at(d.turns[v] > 0 ? 1 : 2), &c = at(d.turns[v] > 0 ? 2 : 1);
        ASSERT_TRUE(euclidean::exists(a, b, c, at(3)));
        for (std::size_t q = 0; q < balls.size(); ++q) {
            const bool is_one =
                std::find(list.begin(), list.end(), static_cast<Index>(q)) != list.end();
            if (!is_one && !is_hidden[q]) {
                ASSERT_LT(euclidean::in_sphere(a, b, c, at(3), balls[q]), 0);
            }
        }
    }
}

/// All quadruples of balls, by brute force: the vertices, where no five balls touch one sphere.
std::map<List, int> all_vertices(const Balls& balls, const BallDiagram& d) {
    std::vector<Index> visible;
    for (std::size_t i = 0, h = 0; i < balls.size(); ++i) {
        if (h < d.hidden.size() && d.hidden[h].site == static_cast<Index>(i)) {
            ++h;
        } else {
            visible.push_back(static_cast<Index>(i));
        }
    }
    std::map<List, int> vertices;
    const std::size_t n = visible.size();
    const auto at = [&](std::size_t k) -> const Site3& {
        return balls[static_cast<std::size_t>(visible[k])];
    };
    std::vector<std::size_t> judges(n);  // those that have had a conflict first
    for (std::size_t i = 0; i < n; ++i) judges[i] = i;
    const auto try_four = [&](std::size_t i, std::size_t j, std::size_t k, std::size_t l,
                              List list) {
        if (!euclidean::exists(at(i), at(j), at(k), at(l))) return;
        for (std::size_t m = 0; m < n; ++m) {
            const std::size_t q = judges[m];
            if (q == i || q == j || q == k || q == l) continue;
            if (euclidean::in_sphere(at(i), at(j), at(k), at(l), at(q)) <= 0) continue;
            std::swap(judges[m], judges[m / 2]);
            return;
        }
        ++vertices[std::move(list)];
    };
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i + 1; j < n; ++j)
            for (std::size_t k = j + 1; k < n; ++k)
                for (std::size_t l = k + 1; l < n; ++l) {
                    const List list{visible[i], visible[j], visible[k], visible[l]};
                    try_four(i, j, k, l, list);
                    try_four(i, k, j, l, list);
                }
    return vertices;
}

TEST(BallDiagram, OfMoreBallsHasAllVertices) {
    Random g(7);
    for (int trial = 0; trial < thoroughness; ++trial) {
        const int n = 40 + g.below(20);
        const Balls balls = trial % 2 == 0 ? random_balls(g, n, 9, 3) : few_giants(g, n);
        const BallDiagram d = ball_diagram(balls);
        expect_laws(balls, d);
        std::map<List, int> vertices;
        for (std::size_t v = 0; v < d.vertices.size(); ++v) ++vertices[list_of(d.vertices[v])];
        EXPECT_EQ(vertices, all_vertices(balls, d));
    }
}

/// Balls with centres near a line, a circle, a plane or a sphere, and radii near those that let all
/// touch along one curve, or one sphere: the search for candidates tells them apart by less than
/// doubles do.
Balls nearly_on(const std::string& shape, Random& g, int n, double off) {
    Balls balls;
    const auto noise = [&] { return off * (2 * g.real() - 1); };
    for (int i = 0; i < n; ++i) {
        const double t = 3.0 * i + g.real(), angle = 2.0 * i + g.real();
        Site3 b{0, 0, 0, 1};
        if (shape == "line" || shape == "cone") {
            b = {0.48 * t, 0.6 * t, 0.64 * t, shape == "cone" ? 0.25 * t : 1.0};
        } else if (shape == "axis") {
            b.x = 3.0 * i;
        } else if (shape == "circle") {
            b = {20 * std::cos(angle), 16 * std::sin(angle), 12 * std::sin(angle), 1};
        } else if (shape == "plane") {
            b = {40 * g.real(), 40 * g.real(), 0, 1};
            b.z = 0.3 * b.x - 0.7 * b.y;
        } else {
            const double z = 2 * g.real() - 1, r = std::sqrt(1 - z * z);
            b = {20 * r * std::cos(angle), 20 * r * std::sin(angle), 20 * z, 1};
        }
        balls.push_back({b.x + noise(), b.y + noise(), b.z + noise(), b.r + noise()});
    }
    return balls;
}

TEST(BallDiagram, OfBallsNearlyOnALineHasAllVertices) {
    Random g(18);
    for (const char* shape : {"line", "axis", "cone", "circle", "plane", "sphere"}) {
        for (const double off : {0x1p-10, 0x1p-25, 0x1p-40, 0x1p-49}) {
            for (int trial = 0; trial < (is_fast ? 3 : 1); ++trial) {
                const Balls balls = nearly_on(shape, g, is_sanitized ? 11 : 14 + g.below(8), off);
                SCOPED_TRACE(shape + std::string(", off by ") + std::to_string(std::ilogb(off)));
                const BallDiagram d = ball_diagram(balls);
                expect_laws(balls, d);
                std::map<List, int> vertices;
                bool is_general = true;
                for (std::size_t v = 0; v < d.vertices.size(); ++v) {
                    ++vertices[list_of(d.vertices[v])];
                    is_general &= d.vertices[v].size() == 4 && d.turns[v] != 0;
                }
                if (is_general) {
                    EXPECT_EQ(vertices, all_vertices(balls, d));
                }
            }
        }
    }
}

/// They were tried four by four: 40 on a circle took more than a minute.
TEST(BallDiagram, OfBallsNearlyOnALineTakesNoLongerThanTheirSquares) {
    Random g(19);
    for (const char* shape : {"line", "axis", "circle", "plane", "sphere"}) {
        for (const double off : {0x1p-10, 0x1p-30, 0x1p-49}) {
            const Balls balls = nearly_on(shape, g, is_fast ? 50 : 15, off);
            const auto begin = std::chrono::steady_clock::now();
            const BallDiagram d = ball_diagram(balls);
            const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
            EXPECT_GT(d.edges.size(), balls.size()) << shape;
            // Some 0.5 s at most on an idle machine.
            EXPECT_LT(seconds.count(), is_fast ? 20.0 : 60.0) << shape << ", off by " << off;
        }
    }
}

TEST(BallDiagram, OfManyBallsObeysItsLaws) {
    Random g(8);
    for (const int n : is_fast        ? std::array{200, 500, 2000}
                       : is_sanitized ? std::array{20, 50, 100}
                                      : std::array{50, 100, 300}) {
        for (const double most : {1.0, 3.0, 20.0}) {
            const Balls balls = random_balls(g, n, 2.5 * most * std::cbrt(n) / 3, most);
            expect_laws(balls, ball_diagram(balls));
        }
    }
    const Balls balls = few_giants(g, is_fast ? 600 : is_sanitized ? 100 : 200);
    expect_laws(balls, ball_diagram(balls));
}

/// Two clouds far from one another, one inside a shell of large balls: nothing that is reached from
/// one leads to the other along edges.
TEST(BallDiagram, HasAllComponents) {
    Random g(9);
    Balls balls{{-1e4, 0, 0, 9990}, {1e4, 0, 0, 9990}};
    const int n = is_sanitized ? 12 : 30;
    for (int i = 0; i < n; ++i)
        balls.push_back({2 * g.real() - 1, 40 * g.real() - 20, 40 * g.real() - 20, 0.5});
    for (int i = 0; i < n; ++i)
        balls.push_back({2 * g.real() - 1, 2000 + 40 * g.real(), 40 * g.real() - 20, 0.5});
    const BallDiagram d = ball_diagram(balls);
    expect_laws(balls, d);
    std::map<List, int> vertices;
    for (std::size_t v = 0; v < d.vertices.size(); ++v) ++vertices[list_of(d.vertices[v])];
    EXPECT_EQ(vertices, all_vertices(balls, d));
}

TEST(BallDiagram, OfEqualRadiiIsDelaunays) {
    Random g(10);
    Balls balls;
    for (int i = 0; i < 500; ++i) balls.push_back({g.real(), g.real(), g.real(), 0.125});
    const BallDiagram d = ball_diagram(balls);
    std::vector<List> ours, theirs;
    for (std::size_t v = 0; v < d.vertices.size(); ++v) ours.push_back(list_of(d.vertices[v]));
    std::set<List> facets;
    for (const SpaceCell& cell : triangulate(std::span<const Site3>(balls)).cells) {
        List list(cell.begin(), cell.end());
        std::sort(list.begin(), list.end());
        for (std::size_t k = 0; k < 4; ++k) {
            List facet = list;
            facet.erase(facet.begin() + static_cast<std::ptrdiff_t>(k));
            if (facet[0] >= 0) facets.insert(facet);
        }
        if (list[0] >= 0) theirs.push_back(list);
    }
    std::sort(theirs.begin(), theirs.end());
    EXPECT_EQ(ours, theirs);
    std::set<List> edges;
    for (std::size_t e = 0; e < d.edges.size(); ++e) edges.insert(list_of(d.edges[e]));
    EXPECT_EQ(edges, facets);
}

// ---- crystals and other sets of which many touch one sphere
// --------------------------------------

std::array<List, 2> rising(const List& a, const List& b) {
    return {std::min(a, b), std::max(a, b)};
}

/// Beside Delaunay's tessellation of the centres, for equal radii: cells with one sphere are one
/// vertex, two of which share an edge where their cells share a facet; facets of the hull in one
/// plane are one edge to infinity.
void expect_as_delaunays(const Balls& balls) {
    const BallDiagram d = ball_diagram(balls);
    expect_order(d);
    const SpaceTessellation t = triangulate(std::span<const Site3>(balls));
    ASSERT_EQ(t.dimension, 3);
    const auto at = [&](Index i) -> const Site3& { return balls[static_cast<std::size_t>(i)]; };
    std::vector<List> touching(t.cells.size());
    for (std::size_t c = 0; c < t.cells.size(); ++c) {
        const auto [i, j, k, l] = t.cells[c];
        if (i == infinite) continue;
        for (Index q = 0; q < static_cast<Index>(balls.size()); ++q)
            if (q == i || q == j || q == k || q == l ||
                euclidean::in_sphere(at(i), at(j), at(k), at(l), at(q)) == 0)
                touching[c].push_back(q);
    }
    std::set<List> vertices;
    std::map<List, std::array<List, 2>> edges;  // the lists of both ends, none for infinity
    for (std::size_t c = 0; c < t.cells.size(); ++c) {
        if (touching[c].empty()) continue;
        vertices.insert(touching[c]);
        for (std::size_t k = 0; k < 4; ++k) {
            const List& other = touching[static_cast<std::size_t>(t.neighbours[c][k])];
            if (other == touching[c]) continue;
            List shared;
            if (other.empty()) {
                std::array<Index, 3> facet;
                for (std::size_t m = 0; m < 3; ++m) facet[m] = t.cells[c][(k + 1 + m) % 4];
                for (const Index q : touching[c])
                    if (std::ranges::find(facet, q) != facet.end() ||
                        ccw(at(facet[0]), at(facet[1]), at(facet[2]), at(q)) == 0)
                        shared.push_back(q);
            } else {
                std::ranges::set_intersection(touching[c], other, std::back_inserter(shared));
            }
            edges[shared] = rising(touching[c], other);
        }
    }
    std::vector<List> ours;
    for (std::size_t v = 0; v < d.vertices.size(); ++v) ours.push_back(list_of(d.vertices[v]));
    EXPECT_EQ(ours, std::vector<List>(vertices.begin(), vertices.end()));
    ASSERT_EQ(d.edges.size(), edges.size());
    for (std::size_t e = 0; e < d.edges.size(); ++e) {
        const auto found = edges.find(list_of(d.edges[e]));
        ASSERT_TRUE(found != edges.end()) << ::testing::PrintToString(list_of(d.edges[e]));
        const auto list_at = [&](Index end) {
            return end < 0 ? List() : ours[static_cast<std::size_t>(end)];
        };
        EXPECT_EQ(found->second, rising(list_at(d.ends[e][0]), list_at(d.ends[e][1])));
    }
}

/// Points of a grid of n³, those of which `place` makes a ball.
template <class Place>
Balls crystal(int n, const Place& place) {
    Balls balls;
    for (int x = 0; x < n; ++x)
        for (int y = 0; y < n; ++y)
            for (int z = 0; z < n; ++z) place(balls, x, y, z);
    return balls;
}
void cubic(Balls& balls, int x, int y, int z) {
    balls.push_back({0.1 * x, 0.1 * y, 0.1 * z, 0.05});
}
void face_centred(Balls& balls, int x, int y, int z) {
    if ((x + y + z) % 2 == 0) balls.push_back({1.0 * x, 1.0 * y, 1.0 * z, 0.5});
}
void body_centred(Balls& balls, int x, int y, int z) {
    if (x % 2 == z % 2 && y % 2 == z % 2) balls.push_back({1.0 * x, 1.0 * y, 1.0 * z, 0.5});
}
/// Layers of triangles, each over the gaps of that below; with integers, so that layers are exact.
void close_packed(Balls& balls, int x, int y, int z) {
    balls.push_back({64.0 * (2 * x + (y + z) % 2), 111.0 * y + 37.0 * (z % 2), 105.0 * z, 64.0});
}
void rock_salt(Balls& balls, int x, int y, int z) {
    balls.push_back({1.0 * x, 1.0 * y, 1.0 * z, (x + y + z) % 2 == 0 ? 0.5 : 0.25});
}

TEST(BallDiagram, OfCrystalsIsDelaunays) {
    expect_as_delaunays(crystal(6, cubic));
    expect_as_delaunays(crystal(6, face_centred));
    expect_as_delaunays(crystal(8, body_centred));
    expect_as_delaunays(crystal(5, close_packed));
}

TEST(BallDiagram, OfCrystalsOfTwoRadiiObeysItsLaws) {
    const Balls balls = crystal(7, rock_salt);
    const BallDiagram d = ball_diagram(balls);
    expect_laws(balls, d);
    // In the middle of each cube is a vertex of its four large balls.
    const auto is_half = [](double x) { return x - std::floor(x) == 0.5; };
    std::size_t middles = 0;
    for (std::size_t v = 0; v < d.vertices.size(); ++v) {
        const Site3& s = d.spheres[v];
        if (!is_half(s.x) || !is_half(s.y) || !is_half(s.z)) continue;
        ++middles;
        EXPECT_EQ(d.vertices[v].size(), 4U);
        for (const Index i : d.vertices[v]) EXPECT_EQ(balls[static_cast<std::size_t>(i)].r, 0.5);
    }
    EXPECT_EQ(middles, 216U);
    expect_as_oracle(crystal(2, rock_salt));
}

/// Equal balls between two large ones, each with a ring of its own: what they do with others is not
/// known from their tessellation.
TEST(BallDiagram, OfEqualBallsBetweenTwoLargeOnesHasAllRings) {
    Balls balls;
    for (const double y : {-16.0, 0.0, 16.0})
        for (const double z : {-16.0, 0.0, 16.0}) balls.push_back({0.0, y, z, 1.0});
    balls.push_back({-64.0, 0.0, 0.0, 60.0});
    balls.push_back({64.0, 0.0, 0.0, 60.0});
    const BallDiagram d = ball_diagram(balls);
    expect_laws(balls, d);
    const Curves curves = curves_of(d);
    for (Index i = 0; i < 9; ++i) {
        ASSERT_TRUE(curves.contains({i, 9, 10})) << i;
        EXPECT_TRUE(curves.at({i, 9, 10}).is_closed) << i;
    }
}

TEST(BallDiagram, OfCentresInAPlaneIsItsTessellations) {
    Random g(11);
    Balls balls;
    for (int i = 0; i < 200; ++i) {
        const double x = std::round(1e6 * g.real()), y = std::round(1e6 * g.real());
        balls.push_back({x, y, x + 2 * y, 3.0});
    }
    const BallDiagram d = ball_diagram(balls);
    EXPECT_EQ(d.vertices.size(), 0U);
    std::vector<List> ours, theirs;
    for (std::size_t e = 0; e < d.edges.size(); ++e) {
        ours.push_back(list_of(d.edges[e]));
        EXPECT_EQ(d.ends[e], (std::array<Index, 2>{infinite, infinite}));
    }
    for (const SpaceCell& cell : triangulate(std::span<const Site3>(balls)).cells)
        if (cell[0] != infinite) theirs.push_back({cell[0], cell[1], cell[2]});
    std::sort(theirs.begin(), theirs.end());
    EXPECT_EQ(ours, theirs);
    expect_order(d);
}

TEST(BallDiagram, OfASquareGridInAPlaneHasAnEdgeASquare) {
    Balls balls;
    for (int x = 0; x < 12; ++x)
        for (int y = 0; y < 12; ++y) balls.push_back({1.0 * x, 1.0 * y, 0.0, 0.25});
    const BallDiagram d = ball_diagram(balls);
    EXPECT_EQ(d.vertices.size(), 0U);
    EXPECT_EQ(d.edges.size(), 121U);
    for (std::size_t e = 0; e < d.edges.size(); ++e) EXPECT_EQ(d.edges[e].size(), 4U);
}

TEST(BallDiagram, OfCentresOnALineHasNothing) {
    Random g(12);
    Balls balls;
    for (int i = 0; i < 120; ++i) balls.push_back({g.real(), 0.0, 0.0, 0.125});
    const BallDiagram d = ball_diagram(balls);
    EXPECT_EQ(d.vertices.size() + d.edges.size() + d.hidden.size(), 0U);
}

/// Integer points at an integer distance from the origin; in a plane, of three numbers the last 0.
Balls on_sphere(Random& g, int distance, bool is_flat, std::size_t most) {
    Balls balls;
    const int high = is_flat ? 0 : distance;
    for (int x = -distance; x <= distance; ++x)
        for (int y = -distance; y <= distance; ++y)
            for (int z = -high; z <= high; ++z)
                if (x * x + y * y + z * z == distance * distance)
                    balls.push_back({1.0 * x, 1.0 * y, 1.0 * z, 1.0});
    for (std::size_t i = balls.size(); i > 1; --i)
        std::swap(balls[i - 1], balls[static_cast<std::size_t>(g.below(static_cast<int>(i)))]);
    balls.resize(std::min(balls.size(), most));
    return balls;
}

TEST(BallDiagram, OfCentresOnACircleHasOneEdge) {
    Random g(13);
    Balls balls = on_sphere(g, 5 * 13 * 17, true, 60);
    const BallDiagram d = ball_diagram(balls);
    EXPECT_EQ(d.vertices.size(), 0U);
    ASSERT_EQ(d.edges.size(), 1U);
    EXPECT_EQ(d.edges[0].size(), balls.size());
    EXPECT_EQ(d.ends[0], (std::array<Index, 2>{infinite, infinite}));
    // With one ball more on each side of the plane, the edge has two ends; from these others go on
    // to infinity, between each two neighbours on the circle.
    balls.insert(balls.begin(), {0.0, 0.0, 3000.0, 1.0});
    balls.push_back({0.0, 0.0, -4000.0, 2.0});
    const BallDiagram e = ball_diagram(balls);
    EXPECT_EQ(e.vertices.size(), 2U);
    EXPECT_EQ(e.edges.size(), 1 + 2 * (balls.size() - 2));
    expect_laws(balls, e);
}

TEST(BallDiagram, OfCentresOnASphereHasOneVertex) {
    Random g(14);
    const Balls balls = on_sphere(g, 33, false, 150);
    const BallDiagram d = ball_diagram(balls);
    ASSERT_EQ(d.vertices.size(), 1U);
    EXPECT_EQ(d.vertices[0].size(), balls.size());
    EXPECT_EQ(d.spheres[0].r, 32.0);
    // An edge for each facet of the hull, of which those with k corners are k - 2 triangles.
    std::size_t triangles = 0;
    for (std::size_t e = 0; e < d.edges.size(); ++e) {
        triangles += d.edges[e].size() - 2;
        EXPECT_EQ(d.ends[e], (std::array<Index, 2>{infinite, 0}));
    }
    EXPECT_EQ(triangles, 2 * balls.size() - 4);
    expect_as_delaunays(balls);
    for (int trial = 0; trial < 3 * thoroughness && !HasFailure(); ++trial)
        expect_as_oracle(on_sphere(g, 9, false, 6 + static_cast<std::size_t>(g.below(2))));
}

/// The same, of several radii: each moved outward along its normal, with more radius by as much.
TEST(BallDiagram, OfBallsOfSeveralRadiiAroundOneSphereObeysItsLaws) {
    Random g(15);
    for (const std::size_t n : {7, 16}) {
        Balls balls = on_sphere(g, 9, false, n);
        for (Site3& b : balls) {
            const int times = g.between(1, 4);
            b = {times * b.x, times * b.y, times * b.z, 9.0 * times - 5.0};
        }
        const BallDiagram d = ball_diagram(balls);
        expect_laws(balls, d);
        const auto is_around_origin = [](const Site3& s) { return s.x == 0 && s.r == 5.0; };
        const auto found = std::ranges::find_if(d.spheres, is_around_origin);
        ASSERT_TRUE(found != d.spheres.end());
        const auto v = static_cast<Index>(found - d.spheres.begin());
        EXPECT_EQ(d.vertices[static_cast<std::size_t>(v)].size(), balls.size());
        if (n < 8) expect_as_oracle(balls);
    }
}

// ---- what is far apart, on a line, or hidden
// -----------------------------------------------------

void expect_all_vertices(const Balls& balls) {
    const BallDiagram d = ball_diagram(balls);
    expect_laws(balls, d);
    std::map<List, int> vertices;
    for (std::size_t v = 0; v < d.vertices.size(); ++v) ++vertices[list_of(d.vertices[v])];
    EXPECT_EQ(vertices, all_vertices(balls, d));
}

/// Each at a smaller scale, seen from which all larger ones, and from all larger ones which, is in
/// one direction.
Balls ever_smaller(Random& g, int n, int bits) {
    Balls balls;
    for (int i = 0; i < n; ++i) {
        const double scale = std::ldexp(1.0, -i * bits);
        const auto one = [&] { return scale * (1 + g.real()); };
        const double x = one(), y = one(), z = one();
        balls.push_back({x, y, z, 0.2 * scale * g.real()});
    }
    return balls;
}
/// Two clouds, far from one another.
Balls two_clouds(Random& g, int n, int bits) {
    Balls balls;
    const double scale = std::ldexp(1.0, -bits);
    for (int i = 0; i < n; ++i) {
        const auto one = [&] { return scale * g.real(); };
        const double x = one(), y = one(), z = one();
        balls.push_back({x + i % 2, y, z, 0.1 * one()});
    }
    return balls;
}

TEST(BallDiagram, OfBallsOnManyScalesIsTheOracles) {
    Random g(16);
    for (int trial = 0; trial < 4 * thoroughness && !HasFailure(); ++trial) {
        expect_as_oracle(ever_smaller(g, 5, 1 + g.below(60)));
        expect_as_oracle(two_clouds(g, 6, 10 + g.below(60)));
    }
}

TEST(BallDiagram, OfMoreBallsOnManyScalesHasAllVertices) {
    Random g(17);
    const int n = is_fast ? 20 : is_sanitized ? 10 : 14;
    for (const int bits : {2, 4, 10, 40}) expect_all_vertices(ever_smaller(g, n, bits));
    for (const int bits : {20, 45, 60}) expect_all_vertices(two_clouds(g, n + 4, bits));
    expect_all_vertices(two_clouds(g, 16, 800));
    for (const int bits : {20, 30}) {
        const Balls balls = two_clouds(g, is_sanitized ? 60 : 120, bits);
        expect_laws(balls, ball_diagram(balls));
    }
}

TEST(BallDiagram, OfBallsOfSeveralRadiiOnALineHasRings) {
    Random g(18);
    const auto on_a_line = [&](int n, int side, int most) {
        Balls balls;
        for (int i = 0; i < n; ++i) {
            const double t = g.below(side);
            balls.push_back({t, 2 * t, -t, 0.5 * g.below(most)});
        }
        return balls;
    };
    for (int trial = 0; trial < 8 * thoroughness && !HasFailure(); ++trial)
        expect_as_oracle(on_a_line(4 + g.below(4), 100, 20));
    const Balls balls = on_a_line(400, 1'000'000, 200);
    const BallDiagram d = ball_diagram(balls);
    expect_laws(balls, d);
    EXPECT_EQ(d.vertices.size(), 0U);
    EXPECT_GT(d.edges.size(), 300U);
    // Beside the line all is the same as on it but for the search.
    Balls some(balls.begin(), balls.begin() + 20);
    const BallDiagram of_some = ball_diagram(some);
    some.push_back({0.0, 0.0, 1e12, 0.5});
    const Curves curves = curves_of(ball_diagram(some));
    for (const auto& [list, arcs] : curves_of(of_some)) {
        EXPECT_TRUE(arcs.is_closed);
        EXPECT_TRUE(curves.contains(list));
    }
}

TEST(BallDiagram, OfManyHiddenBallsNamesTheFirstThatHides) {
    const auto expect_hidden_by_first = [](const Balls& balls) {
        const BallDiagram d = ball_diagram(balls);
        std::vector<char> is_hidden(balls.size());
        for (const Hidden& h : d.hidden) is_hidden[static_cast<std::size_t>(h.site)] = 1;
        auto next = d.hidden.begin();
        for (std::size_t q = 0; q < balls.size(); ++q) {
            std::size_t by = 0;
            while (by < balls.size() &&
                   (is_hidden[by] || by == q || !euclidean::hidden(balls[q], balls[by])))
                ++by;
            if (!is_hidden[q]) {
                if (by < q) ADD_FAILURE() << q << " is hidden by " << by;
                continue;
            }
            EXPECT_EQ(*next, (Hidden{static_cast<Index>(q), static_cast<Index>(by)}));
            ++next;
        }
    };
    Random g(19);
    Balls lattice, in_large_ones;
    for (int i = 0; i < 600; ++i) {
        const auto one = [&] { return 1.0 * g.below(4); };
        const double x = one(), y = one(), z = one();
        lattice.push_back({x, y, z, 1.0 * g.below(3)});
        in_large_ones.push_back({g.real(), g.real(), g.real(), i % 8 == 0 ? 1 + g.real() : 0.1});
    }
    expect_hidden_by_first(lattice);
    expect_hidden_by_first(in_large_ones);
    // As many as this have no time for each to be held against each.
    constexpr int many = 100'000;
    Balls equal, nested;
    for (int i = 0; i < many; ++i) {
        equal.push_back({1.0, 2.0, 3.0, 1.0});
        nested.push_back({0.0, 0.0, 0.25 * i, 1.0 + i});
    }
    EXPECT_EQ(ball_diagram(equal).hidden.size(), many - 1U);
    const std::vector<Hidden> hidden = ball_diagram(nested).hidden;
    ASSERT_EQ(hidden.size(), many - 1U);
    for (const Hidden& h : hidden) EXPECT_EQ(h.by, many - 1);
}

/// As many neighbours as there are balls.
TEST(BallDiagram, OfALargeBallAmidSmallOnesHasAllVertices) {
    Random g(20);
    Balls balls{{0, 0, 0, 1}};
    while (balls.size() < (is_sanitized ? 25 : 60)) {
        const double x = 2 * g.real() - 1, y = 2 * g.real() - 1, z = 2 * g.real() - 1;
        const double length = std::hypot(x, y, z);
        if (length < 0.1 || length > 1.0) continue;
        const double r = 0.01 * g.real(), away = (1 + r + 1e-4 * g.real()) / length;
        balls.push_back({away * x, away * y, away * z, r});
    }
    expect_all_vertices(balls);
}

}  // namespace
}  // namespace signum
