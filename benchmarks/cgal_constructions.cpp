#include "cgal_constructions.hpp"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_2.h>
#include <CGAL/version.h>

namespace signum::benchmarks::cgal {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

template <class Triangulation, class Point>
Construction construction(std::vector<Point> points) {
    return [points = std::move(points)] {
        const auto triangulation = std::make_shared<Triangulation>(points.begin(), points.end());
        return Built{static_cast<std::int64_t>(triangulation->number_of_vertices()), triangulation};
    };
}

}  // namespace

std::string version() {
    return CGAL_VERSION_STR;
}

Construction delaunay(const std::vector<Site>& sites) {
    std::vector<Kernel::Point_2> points;
    points.reserve(sites.size());
    for (const Site& site : sites) points.emplace_back(site.x, site.y);
    return construction<CGAL::Delaunay_triangulation_2<Kernel>>(std::move(points));
}

Construction regular(const std::vector<Site>& sites) {
    std::vector<Kernel::Weighted_point_2> points;
    points.reserve(sites.size());
    for (const Site& site : sites)
        points.emplace_back(Kernel::Point_2(site.x, site.y), site.r * site.r);
    return construction<CGAL::Regular_triangulation_2<Kernel>>(std::move(points));
}

}  // namespace signum::benchmarks::cgal
