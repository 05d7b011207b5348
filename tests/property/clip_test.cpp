/// Cells in boxes of small integers, whose sides run along edges, through vertices and through
/// sites: they tile the box, and each polygon has the area that is told of it and the points that
/// brute force calls nearest to its site. SIGNUM_CLIP_BOXES in the environment: how many boxes a
/// metric, SIGNUM_CLIP_SEED: which.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "../../triangulation/triangulate.hpp"
#include "../../voronoi/clip.hpp"
#include "../../voronoi/polygon.hpp"

#include "../by_metric.hpp"
#include "../thoroughness.hpp"

namespace signum {
namespace {

/// Sites of small integers, which are to be multiplied by the unit, and a box in the plane.
struct Scene {
    std::vector<Site> sites;
    Box box;
    double unit;
};

std::string text(const Scene& scene) {
    std::ostringstream out;
    out.precision(17);
    for (const Site& s : scene.sites) out << "{" << s.x << ", " << s.y << ", " << s.r << "}, ";
    const Box& box = scene.box;
    out << "box {" << box.x0 << ", " << box.y0 << ", " << box.x1 << ", " << box.y1
        << "}, sites times " << scene.unit;
    return out.str();
}

class Scenes {
 public:
    explicit Scenes(std::uint64_t seed) : random_(seed) {}

    [[nodiscard]] Scene next() {
        Scene scene;
        scene.sites.resize(static_cast<std::size_t>(1 + below(8)));
        const int range = 2 + below(7);
        const int radii = below(2) == 0 ? 1 : 1 + below(5);
        const int shape = below(8);
        for (Site& s : scene.sites) {
            s = {1.0 * below(range), 1.0 * below(range), 1.0 * below(radii)};
            if (shape == 0) s.y = s.x;  // on a line
            if (shape == 1) s.y = 2;
        }
        // One that hides the others, or all but.
        if (shape == 2) scene.sites[0].r = range + below(range);
        for (double Box::*side : {&Box::x0, &Box::y0}) scene.box.*side = below(range + 8) - 4;
        const int longest = below(2) == 0 ? 2 : range + 4;
        scene.box.x1 = scene.box.x0 + 1 + below(longest);
        scene.box.y1 = scene.box.y0 + 1 + below(longest);
        // Vertices, and the points where curves turn, lie between integers, too.
        if (below(4) == 0)
            for (double Box::*side : {&Box::x0, &Box::y0, &Box::x1, &Box::y1})
                scene.box.*side *= 0.25;
        if (below(16) == 0) {
            // Far from all sites.
            const double away = 1 << below(20);
            scene.box.x0 += away;
            scene.box.x1 += away;
        }
        // Exactly on the lattice, or by rounding beside it.
        constexpr double units[] = {1.0, 1.0, 0.1, 1.0 / 3};
        scene.unit = units[below(4)];
        return scene;
    }

    /// Moves some sides of the box to vertices of the diagram, or all of it close around one, or
    /// close around a site.
    void snap(Box& box, const std::vector<Site>& sites, const Voronoi& diagram) {
        const auto vertices = diagram.vertices();
        const bool at_site = vertices.empty() || below(4) == 0;
        const auto place = [&]() -> Point {
            if (at_site) {
                const Site& s =
                    sites[static_cast<std::size_t>(below(static_cast<int>(sites.size())))];
                return {s.x, s.y};
            }
            const DiagramVertex& v =
                vertices[static_cast<std::size_t>(below(static_cast<int>(vertices.size())))];
            return {v.x, v.y};
        };
        const Point p = place();
        const Point q = place();
        Box snapped = box;
        if (below(2) == 0) {
            const double size = std::ldexp(1.0, -below(30));
            // The place inside, on a side, in a corner.
            snapped = {p.x - below(2) * size, p.y - below(2) * size, p.x + size, p.y + size};
        } else {
            if (below(2) == 0) snapped.x0 = p.x;
            if (below(2) == 0) snapped.y0 = p.y;
            if (below(2) == 0) snapped.x1 = q.x;
            if (below(2) == 0) snapped.y1 = q.y;
        }
        if (snapped.x0 < snapped.x1 && snapped.y0 < snapped.y1) box = snapped;
    }

 private:
    int below(int count) { return static_cast<int>(random_() % static_cast<std::uint64_t>(count)); }

