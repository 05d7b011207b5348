// Sites from Boost.Geometry's points, cells as its polygons.

#include <signum/interop/boost_geometry.hpp>

#include <cstdio>

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>

#include <signum/triangulation/triangulate.hpp>
#include <signum/voronoi/clip.hpp>
#include <signum/voronoi/voronoi.hpp>

namespace bg = boost::geometry;

int main() {
    bg::model::multi_point<bg::model::d2::point_xy<double>> shops;
    bg::read_wkt("MULTIPOINT((1 1),(3 1),(1 3),(3 3.5))", shops);

    const std::vector<signum::Point> sites = signum::boost_geometry::sites(shops);
    const auto diagram = signum::voronoi(signum::triangulate(sites, signum::Power{}));
    const signum::Box town = {0, 0, 4, 4};
    const signum::ClippedVoronoi clipped(diagram, town);

    double sum = 0;
    for (const auto& cell : signum::boost_geometry::cells(clipped, 1e-3)) sum += bg::area(cell);
    std::printf("the cells' area is %g, the town's %g\n", sum, bg::area(town));
    std::printf("%d\n", bg::within(sites[0], signum::boost_geometry::cell(clipped, 0, 1e-3)));
}
