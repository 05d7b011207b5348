/// Boost.Geometry's points as sites and cells as its polygons: areas and places are those that
/// signum tells itself.

#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>

#include "../../../bindings/interop/boost_geometry.hpp"
#include "../../../triangulation/triangulate.hpp"
#include "../../../voronoi/voronoi.hpp"

namespace {

namespace bg = boost::geometry;
using signum::Box;
using signum::Index;
using signum::Point;
using signum::Site;

/// Spread, or on a grid, with some sites hidden.
std::vector<Site> sites(int kind) {
    std::mt19937_64 random(kind + 1);
    std::uniform_real_distribution<double> spread(0.0, 4.0);
    std::vector<Site> result;
    for (int i = 0; i < 40; ++i) {
        const double x = spread(random);
        const double y = spread(random);
        result.push_back(kind == 0 ? Site{x, y, x / 8.0} : Site{std::floor(x), std::floor(y), 0.0});
    }
    return result;
}

/// Counterclockwise and open, where the default is clockwise and closed.
using Other =
    bg::model::multi_polygon<bg::model::polygon<bg::model::d2::point_xy<double>, false, false>>;

void expect_cells(const std::vector<Site>& all, signum::Metric metric) {
    const auto diagram = signum::voronoi(signum::triangulate(all, metric));
    const Box box = {-1, -1, 5, 5};
    const signum::ClippedVoronoi clipped(diagram, box);
    constexpr double tolerance = 1e-4;
    const auto cells = signum::boost_geometry::cells(clipped, tolerance);
    ASSERT_EQ(cells.size(), all.size());
    double sum = 0.0;
    int hidden = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto site = static_cast<Index>(i);
        EXPECT_EQ(cells[i].empty(), diagram.is_hidden(site));
        if (cells[i].empty()) {
            ++hidden;
            continue;
        }
        std::string why;
        EXPECT_TRUE(bg::is_valid(cells[i], why)) << why;
        const double area = bg::area(cells[i]);
        EXPECT_NEAR(area, signum::measure(clipped.cell(site)).area, 0.01);
        EXPECT_NEAR(bg::area(signum::boost_geometry::cell<Other>(clipped, site, tolerance)), area,
                    1e-9);
        sum += area;
    }
    EXPECT_NEAR(sum, bg::area(box), 1e-6);
    EXPECT_GT(hidden, 0);
}
TEST(BoostGeometry, CellsTileTheBox) {
    expect_cells(sites(1), signum::Power{});
    expect_cells(sites(1), signum::Supremum{});
    std::vector<Site> discs = sites(0);
    discs.push_back({2.0, 2.0, -3.0});
    expect_cells(discs, signum::Euclidean{});
}

TEST(BoostGeometry, SitesFromPointsOfAnyExactNumber) {
    bg::model::multi_point<bg::model::point<float, 2, bg::cs::cartesian>> floats;
    bg::read_wkt("MULTIPOINT((0.1 1),(2 3.5))", floats);
    const std::vector<Point> expected = {{static_cast<double>(0.1F), 1.0}, {2.0, 3.5}};
    EXPECT_EQ(signum::boost_geometry::sites(floats), expected);
    EXPECT_EQ(signum::boost_geometry::sites(expected), expected);
    bg::model::ring<bg::model::d2::point_xy<int>> ring;
    bg::read_wkt("POLYGON((0 0,0 1,1 1,0 0))", ring);
    EXPECT_EQ(signum::boost_geometry::sites(ring).size(), 4);
    EXPECT_TRUE(signum::boost_geometry::sites(std::vector<Point>()).empty());
}

TEST(BoostGeometry, KnowsSignumsPointsAndBoxes) {
    EXPECT_EQ(bg::distance(Point{0, 0}, Point{3, 4}), 5.0);
    EXPECT_TRUE(bg::within(Point{1, 1}, Box{0, 0, 2, 2}));
    Box box{};
    bg::envelope(std::vector<Point>{{1, 5}, {2, -1}}.front(), box);
    EXPECT_EQ(box, (Box{1, 5, 1, 5}));
}

TEST(BoostGeometry, RefusesWhatIsNoSiteAndNoTolerance) {
    const auto diagram = signum::voronoi(signum::triangulate(sites(0), signum::Power{}));
    const signum::ClippedVoronoi clipped(diagram, {-1, -1, 5, 5});
    EXPECT_THROW((void)signum::boost_geometry::cell(clipped, 1000, 1e-3), std::out_of_range);
    EXPECT_THROW((void)signum::boost_geometry::cell(clipped, 0, 0.0), std::invalid_argument);
}

}  // namespace
