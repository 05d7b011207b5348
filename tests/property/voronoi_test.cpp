// The diagram against its definition: cells tile every box, contain the points that brute force
// calls nearest, and their edges lie where two sites are equally near and none is nearer.

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "../../predicates/additive.hpp"
#include "../../predicates/ccw.hpp"
#include "../../triangulation/triangulate.hpp"
#include "../../voronoi/clip.hpp"
#include "../../voronoi/polygon.hpp"

#include "../thoroughness.hpp"
#include "degenerate_sites.hpp"

namespace signum {
namespace {

const int thoroughness = is_fast ? 10 : 1;

double norm(Metric metric, double x, double y) {
    switch (metric) {
        case Metric::manhattan:
            return std::abs(x) + std::abs(y);
        case Metric::supremum:
            return std::max(std::abs(x), std::abs(y));
        default:
            return std::hypot(x, y);
    }
}

double distance(Metric metric, Point p, const Site& s) {
    const double length = norm(metric, p.x - s.x, p.y - s.y);
    return metric == Metric::power ? length * length - s.r * s.r : length - s.r;
}

/// The same with hundreds of bits.
mpf_class precise_distance(Metric metric, Point p, const Site& s) {
    const mpf_class x = mpf_class(p.x, 400) - s.x;
    const mpf_class y = mpf_class(p.y, 400) - s.y;
    const mpf_class r(s.r, 400);
    switch (metric) {
        case Metric::power:
            return mpf_class(x * x + y * y - r * r);
        case Metric::euclidean:
            return mpf_class(sqrt(mpf_class(x * x + y * y)) - r);
        case Metric::manhattan:
            return mpf_class(abs(x) + abs(y) - r);
        case Metric::supremum:
            break;
    }
    return mpf_class((abs(x) > abs(y) ? abs(x) : abs(y)) - r);
}

struct Nearest {
    Index site;
    double margin;  ///< to the second, in doubles
    bool tied;      ///< to some hundred bits
};

/// Brute force; of equally near sites the first in the tie rule's order.
Nearest nearest(Metric metric, Point p, const std::vector<Site>& sites) {
    Nearest result = {0, 1e300, false};
    std::vector<double> distances;
    for (const Site& s : sites) distances.push_back(distance(metric, p, s));
    // In the power metric the rule goes by weights, which are squares.
    const auto of = [&](Index i) {
        Site s = sites[static_cast<std::size_t>(i)];
        if (metric == Metric::power) s.r = std::abs(s.r);
        return s;
    };
    for (Index i = 1; i < static_cast<Index>(sites.size()); ++i) {
        const double difference = distances[static_cast<std::size_t>(i)] -
                                  distances[static_cast<std::size_t>(result.site)];
        int sign = difference < 0 ? -1 : 1;
        bool tied = false;
        if (std::abs(difference) < 1e-9) {
            const mpf_class exact =
                precise_distance(metric, p, of(i)) - precise_distance(metric, p, of(result.site));
            tied = abs(exact) < 1e-60;
            sign = tied ? (additive::precedes(of(i), i, of(result.site), result.site) ? -1 : 1)
                        : sgn(exact);
        }
        if (sign < 0)
            result = {i, 1e300, tied};
        else
            result.tied = result.tied || tied;
    }
    for (Index i = 0; i < static_cast<Index>(sites.size()); ++i)
        if (i != result.site)
            result.margin =
                std::min(result.margin, distances[static_cast<std::size_t>(i)] -
                                            distances[static_cast<std::size_t>(result.site)]);
    return result;
}

/// Whether a ray to the right crosses the shape's border an odd number of times.
bool contains(const CellShape& shape, Point p) {
    bool inside = false;
    for (const auto& loop : shape.loops)
        for (const Conic& conic : loop) {
            // Where the curve crosses the line of p: (1-s)² a + 2s(1-s) w b + s² c = 0.
            const double a = conic.from.y - p.y;
            const double c = conic.to.y - p.y;
            const auto cross_at = [&](double s) {
                if (conic.at(s).x > p.x) inside = !inside;
            };
            if (conic.is_straight()) {
                if ((a > 0) != (c > 0)) cross_at(a / (a - c));
                continue;
            }
            const double b = conic.weight * (conic.control.y - p.y);
            const double discriminant = b * b - a * c;
            if (discriminant <= 0) continue;  // touches the line at most
            const double sum = -(b + std::copysign(std::sqrt(discriminant), b));
            // s = numerator / (numerator + denominator), for t = s / (1 - s) a root above 0.
            const auto is_root = [](double numerator, double denominator) {
                return (numerator > 0) == (denominator > 0) && numerator + denominator != 0;
            };
            // Ends on the line count for one of the two curves that meet there: as if below it.
            if ((a > 0) != (c > 0)) {
                if (is_root(sum, c))
                    cross_at(sum / (sum + c));
                else
                    cross_at(a / (a + sum));
            } else if (is_root(sum, c) && is_root(a, sum)) {
                cross_at(sum / (sum + c));
                cross_at(a / (a + sum));
            }
        }
    return inside;
}

std::string text(const std::vector<Site>& sites) {
    std::string result;
    for (const Site& s : sites)
        result += "{" + std::to_string(s.x) + ", " + std::to_string(s.y) + ", " +
                  std::to_string(s.r) + "}, ";
    return result;
}

bool is_on(Point a, Point b, Point p) {
    return ccw(a, b, p) == 0 && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) &&
           std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y);
}

bool meet(Point a, Point b, Point c, Point d) {
    if (ccw(a, b, c) * ccw(a, b, d) < 0 && ccw(c, d, a) * ccw(c, d, b) < 0) return true;
    return is_on(a, b, c) || is_on(a, b, d) || is_on(c, d, a) || is_on(c, d, b);
}

