#include "power_cells.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace signum::oracle {
namespace {

using Place = std::array<mpq_class, 3>;

mpq_class product(const Place& a, const Place& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// All p with normal · p <= height; the largest coordinate of the normal is 1 in magnitude.
struct HalfSpace {
    Place normal;
    mpq_class height;
    std::size_t largest;
    std::vector<std::int32_t> beyond;
};

void add(std::vector<HalfSpace>& all, Place normal, mpq_class height, std::int32_t beyond) {
    std::size_t largest = 0;
    for (std::size_t axis = 1; axis < 3; ++axis)
        if (abs(normal[axis]) > abs(normal[largest])) largest = axis;
    const mpq_class unit = abs(normal[largest]);
    for (mpq_class& each : normal) each /= unit;
    height /= unit;
    for (HalfSpace& other : all)
        if (other.normal == normal && other.height == height) {
            other.beyond.push_back(beyond);
            return;
        }
    all.push_back({normal, height, largest, {beyond}});
}

/// Twice the area of the convex hull of points in the plane.
mpq_class hull_area(std::vector<std::array<mpq_class, 2>> points) {
    std::sort(points.begin(), points.end());
    const auto turn = [](const auto& a, const auto& b, const auto& c) -> mpq_class {
        return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    };
    mpq_class area = 0;
    for (int half = 0; half < 2; ++half) {
        std::vector<std::array<mpq_class, 2>> chain;
        for (const auto& p : points) {
            while (chain.size() > 1 && turn(chain[chain.size() - 2], chain.back(), p) <= 0)
                chain.pop_back();
            chain.push_back(p);
        }
        for (std::size_t k = 0; k + 1 < chain.size(); ++k)
            area += chain[k][0] * chain[k + 1][1] - chain[k][1] * chain[k + 1][0];
        std::reverse(points.begin(), points.end());
    }
    return area;
}

std::vector<Place> corners_of(const std::vector<HalfSpace>& planes) {
    std::vector<Place> corners;
    for (std::size_t i = 0; i < planes.size(); ++i)
        for (std::size_t j = i + 1; j < planes.size(); ++j) {
            const Place& a = planes[i].normal;
            const Place& b = planes[j].normal;
            const Place along = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                                 a[0] * b[1] - a[1] * b[0]};
            for (std::size_t k = j + 1; k < planes.size(); ++k) {
                const Place& c = planes[k].normal;
                const mpq_class determinant = product(along, c);
                if (determinant == 0) continue;
                Place p;
                for (std::size_t x = 0; x < 3; ++x) {
                    const std::size_t y = (x + 1) % 3;
                    const std::size_t z = (x + 2) % 3;
                    p[x] = (planes[i].height * (b[y] * c[z] - b[z] * c[y]) +
                            planes[j].height * (c[y] * a[z] - c[z] * a[y]) +
                            planes[k].height * along[x]) /
                           determinant;
                }
                const bool is_inside = std::all_of(
                    planes.begin(), planes.end(),
                    [&](const HalfSpace& s) { return product(s.normal, p) <= s.height; });
                if (is_inside && std::find(corners.begin(), corners.end(), p) == corners.end())
                    corners.push_back(p);
            }
        }
    return corners;
}

PowerCell cell_of(const std::vector<HalfSpace>& planes) {
    PowerCell cell;
    const std::vector<Place> corners = corners_of(planes);
    for (const HalfSpace& plane : planes) {
        std::vector<std::array<mpq_class, 2>> seen;
        for (const Place& p : corners)
            if (product(plane.normal, p) == plane.height)
                seen.push_back({p[(plane.largest + 1) % 3], p[(plane.largest + 2) % 3]});
        const mpq_class shadow = hull_area(seen) / 2;
        if (shadow == 0) continue;
        // The face is as much larger as the normal is longer than its largest coordinate, 1.
        cell.volume += shadow * plane.height / 3;
        const mpq_class square = shadow * shadow * product(plane.normal, plane.normal);
        cell.faces.push_back({plane.beyond, std::sqrt(square.get_d())});
    }
    return cell;
}

}  // namespace

std::vector<PowerCell> power_cells(const std::vector<WeighedPoint>& sites,
                                   const std::array<mpq_class, 3>& low,
                                   const std::array<mpq_class, 3>& high) {
    std::vector<PowerCell> cells;
    for (std::size_t i = 0; i < sites.size(); ++i) {
        std::vector<HalfSpace> planes;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            Place normal = {0, 0, 0};
            normal[axis] = -1;
            add(planes, normal, -low[axis], -1 - 2 * static_cast<std::int32_t>(axis));
            normal[axis] = 1;
            add(planes, normal, high[axis], -2 - 2 * static_cast<std::int32_t>(axis));
        }
        bool is_hidden = false;
        for (std::size_t j = 0; j < sites.size(); ++j) {
            if (j == i) continue;
            Place normal;
            for (std::size_t axis = 0; axis < 3; ++axis)
                normal[axis] = 2 * (sites[j].x[axis] - sites[i].x[axis]);
            const mpq_class height = (product(sites[j].x, sites[j].x) - sites[j].weight) -
                                     (product(sites[i].x, sites[i].x) - sites[i].weight);
            if (product(normal, normal) == 0)
                is_hidden = is_hidden || height < 0;
            else
                add(planes, normal, height, static_cast<std::int32_t>(j));
        }
        cells.push_back(is_hidden ? PowerCell{} : cell_of(planes));
    }
    return cells;
}

}  // namespace signum::oracle
