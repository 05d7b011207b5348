#include "cells.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "../../core/parallel.hpp"
#include "../../exact/floating_environment.hpp"
#include "../../triangulation/structure/curve_order.hpp"
#include "faces.hpp"

namespace signum {
namespace {

class Measuring {
 public:
    Measuring(const SpaceTessellation& tessellation, const AnySites3& sites, const Box3& box,
              int threads)
        : workers_(threads,
                   static_cast<std::size_t>(std::max<std::int64_t>(tessellation.sites, 0))),
          faces_(tessellation, sites, box, threads) {
        result_.box = box;
        result_.measures.resize(faces_.sites().size());
        found_.reserve(8 * faces_.sites().size());
        apexes_.resize(faces_.sites().size());
        has_apex_.resize(faces_.sites().size(), 0);
    }

    [[nodiscard]] SpaceCells run() && {
        const LargeArray<Index> order = along_curve();
        if (workers_.count() == 1) {
            cut_faces(faces_, rims_, order, 0, order.size(), [this](const Cut& cut) {
                note(cut, found_);
                add_to_first(cut);
                add_to_second(cut);
            });
        } else {
            // Of so many sites at a time: their faces stay near the processor, and in little
            // memory.
            constexpr std::size_t at_a_time = std::size_t{1} << 14;
            std::vector<SpaceFaces> own;
            std::vector<Stretch> stretches;
            for (std::size_t k = 0; k < order.size(); k += at_a_time)
                add_together(order, k, std::min(k + at_a_time, order.size()), own, stretches);
        }
        measure_sides();
        list_faces();
        workers_.each_range(has_apex_.size(), [this](std::size_t begin, std::size_t end) {
            const exact::IeeeEnvironment environment;
            for (std::size_t s = begin; s < end; ++s) finish(static_cast<Index>(s));
        });
        return std::move(result_);
    }

 private:
    /// A face and its two cells; of a side of the box the second one is that side.
    struct Found {
        Index first;
        Index second;
        double area;
    };

    struct EndOfCell {
        Index site;
        EdgeEnd end;
    };

    /// What faces leave on the sides of the box.
    struct Rims {
        std::vector<SideStep> steps;
        std::vector<EndOfCell> ends;
    };

    /// Near sites after one another, so that most of what a site looks at has been looked at. Which
    /// of two comes first depends on the two and on the box alone, and so do sums.
    [[nodiscard]] LargeArray<Index> along_curve() const {
        constexpr CurveKeys layout{28, 12};  // of 2^28 sites at the most
        std::array<AxisRange, 3> ranges;
        for (std::size_t k = 0; k < 3; ++k) {
            ranges[k].include(faces_.sites().box().low.*axes_of_space[k]);
            ranges[k].include(faces_.sites().box().high.*axes_of_space[k]);
        }
        LargeArray<std::uint64_t> keys(has_apex_.size());
        workers_.each_range(keys.size(), [&](std::size_t begin, std::size_t end) {
            const exact::IeeeEnvironment environment;
            for (std::size_t i = begin; i < end; ++i) {
                const Point3 eye = faces_.sites().eye(static_cast<Index>(i));
                std::array<std::uint32_t, 3> cell;
                for (std::size_t k = 0; k < 3; ++k)
                    cell[k] = ranges[k].cell(eye.*axes_of_space[k], layout.axis_bits);
                keys[i] = HilbertCurve<3>::place(cell, layout.axis_bits) << layout.item_bits | i;
            }
        });
        boost::sort::pdqsort_branchless(keys.begin(), keys.end());
        LargeArray<Index> order(keys.size());
        for (std::size_t i = 0; i < keys.size(); ++i)
            order[i] = static_cast<Index>(layout.item(keys[i]));
        return order;
    }
    /// A face between two sites, seen from the first, and one of its corners.
    struct Cut {
        Index i;
        Index j;
        CutFace face;
        Point3 corner;
    };
    /// The faces of a stretch of the order, each told by its lesser site.
    template <class Put>
    static void cut_faces(SpaceFaces& faces, Rims& rims, const LargeArray<Index>& order,
                          std::size_t begin, std::size_t end, const Put& put) {
        for (std::size_t k = begin; k < end; ++k) {
            const Index i = order[k];
            if (k + 1 < order.size()) faces.prefetch(order[k + 1]);
            for (const auto& neighbour : faces.neighbours(i, i)) {
                const CutFace* const face = faces.cut(i, neighbour);
                if (face == nullptr) continue;
                put(Cut{i, neighbour.site, *face, faces.polygon().front()});
                if (faces.is_at_box()) [[unlikely]]
                    keep_rims(faces, rims, i, neighbour.site);
            }
        }
    }
    /// What one thread cuts of a stretch, and which sides of it go to which bucket of sites.
    struct Stretch {
        std::vector<Cut> cuts;
        std::vector<Found> found;
        std::vector<std::vector<std::uint32_t>> sides;
        Rims rims;