/// Exactly: no two sides meet but neighbours, and those at their common end alone.
bool is_simple(const std::vector<Point>& polygon) {
    const std::size_t n = polygon.size();
    const auto at = [&](std::size_t i) { return polygon[i % n]; };
    for (std::size_t i = 0; i < n; ++i) {
        if (at(i) == at(i + 1) || is_on(at(i), at(i + 1), at(i + 2)) ||
            is_on(at(i + 1), at(i + 2), at(i)))
            return false;
        for (std::size_t j = i + 2; j < n && !(i == 0 && j == n - 1); ++j)
            if (meet(at(i), at(i + 1), at(j), at(j + 1))) return false;
    }
    return true;
}

double area(const std::vector<Point>& polygon) {
    double twice = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point a = polygon[i];
        const Point b = polygon[(i + 1) % polygon.size()];
        twice += (a.x - polygon[0].x) * (b.y - polygon[0].y) -
                 (b.x - polygon[0].x) * (a.y - polygon[0].y);
    }
    return twice / 2;
}

double area(const Box& box) {
    return (box.x1 - box.x0) * (box.y1 - box.y0);
}

class VoronoiCells : public testing::TestWithParam<Metric> {
 protected:
    std::mt19937_64 random_{23};

    int below(int count) { return static_cast<int>(random_() % static_cast<std::uint64_t>(count)); }
    double real() { return static_cast<double>(random_() >> 11) * 0x1p-53; }

    [[nodiscard]] Voronoi build(const std::vector<Site>& sites, bool merge = false) const {
        return Voronoi(triangulate(sites, GetParam()), {merge});
    }

    /// Random, overlapping, on a circle, on grids, on a line, nearly so; of all the size of a unit.
    std::vector<Site> some_sites(int family, int largest_count) {
        std::vector<Site> sites(static_cast<std::size_t>(1 + below(largest_count)));
        const double spacing = 1 / std::sqrt(static_cast<double>(sites.size()));
        if (family >= 8) {
            brute_force::Degenerate(random_()).fill(family - 8, sites.data(), sites.size());
            return sites;
        }
        for (Site& s : sites) {
            const double angle = 6.3 * real();
            switch (family) {
                case 0:
                    s = {real(), real(), 0};
                    break;
                case 1:
                    s = {real(), real(), below(2) * spacing * (0.9 + 0.2 * real())};
                    break;
                case 2:
                    s = {real(), real(), 0.5 * real()};
                    break;
                case 3:
                    s = {std::cos(angle), std::sin(angle), 0.02 * real()};
                    break;
                case 4:
                    s = {1.0 * below(8), 1.0 * below(8), 1.0 * below(4)};
                    break;
                case 5:
                    s = {1.0 * below(6), 1.0 * below(6), 0};
                    break;
                case 6: {
                    const double t = below(12);
                    s = {t, 2 * t, 0.5 * below(3)};
                    break;
                }
                default:
                    s = {below(6) + 1e-12 * real(), below(6) + 1e-13 * real(),
                         0.3 * below(2) + 1e-14 * real()};
            }
        }
        return sites;
    }
    static constexpr int families = 8 + brute_force::Degenerate::families;

    /// Around the sites, in their midst, through their coordinates, far around them.
    Box some_box(const std::vector<Site>& sites) {
        switch (below(6)) {
            case 0:
                return {0.25, 0.25, 0.75, 0.75};
            case 1:
                return {0, 0, 2, 2};
            case 2:
                return {-100, -100, 100, 100};
            case 3:
                return {0.5, 0.5, 2.5, 1.5};
            default:
                return default_box(sites);
        }
    }
};

TEST_P(VoronoiCells, AreaSumsToThatOfTheBox) {
    int cells = 0;
    for (int round = 0; round < 400 * thoroughness; ++round) {
        const auto sites = some_sites(round % families, 40);
        const Box box = some_box(sites);
        const Voronoi diagram = build(sites, round % 2 == 0);
        const ClippedVoronoi clipped(diagram, box);
        double sum = 0;
        for (Index i = 0; i < static_cast<Index>(sites.size()); ++i) {
            if (diagram.is_hidden(i)) continue;
            const CellShape shape = clipped.cell(i);
            for (const auto& loop : shape.loops)
                for (std::size_t c = 0; c < loop.size(); ++c) {
                    const Point end = loop[c].to;
                    const Point next = loop[(c + 1) % loop.size()].from;
                    ASSERT_LE(std::hypot(end.x - next.x, end.y - next.y), 1e-9) << text(sites);
                }
            if (shape.loops.empty()) continue;
            ++cells;
            const Measure of = measure(shape);
            ASSERT_GE(of.area, 0.0) << text(sites);
            sum += of.area;
        }
        ASSERT_NEAR(sum / area(box), 1.0, 1e-12) << "round " << round << ", " << text(sites);
    }
    EXPECT_GT(cells, 1000 * thoroughness);
}

/// A quarter of a million points a metric.
TEST_P(VoronoiCells, ContainThePointsNearestToTheirSites) {
    int points = 0;
    int ties = 0;
    int near = 0;
    while (points < 25'000 * thoroughness) {
        const auto sites = some_sites(below(families), 60);
        const Box box = some_box(sites);
        const Voronoi diagram = build(sites);
        const ClippedVoronoi clipped(diagram, box);
        std::vector<CellShape> shapes;
        for (Index i = 0; i < static_cast<Index>(sites.size()); ++i)
            shapes.push_back(diagram.is_hidden(i) ? CellShape{} : clipped.cell(i));
        const double extent = std::max({box.x1, -box.x0, box.y1, -box.y0, 10.0});
        for (int k = 0; k < 1000; ++k, ++points) {
            Point p = {box.x0 + (box.x1 - box.x0) * real(), box.y0 + (box.y1 - box.y0) * real()};
            // On the lattice of the input, where ties are.
            if (k % 8 == 0) p = {std::round(2 * p.x) / 2, std::round(2 * p.y) / 2};
            const Nearest at = nearest(GetParam(), p, sites);
            ASSERT_EQ(diagram.tessellation().nearest(p), at.site)
                << p.x << ", " << p.y << ": " << text(sites);
            ties += static_cast<int>(at.tied);
            // The shapes are as good as doubles.
            if (at.margin < 1e-12 * extent * extent) {
                ++near;
                continue;
            }
            if (!(box.x0 < p.x && p.x < box.x1 && box.y0 < p.y && p.y < box.y1)) continue;
            ASSERT_TRUE(contains(shapes[static_cast<std::size_t>(at.site)], p))
                << p.x << ", " << p.y << " is nearest to " << at.site << ": " << text(sites);
        }
    }
    EXPECT_GT(ties, 100 * thoroughness);
    // In the Manhattan and supremum metrics ties fill whole regions.
    EXPECT_LT(near, points / 2);
}

