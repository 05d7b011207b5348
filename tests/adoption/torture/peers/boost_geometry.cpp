// Boost.Geometry: on which side of a segment a point lies, by its default strategy.
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>

extern "C" int orient2d(const double* a, const double* b, const double* c) {
    using Point = boost::geometry::model::d2::point_xy<double>;
    return boost::geometry::strategy::side::side_by_triangle<>::apply(
        Point(a[0], a[1]), Point(b[0], b[1]), Point(c[0], c[1]));
}