        void clear(std::size_t buckets) {
            cuts.clear();
            found.clear();
            rims = {};
            sides.resize(buckets);
            for (auto& of_bucket : sides) of_bucket.clear();
        }
    };
    /// The same by several threads: each face to both its cells in the order in which one thread
    /// would come by it, for sums are rounded.
    void add_together(const LargeArray<Index>& order, std::size_t begin, std::size_t end,
                      std::vector<SpaceFaces>& own, std::vector<Stretch>& stretches) {
        const std::size_t size = end - begin;
        const std::size_t ranges = workers_.range_count(size);
        while (own.size() < ranges) own.push_back(faces_.another());
        stretches.resize(std::max(stretches.size(), ranges));
        // A bucket has all sides of some sites; neighbours in memory are in one.
        const std::size_t buckets = 4 * static_cast<std::size_t>(workers_.count());
        constexpr std::size_t together = 256;
        const auto bucket = [&](Index site) {
            return static_cast<std::size_t>(site) / together % buckets;
        };
        workers_.each(ranges, [&](std::size_t range) {
            const exact::IeeeEnvironment environment;
            Stretch stretch = std::move(stretches[range]);
            stretch.clear(buckets);
            const auto put = [&](const Cut& cut) {
                const auto side = static_cast<std::uint32_t>(2 * stretch.cuts.size());
                stretch.cuts.push_back(cut);
                stretch.sides[bucket(cut.i)].push_back(side);
                stretch.sides[bucket(cut.j)].push_back(side + 1);
                note(cut, stretch.found);
            };
            cut_faces(own[range], stretch.rims, order, begin + size * range / ranges,
                      begin + size * (range + 1) / ranges, put);
            stretches[range] = std::move(stretch);
        });
        workers_.each(buckets, [&](std::size_t of_bucket) {
            const exact::IeeeEnvironment environment;
            for (std::size_t range = 0; range < ranges; ++range)
                for (const std::uint32_t side : stretches[range].sides[of_bucket]) {
                    const Cut& cut = stretches[range].cuts[side / 2];
                    side % 2 == 0 ? add_to_first(cut) : add_to_second(cut);
                }
        });
        const auto append = [](auto& all, const auto& more) {
            all.insert(all.end(), more.begin(), more.end());
        };
        for (std::size_t range = 0; range < ranges; ++range) {
            append(found_, stretches[range].found);
            append(rims_.steps, stretches[range].rims.steps);
            append(rims_.ends, stretches[range].rims.ends);
        }
    }
    static void note(const Cut& cut, std::vector<Found>& found) {
        if (!cut.face.is_narrow) found.push_back({cut.i, cut.j, cut.face.area});
    }
    void add_to_first(const Cut& cut) noexcept {
        add(cut.i, cut.face.normal, cut.corner, cut.face, {});
    }
    void add_to_second(const Cut& cut) noexcept {
        add(cut.j, plus({}, cut.face.normal, -1.0), cut.corner, cut.face,
            faces_.sites().between_eyes(cut.i, cut.j));
    }

    [[nodiscard]] SpaceMeasure& measure_of(Index i) noexcept {
        return result_.measures[static_cast<std::size_t>(i)];
    }
    /// The cone over a face, its normal turned outward; `offset` leads from where the face and a
    /// corner of it were seen to site i. Cones of a cell begin at a corner of its first face, so
    /// that of a small cell far from its site the rounding of faces is not multiplied by that
    /// distance.
    void add(Index i, const Point3& normal, const Point3& corner, const CutFace& face,
             const Point3& offset) noexcept {
        const auto s = static_cast<std::size_t>(i);
        if (has_apex_[s] == 0) {
            has_apex_[s] = 1;
            apexes_[s] = minus(corner, offset);
        }
        const Point3 from = plus(offset, apexes_[s]);
        const double over = dot(normal, minus(corner, from));
        SpaceMeasure& measure = measure_of(i);
        if (!face.is_narrow) measure.area += face.area;
        measure.volume += over * face.area / 3;
        measure.centroid = plus(measure.centroid, plus(face.moment, from, -face.area), over / 4);
    }

    // ---- sides of the box ----------------------------------------------------------------------