TEST_P(VoronoiCells, AreBoundedByEdgesInOrder) {
    for (int round = 0; round < 200 * thoroughness; ++round) {
        const auto sites = some_sites(round % families, 30);
        const Voronoi diagram = build(sites, round % 2 == 1);
        const auto edges = diagram.edges();
        std::vector<std::array<int, 2>> walked(edges.size());
        for (Index i = 0; i < static_cast<Index>(sites.size()); ++i) {
            const auto steps = diagram.cell(i);
            bool to_infinity = false;
            for (std::size_t k = 0; k < steps.size(); ++k) {
                const auto end = [&](const VoronoiStep& step, bool last) {
                    const VoronoiEdge& edge = edges[static_cast<std::size_t>(step.edge)];
                    return step.forward == last ? edge.to : edge.from;
                };
                const VoronoiEdge& edge = edges[static_cast<std::size_t>(steps[k].edge)];
                EXPECT_EQ(steps[k].forward ? edge.left : edge.right, i);
                ++walked[static_cast<std::size_t>(steps[k].edge)][steps[k].forward ? 1 : 0];
                EXPECT_EQ(end(steps[k], true), end(steps[(k + 1) % steps.size()], false));
                to_infinity = to_infinity || end(steps[k], true) == at_infinity;
            }
            if (to_infinity) {
                const VoronoiEdge& first = edges[static_cast<std::size_t>(steps[0].edge)];
                EXPECT_EQ(steps[0].forward ? first.from : first.to, at_infinity);
            }
            EXPECT_EQ(diagram.is_unbounded(i),
                      !diagram.is_hidden(i) && (steps.empty() || to_infinity));
            const auto neighbours = diagram.tessellation().neighbours(i);
            EXPECT_EQ(static_cast<std::ptrdiff_t>(steps.size()),
                      std::ranges::count_if(neighbours, [](Index v) { return v != infinite; }));
        }
        for (const auto& times : walked) EXPECT_EQ(times, (std::array{1, 1}));
        ASSERT_FALSE(HasFailure()) << text(sites);
    }
}

TEST_P(VoronoiCells, EdgesLieBetweenTheNearestSites) {
    int checked = 0;
    std::set<EdgeKind> kinds;
    for (int round = 0; round < 60 * thoroughness; ++round) {
        const auto sites = some_sites(round % families, 25);
        const Voronoi diagram = build(sites);
        for (Index e = 0; e < static_cast<Index>(diagram.edges().size()); ++e) {
            const VoronoiEdge& edge = diagram.edges()[static_cast<std::size_t>(e)];
            const auto geometry = diagram.geometry(e);
            ASSERT_TRUE(geometry);
            kinds.insert(geometry->kind);
            if (geometry->kind == EdgeKind::point) continue;
            const auto end = [](double t, double other) {
                return std::isfinite(t)       ? t
                       : std::isfinite(other) ? other + std::copysign(3, t)
                                              : std::copysign(3, t);
            };
            const double from = end(geometry->from, geometry->to);
            const double to = end(geometry->to, geometry->from);
            for (const double share : {0.0, 0.01, 0.4, 0.77, 1.0}) {
                const Point p = std::visit(
                    [&](const auto& curve) { return curve.at(from + share * (to - from)); },
                    geometry->curve);
                if (std::hypot(p.x, p.y) > 1e4) continue;
                const auto& a = sites[static_cast<std::size_t>(edge.left)];
                const auto& b = sites[static_cast<std::size_t>(edge.right)];
                const double scale = GetParam() == Metric::power ? 1e-8 : 1e-9;
                const double size = 1 + std::hypot(p.x, p.y);
                const double one = distance(GetParam(), p, a);
                EXPECT_NEAR(one, distance(GetParam(), p, b), scale * size) << p.x << ", " << p.y;
                const Nearest least = nearest(GetParam(), p, sites);
                EXPECT_NEAR(one,
                            distance(GetParam(), p, sites[static_cast<std::size_t>(least.site)]),
                            scale * size)
                    << p.x << ", " << p.y << " edge " << e;
                ++checked;
            }
            if (edge.from != at_infinity) {
                EXPECT_EQ(geometry->start.x,
                          diagram.vertices()[static_cast<std::size_t>(edge.from)].x);
            }
            ASSERT_FALSE(HasFailure()) << text(sites);
        }
    }
    EXPECT_GT(checked, 2000 * thoroughness);
    EXPECT_GE(kinds.size(), 4U);
    EXPECT_EQ(kinds.contains(EdgeKind::hyperbola), GetParam() == Metric::euclidean);
    EXPECT_EQ(kinds.contains(EdgeKind::polyline),
              GetParam() == Metric::manhattan || GetParam() == Metric::supremum);
}