    std::mt19937_64 random_;
};

/// A point of the samples' grid, in units of 1/1024; off every line where a straight bisector of
/// lattice sites in the Manhattan and supremum metrics may lie.
struct Sample {
    std::int64_t x;
    std::int64_t y;
};
constexpr std::int64_t grid = 1024;

/// Times 1024, or the square of that in the power metric; of the Euclidean metric rounded.
long double distance(Metric metric, const Sample& p, const Site& s) {
    const std::int64_t x = std::abs(p.x - grid * static_cast<std::int64_t>(s.x));
    const std::int64_t y = std::abs(p.y - grid * static_cast<std::int64_t>(s.y));
    const auto r = grid * static_cast<std::int64_t>(s.r);
    const std::int64_t length = by_metric::length_or_square(metric, x, y);
    if (metric == Metric::power) return static_cast<long double>(length - r * r);
    if (metric == Metric::euclidean)
        return std::sqrt(static_cast<long double>(length)) - static_cast<long double>(r);
    return static_cast<long double>(length - r);
}

/// Of equally near sites the largest has the point, then the one on the left, then the lower one,
/// then the first (geometry of ties: the later one's radius is a bit smaller).
bool comes_first(const Site& a, const Site& b) {
    if (a.r != b.r) return a.r > b.r;
    if (a.x != b.x) return a.x < b.x;
    return a.y < b.y;
}

struct Nearest {
    std::size_t site;
    long double margin;  ///< of sites elsewhere that are not as near
    bool is_tied;
};
Nearest nearest(Metric metric, const Sample& p, const std::vector<Site>& sites) {
    Nearest result = {0, 1e30L, false};
    std::vector<long double> all;
    for (const Site& s : sites) all.push_back(distance(metric, p, s));
    for (std::size_t i = 1; i < sites.size(); ++i)
        if (all[i] < all[result.site] ||
            (all[i] == all[result.site] && comes_first(sites[i], sites[result.site])))
            result.site = i;
    const Site& at = sites[result.site];
    for (std::size_t i = 0; i < sites.size(); ++i) {
        if (sites[i].x == at.x && sites[i].y == at.y) continue;
        const long double margin = all[i] - all[result.site];
        if (margin == 0)
            result.is_tied = true;
        else
            result.margin = std::min(result.margin, margin);
    }
    return result;
}

double area(const std::vector<Point>& polygon) {
    double twice = 0;
    const Point origin = polygon[0];
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point a = polygon[i];
        const Point b = polygon[(i + 1) % polygon.size()];
        twice += (a.x - origin.x) * (b.y - origin.y) - (b.x - origin.x) * (a.y - origin.y);
    }
    return twice / 2;
}

/// Whether a ray to the right crosses the polygon an odd number of times.
bool contains(const std::vector<Point>& polygon, Point p) {
    bool inside = false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point a = polygon[i];
        const Point b = polygon[(i + 1) % polygon.size()];
        if ((a.y > p.y) == (b.y > p.y)) continue;
        if (a.x + (b.x - a.x) * ((p.y - a.y) / (b.y - a.y)) > p.x) inside = !inside;
    }
    return inside;
}

class ClippedCells : public testing::TestWithParam<Metric> {
 protected:
    /// What is wrong with the cells in a box, if anything.
    [[nodiscard]] std::string fault(const Scene& scene, const Voronoi& diagram) {
        const Box& box = scene.box;
        const Metric metric = GetParam();
        const double unit = scene.unit;
        const double width = box.x1 - box.x0;
        const double height = box.y1 - box.y0;
        const double extent = std::max(
            {std::abs(box.x0), std::abs(box.x1), std::abs(box.y0), std::abs(box.y1), 16 * unit});
        // Of the plane beyond the box corners are as good as their coordinates.
        const double rounding = 1e-9 * width * height + 1e-13 * extent * (width + height);
        const double tolerance = 1e-4 * std::max(width, height);

        const ClippedVoronoi clipped(diagram, box);
        std::vector<std::vector<std::vector<Point>>> cells;
        double sum = 0;
        double sum_of_polygons = 0;
        for (Index i = 0; i < static_cast<Index>(scene.sites.size()); ++i) {
            const CellShape shape = clipped.cell(i);
            const Measure of = measure(shape);
            if (!(of.area >= 0))
                return "the area of cell " + std::to_string(i) + " is " +
                       std::to_string(of.area * 1e16) + "e-16";
            sum += of.area;
            double of_polygons = 0;
            cells.push_back(polygons(shape, tolerance));
            for (const auto& polygon : cells.back()) of_polygons += area(polygon);
            sum_of_polygons += of_polygons;
            const double curved =
                metric == Metric::euclidean ? 1.1 * tolerance * of.perimeter : 0.0;
            if (std::abs(of_polygons - of.area) > rounding + curved)
                return "cell " + std::to_string(i) + " has area " + std::to_string(of.area) +
                       ", its polygons " + std::to_string(of_polygons);
        }
        if (std::abs(sum - width * height) > rounding)
            return "areas sum to " + std::to_string(sum) + ", not " +
                   std::to_string(width * height);
        if (std::abs(sum_of_polygons - width * height) > rounding)
            return "areas of polygons sum to " + std::to_string(sum_of_polygons);
        // Out there rounding has moved borders, and samples are no integers.
        return extent > 0x1p20 * unit ? "" : misplaced_sample(scene, cells, tolerance);
    }

    std::uint64_t samples_ = 0;
    std::uint64_t ties_ = 0;
    std::uint64_t skipped_ = 0;

