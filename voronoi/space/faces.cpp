#include "faces.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "../../core/parallel.hpp"
#include "../../exact/floating_environment.hpp"
#include "../../triangulation/space/cells.hpp"

namespace signum {
namespace {

/// What is narrower, of its distance from the site, may be nothing but the rounding of coordinates.
constexpr double least_share = 0x1p-40;
/// In the box's longest side, which is 1 to 2: what is no wider is nothing.
constexpr double least_width = 0x1p-45;

/// Whether one order of a cell's sites is an even permutation of the other.
[[nodiscard]] bool turns(const SpaceCell& cell, const SpaceCell& other) noexcept {
    bool is_even = true;
    SpaceCell left = cell;
    for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t m = k + 1; m < 4; ++m)
            if (left[m] == other[k]) {
                std::swap(left[k], left[m]);
                is_even = !is_even;
            }
    return is_even;
}

}  // namespace

SpaceFaces::SpaceFaces(const SpaceTessellation& tessellation, const AnySites3& sites,
                       const Box3& box, int threads)
    : SpaceFaces(std::make_shared<const All>(tessellation, sites, box, threads)) {}

SpaceFaces::SpaceFaces(std::shared_ptr<const All> all) : all_(std::move(all)) {
    seen_.resize(sites_.size(), 0);
}

// ---- vertices and stars ------------------------------------------------------------------------

SpaceFaces::All::All(const SpaceTessellation& tessellation, const AnySites3& of, const Box3& box,
                     int threads)
    : dimension(tessellation.dimension), sites(of, box) {
    if (tessellation.sites != static_cast<std::int64_t>(sites.size()))
        throw std::invalid_argument("a tessellation of another number of sites");
    cells.resize(tessellation.cells.size());
    const Workers workers(threads, cells.size());
    workers.each_range(cells.size(), [&](std::size_t begin, std::size_t end) {
        const exact::IeeeEnvironment environment;
        for (std::size_t c = begin; c < end; ++c) {
            cells[c] = {tessellation.cells[c], tessellation.neighbours[c], {}, 0};
            if (dimension == 3) place_vertex(cells[c]);
        }
    });
    collect_stars();
}

void SpaceFaces::All::place_vertex(Cell& cell) const {
    const auto& [first_site, second, third, fourth] = cell.sites;
    if (first_site < 0) {
        cell.where = infinite;
        return;
    }
    const ThreePlanes planes = {second, third, fourth};
    const Corner corner = sites.corner(first_site, planes);
    cell.vertex = corner.place;
    cell.where = sites.sides_beyond(first_site, planes, corner);
}

void SpaceFaces::All::collect_stars() {
    const auto size = static_cast<std::size_t>(dimension + 1);
    first.assign(sites.size() + 2, 0);
    // Cells with the vertex at infinity have it first.
    for (const auto& [four, neighbours, vertex, where] : cells)
        if (four[0] >= 0)
            for (std::size_t k = 0; k < size; ++k) ++first[static_cast<std::size_t>(four[k]) + 2];
    for (std::size_t s = 2; s < first.size(); ++s) first[s] += first[s - 1];
    star.resize(first.back());
    // The begin of each star moves to its end.
    for (std::size_t c = 0; c < cells.size(); ++c) {
        const SpaceCell& four = cells[c].sites;
        if (four[0] >= 0)
            for (std::size_t k = 0; k < size; ++k)
                star[first[static_cast<std::size_t>(four[k]) + 1]++] = static_cast<Index>(c);
    }
    first.pop_back();
}

std::span<const SpaceFaces::Neighbour> SpaceFaces::neighbours(Index i, Index least) {
    if (++round_ == 0) [[unlikely]] {
        std::ranges::fill(seen_, 0U);
        round_ = 1;
    }
    neighbours_.clear();
    for (const Index c : star(i))
        for (const Index v : cell(c).sites) {
            if (v <= least || v == i || v < 0) continue;
            std::uint32_t& seen = seen_[static_cast<std::size_t>(v)];
            if (seen == round_) continue;
            seen = round_;
            neighbours_.push_back({v, c});
        }
    return neighbours_;
}

// ---- one face ----------------------------------------------------------------------------------