    /// What the last face leaves on the sides: a step for each of its two cells, in which their
    /// rims run against the face.
    static void keep_rims(const SpaceFaces& faces, Rims& rims, Index i, Index j) {
        const auto polygon = faces.polygon();
        const auto borders = faces.borders();
        const Point3 offset = faces.sites().between_eyes(i, j);
        for (std::size_t k = 0; k < polygon.size(); ++k) {
            if (!is_box_side(borders[k])) continue;
            const int side = Side::named(borders[k]).number;
            const Point3& from = polygon[k];
            const Point3& to = polygon[k + 1 < polygon.size() ? k + 1 : 0];
            rims.steps.push_back({i, side, to, from});
            rims.steps.push_back({j, side, minus(from, offset), minus(to, offset)});
        }
        faces.for_ends_on_edges(i, j, [&](const EdgeEnd& end) {
            rims.ends.push_back({i, end});
            EdgeEnd other = end;
            other.is_high = !end.is_high;
            other.place = minus(end.place, offset);
            rims.ends.push_back({j, other});
        });
    }
    /// The parts of the box's edges close the rims.
    void measure_sides() {
        std::ranges::sort(rims_.ends, {}, &EndOfCell::site);
        if (rims_.ends.empty()) {
            if (const Index owner = faces_.owner_of_box(); owner >= 0) add_edges(owner, {}, true);
        }
        std::vector<EdgeEnd> of_cell;
        for (std::size_t k = 0; k < rims_.ends.size();) {
            const Index i = rims_.ends[k].site;
            for (of_cell.clear(); k < rims_.ends.size() && rims_.ends[k].site == i; ++k)
                of_cell.push_back(rims_.ends[k].end);
            add_edges(i, of_cell, false);
        }
        const auto of = [](const SideStep& step) { return std::pair(step.site, step.side); };
        std::ranges::stable_sort(rims_.steps, {}, of);
        for (std::size_t k = 0; k < rims_.steps.size();) {
            std::size_t last = k;
            while (last < rims_.steps.size() && of(rims_.steps[last]) == of(rims_.steps[k])) ++last;
            const auto [i, number, from, to] = rims_.steps[k];
            const CutFace face =
                SpaceFaces::on_side(Side(number), std::span(rims_.steps).subspan(k, last - k));
            if (!face.is_narrow) found_.push_back({i, Side(number).name(), face.area});
            add(i, face.normal, from, face, {});
            k = last;
        }
    }
    void add_edges(Index i, std::span<const EdgeEnd> ends, bool is_whole_box) {
        const Box3 box = faces_.box_from(i);
        for (const EdgePart& part : edge_parts(ends, is_whole_box)) {
            const auto [low, high] = ends_of(part, box);
            for (const Side side : {part.edge.next(), part.edge.last()}) {
                const bool is_up = side.number == side_around_which_up(part.edge).number;
                rims_.steps.push_back({i, side.number, is_up ? low : high, is_up ? high : low});
            }
        }
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
        workers_.each_range(first.size() - 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t s = begin; s < end; ++s)
                std::sort(result_.faces.begin() + first[s], result_.faces.begin() + first[s + 1],
                          [](const SpaceFace& a, const SpaceFace& b) {
                              return (a.beyond < 0) != (b.beyond < 0) ? b.beyond < 0
                                     : a.beyond < 0                   ? a.beyond > b.beyond
                                                                      : a.beyond < b.beyond;
                          });
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
        const Point3 place = measure.volume > 0.0 ? apexes_[static_cast<std::size_t>(i)] : Point3{};
        const Point3 eye = faces_.sites().eye(i);
        for (double Point3::*const axis : axes_of_space) {
            const double moved = measure.volume > 0.0 ? sum.*axis / measure.volume : 0.0;
            // Of next to no volume rounding may lead out of it.
            const double x = std::clamp(place.*axis + moved, box.low.*axis, box.high.*axis);
            measure.centroid.*axis = in_plane(eye.*axis + x, 1);
        }
        measure.volume = in_plane(measure.volume, 3);
        measure.area = in_plane(measure.area, 2);
    }

    Workers workers_;
    SpaceFaces faces_;
    SpaceCells result_;
    LargeArray<Point3> apexes_;
    std::vector<char> has_apex_;
    std::vector<Found> found_;
    Rims rims_;
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

namespace {

/// Point3, Site3 or power::Site3.
template <class S>
Box3 box_around(std::span<const S> sites) {
    const exact::IeeeEnvironment environment;
    if (sites.empty()) throw std::invalid_argument("no site, no box");
    Box3 box = {{sites[0].x, sites[0].y, sites[0].z}, {sites[0].x, sites[0].y, sites[0].z}};
    for (const S& site : sites) {
        const Point3 centre = {site.x, site.y, site.z};
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

}  // namespace

Box3 default_box(std::span<const Point3> sites) {
    return box_around(sites);
}
Box3 default_box(std::span<const Site3> sites) {
    return box_around(sites);
}
Box3 default_box(std::span<const power::Site3> sites) {
    return box_around(sites);
}

SpaceCells space_cells(const SpaceTessellation& tessellation, std::span<const Point3> sites,
                       const Box3& box, int threads) {
    const exact::IeeeEnvironment environment;
    return Measuring(tessellation, sites, box, threads).run();
}
SpaceCells space_cells(const SpaceTessellation& tessellation, std::span<const Site3> sites,
                       const Box3& box, int threads) {
    const exact::IeeeEnvironment environment;
    return Measuring(tessellation, sites, box, threads).run();
}
SpaceCells space_cells(const SpaceTessellation& tessellation, std::span<const power::Site3> sites,
                       const Box3& box, int threads) {
    const exact::IeeeEnvironment environment;
    return Measuring(tessellation, sites, box, threads).run();
}

}  // namespace signum
