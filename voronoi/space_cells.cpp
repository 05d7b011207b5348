#include "space_cells.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "../spatial/order.hpp"
#include "space_faces.hpp"

namespace signum {
namespace {

class Measuring {
 public:
    Measuring(const SpaceTessellation& tessellation, const AnySites3& sites, const Box3& box)
        : faces_(tessellation, sites, box), size_(static_cast<Index>(faces_.sites().size())) {
        result_.box = box;
        result_.measures.resize(faces_.sites().size());
        touched_.resize(faces_.sites().size(), 0);
        found_.reserve(8 * faces_.sites().size());
        apexes_.reserve(faces_.sites().size());
        for (Index i = 0; i < size_; ++i) apexes_.push_back(faces_.point_near_cell(i));
    }

    [[nodiscard]] SpaceCells run() && {
        // Near ones after one another, so that most of what a site looks at has been looked at.
        const auto place = [&](Index i) { return faces_.sites()[i].centre; };
        const LargeArray<Index> order = spatial::insertion_order(touched_.size(), place, 1);
        for (std::size_t k = 0; k < order.size(); ++k) {
            const Index i = order[k];
            if (k + 1 < order.size()) faces_.prefetch(order[k + 1]);
            for (const auto& neighbour : faces_.neighbours(i, i)) {
                const CutFace* const face = faces_.cut(i, neighbour);
                if (const auto touched = static_cast<std::uint8_t>(faces_.touched());
                    touched != 0) {
                    touched_of(i) |= touched;
                    touched_of(neighbour.site) |= touched;
                }
                if (face == nullptr || face->is_narrow) continue;
                found_.push_back({i, neighbour.site, face->area});
                add(i, face->plane.normal, face->plane.height, *face, {});
                add(neighbour.site, plus({}, face->plane.normal, -1.0), face->plane.height_beyond,
                    *face, faces_.sites().offset(i, neighbour.site));
            }
        }
        // A side that no face meets is in one cell.
        for (int side = 0; side < 6; ++side)
            if (const Index owner = nearest_to_middle(side); owner >= 0)
                touched_of(owner) |= static_cast<std::uint8_t>(1U << side);
        for (Index i = 0; i < size_; ++i) {
            if (touched_of(i) == 0) continue;
            const auto neighbours = faces_.neighbours(i);
            for (int side = 0; side < 6; ++side) {
                if ((touched_of(i) >> side & 1U) == 0) continue;
                const CutFace* const face = faces_.cut_side(i, side, neighbours);
                if (face == nullptr || face->is_narrow) continue;
                found_.push_back({i, static_cast<Index>(-1 - side), face->area});
                add(i, face->plane.normal, face->plane.height, *face, {});
            }
        }
        list_faces();
        for (Index i = 0; i < size_; ++i) finish(i);
        return std::move(result_);
    }

 private:
    /// A face and its two cells; of a side of the box the second one is that side.
    struct Found {
        Index first;
        Index second;
        double area;
    };

    [[nodiscard]] std::uint8_t& touched_of(Index i) noexcept {
        return touched_[static_cast<std::size_t>(i)];
    }
    [[nodiscard]] SpaceMeasure& measure_of(Index i) noexcept {
        return result_.measures[static_cast<std::size_t>(i)];
    }
    /// Where the cones of a cell begin, seen from its site: in the cell, which may be small and far
    /// from the site, so that rounding of its faces is not multiplied by that distance.
    [[nodiscard]] const Point3& apex(Index i) const noexcept {
        return apexes_[static_cast<std::size_t>(i)];
    }
    /// The cone over a face, its normal turned outward; `offset` leads from where the face was
    /// seen to site i.
    void add(Index i, const Point3& normal, double height, const CutFace& face,
             const Point3& offset) noexcept {
        const Point3 from = apex(i);
        const double over = height - dot(normal, from);
        const Point3 moment = plus(face.moment, plus(offset, from), -face.area);
        SpaceMeasure& measure = measure_of(i);
        measure.area += face.area;
        measure.volume += over * face.area / 3;
        measure.centroid = plus(measure.centroid, moment, over / 4);
    }
    /// The visible site nearest to the middle of a side; -1 where there is none. Two are compared
    /// by differences, which large weights and distances do not swallow.
    [[nodiscard]] Index nearest_to_middle(int side) const noexcept {
        const Box3& box = faces_.sites().box();
        Point3 middle = plus(plus({}, box.low, 0.5), box.high, 0.5);
        double Point3::*const axis = axes_of_space[side / 2];
        middle.*axis = side % 2 != 0 ? box.high.*axis : box.low.*axis;
        Index best = -1;
        for (Index i = 0; i < size_; ++i) {
            if (!faces_.is_visible(i)) continue;
            if (best >= 0) {
                const Point3 offset = faces_.sites().offset(best, i);
                const Point3 to_middle = minus(middle, faces_.sites()[best].centre);
                if (2 * dot(offset, to_middle) <=
                    dot(offset, offset) - faces_.sites().weight_difference(best, i))
                    continue;
            }
            best = i;
        }
        return best;
    }
    /// Into the lists of both cells, which are then put in order.
    void list_faces() {
        auto& first = result_.first_face;
        first.assign(result_.measures.size() + 2, 0);
        for (const Found& each : found_) {
            ++first[static_cast<std::size_t>(each.first) + 2];
            if (each.second >= 0) ++first[static_cast<std::size_t>(each.second) + 2];
        }
        for (std::size_t s = 2; s < first.size(); ++s) first[s] += first[s - 1];
        result_.faces.resize(static_cast<std::size_t>(first.back()));
        const auto put = [&](Index i, Index beyond, double area) {
            // The begin of each list moves to its end.
            std::int64_t& next = first[static_cast<std::size_t>(i) + 1];
            result_.faces[static_cast<std::size_t>(next++)] = {beyond, in_plane(area, 2)};
        };
        for (const auto& [i, j, area] : found_) {
            put(i, j, area);
            if (j >= 0) put(j, i, area);
        }
        first.pop_back();
        for (std::size_t s = 0; s + 1 < first.size(); ++s)
            std::sort(result_.faces.begin() + first[s], result_.faces.begin() + first[s + 1],
                      [](const SpaceFace& a, const SpaceFace& b) {
                          return (a.beyond < 0) != (b.beyond < 0) ? b.beyond < 0
                                 : a.beyond < 0                   ? a.beyond > b.beyond
                                                                  : a.beyond < b.beyond;
                      });
    }
    /// A product of so many lengths as it is where the sites lie.
    [[nodiscard]] double in_plane(double value, int lengths) const noexcept {
        return std::ldexp(value, lengths * faces_.sites().exponent());
    }
    void finish(Index i) noexcept {
        SpaceMeasure& measure = measure_of(i);
        const Box3 box = faces_.box_from(i);
        const Point3 sum = measure.centroid;
        measure.volume = std::max(measure.volume, 0.0);
        // Without a volume the site itself, or what is next to it in the box.
        const Point3 place = measure.volume > 0.0 ? apex(i) : Point3{};
        const Point3& eye = faces_.sites()[i].centre;
        for (double Point3::*const axis : axes_of_space) {
            const double moved = measure.volume > 0.0 ? sum.*axis / measure.volume : 0.0;
            // Of next to no volume rounding may lead out of it.
            const double x = std::clamp(place.*axis + moved, box.low.*axis, box.high.*axis);
            measure.centroid.*axis = in_plane(eye.*axis + x, 1);
        }
        measure.volume = in_plane(measure.volume, 3);
        measure.area = in_plane(measure.area, 2);
    }