 private:
    [[nodiscard]] std::string misplaced_sample(
        const Scene& scene, const std::vector<std::vector<std::vector<Point>>>& cells,
        double tolerance) {
        const Box& box = scene.box;
        const auto off_lattice = [&](double low, double high, int i, std::int64_t offset) {
            const double place = (low + (high - low) * (0.2 * i)) / scene.unit;
            return 256 * static_cast<std::int64_t>(std::floor(4 * place)) + offset;
        };
        const auto in_plane = [&](std::int64_t place) {
            return static_cast<double>(place) / grid * scene.unit;
        };
        const double margin = 1e-6 * scene.unit;
        for (int i = 0; i < 5; ++i)
            for (int j = 0; j < 5; ++j) {
                const Sample p = {off_lattice(box.x0, box.x1, i, 173),
                                  off_lattice(box.y0, box.y1, j, 39)};
                const Point place = {in_plane(p.x), in_plane(p.y)};
                if (place.x < box.x0 + margin || place.x > box.x1 - margin ||
                    place.y < box.y0 + margin || place.y > box.y1 - margin)
                    continue;
                const Nearest at = nearest(GetParam(), p, scene.sites);
                ++samples_;
                ties_ += static_cast<std::uint64_t>(at.is_tied);
                const bool is_euclidean = GetParam() == Metric::euclidean;
                const bool is_near_border =
                    (is_euclidean &&
                     at.margin <= 3 * tolerance / scene.unit * static_cast<double>(grid)) ||
                    // Elsewhere a tie fills a quadrant, unless what is rounded tells otherwise.
                    (at.is_tied &&
                     (is_euclidean || GetParam() == Metric::power || scene.unit != 1.0));
                if (is_near_border) {
                    ++skipped_;
                    continue;
                }
                for (std::size_t cell = 0; cell < cells.size(); ++cell) {
                    const auto times = std::ranges::count_if(
                        cells[cell], [&](const auto& polygon) { return contains(polygon, place); });
                    if (times != (cell == at.site ? 1 : 0))
                        return "cell " + std::to_string(cell) + " has " + std::to_string(place.x) +
                               ", " + std::to_string(place.y) + " " + std::to_string(times) +
                               " times, which is nearest to " + std::to_string(at.site);
                }
            }
        return "";
    }
};

TEST_P(ClippedCells, TileBoxesOnTheLatticeOfTheirSites) {
    const std::uint64_t boxes = asked_for("SIGNUM_CLIP_BOXES", is_fast ? 40'000 : 500);
    Scenes scenes(asked_for("SIGNUM_CLIP_SEED", 1998));
    std::uint64_t faults = 0;
    for (std::uint64_t i = 0; i < boxes; ++i) {
        Scene scene = scenes.next();
        const double unit = scene.unit;
        std::vector<Site> sites;
        for (const Site& s : scene.sites) sites.push_back({s.x * unit, s.y * unit, s.r * unit});
        for (double Box::*side : {&Box::x0, &Box::y0, &Box::x1, &Box::y1}) scene.box.*side *= unit;
        const Voronoi diagram = voronoi(triangulate(sites, GetParam()));
        if (i % 4 == 0) scenes.snap(scene.box, sites, diagram);
        const std::string what = fault(scene, diagram);
        if (!what.empty() && ++faults <= 10) ADD_FAILURE() << what << ": " << text(scene);
    }
    EXPECT_EQ(faults, 0U) << "of " << boxes << " boxes";
    RecordProperty("samples", std::to_string(samples_));
    EXPECT_LT(2 * skipped_, samples_);
    const bool is_rectangular = GetParam() == Metric::manhattan || GetParam() == Metric::supremum;
    EXPECT_GE(100 * ties_, is_rectangular ? samples_ : 0);
}

TEST(ClippedVoronoi, EdgesOnASideOfTheBox) {
    // The edges of the first site with the others both run upwards along x = 1 from where they meet
    // it; a rounding beside the side, one of them had the whole box on its left.
    const Voronoi diagram =
        voronoi(triangulate(std::vector<Site>{{1, 0, 2}, {4, 3, 2}, {0, 2, 1}}, Manhattan{}));
    const ClippedVoronoi clipped(diagram, {-4, -1, 1, 6});
    constexpr double areas[] = {10.5, 0, 24.5};
    for (Index i = 0; i < 3; ++i) EXPECT_NEAR(measure(clipped.cell(i)).area, areas[i], 1e-12) << i;
}

TEST(ClippedVoronoi, AreasAreNeverBelowNothing) {
    // A corner of the cell in a corner of the box, a rounding wide.
    const std::vector<Site> sites = {{1, 0, 0}, {2, 0, 0}, {0, 0, 0},
                                     {0, 2, 0}, {0, 1, 0}, {1, 1, 0}};
    const Voronoi diagram = voronoi(triangulate(sites, Supremum{}));
    const ClippedVoronoi clipped(diagram, {1, 2, 3, 3});
    for (Index i = 0; i < 6; ++i) {
        const Measure of = measure(clipped.cell(i));
        EXPECT_GE(of.area, 0.0) << i;
        EXPECT_EQ(std::isnan(of.centroid.x), of.area == 0) << i;
    }
}

INSTANTIATE_TEST_SUITE_P(AllMetrics, ClippedCells, testing::ValuesIn(all_metrics),
                         [](const auto& of) { return std::string(name_of(of.param)); });

}  // namespace
}  // namespace signum
