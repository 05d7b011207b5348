#include "polyhedra.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "../../core/groups.hpp"
#include "../../exact/floating_environment.hpp"
#include "faces.hpp"

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
    /// A face as it was cut, by its points.
    struct Loop {
        Index beyond;
        std::size_t first;
        std::size_t last;
        bool is_reversed;
    };
    /// A step between two points, counterclockwise around the cell's part of a side.
    struct Rim {
        Index side;
        std::size_t from;
        std::size_t to;
    };
    /// A corner of a loop, and who lies beyond the three planes that meet there, in order.
    struct FacePoint {
        Point3 place;
        ThreePlanes planes;
    };

    [[nodiscard]] SpacePolyhedron polyhedron(Index site) {
        loops_.clear();
        points_.clear();
        rims_.clear();
        ends_.clear();
        if (!faces_.is_visible(site)) return {site, {}, {}, {0}, {}};
        const auto found = faces_.neighbours(site);
        neighbours_.assign(found.begin(), found.end());
        std::ranges::sort(neighbours_, {}, &SpaceFaces::Neighbour::site);
        for (const SpaceFaces::Neighbour& each : neighbours_) {
            // As the lesser site sees it, so that both cells have the same one.
            const bool is_lesser = site < each.site;
            const Index i = is_lesser ? site : each.site;
            const Index j = is_lesser ? each.site : site;
            if (faces_.cut(i, {j, each.cell}) != nullptr) keep(site, i, j);
        }
        keep_sides(site);
        return joined(site);
    }
    void keep(Index site, Index i, Index j) {
        const std::size_t first = points_.size();
        const Index beyond = site == i ? j : i;
        const Point3 eye = faces_.sites().between_eyes(site, i);
        const auto polygon = faces_.polygon();
        const auto borders = faces_.borders();
        for (std::size_t k = 0; k < polygon.size(); ++k)
            points_.push_back(
                {plus(polygon[k], eye),
                 in_order({beyond, borders[k > 0 ? k - 1 : borders.size() - 1], borders[k]})});
        for (std::size_t k = 0; k < polygon.size(); ++k) {
            if (!faces_.is_at_box() || !is_box_side(borders[k])) continue;
            std::size_t from = first + k;
            std::size_t to = k + 1 < polygon.size() ? from + 1 : first;
            if (site == i) std::swap(from, to);
            rims_.push_back({borders[k], from, to});
        }
        faces_.for_ends_on_edges(i, j, [&](EdgeEnd end) {
            end.is_high = end.is_high == (site == i);
            end.corner += first;
            ends_.push_back(end);
        });
        loops_.push_back({beyond, first, points_.size(), site == j});
    }
    [[nodiscard]] static ThreePlanes in_order(ThreePlanes planes) {
        std::ranges::sort(planes);
        return planes;
    }

    /// The parts of the box's edges close the rims that faces leave on its sides.
    void keep_sides(Index site) {
        const bool is_whole_box = loops_.empty() && site == owner_of_box();
        const Box3 box = faces_.box_from(site);
        for (const EdgePart& part : edge_parts(ends_, is_whole_box)) {
            const auto& [edge, low, high] = part;
            const auto [from, to] = ends_of(part, box);
            const auto point = [this, &edge = edge](const EdgeEnd* end, bool is_high,
                                                    const Point3& place) {
                if (end != nullptr) return end->corner;
                points_.push_back({place, in_order({edge.next().name(), edge.last().name(),
                                                    edge.end(is_high).name()})});
                return points_.size() - 1;
            };
            const std::size_t first = point(low, false, from);
            const std::size_t last = point(high, true, to);
            const Side up = side_around_which_up(edge);
            const Side down = up.number == edge.next().number ? edge.last() : edge.next();
            rims_.push_back({up.name(), first, last});
            rims_.push_back({down.name(), last, first});
        }
        find_alike();
        for (int number = 0; number < 6; ++number) keep_side(Side(number).name());
    }
    /// Where the same planes meet.
    void find_alike() {
        by_planes_.clear();
        for (std::size_t k = 0; k < points_.size(); ++k)
            by_planes_.push_back({points_[k].planes, k});
        std::ranges::sort(by_planes_);
        alike_.resize(points_.size());
        std::size_t first = 0;
        for (std::size_t n = 0; n < by_planes_.size(); ++n) {
            if (by_planes_[n].first != by_planes_[first].first) first = n;
            alike_[by_planes_[n].second] = by_planes_[first].second;
        }
    }
    void keep_side(Index side) {
        const auto start = std::ranges::find(rims_, side, &Rim::side);
        if (start == rims_.end()) return;
        rim_from_.assign(points_.size(), rims_.size());
        for (std::size_t r = rims_.size(); r-- > 0;)
            if (rims_[r].side == side) rim_from_[alike_[rims_[r].from]] = r;
        const std::size_t first = points_.size();
        const std::size_t most = first + rims_.size();
        const std::size_t origin = alike_[start->from];
        for (Rim at = *start; points_.size() < most;) {
            const FacePoint from = points_[at.from];
            points_.push_back(from);
            alike_.push_back(alike_[at.from]);
            const std::size_t to = alike_[at.to];
            if (to == origin || rim_from_[to] == rims_.size()) break;
            at = rims_[rim_from_[to]];
        }
        loops_.push_back({side, first, points_.size(), false});
    }
    [[nodiscard]] Index owner_of_box() {
        if (owner_ == unknown) owner_ = faces_.owner_of_box();
        return owner_;
    }

    /// Law 2: of all the corners that are near to one another one is made; where that would not
    /// leave a polyhedron, of those along an edge; and if not that either, of none.
    [[nodiscard]] SpacePolyhedron joined(Index site) {
        SpacePolyhedron result;
        for (const Joining joining : {Joining::near, Joining::along_edges, Joining::none}) {
            join_points(joining, nearness(site));
            result = with_joined_corners(site);
            if (is_closed(result)) break;
        }
        name_corners(result);
        return result;
    }
    [[nodiscard]] SpacePolyhedron with_joined_corners(Index site) {
        SpacePolyhedron result;
        result.site = site;
        result.first_corner = {0};
        for (const auto& [beyond, first, last, is_reversed] : loops_) {
            const std::size_t begin = result.face_corners.size();
            for (std::size_t k = first; k < last; ++k) {
                const auto corner =
                    static_cast<Index>(groups_.of(is_reversed ? first + last - 1 - k : k));
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
        // Two sides of one polygon.
        if (result.beyond.size() < 3) return {site, {}, {}, {0}, {}};
        return result;
    }
    /// Law 1, but for what is convex.
    [[nodiscard]] bool is_closed(const SpacePolyhedron& result) {
        steps_.clear();
        for (std::size_t f = 0; f < result.beyond.size(); ++f) {
            const auto loop = result.corners_of(f);
            for (std::size_t k = 0; k < loop.size(); ++k)
                steps_.push_back({loop[k], loop[k + 1 < loop.size() ? k + 1 : 0]});
        }
        std::ranges::sort(steps_);
        if (std::ranges::adjacent_find(steps_) != steps_.end()) return false;
        for (const auto& [from, to] : steps_)
            if (!std::ranges::binary_search(steps_, std::pair(to, from))) return false;
        // Euler: corners - edges + faces = 2.
        std::size_t corners = 0;
        for (std::size_t k = 0; k < steps_.size(); ++k)
            if (k == 0 || steps_[k].first != steps_[k - 1].first) ++corners;
        return steps_.empty() || corners + result.beyond.size() == steps_.size() / 2 + 2;
    }

    enum class Joining { near, along_edges, none };
    void join_points(Joining joining, double near) {
        groups_ = Groups(alike_);
        if (joining == Joining::near) {
            order_.resize(points_.size());
            for (std::size_t k = 0; k < points_.size(); ++k) order_[k] = k;
            join_near(order_, near);
        }
        if (joining != Joining::along_edges) return;
        for (const Loop& loop : loops_)
            for (std::size_t k = loop.first; k < loop.last; ++k) {
                const std::size_t next = k + 1 < loop.last ? k + 1 : loop.first;
                if (are_near(k, next, near)) groups_.join(k, next);
            }
    }
    [[nodiscard]] bool are_near(std::size_t k, std::size_t m, double near) const noexcept {
        const Point3& p = points_[k].place;
        const Point3& q = points_[m].place;
        return std::fabs(p.x - q.x) <= near && std::fabs(p.y - q.y) <= near &&
               std::fabs(p.z - q.z) <= near;
    }
    /// Along the first axis along which they reach far they part where a step is longer than near;
    /// where none is, into halves, and once more those that are near to both. What is left
    /// together is few, or nearly in one place.
    void join_near(std::span<std::size_t> points, double near) {
        constexpr std::size_t few = 8;
        if (points.size() > few)
            for (const auto axis : axes_of_space) {
                const auto place = [&](std::size_t k) { return points_[k].place.*axis; };
                std::ranges::sort(points, {}, place);
                if (place(points.back()) - place(points.front()) <= 4 * near) continue;
                join_parts(points, near, axis);
                return;
            }
        join_reached(points, near);
    }
    void join_parts(std::span<std::size_t> points, double near, double Point3::*axis) {
        const auto place = [&](std::size_t k) { return points_[k].place.*axis; };
        std::size_t first = 0;
        for (std::size_t k = 1; k < points.size(); ++k) {
            if (place(points[k]) - place(points[k - 1]) <= near) continue;
            join_near(points.subspan(first, k - first), near);
            first = k;
        }
        if (first > 0) {
            join_near(points.subspan(first), near);
            return;
        }
        const std::size_t half = points.size() / 2;
        const double middle = place(points[half]);
        std::vector<std::size_t> between;
        for (const std::size_t k : points)
            if (std::fabs(place(k) - middle) <= near) between.push_back(k);
        join_near(points.first(half), near);
        join_near(points.subspan(half), near);
        join_near(between, near);
    }
    /// From each point those that have not been reached yet: of points in one place all are at
    /// once.
    void join_reached(std::span<std::size_t> points, double near) {
        std::size_t reached = 0;
        for (std::size_t from = 0; from < points.size(); ++from) {
            if (from == reached) ++reached;
            for (std::size_t k = reached; k < points.size(); ++k) {
                if (!are_near(points[from], points[k], near)) continue;
                groups_.join(points[from], points[k]);
                std::swap(points[k], points[reached++]);
            }
        }
    }
    [[nodiscard]] double nearness(Index site) const noexcept {
        const Box3& box = faces_.sites().box();
        const Point3 eye = faces_.sites().eye(site);
        double extent = 0.0;
        double largest = 1.0;
        for (const auto axis : axes_of_space) {
            largest = std::max({largest, std::fabs(box.low.*axis), std::fabs(box.high.*axis),
                                std::fabs(eye.*axis)});
            for (const FacePoint& p : points_)
                extent = std::max(extent, std::fabs(p.place.*axis - points_[0].place.*axis));
        }
        return std::max(0x1p-44 * extent, 0x1p-47 * largest);
    }
    /// Those that faces have, in the order in which faces have them, in the coordinates of the
    /// sites.
    void name_corners(SpacePolyhedron& result) {
        names_.assign(points_.size(), -1);
        const Point3 eye = faces_.sites().eye(result.site);
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
    std::vector<std::pair<ThreePlanes, std::size_t>> by_planes_;
    std::vector<std::size_t> alike_;     // by point: the first one where the same planes meet
    std::vector<std::size_t> rim_from_;  // of a side, by such points; where none begins, the end
    Groups groups_;                      // of points that are one corner
    std::vector<std::size_t> order_;
    std::vector<Rim> rims_;
    std::vector<EdgeEnd> ends_;
    std::vector<std::pair<Index, Index>> steps_;
    static constexpr Index unknown = -2;
    Index owner_ = unknown;
    std::vector<Index> names_;
};

}  // namespace

std::vector<SpacePolyhedron> space_polyhedra(const SpaceTessellation& tessellation,
                                             std::span<const Point3> sites, const Box3& box,
                                             std::span<const Index> which) {
    const exact::IeeeEnvironment environment;
    return Building(tessellation, sites, box).run(which);
}
std::vector<SpacePolyhedron> space_polyhedra(const SpaceTessellation& tessellation,
                                             std::span<const Site3> sites, const Box3& box,
                                             std::span<const Index> which) {
    const exact::IeeeEnvironment environment;
    return Building(tessellation, sites, box).run(which);
}
std::vector<SpacePolyhedron> space_polyhedra(const SpaceTessellation& tessellation,
                                             std::span<const power::Site3> sites, const Box3& box,
                                             std::span<const Index> which) {
    const exact::IeeeEnvironment environment;
    return Building(tessellation, sites, box).run(which);
}

}  // namespace signum