    SpaceFaces faces_;
    Index size_;
    SpaceCells result_;
    LargeArray<Point3> apexes_;
    std::vector<std::uint8_t> touched_;
    std::vector<Found> found_;
};

}  // namespace

std::vector<bool> unbounded_cells(const SpaceTessellation& tessellation) {
    const bool are_flat = tessellation.dimension < 3;
    std::vector<bool> result(static_cast<std::size_t>(tessellation.sites), are_flat);
    for (const auto& [site, by] : tessellation.hidden)
        result[static_cast<std::size_t>(site)] = false;
    if (are_flat) return result;
    for (const auto& [a, b, c, d] : tessellation.cells)
        if (a == infinite)
            for (const Index site : {b, c, d}) result[static_cast<std::size_t>(site)] = true;
    return result;
}

Box3 default_box(std::span<const Site3> sites) {
    if (sites.empty()) throw std::invalid_argument("no site, no box");
    Box3 box = {{sites[0].x, sites[0].y, sites[0].z}, {sites[0].x, sites[0].y, sites[0].z}};
    for (const auto& [x, y, z, r] : sites) {
        const Point3 centre = {x, y, z};
        if (!are_finite(centre)) throw std::invalid_argument("a centre is not finite");
        for (const auto axis : axes_of_space) {
            box.low.*axis = std::min(box.low.*axis, centre.*axis);
            box.high.*axis = std::max(box.high.*axis, centre.*axis);
        }
    }
    double tenth = 0.0;  // of the longest side, which itself may be no double
    double extent = 0.0;
    bool is_point = true;
    for (const auto axis : axes_of_space) {
        tenth = std::max(tenth, (box.high.*axis / 2 - box.low.*axis / 2) / 5);
        extent = std::max({extent, std::fabs(box.low.*axis), std::fabs(box.high.*axis)});
        is_point &= box.low.*axis == box.high.*axis;
    }
    // Doubles are to tell its sides apart.
    constexpr double denormal = std::numeric_limits<double>::denorm_min();
    const double margin = std::max({is_point ? 1.0 : tenth, 0x1p-50 * extent, denormal});
    constexpr double largest = std::numeric_limits<double>::max();
    for (const auto axis : axes_of_space) {
        box.low.*axis = std::max(box.low.*axis - margin, -largest);
        box.high.*axis = std::min(box.high.*axis + margin, largest);
    }
    return box;
}

SpaceCells space_cells(const SpaceTessellation& tessellation, std::span<const Point3> sites,
                       const Box3& box) {
    return Measuring(tessellation, sites, box).run();
}
SpaceCells space_cells(const SpaceTessellation& tessellation, std::span<const Site3> sites,
                       const Box3& box) {
    return Measuring(tessellation, sites, box).run();
}
SpaceCells space_cells(const SpaceTessellation& tessellation, std::span<const power::Site3> sites,
                       const Box3& box) {
    return Measuring(tessellation, sites, box).run();
}

}  // namespace signum