/// All cells around the edge, with infinity's. Two of a cell's vertices are the edge's; the walk
/// leaves one of the others behind and keeps the last, and what is new is what is left.
void SpaceFaces::walk_around(Index i, const Neighbour& neighbour) {
    const Index edge = i ^ neighbour.site;
    const auto others = [&](const SpaceCell& four) {
        return four[0] ^ four[1] ^ four[2] ^ four[3] ^ edge;
    };
    const SpaceCell& start = cell(neighbour.cell).sites;
    Index behind = start[0];
    for (const Index v : start)
        if (v != i && v != neighbour.site) behind = v;
    Index ahead = others(start) ^ behind;
    // Counterclockwise seen along the edge from beyond: then these four turn as the cell does.
    if (!turns(start, {i, neighbour.site, behind, ahead})) std::swap(behind, ahead);
    ring_.clear();
    around_.clear();
    Index c = neighbour.cell;
    do {
        ring_.push_back(c);
        around_.push_back(ahead);
        c = cell(c).neighbours[spatial::place_of(behind, cell(c).sites)];
        behind = ahead;
        ahead ^= others(cell(c).sites);
    } while (c != neighbour.cell);
}

/// Of flat sites: who shares a cell with both, in the first one and in the one across from there.
void SpaceFaces::collect_around(Index i, const Neighbour& neighbour) {
    around_.clear();
    const auto is_third = [&](Index v) { return v >= 0 && v != i && v != neighbour.site; };
    const Cell& first = cell(neighbour.cell);
    for (std::size_t k = 0; k < first.sites.size(); ++k) {
        if (!is_third(first.sites[k])) continue;
        around_.push_back(first.sites[k]);
        const SpaceCell& across = cell(first.neighbours[k]).sites;
        if (across[0] < 0) continue;
        for (const Index v : across)
            if (is_third(v)) around_.push_back(v);
    }
}

const CutFace* SpaceFaces::cut(Index i, const Neighbour& neighbour) {
    const Index j = neighbour.site;
    corners_.clear();
    std::uint32_t all = 0;
    std::uint32_t any = infinite;
    if (dimension_ == 3) {
        walk_around(i, neighbour);
        all = all_sides;
        any = 0;
        for (const Index c : ring_) {
            const std::uint32_t bits = cell(c).where;
            all &= bits;
            any |= bits;
        }
        if (all != 0) return nullptr;
    }
    face_.normal = sites_.direction(i, j);
    if (any == 0) [[likely]] {
        join_vertices(i);
        measure();
        face_.is_narrow = is_narrow(false);
        return &face_;
    }
    if (dimension_ == 3) {
        start();
    } else {
        collect_around(i, neighbour);
        start_flat(i, j);
    }
    for (int number = 0; number < 6 && !corners_.empty(); ++number)
        if ((any & (infinite | 1U << number)) != 0) cut_by(i, j, Side(number));
    if (corners_.size() < 3) return nullptr;
    polygon_.clear();
    borders_.clear();
    for (const FaceCorner& each : corners_) {
        borders_.push_back(each.border);
        if (each.cell < 0) {
            polygon_.push_back(each.known.place);
        } else {
            const Cell& at = cell(each.cell);
            polygon_.push_back(plus(sites_.between_eyes(i, at.sites[0]), at.vertex));
        }
    }
    measure();
    face_.is_narrow = is_narrow(true);
    return &face_;
}

void SpaceFaces::join_vertices(Index i) {
    const Point3 eye = sites_.eye(i);
    polygon_.clear();
    borders_.assign(around_.begin(), around_.end());
    for (const Index c : ring_) {
        const auto& [four, neighbours, vertex, where] = cell(c);
        polygon_.push_back(plus(minus(sites_.eye(four[0]), eye), vertex));
    }
}

Box3 SpaceFaces::box_from(Index i) const noexcept {
    const Point3 eye = sites_.eye(i);
    return {minus(sites_.box().low, eye), minus(sites_.box().high, eye)};
}

// ---- where the box cuts ------------------------------------------------------------------------

void SpaceFaces::start() {
    for (std::size_t k = 0; k < ring_.size(); ++k)
        corners_.push_back({around_[k] < 0 ? at_infinity : around_[k],
                            (cell(ring_[k]).where & infinite) != 0 ? no_cell : ring_[k]});
}

