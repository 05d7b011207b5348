#include "space_polyhedra.hpp"

#include <algorithm>
#include <cmath>

#include "space_faces.hpp"

namespace signum {
namespace {

class Building {
 public:
    Building(const SpaceTessellation& tessellation, const AnySites3& sites, const Box3& box)
        : faces_(tessellation, sites, box) {}

    [[nodiscard]] std::vector<SpacePolyhedron> run(std::span<const Index> which) {
        std::vector<SpacePolyhedron> result;
        result.reserve(which.size());
        for (const Index site : which) {
            static_cast<void>(checked("site", site, faces_.sites().size()));
            result.push_back(polyhedron(site));
        }
        return result;
    }

 private:
    /// A face as it was cut, seen from the centre of the cell's site.
    struct Loop {
        Index beyond;
        std::size_t first;
        std::size_t last;
    };

    [[nodiscard]] SpacePolyhedron polyhedron(Index site) {
        loops_.clear();
        points_.clear();
        if (!faces_.is_visible(site)) return joined(site);
        const auto found = faces_.neighbours(site);
        neighbours_.assign(found.begin(), found.end());
        std::ranges::sort(neighbours_, {}, &SpaceFaces::Neighbour::site);
        for (const SpaceFaces::Neighbour& each : neighbours_) {
            // As the lesser site sees it, so that both cells have the same one.
            const bool is_lesser = site < each.site;
            const CutFace* const face =
                is_lesser ? faces_.cut(site, each) : faces_.cut(each.site, {site, each.cell});
            if (face == nullptr) continue;
            const Point3 normal = plus({}, face->plane.normal, is_lesser ? 1.0 : -1.0);
            const Point3 eye = is_lesser ? Point3{} : faces_.sites().offset(site, each.site);
            keep(each.site, normal, eye);
        }
        for (int side = 0; side < 6; ++side)
            if (const CutFace* const face = faces_.cut_side(site, side, neighbours_))
                keep(static_cast<Index>(-1 - side), face->plane.normal, {});
        return joined(site);
    }
    void keep(Index beyond, const Point3& normal, const Point3& eye) {
        const std::size_t first = points_.size();
        for (const Point3& p : faces_.polygon()) points_.push_back(plus(p, eye));
        Point3 twice;
        for (std::size_t k = first + 2; k < points_.size(); ++k)
            twice = plus(twice, cross(minus(points_[k - 1], points_[first]),
                                      minus(points_[k], points_[first])));
        if (dot(twice, normal) < 0.0)
            std::reverse(points_.begin() + static_cast<std::ptrdiff_t>(first), points_.end());
        loops_.push_back({beyond, first, points_.size()});
    }

    /// Law 2.
    [[nodiscard]] SpacePolyhedron joined(Index site) {
        SpacePolyhedron result;
        result.site = site;
        result.first_corner = {0};
        const double near = nearness(site);
        corners_.clear();
        for (const auto& [beyond, first, last] : loops_) {
            const std::size_t begin = result.face_corners.size();
            for (std::size_t k = first; k < last; ++k) {
                const Index corner = corner_at(points_[k], near);
                if (result.face_corners.size() == begin || result.face_corners.back() != corner)
                    result.face_corners.push_back(corner);
            }
            while (result.face_corners.size() > begin + 1 &&
                   result.face_corners.back() == result.face_corners[begin])
                result.face_corners.pop_back();
            if (result.face_corners.size() < begin + 3) {
                result.face_corners.resize(begin);
                continue;
            }
            result.beyond.push_back(beyond);
            result.first_corner.push_back(static_cast<Index>(result.face_corners.size()));
        }
        name_corners(result);
        return result;
    }
    [[nodiscard]] double nearness(Index site) const noexcept {
        const Box3& box = faces_.sites().box();
        const Point3& eye = faces_.sites()[site].centre;
        double extent = 0.0;
        double largest = 1.0;
        for (const auto axis : axes_of_space) {
            largest = std::max({largest, std::fabs(box.low.*axis), std::fabs(box.high.*axis),
                                std::fabs(eye.*axis)});
            for (const Point3& p : points_)
                extent = std::max(extent, std::fabs(p.*axis - points_[0].*axis));
        }
        return std::max(0x1p-36 * extent, 0x1p-47 * largest);
    }
    [[nodiscard]] Index corner_at(const Point3& p, double near) {
        for (std::size_t k = 0; k < corners_.size(); ++k)
            if (std::fabs(p.x - corners_[k].x) <= near && std::fabs(p.y - corners_[k].y) <= near &&
                std::fabs(p.z - corners_[k].z) <= near)
                return static_cast<Index>(k);
        corners_.push_back(p);
        return static_cast<Index>(corners_.size() - 1);
    }
    /// Those that faces have, in the order in which faces have them, in the coordinates of the
    /// sites.
    void name_corners(SpacePolyhedron& result) {
        names_.assign(corners_.size(), -1);
        const Point3& eye = faces_.sites()[result.site].centre;
        const Box3& box = faces_.sites().box();
        const int exponent = faces_.sites().exponent();
        for (Index& corner : result.face_corners) {
            const auto place = static_cast<std::size_t>(corner);
            if (names_[place] < 0) {
                names_[place] = static_cast<Index>(result.corners.size());
                Point3 p = plus(eye, corners_[place]);
                for (const auto axis : axes_of_space)
                    p.*axis =
                        std::ldexp(std::clamp(p.*axis, box.low.*axis, box.high.*axis), exponent);
                result.corners.push_back(p);
            }
            corner = names_[place];
        }
    }

    SpaceFaces faces_;
    std::vector<SpaceFaces::Neighbour> neighbours_;
    std::vector<Loop> loops_;
    std::vector<Point3> points_;
    std::vector<Point3> corners_;
    std::vector<Index> names_;
};

}  // namespace

std::vector<SpacePolyhedron> space_polyhedra(const SpaceTessellation& tessellation,
                                             std::span<const Point3> sites, const Box3& box,
                                             std::span<const Index> which) {
    return Building(tessellation, sites, box).run(which);
}
std::vector<SpacePolyhedron> space_polyhedra(const SpaceTessellation& tessellation,
                                             std::span<const Site3> sites, const Box3& box,
                                             std::span<const Index> which) {
    return Building(tessellation, sites, box).run(which);
}
std::vector<SpacePolyhedron> space_polyhedra(const SpaceTessellation& tessellation,
                                             std::span<const power::Site3> sites, const Box3& box,
                                             std::span<const Index> which) {
    return Building(tessellation, sites, box).run(which);
}

}  // namespace signum
