#include "polygon.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "../exact/floating_environment.hpp"
#include "vector.hpp"

namespace signum {

namespace {

/// What rounding may do to a coordinate of the polygon.
double rounding_of(const std::vector<Point>& points) noexcept {
    double largest = 0;
    for (const Point& p : points) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
    return 0x1p-51 * largest;
}

/// Whether a polygon stays, or goes to `tip` and back on the same line.
bool is_spike(Point before, Point tip, Point after, double rounding) noexcept {
    const Point a = minus(before, tip);
    const Point b = minus(after, tip);
    const double to_a = std::hypot(a.x, a.y);
    const double to_b = std::hypot(b.x, b.y);
    if (std::min(to_a, to_b) <= rounding) return true;
    // Unit vectors: products of two lengths may be beyond doubles.
    const Point u = {a.x / to_a, a.y / to_a};
    const Point v = {b.x / to_b, b.y / to_b};
    const double width = std::abs(cross(u, v)) * std::min(to_a, to_b);
    return dot(u, v) > 0 && width <= rounding;
}

/// The polygon without what has no width: where the tie rule decides between many squares, a cell
/// may have spikes, and merged vertices leave points that are the same.
std::vector<Point> without_spikes(const std::vector<Point>& points) {
    const double rounding = rounding_of(points);
    std::vector<Point> kept;
    const auto trim = [&](Point next) {
        while (kept.size() >= 2 && is_spike(kept[kept.size() - 2], kept.back(), next, rounding))
            kept.pop_back();
    };
    for (const Point& p : points) {
        trim(p);
        kept.push_back(p);
    }
    // Across the seam.
    std::size_t first = 0;
    while (kept.size() - first >= 3) {
        const std::size_t last = kept.size() - 1;
        if (is_spike(kept[last - 1], kept[last], kept[first], rounding))
            kept.pop_back();
        else if (is_spike(kept[last], kept[first], kept[first + 1], rounding))
            ++first;
        else
            break;
    }
    kept.erase(kept.begin(), kept.begin() + static_cast<std::ptrdiff_t>(first));
    return kept;
}

}  // namespace

std::vector<std::vector<Point>> polygons(const CellShape& shape, double tolerance) {
    const exact::IeeeEnvironment environment;
    std::vector<std::vector<Point>> result;
    for (const std::vector<Conic>& loop : shape.loops) {
        std::vector<Point> points;
        for (const Conic& conic : loop) sample(conic, tolerance, points);
        points = without_spikes(points);
        if (points.size() >= 3) result.push_back(std::move(points));
    }
    return result;
}

}  // namespace signum
