#include "cgal_space_constructions.hpp"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_3.h>
#include <algorithm>
#include <map>

namespace signum::benchmarks::cgal {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Delaunay = CGAL::Delaunay_triangulation_3<Kernel>;
using Regular = CGAL::Regular_triangulation_3<Kernel>;

std::vector<Kernel::Point_3> points(const std::vector<Site3>& sites) {
    std::vector<Kernel::Point_3> result;
    result.reserve(sites.size());
    for (const Site3& site : sites) result.emplace_back(site.x, site.y, site.z);
    return result;
}
std::vector<Kernel::Weighted_point_3> weighted_points(const std::vector<Site3>& sites) {
    std::vector<Kernel::Weighted_point_3> result;
    result.reserve(sites.size());
    for (const Site3& site : sites)
        result.emplace_back(Kernel::Point_3(site.x, site.y, site.z), site.r * site.r);
    return result;
}

template <class Triangulation, class Point>
Construction construction(std::vector<Point> points) {
    return [points = std::move(points)] {
        const auto triangulation = std::make_shared<Triangulation>(points.begin(), points.end());
        return Built{static_cast<std::int64_t>(triangulation->number_of_vertices()), triangulation};
    };
}

template <class Triangulation, class Point>
std::vector<std::array<Index, 4>> cells(const std::vector<Point>& points) {
    std::map<Point, Index> numbers;
    for (std::size_t i = 0; i < points.size(); ++i) numbers[points[i]] = static_cast<Index>(i);
    const Triangulation triangulation(points.begin(), points.end());
    std::vector<std::array<Index, 4>> result;
    for (auto c = triangulation.finite_cells_begin(); c != triangulation.finite_cells_end(); ++c) {
        std::array<Index, 4> cell{};
        for (int k = 0; k < 4; ++k)
            cell[static_cast<std::size_t>(k)] = numbers.at(c->vertex(k)->point());
        std::ranges::sort(cell);
        result.push_back(cell);
    }
    std::ranges::sort(result);
    return result;
}

}  // namespace

Construction delaunay(const std::vector<Site3>& sites) {
    return construction<Delaunay>(points(sites));
}
Construction regular(const std::vector<Site3>& sites) {
    return construction<Regular>(weighted_points(sites));
}
std::vector<std::array<Index, 4>> delaunay_cells(const std::vector<Site3>& sites) {
    return cells<Delaunay>(points(sites));
}
std::vector<std::array<Index, 4>> regular_cells(const std::vector<Site3>& sites) {
    return cells<Regular>(weighted_points(sites));
}

}  // namespace signum::benchmarks::cgal
