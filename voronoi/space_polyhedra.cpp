#include "space_polyhedra.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

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
    /// A corner of a loop, and who lies beyond the three planes that meet there, in order.
    struct FacePoint {
        Point3 place;
        std::array<Index, 3> planes;
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
            if (is_lesser && faces_.cut(site, each) != nullptr) keep(each.site, {});
            if (!is_lesser && faces_.cut(each.site, {site, each.cell}) != nullptr) {
                const std::size_t first = points_.size();
                keep(each.site, faces_.sites().offset(site, each.site));
                std::reverse(points_.begin() + static_cast<std::ptrdiff_t>(first), points_.end());
            }
        }
        for (int side = 0; side < 6; ++side)
            if (faces_.cut_side(site, side, neighbours_) != nullptr)
                keep(static_cast<Index>(-1 - side), {});
        return joined(site);
    }
    void keep(Index beyond, const Point3& eye) {
        const std::size_t first = points_.size();
        const auto polygon = faces_.polygon();
        const auto borders = faces_.borders();
        for (std::size_t k = 0; k < polygon.size(); ++k) {
            std::array<Index, 3> planes = {beyond, borders[k > 0 ? k - 1 : borders.size() - 1],
                                           borders[k]};
            std::ranges::sort(planes);
            points_.push_back({plus(polygon[k], eye), planes});
        }
        loops_.push_back({beyond, first, points_.size()});
    }

    /// Law 2.
    [[nodiscard]] SpacePolyhedron joined(Index site) {
        SpacePolyhedron result;
        result.site = site;
        result.first_corner = {0};
        join_points(nearness(site));
        for (const auto& [beyond, first, last] : loops_) {
            const std::size_t begin = result.face_corners.size();
            for (std::size_t k = first; k < last; ++k) {
                const auto corner = static_cast<Index>(root(k));
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
        while (close_gap(result)) {
        }
        name_corners(result);
        return result;
    }

    /// A corner from its face's loop to the next one.
    struct Step {
        Index from;
        Index to;
        std::size_t face;
        std::size_t place;  ///< of the former in the list
    };
    /// Where planes nearly coincide, what is one edge to one face may be several to others, along
    /// it. The longest of the steps that nobody takes in the other direction gets the corners of
    /// those that lead back. False where there is none.
    [[nodiscard]] bool close_gap(SpacePolyhedron& result) {
        steps_.clear();
        for (std::size_t f = 0; f < result.beyond.size(); ++f) {
            const auto first = static_cast<std::size_t>(result.first_corner[f]);
            const auto last = static_cast<std::size_t>(result.first_corner[f + 1]);
            for (std::size_t k = first; k < last; ++k)
                steps_.push_back({result.face_corners[k],
                                  result.face_corners[k + 1 < last ? k + 1 : first], f, k});
        }
        const auto reversed = [](const Step& s) { return std::pair(s.to, s.from); };
        const auto as_is = [](const Step& s) { return std::pair(s.from, s.to); };
        std::ranges::sort(steps_, {}, as_is);
        alone_.clear();
        for (const Step& each : steps_)
            if (!std::ranges::binary_search(steps_, reversed(each), {}, as_is))
                alone_.push_back(each);
        const auto length_of = [&](const Step& s) {
            return length(minus(points_[static_cast<std::size_t>(s.to)].place,
                                points_[static_cast<std::size_t>(s.from)].place));
        };
        std::ranges::sort(alone_, std::greater{}, length_of);
        for (const Step& longest : alone_) {
            std::vector<Index> back;
            Index at = longest.to;
            while (at != longest.from && back.size() < alone_.size()) {
                const auto next = std::ranges::find(alone_, at, &Step::from);
                if (next == alone_.end()) break;
                at = next->to;
                if (at != longest.from) back.push_back(at);
            }
            if (at != longest.from || back.empty()) continue;
            result.face_corners.insert(
                result.face_corners.begin() + static_cast<std::ptrdiff_t>(longest.place + 1),
                back.rbegin(), back.rend());
            for (std::size_t f = longest.face + 1; f < result.first_corner.size(); ++f)
                result.first_corner[f] += static_cast<Index>(back.size());
            return true;
        }
        return false;
    }
    /// Where three planes meet is one corner, however badly it is known; and so are places near
    /// to one another.
    void join_points(double near) {
        root_.resize(points_.size());
        for (std::size_t k = 0; k < points_.size(); ++k) root_[k] = k;
        const auto are_near = [&](double a, double b) { return std::fabs(a - b) <= near; };
        for (std::size_t k = 0; k < points_.size(); ++k)
            for (std::size_t m = 0; m < k; ++m) {
                const auto& [p, planes] = points_[k];
                const auto& [q, others] = points_[m];
                if (planes == others ||
                    (are_near(p.x, q.x) && are_near(p.y, q.y) && are_near(p.z, q.z)))
                    join(root(m), root(k));
            }
    }
    [[nodiscard]] std::size_t root(std::size_t k) noexcept {
        while (root_[k] != k) k = root_[k] = root_[root_[k]];
        return k;
    }
    void join(std::size_t a, std::size_t b) noexcept { root_[std::max(a, b)] = std::min(a, b); }

    [[nodiscard]] double nearness(Index site) const noexcept {
        const Box3& box = faces_.sites().box();
        const Point3& eye = faces_.sites()[site].centre;
        double extent = 0.0;
        double largest = 1.0;
        for (const auto axis : axes_of_space) {
            largest = std::max({largest, std::fabs(box.low.*axis), std::fabs(box.high.*axis),
                                std::fabs(eye.*axis)});
            for (const FacePoint& p : points_)
                extent = std::max(extent, std::fabs(p.place.*axis - points_[0].place.*axis));
        }
        return std::max(0x1p-36 * extent, 0x1p-47 * largest);
    }
    /// Those that faces have, in the order in which faces have them, in the coordinates of the
    /// sites.
    void name_corners(SpacePolyhedron& result) {
        names_.assign(points_.size(), -1);
        const Point3& eye = faces_.sites()[result.site].centre;
        const Box3& box = faces_.sites().box();
        const int exponent = faces_.sites().exponent();
        for (Index& corner : result.face_corners) {
            const auto place = static_cast<std::size_t>(corner);
            if (names_[place] < 0) {
                names_[place] = static_cast<Index>(result.corners.size());
                Point3 p = plus(eye, points_[place].place);
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
    std::vector<FacePoint> points_;
    std::vector<std::size_t> root_;
    std::vector<Step> steps_;
    std::vector<Step> alone_;
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