TEST_P(VoronoiCells, PolygonsAreSimpleAndTileTheBox) {
    int checked = 0;
    for (int round = 0; round < 100 * thoroughness; ++round) {
        const auto sites = some_sites(round % families, 40);
        const Box box = some_box(sites);
        const Voronoi diagram = build(sites, round % 2 == 0);
        const ClippedVoronoi clipped(diagram, box);
        double sum = 0;
        for (Index i = 0; i < static_cast<Index>(sites.size()); ++i) {
            if (diagram.is_hidden(i)) continue;
            // However coarse: cells thinner than the tolerance have a polygon of their own, too.
            const double tolerance = (round % 3 == 0 ? 1e-3 : 1.0) * (box.x1 - box.x0);
            for (const auto& polygon : polygons(clipped.cell(i), tolerance)) {
                ++checked;
                ASSERT_TRUE(is_simple(polygon)) << "cell " << i << " of " << text(sites);
                ASSERT_GT(area(polygon), 0.0) << "cell " << i << " of " << text(sites);
                sum += area(polygon);
            }
        }
        // Both sides of an edge take the same points of it.
        ASSERT_NEAR(sum / area(box), 1.0, 1e-12) << text(sites);
    }
    EXPECT_GT(checked, 400 * thoroughness);
}

TEST_P(VoronoiCells, MeasuresAreThoseOfAFinePolygon) {
    for (int round = 0; round < 6 * thoroughness; ++round) {
        const auto sites = some_sites(1 + round % 2, 30);
        const Voronoi diagram = build(sites);
        const ClippedVoronoi whole(diagram);
        for (Index i = 0; i < static_cast<Index>(sites.size()); ++i) {
            if (diagram.is_hidden(i)) continue;
            const CellShape shape = whole.cell(i);
            const Measure of = measure(shape);
            if (diagram.is_unbounded(i)) {
                EXPECT_TRUE(shape.loops.empty());
                EXPECT_EQ(of.area, INFINITY);
                EXPECT_TRUE(std::isnan(of.centroid.x));
                continue;
            }
            ASSERT_EQ(shape.loops.size(), 1U);
            const auto fine = polygons(shape, 1e-8);
            if (fine.empty()) continue;  // of no area
            double perimeter = 0;
            double x = 0;
            double y = 0;
            const auto& polygon = fine[0];
            for (std::size_t k = 0; k < polygon.size(); ++k) {
                const Point o = polygon[0];
                const Point p = polygon[k];
                const Point q = polygon[(k + 1) % polygon.size()];
                perimeter += std::hypot(p.x - q.x, p.y - q.y);
                const double t = ((p.x - o.x) * (q.y - o.y) - (q.x - o.x) * (p.y - o.y)) / 2;
                x += t * (o.x + p.x + q.x) / 3;
                y += t * (o.y + p.y + q.y) / 3;
            }
            const double exact = area(polygon);
            EXPECT_NEAR(of.area, exact, 1e-7 * perimeter);
            EXPECT_NEAR(of.perimeter, perimeter, 1e-6 * perimeter);
            if (exact > 1e-4 * perimeter * perimeter) {
                EXPECT_NEAR(of.centroid.x, x / exact, 1e-4 * perimeter);
                EXPECT_NEAR(of.centroid.y, y / exact, 1e-4 * perimeter);
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Metrics, VoronoiCells, testing::ValuesIn(all_metrics),
                         [](const auto& metric) { return std::string(name_of(metric.param)); });

// Single diagrams ---------------------------------------------------------------------------------

TEST(Voronoi, OfNoSiteAndOne) {
    const Voronoi none = voronoi(triangulate(std::vector<Site>{}, Euclidean{}));
    EXPECT_TRUE(none.vertices().empty());
    EXPECT_TRUE(none.edges().empty());
    const Voronoi one = voronoi(triangulate(std::vector<Site>{{3, 4, 1}, {3, 4, 0}}, Euclidean{}));
    EXPECT_TRUE(one.cell(0).empty());
    EXPECT_TRUE(one.is_unbounded(0));
    EXPECT_FALSE(one.is_unbounded(1));
    const CellShape all = ClippedVoronoi(one, {0, 0, 2, 1}).cell(0);
    EXPECT_EQ(measure(all).area, 2);
    EXPECT_EQ(measure(all).perimeter, 6);
    EXPECT_EQ(measure(all).centroid, (Point{1, 0.5}));
    EXPECT_TRUE(all.clipped);
}

TEST(Voronoi, MergesDegenerateVerticesOnRequest) {
    std::vector<Site> grid;
    for (int x = 0; x < 6; ++x)
        for (int y = 0; y < 6; ++y) grid.push_back({1.0 * x, 1.0 * y, 0.25});
    for (const Metric metric : all_metrics) {
        const Tessellation t = triangulate(grid, metric);
        EXPECT_EQ(voronoi(t).vertices().size(), 50U);
        const Voronoi merged = voronoi(t, {.merge = true});
        EXPECT_EQ(merged.vertices().size(), 25U) << name_of(metric);
        std::set<std::pair<double, double>> places;
        for (const DiagramVertex& v : merged.vertices()) places.emplace(v.x, v.y);
        EXPECT_EQ(places.size(), 25U);
        const ClippedVoronoi clipped(merged, {-0.5, -0.5, 5.5, 5.5});
        for (Index i = 0; i < 36; ++i) {
            const Measure of = measure(clipped.cell(i));
            EXPECT_NEAR(of.area, 1, 1e-15) << name_of(metric);
            EXPECT_NEAR(of.perimeter, 4, 1e-15);
        }
    }
    // Exactly on a circle: 65² = 16² + 63² = 33² + 56² = 25² + 60² = 39² + 52².
    std::vector<Site> circle;
    for (const auto& [a, b] : {std::pair{16, 63}, {33, 56}, {25, 60}, {39, 52}, {0, 65}})
        for (const int s : {-1, 1})
            for (const int r : {-1, 1})
                for (const bool swap : {false, true}) {
                    const double x = s * (swap ? b : a);
                    const double y = r * (swap ? a : b);
                    circle.push_back({x + 7, y - 3, 2});
                }
    const Tessellation t = triangulate(circle, Euclidean{});
    const Voronoi merged = voronoi(t, {.merge = true});
    ASSERT_EQ(merged.vertices().size(), 1U);
    EXPECT_EQ(merged.vertices()[0].x, 7);
    EXPECT_EQ(merged.vertices()[0].y, -3);
    EXPECT_EQ(merged.vertices()[0].rho, 63);
}

/// Nested circles all of whose cells are unbounded or reach around others; the arcs of the smaller
/// discs are half-open.
TEST(Voronoi, AHyperbolaIsTheBisectorOfTwoDiscs) {
    const Voronoi diagram =
        voronoi(triangulate(std::vector<Site>{{-5, 0, 3}, {5, 0, -3}}, Euclidean{}));
    ASSERT_EQ(diagram.edges().size(), 1U);
    const auto geometry = diagram.geometry(0);
    ASSERT_TRUE(geometry);
    EXPECT_EQ(geometry->kind, EdgeKind::hyperbola);
    EXPECT_EQ(geometry->from, -INFINITY);
    EXPECT_EQ(geometry->to, INFINITY);
    const auto& curve = std::get<HyperbolaCurve>(geometry->curve);
    // a is half of what the left disc's radius has more, b completes half the distance.
    EXPECT_EQ(std::abs(curve.a), 3);
    EXPECT_DOUBLE_EQ(curve.b, 4);
    EXPECT_EQ(curve.at(0).x, 3);
    const CellShape left = ClippedVoronoi(diagram, {-10, -10, 10, 10}).cell(0);
    ASSERT_EQ(left.loops.size(), 1U);
    const CellShape right = ClippedVoronoi(diagram, {-10, -10, 10, 10}).cell(1);
    EXPECT_NEAR(measure(left).area + measure(right).area, 400, 1e-12);
    // Between x = 3 √(1 + y²/16) and x = 10 for y from -10 to 10: the hyperbola leaves the box at
    // its upper and lower side, at x = 3 √7.25.
    const double edge = 3 * std::sqrt(7.25);
    const double under = 10 * std::sqrt(116.0) / 2 + 8 * std::asinh(2.5);
    EXPECT_LT(edge, 10);
    EXPECT_NEAR(measure(right).area, 200 - 2 * 3.0 / 4 * under, 1e-12);
}

TEST(Voronoi, ScaleDoesNotMatter) {
    const std::vector<Site> sites = {{0, 0, 3}, {9, 2, 2}, {6, 8, 1}, {2, 7, 0}, {4, 2, 1.5}};
    for (const Metric metric : all_metrics) {
        const Voronoi diagram = voronoi(triangulate(sites, metric));
        const ClippedVoronoi clipped(diagram, {-4, -4, 12, 12});
        for (const int exponent : {900, -900, 1018, -1070}) {
            std::vector<Site> scaled = sites;
            for (Site& s : scaled)
                s = {std::ldexp(s.x, exponent), std::ldexp(s.y, exponent),
                     std::ldexp(s.r, exponent)};
            const auto side = [&](double value) { return std::ldexp(value, exponent); };
            const Voronoi other = voronoi(triangulate(scaled, metric));
            const ClippedVoronoi cut(other, {side(-4), side(-4), side(12), side(12)});
            for (Index i = 0; i < 5; ++i) {
                if (diagram.is_hidden(i)) continue;
                const CellShape a = clipped.cell(i);
                const CellShape b = cut.cell(i);
                ASSERT_EQ(a.loops.size(), b.loops.size());
                for (std::size_t l = 0; l < a.loops.size(); ++l) {
                    ASSERT_EQ(a.loops[l].size(), b.loops[l].size());
                    for (std::size_t c = 0; c < a.loops[l].size(); ++c) {
                        const double tolerance = exponent == -1070 ? 0.2 : 1e-12;
                        EXPECT_NEAR(std::ldexp(b.loops[l][c].to.x, -exponent), a.loops[l][c].to.x,
                                    tolerance);
                        EXPECT_NEAR(std::ldexp(b.loops[l][c].to.y, -exponent), a.loops[l][c].to.y,
                                    tolerance);
                    }
                }
            }
        }
    }
}

double area_of_cells(const Voronoi& diagram, const Box& box) {
    const ClippedVoronoi clipped(diagram, box);
    double sum = 0;
    for (Index i = 0; i < static_cast<Index>(diagram.tessellation().sites().size()); ++i)
        if (!diagram.is_hidden(i)) sum += measure(clipped.cell(i)).area;
    return sum;
}

/// The axis of such a hyperbola is so short that the square of a coordinate over it overflows.
TEST(Voronoi, RadiiThatVanishBesideTheDistances) {
    const Box box = {-3, -3, 3, 3};
    for (const double r : {1e-100, 1e-154, 1e-155, 1e-170, 1e-308, 5e-324}) {
        const std::vector<Site> sites = {{1, 1, 1}, {-1, -1, 0}, {0, 0, 0}, {1, -1.7, r}};
        const Voronoi diagram = voronoi(triangulate(sites, Euclidean{}));
        EXPECT_NEAR(area_of_cells(diagram, box) / area(box), 1, 1e-12) << r;
    }
}

/// Each of these cells once had all the box too much: its border touches that of the box.
TEST(Voronoi, ACellWhoseVertexLiesOnTheBorderIsNotTheRestOfTheBox) {
    // Far from the origin, so that rounding is visible; the vertex is (10000000300000000, 3e8).
    const Voronoi distant = voronoi(triangulate(std::vector<Site>{{10000000200000000, 3e8, -1e8},
                                                                  {10000000300000000, 5e8, 0},
                                                                  {10000000400000000, 2e8, 0}},
                                                Manhattan{}));
    const Box box = {10000000150000000, 3e8, 10000000440000000, 5.4e8};
    EXPECT_NEAR(area_of_cells(distant, box) / area(box), 1, 1e-6);
    // Two cells next to each other, a few roundings wide, in the corner of the third one's box.
    const std::vector<Site> cluster = {
        {8.738509993212801e-15, -9.9999999994560468e-05, 1.3074e-16},
        {8.2500481268166721e-15, -9.9999999991131041e-05, 9.17e-16},
        {5.7826142643220285e-17, -9.999999999090222e-05, 4.93e-16},
        {8.2819194951634589, 6.7682463450516321, 0.85439745944110201}};
    const Voronoi tiny = voronoi(triangulate(cluster, Euclidean{}));
    ASSERT_EQ(tiny.vertices().size(), 3U);
    for (const DiagramVertex& v : tiny.vertices()) {
        const Box corner = {v.x, v.y, v.x + 2, v.y + 5};
        EXPECT_NEAR(area_of_cells(tiny, corner) / 10, 1, 1e-12);
    }
    // A cell in two parts, one of them about as wide as rounding.
    const Voronoi thin = voronoi(triangulate(
        std::vector<Site>{{0.00099951881114247656, -9999.9999999879565, 9.9518660466824181e-05},
                          {0.00098877251368106899, -9999.9999819962341, 7.8782270785986792e-05},
                          {0.00099176565950023841, -9999.9999861194246, 8.3860770593616207e-05}},
        Euclidean{}));
    const Box across = {0.00089457629644953214, -9999.9999469666836, 0.0010886983162700296,
                        -9999.9999467725611};
    EXPECT_NEAR(area_of_cells(thin, across) / area(across), 1, 1e-3);
    const Box beside = {3.7621659178233546e-15, -9.9999999994751694e-05, 2.5450709206128899,
                        4.6173570614119157};
    EXPECT_NEAR(area_of_cells(tiny, beside) / area(beside), 1, 1e-12);
}

/// Both vertices of an edge lie in the box, all of it by rounding outside: what its cell has of the
/// border was left out.
TEST(Voronoi, AnEdgeMayRunAlongTheBorder) {
    const Voronoi squares = voronoi(
        triangulate(std::vector<Site>{{1.0000000000009066e-05, -0.099999999999999992, 2.18e-19},
                                      {1.0000000000009618e-05, -0.099999999999999992, 3.11e-19},
                                      {0.0023924358805030334, -0.098861778443690429, 0},
                                      {1.0000000000009555e-05, -0.1, 3.75e-19}},
                    Manhattan{}));
    const Box box = {1.0000000000002644e-05, -0.1, 0.0031029341953221312, -0.093003342960874619};
    EXPECT_NEAR(area_of_cells(squares, box) / area(box), 1, 1e-11);
    const Voronoi discs = voronoi(triangulate(
        std::vector<Site>{{10050.000000000009, 20.000000000000519, 2.1667572894091592e-14},
                          {10030.000000000007, 20.000000000000668, 3.0971162682976257e-14},
                          {10050.000000000009, 20.000000000000085, 7.2039123317388418e-14},
                          {10030.000000000004, 30.000000000000892, 3.0000000000000631}},
        Euclidean{}));
    const Box other = {10040.000000000007, 20.000000000000593, 10055.000000000009,
                       35.00000000000162};
    EXPECT_NEAR(area_of_cells(discs, other) / area(other), 1, 1e-10);
}

/// Their products are beyond doubles; the centroid is not.
TEST(Voronoi, MeasuresOfExtremeSizeHaveACentroid) {
    for (const double size : {1e150, 1e120, 1e-120, 1e-200}) {
        const std::vector<Site> sites = {{size, 0, 0}, {3 * size, 0, 0}};
        const Voronoi diagram = voronoi(triangulate(sites, Euclidean{}));
        const Measure of = measure(ClippedVoronoi(diagram, {0, 0, 4 * size, 2 * size}).cell(0));
        EXPECT_DOUBLE_EQ(of.area, 4 * size * size);
        EXPECT_DOUBLE_EQ(of.perimeter, 8 * size);
        EXPECT_DOUBLE_EQ(of.centroid.x, size);
        EXPECT_DOUBLE_EQ(of.centroid.y, size);
    }
}

/// A spike in a polygon of any size is none.
TEST(Voronoi, PolygonsHaveNoSpikesAtAnyScale) {
    for (const int exponent : {-1000, -540, 0, 530, 1000}) {
        const auto at = [&](double x, double y) -> Point {
            return {std::ldexp(x, exponent), std::ldexp(y, exponent)};
        };
        const Point corners[] = {at(0, 0), at(3, 0), at(3, 1), at(7, 1), at(2, 1), at(0, 5)};
        CellShape shape;
        auto& loop = shape.loops.emplace_back();
        for (std::size_t i = 0; i < 6; ++i)
            loop.push_back(Conic::straight(corners[i], corners[(i + 1) % 6]));
        const auto found = polygons(shape, 1);
        ASSERT_EQ(found.size(), 1U);
        EXPECT_EQ(found[0].size(), 5U) << exponent;
        EXPECT_TRUE(std::ranges::find(found[0], at(7, 1)) == found[0].end()) << exponent;
    }
}

TEST(Voronoi, DefaultBoxesHaveAnInside) {
    for (const double x : {0.0, 3.0, 1e17, -1e300, 1.7e308})
        for (const double y : {0.0, 4.0, 1e308}) {
            const Box at_point = default_box(std::vector<Site>{{x, y, 0}});
            EXPECT_TRUE(at_point.x0 < x && x < at_point.x1) << x << ", " << y;
            EXPECT_TRUE(at_point.y0 < y && y < at_point.y1) << x << ", " << y;
            const Box of_line = default_box(std::vector<Site>{{x, y, 0}, {x, y + 1, 0}});
            EXPECT_TRUE(of_line.x0 < x && x < of_line.x1) << x << ", " << y;
        }
    EXPECT_EQ(default_box(std::vector<Site>{{3, 4, 1}}), (Box{2, 3, 4, 5}));
    for (const auto& sites : {std::vector<Site>{{0, 0, 5e-324}},
                              {{5e-324, 0, 0}},
                              {{5e-324, 0, 0}, {0, 0, 0}},
                              {{0, 0, 0}, {1e-323, 0, 0}}}) {
        const Voronoi diagram = voronoi(triangulate(sites, Euclidean{}));
        const Box box = default_box(sites, diagram.exponent());
        EXPECT_TRUE(box.x0 < sites[0].x && sites[0].x < box.x1);
        EXPECT_TRUE(fits(box, diagram));
    }
}

/// Lengths that are divided are those of the same sites enlarged, whose doubles tell more points
/// apart: a vertex is not rounded to a denormal on the way.
TEST_P(VoronoiCells, EdgesOfDenormalSitesAreThoseOfUsualOnes) {
    for (int round = 0; round < 60; ++round) {
        const int range = round % 2 == 0 ? 300 : 4;
        std::vector<Site> usual(12);
        std::vector<Site> denormal(12);
        for (std::size_t i = 0; i < 12; ++i) {
            usual[i] = {1.0 * below(range), 1.0 * below(range), 1.0 * below(1 + range / 8)};
            denormal[i] = {usual[i].x * 0x1p-1074, usual[i].y * 0x1p-1074, usual[i].r * 0x1p-1074};
        }
        const Voronoi large = build(usual);
        const Voronoi small = build(denormal);
        ASSERT_EQ(large.edges().size(), small.edges().size());
        const double unit = std::ldexp(1.0, small.exponent() + 1074);
        for (Index e = 0; e < static_cast<Index>(large.edges().size()); ++e) {
            const auto expected = large.geometry(e);
            const auto found = small.geometry(e);
            ASSERT_EQ(expected.has_value(), found.has_value());
            if (!found) continue;
            EXPECT_EQ(found->kind, expected->kind);
            for (const auto end : {&EdgeGeometry::start, &EdgeGeometry::end}) {
                const Point p = (*found).*end;
                const Point q = (*expected).*end;
                if (!std::isfinite(q.x)) continue;
                EXPECT_EQ(p.x * unit, q.x);
                EXPECT_EQ(p.y * unit, q.y);
            }
        }
    }
}

/// How much of the box around the origin each cell takes.
std::vector<double> shares_of(const std::vector<Site>& sites, Metric metric, double reach) {
    const Voronoi diagram = voronoi(triangulate(sites, metric));
    const double side = std::ldexp(reach, -diagram.exponent());
    const Box box = {-side, -side, side, side};
    const ClippedVoronoi clipped(diagram, box, Lengths::divided);
    std::vector<double> shares;
    for (Index i = 0; i < static_cast<Index>(sites.size()); ++i)
        shares.push_back(diagram.is_hidden(i) ? 0.0 : measure(clipped.cell(i)).area / area(box));
    return shares;
}

/// From where the other sites are, a close pair looks the same however close it is: also where its
/// distance is a denormal, or none among numbers as large as theirs.
TEST(Voronoi, OfAPairThatIsCloserThanDoublesCanTell) {
    std::mt19937_64 random(79);
    const auto below = [&](int bound) { return static_cast<double>(random() % bound); };
    for (int round = 0; round < (is_sanitized ? 20 : 200); ++round) {
        for (const Metric metric : all_metrics) {
            // The radii of the pair differ by less than their distance, or not at all.
            const std::array<double, 4> of_pair = {below(60), below(60) + 1, -below(60) - 1,
                                                   below(60)};
            const double radius = round % 2 == 0 ? 0.0 : below(40);
            const auto sites = [&](double least, double far) -> std::vector<Site> {
                return {{far, far, 0},
                        {-far, 0.75 * far, 0},
                        {0.625 * far, -far, 0},
                        {-far, -far, 0},
                        {least * of_pair[0], least * of_pair[1], 0},
                        {least * of_pair[2], least * of_pair[3],
                         metric == Metric::power ? 0.0 : least * radius}};
            };
            const std::vector<double> expected = shares_of(sites(0x1p-60, 1.0), metric, 1.0);
            for (const double far :
                 {0x1p-700, 0x1p-100, 1.0, 0x1p199, 0x1p233, 0x1p600, 0x1p1022}) {
                const std::vector<double> found = shares_of(sites(0x1p-1074, far), metric, far);
                for (std::size_t i = 0; i < 6; ++i)
                    ASSERT_NEAR(found[i], expected[i], 1e-9)
                        << name_of(metric) << " of " << far << ", cell " << i << " of round "
                        << round;
            }
        }
    }
}

TEST(Voronoi, OfVerticesBeyondTheDoubles) {
    const auto expect_shares = [](const std::vector<Site>& sites, Metric metric,
                                  const std::vector<double>& areas) {
        const Voronoi diagram = voronoi(triangulate(sites, metric));
        const ClippedVoronoi clipped(diagram, {0, 0, 8, 8});
        for (std::size_t i = 0; i < sites.size(); ++i)
            EXPECT_NEAR(measure(clipped.cell(static_cast<Index>(i))).area, areas[i], 1e-9)
                << name_of(metric) << ", site " << i;
    };
    // All but in line: where the outer two meet is far above, or below, or both.
    constexpr double least = 0x1p-1074;
    expect_shares({{1, 0, 0}, {3, least, 0}, {7, 0, 0}}, Power{}, {16, 24, 24});
    expect_shares({{1, least, 0}, {3, 0, 0}, {7, 0, 0}}, Euclidean{}, {16, 24, 24});
    expect_shares({{0, 1, 0}, {least, 7, 0}, {0, 3, 0}}, Power{}, {16, 24, 24});
    expect_shares({{1, 0, 0}, {3, 0, 0}, {7, 0, least}}, Euclidean{}, {16, 24, 24});
    expect_shares({{1, 0, 0}, {3, 0, least}, {7, 0, 0}}, Euclidean{}, {16, 24, 24});
    expect_shares({{1, 0, least}, {7, 0, 0}, {3, 0, 0}}, Euclidean{}, {16, 24, 24});
}

TEST(Voronoi, OfDiscsThatAllButTouchFromInside) {
    // Within the larger one at its right end, from which the smaller one's cell leads to the right.
    for (const double gap : {0x1p-20, 0x1p-40, 0x1p-53, 0x1p-80, 0x1p-200, 0x1p-537, 0x1p-1000}) {
        const std::vector<Site> sites = {{0, 0, 2}, {2, gap, 0}};
        const Voronoi diagram = voronoi(triangulate(sites, Euclidean{}));
        const auto geometry = diagram.geometry(0);
        ASSERT_TRUE(geometry.has_value());
        const auto& hyperbola = std::get<HyperbolaCurve>(geometry->curve);
        // b² = (4 + gap² - 4) / 4
        EXPECT_NEAR(hyperbola.b / (gap / 2), 1.0, 1e-9) << gap;
    }
}

TEST(Voronoi, OfCloseDiscsThatAllButTouchFromInside) {
    const auto areas = [](const std::vector<Site>& sites, const Box& box) {
        const Voronoi diagram = voronoi(triangulate(sites, Euclidean{}));
        const ClippedVoronoi clipped(diagram, box);
        std::vector<double> result;
        for (Index i = 0; i < static_cast<Index>(sites.size()); ++i)
            result.push_back(measure(clipped.cell(i)).area);
        return result;
    };
    constexpr double least = 0x1p-1074;
    // The first one's cell is all but a ray.
    const std::vector<double> of_three =
        areas({{-least, -0x1p-967, 0}, {0, 0, 0x1p-967}, {-5, 25, 25}}, {-30, -47, 32, 83});
    EXPECT_NEAR(of_three[0], 0.0, 1e-9);
    EXPECT_NEAR(of_three[1] + of_three[2], 62.0 * 130.0, 1e-9);
    const std::vector<double> of_four = areas(
        {{-least, -0x1p-997, 0}, {0, 0, 0x1p-997}, {-4, 19, 3}, {-1, 5, 2}}, {-14, -25, 10, 44});
    EXPECT_NEAR(of_four[0], 0.0, 1e-9);
    EXPECT_NEAR(of_four[1] + of_four[2] + of_four[3], 24.0 * 69.0, 1e-9);
    const std::vector<double> beside =
        areas({{-0x1p-1045, 5, 5}, {0, 4, 4}, {least, 4, 4}}, {-8, -8, 8, 8});
    EXPECT_NEAR(beside[0] + beside[1] + beside[2], 256.0, 1e-9);
}

TEST(Voronoi, RadiiWhoseSumVanishesWeighTheSame) {
    constexpr double least = 0x1p-1074;
    const std::vector<Site> sites = {{-least, 0, 3}, {least, least, -3}, {5, 0, 0}, {0, 5, 0}};
    const Voronoi diagram = voronoi(triangulate(sites, Power{}));
    for (Index edge = 0; edge < static_cast<Index>(diagram.edges().size()); ++edge)
        EXPECT_TRUE(diagram.geometry(edge).has_value()) << edge;
}

TEST(Voronoi, RefusesBoxesOfAnotherSizeThanItsSites) {
    const auto of = [](double size) {
        return voronoi(
            triangulate(std::vector<Site>{{0, 0, 0}, {size, 0, 0}, {0, size, 0}}, Euclidean{}));
    };
    const Voronoi huge = of(1e308);
    const Voronoi tiny = of(1e-320);
    const Voronoi usual = of(1);
    EXPECT_THROW(ClippedVoronoi(huge, {0, 0, 1e-20, 1e-20}), std::invalid_argument);
    EXPECT_THROW(ClippedVoronoi(huge, {0, 0, 1e-320, 1}), std::invalid_argument);
    EXPECT_THROW(ClippedVoronoi(tiny, {-1, -1, 1, 1}), std::invalid_argument);
    EXPECT_THROW(ClippedVoronoi(tiny, {-1e308, -1e308, 1e308, 1e308}), std::invalid_argument);
    EXPECT_THROW(ClippedVoronoi(usual, {-1e308, -1e308, 1e308, 1e308}), std::invalid_argument);
    EXPECT_THROW(ClippedVoronoi(usual, {0, 0, 1e-200, 1e-200}), std::invalid_argument);
    // Anything else has cells.
    for (const double size : {1e150, 1e15, 1e-15, 1e-150})
        EXPECT_NEAR(area_of_cells(usual, {-size, -size, size, size}) / size / size, 4, 1e-12);
    EXPECT_NO_THROW(ClippedVoronoi(huge, {-1e200, -1e200, 1e200, 1e200}));
}

TEST(Voronoi, RefusesBoxesWithoutInside) {
    const Voronoi diagram = voronoi(triangulate(std::vector<Site>{{0, 0, 0}}, Power{}));
    EXPECT_THROW(ClippedVoronoi(diagram, {0, 0, 0, 1}), std::invalid_argument);
    EXPECT_THROW(ClippedVoronoi(diagram, {0, 1, 1, 0}), std::invalid_argument);
    EXPECT_THROW(ClippedVoronoi(diagram, {0, 0, NAN, 1}), std::invalid_argument);
    EXPECT_THROW(ClippedVoronoi(diagram, {0, 0, INFINITY, 1}), std::invalid_argument);
}

}  // namespace
}  // namespace signum