/// Of flat sites all corners are at infinity: the ends of the lines that a third site makes, one
/// or two of them, and between them, or where there is none, whatever goes around the face.
void SpaceFaces::start_flat(Index i, Index j) {
    for (const Index k : around_) {
        corners_.push_back({k, no_cell});
        corners_.push_back({at_infinity, no_cell});
    }
    if (around_.size() == 1) {
        // Across the line, away from the third site.
        for (int axis = 0; axis < 3; ++axis)
            if (const Sign turn = sites_.sign_of_cross(i, j, around_.front(), axis); turn != 0) {
                corners_.push_back({at_infinity, direction(axis, turn > 0)});
                return;
            }
    }
    if (!around_.empty()) return;
    int steepest = 0;
    while (sites_.sign_of_offset(i, j, steepest) == 0) ++steepest;
    const bool is_up = sites_.sign_of_offset(i, j, steepest) > 0;
    const int one = (steepest + (is_up ? 1 : 2)) % 3;
    const int other = (steepest + (is_up ? 2 : 1)) % 3;
    for (const bool is_positive : {true, false})
        for (const int axis : {one, other})
            corners_.push_back({at_infinity, direction(axis, is_positive)});
}

/// Of a corner at infinity: the sign of the coordinate to which it tends. The cross product of the
/// face's normal with that of an edge, outward, is how the edge runs.
Sign SpaceFaces::sign_at_infinity(Index i, Index j, Index before, const FaceCorner& corner,
                                  int axis) const {
    const bool is_end = before != at_infinity;
    const Index border = is_end ? before : corner.border;
    if (border >= 0) {
        const Sign sign = sites_.sign_of_cross(i, j, border, axis);
        return is_end ? sign : -sign;
    }
    int across = 0;
    bool is_positive = false;
    if (border == at_infinity) {
        across = (-2 - corner.cell) / 2;
        is_positive = (-2 - corner.cell) % 2 != 0;
    } else {
        const Side side = Side::named(border);
        across = side.axis_number();
        is_positive = side.is_high() == is_end;
    }
    if (axis == across) return 0;
    const bool is_next = axis == (across + 1) % 3;
    const Sign sign = sites_.sign_of_offset(i, j, 3 - axis - across);
    return is_next == is_positive ? sign : -sign;
}

/// On a side is outside of it.
SpaceFaces::Where SpaceFaces::where_is(Index i, Index j, std::size_t corner, Side side) const {
    const auto told = [](bool is_outside) { return is_outside ? Where::outside : Where::inside; };
    const FaceCorner& at = corners_before_[corner];
    if (at.cell >= 0) return told((cell(at.cell).where >> side.number & 1U) != 0);
    const Index before =
        corners_before_[corner > 0 ? corner - 1 : corners_before_.size() - 1].border;
    const int axis = side.axis_number();
    const auto is_opposite = [&](Index border) {
        return border > at_infinity && is_box_side(border) &&
               Side::named(border).axis_number() == axis;
    };
    if (is_opposite(before) || is_opposite(at.border)) return Where::inside;
    if (before != at_infinity && at.border != at_infinity)
        return told(sites_.is_outside(i, {j, before, at.border}, at.known, side));
    if (const Sign sign = sign_at_infinity(i, j, before, at, axis); sign != 0)
        return told((sign > 0) == side.is_high());
    // It goes along the side. So does the whole line, or the whole plane, or else it may be either.
    const auto looked_up = [&](const ThreePlanes& planes) {
        return told(sites_.is_outside(i, planes, sites_.corner(i, planes), side));
    };
    const int next = (axis + 1) % 3;
    const int last = (axis + 2) % 3;
    const bool is_next = sites_.sign_of_offset(i, j, next) != 0;
    const bool is_last = sites_.sign_of_offset(i, j, last) != 0;
    if (!is_next && !is_last) return looked_up({j, Side(2 * next).name(), Side(2 * last).name()});
    const Index border = before != at_infinity ? before : at.border;
    if (border >= 0) {
        const bool is_along_next = sites_.sign_of_cross(i, j, border, next) != 0;
        return looked_up({j, border, Side(2 * (is_along_next ? next : last)).name()});
    }
    if (border == at_infinity) return Where::either;
    const int third = 3 - axis - Side::named(border).axis_number();
    return looked_up({j, border, Side(2 * third).name()});
}

