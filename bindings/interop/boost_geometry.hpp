#pragma once
/// Boost.Geometry's points as sites, cells of the diagram as its polygons; signum::Point and
/// signum::Box are a point and a box of Boost.Geometry.
///
/// Law: coordinates are cartesian and go in exactly: types whose numbers are not all doubles do not
/// compile.

#include <cstddef>
#include <limits>
#include <ranges>
#include <type_traits>
#include <vector>

#include <boost/geometry/algorithms/correct.hpp>
#include <boost/geometry/core/access.hpp>
#include <boost/geometry/core/coordinate_dimension.hpp>
#include <boost/geometry/core/coordinate_system.hpp>
#include <boost/geometry/core/coordinate_type.hpp>
#include <boost/geometry/core/cs.hpp>
#include <boost/geometry/core/exterior_ring.hpp>
#include <boost/geometry/core/point_type.hpp>
#include <boost/geometry/core/tag.hpp>
#include <boost/geometry/core/tags.hpp>
#include <boost/geometry/geometries/multi_polygon.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <boost/geometry/geometries/register/box.hpp>
#include <boost/geometry/geometries/register/point.hpp>
#include <boost/geometry/strategies/strategies.hpp>

#include <signum/core/index.hpp>
#include <signum/core/site.hpp>
#include <signum/voronoi/clip.hpp>
#include <signum/voronoi/polygon.hpp>

BOOST_GEOMETRY_REGISTER_POINT_2D(signum::Point, double, boost::geometry::cs::cartesian, x, y)
BOOST_GEOMETRY_REGISTER_BOX_2D_4VALUES(signum::Box, signum::Point, x0, y0, x1, y1)

namespace signum::boost_geometry {

using Polygon = boost::geometry::model::polygon<Point>;
using MultiPolygon = boost::geometry::model::multi_polygon<Polygon>;

/// The points of a range (a std::vector, a multi_point, a ring), copied: sites of radius 0. O(n).
template <std::ranges::input_range Range>
[[nodiscard]] std::vector<Point> sites(const Range& range) {
    namespace bg = boost::geometry;
    using Element = std::ranges::range_value_t<Range>;
    static_assert(std::is_same_v<typename bg::tag<Element>::type, bg::point_tag>,
                  "signum takes sites from a range of points");
    static_assert(bg::dimension<Element>::value == 2,
                  "signum takes sites of the plane from points of the plane");
    static_assert(std::is_same_v<typename bg::coordinate_system<Element>::type, bg::cs::cartesian>,
                  "signum measures in the plane: project longitudes and latitudes first");
    using Number = typename bg::coordinate_type<Element>::type;
    static_assert(std::is_arithmetic_v<Number> &&
                      std::numeric_limits<Number>::digits <= std::numeric_limits<double>::digits,
                  "signum takes coordinates that doubles hold exactly: double, float, int");
    std::vector<Point> result;
    if constexpr (std::ranges::sized_range<Range>) result.reserve(std::ranges::size(range));
    for (const Element& point : range)
        result.push_back(
            {static_cast<double>(bg::get<0>(point)), static_cast<double>(bg::get<1>(point))});
    return result;
}

/// The part of a site's cell that lies in the box of the diagram: a polygon for each piece into
/// which the box cuts it, arcs to within `tolerance` (voronoi/polygon.hpp). Cells have no holes.
/// Empty for a hidden site and, without a box, where the cell is unbounded. Closed and turned as
/// the polygon's type says. Throws std::out_of_range where there is no such site,
/// std::invalid_argument unless the tolerance is positive.
template <class Multi = MultiPolygon>
[[nodiscard]] Multi cell(const ClippedVoronoi& diagram, Index site, double tolerance) {
    namespace bg = boost::geometry;
    using Corner = typename bg::point_type<Multi>::type;
    Multi result;
    for (const std::vector<Point>& loop : polygons(diagram.cell(site), tolerance)) {
        auto& polygon = result.emplace_back();
        for (const Point& p : loop) {
            Corner corner;
            bg::set<0>(corner, p.x);
            bg::set<1>(corner, p.y);
            bg::exterior_ring(polygon).push_back(corner);
        }
        bg::correct(polygon);
    }
    return result;
}

/// The cells of all sites, in their order.
template <class Multi = MultiPolygon>
[[nodiscard]] std::vector<Multi> cells(const ClippedVoronoi& diagram, double tolerance) {
    std::vector<Multi> result;
    const std::size_t count = diagram.voronoi().tessellation().sites().size();
    result.reserve(count);
    for (std::size_t site = 0; site < count; ++site)
        result.push_back(cell<Multi>(diagram, static_cast<Index>(site), tolerance));
    return result;
}

}  // namespace signum::boost_geometry