/// A corner that a side has made.
SpaceFaces::FaceCorner SpaceFaces::made(Index i, Index j, Index before, Index border) const {
    FaceCorner result{border, no_cell};
    if (before == at_infinity || border == at_infinity) return result;
    result.known = sites_.corner(i, {j, before, border});
    const Box3 box = box_from(i);
    for (const Index each : {before, border})
        if (is_box_side(each)) {
            const Side side = Side::named(each);
            result.known.place.*side.axis() = side.of(box);
        }
    return result;
}

void SpaceFaces::cut_by(Index i, Index j, Side side) {
    corners_before_.swap(corners_);
    corners_.clear();
    const std::size_t size = corners_before_.size();
    where_.clear();
    std::size_t known = size;
    for (std::size_t k = 0; k < size; ++k) {
        where_.push_back(where_is(i, j, k, side));
        if (where_.back() != Where::either) known = k;
    }
    // As the one before it.
    for (std::size_t n = 1; n < size && known < size; ++n) {
        const std::size_t k = (known + n) % size;
        if (where_[k] == Where::either) where_[k] = where_[(known + n - 1) % size];
    }
    for (std::size_t k = 0; k < size; ++k) {
        const std::size_t next = k + 1 < size ? k + 1 : 0;
        const Index border = corners_before_[k].border;
        if (where_[k] != Where::outside) corners_.push_back(corners_before_[k]);
        if (where_[k] == where_[next]) continue;
        corners_.push_back(where_[next] == Where::outside ? made(i, j, border, side.name())
                                                          : made(i, j, side.name(), border));
    }
}

Index SpaceFaces::owner_of_box() const {
    Index best = -1;
    for (Index i = 0; i < static_cast<Index>(sites_.size()); ++i)
        if (is_visible(i) && (best < 0 || sites_.is_middle_nearer(best, i))) best = i;
    return best;
}

// ---- areas -------------------------------------------------------------------------------------

/// By triangles around the first point.
void SpaceFaces::measure() {
    const Point3& normal = face_.normal;
    const Point3& first = polygon_.front();
    Point3 before = minus(polygon_[1], first);
    Point3 moment;
    double area = 0.0;
    longest_square_ = dot(before, before);
    for (std::size_t k = 2; k < polygon_.size(); ++k) {
        const Point3 next = minus(polygon_[k], first);
        const double twice = dot(cross(before, next), normal);
        area += twice;
        moment = plus(moment, plus(before, next), twice);
        longest_square_ = std::max(longest_square_, dot(next, next));
        before = next;
    }
    face_.area = std::max(area, 0.0) / 2;
    face_.moment = plus(plus({}, moment, 1.0 / 6), first, face_.area);
}

bool SpaceFaces::is_narrow(bool is_cut) const noexcept {
    const double longest = std::sqrt(longest_square_);
    const double distance = length(polygon_.front()) + longest;
    return !(face_.area > least_share * distance * longest) ||
           (is_cut && !(face_.area > least_width * longest));
}

CutFace SpaceFaces::on_side(Side side, std::span<const SideStep> steps) {
    CutFace face{};
    double& outward = face.normal.*side.axis();
    outward = side.is_high() ? 1.0 : -1.0;
    const Point3& first = steps.front().from;
    Point3 moment;
    double area = 0.0;
    double longest_square = 0.0;
    for (const SideStep& step : steps) {
        const Point3 from = minus(step.from, first);
        const Point3 to = minus(step.to, first);
        const double twice = dot(cross(from, to), face.normal);
        area += twice;
        moment = plus(moment, plus(from, to), twice);
        longest_square = std::max({longest_square, dot(from, from), dot(to, to)});
    }
    face.area = std::max(area, 0.0) / 2;
    face.moment = plus(plus({}, moment, 1.0 / 6), first, face.area);
    face.is_narrow = !(face.area > least_width * std::sqrt(longest_square));
    return face;
}

}  // namespace signum
