#include "space_faces.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace signum {
namespace {

/// In the box's longest side, which is 1 to 2: what is no farther from a plane lies in it, and what
/// is no wider is nothing.
constexpr double on_plane = 0x1p-46;
constexpr double least_width = 0x1p-45;
/// What is narrower, of its distance from the site, may be nothing but the rounding of coordinates.
constexpr double least_share = 0x1p-40;
/// From where vertices are too far from the box.
constexpr double far_from_box = 8.0;

/// A plane across an axis: what lies outside the box is below a low side, above a high one.
struct Side {
    double Point3::*axis;
    bool is_high;
    explicit Side(int number) noexcept
        : axis(axes_of_space[number / 2]), is_high(number % 2 != 0) {}
    [[nodiscard]] double of(const Box3& box) const noexcept {
        return is_high ? box.high.*axis : box.low.*axis;
    }
    /// How far beyond the side.
    [[nodiscard]] double beyond(const Point3& p, double at) const noexcept {
        return is_high ? p.*axis - at : at - p.*axis;
    }
};

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

/// As SpaceFace::beyond.
[[nodiscard]] constexpr Index name_of_side(int number) noexcept {
    return static_cast<Index>(-1 - number);
}

}  // namespace

SpaceFaces::SpaceFaces(const SpaceTessellation& tessellation, const AnySites3& sites,
                       const Box3& box)
    : dimension_(tessellation.dimension), sites_(sites, box) {
    if (tessellation.sites != static_cast<std::int64_t>(sites_.size()))
        throw std::invalid_argument("a tessellation of another number of sites");
    cells_.reserve(tessellation.cells.size());
    for (std::size_t c = 0; c < tessellation.cells.size(); ++c) {
        cells_.push_back({tessellation.cells[c], tessellation.neighbours[c], {}, 0});
        if (dimension_ == 3) place_vertex(cells_.back());
    }
    collect_stars();
    seen_.resize(sites_.size(), 0);
}

// ---- vertices and stars ------------------------------------------------------------------------

void SpaceFaces::place_vertex(Cell& cell) const {
    if (cell.sites[0] < 0) {
        cell.where = far | (beyond_any * at_low_x);
        return;
    }
    cell.vertex = vertex_of(cell.sites);
    cell.where = where(plus(sites_[cell.sites[0]].centre, cell.vertex));
}

/// The point where three planes meet: m.v is h for each row of three. By Cramer's rule, and one
/// step of refinement: so it lies within rounding of all three, however they meet. Nothing where
/// the determinant is below `least` of what it might be, both squared.
bool SpaceFaces::meet(const std::array<Point3, 3>& m, const std::array<double, 3>& h, double least,
                      Point3& v) noexcept {
    const Point3 bc = cross(m[1], m[2]);
    const Point3 ca = cross(m[2], m[0]);
    const Point3 ab = cross(m[0], m[1]);
    const double determinant = dot(m[0], bc);
    const double squares = dot(m[0], m[0]) * dot(m[1], m[1]) * dot(m[2], m[2]);
    // Neither an overflow nor a NaN gets through.
    if (!(determinant * determinant > least * squares) || !(squares > 0x1p-900)) [[unlikely]]
        return false;
    const double inverse = 1.0 / determinant;
    const auto solve = [&](double i, double j, double k) -> Point3 {
        return {(i * bc.x + j * ca.x + k * ab.x) * inverse,
                (i * bc.y + j * ca.y + k * ab.y) * inverse,
                (i * bc.z + j * ca.z + k * ab.z) * inverse};
    };
    const Point3 first = solve(h[0], h[1], h[2]);
    v = plus(first,
             solve(h[0] - dot(m[0], first), h[1] - dot(m[1], first), h[2] - dot(m[2], first)));
    return true;
}

/// By the planes between the first site and the others. Where two of these are nearly parallel, the
/// planes of the shortest edges that join the four sites say it better; and where the sites are
/// nearly coplanar, rationals.
Point3 SpaceFaces::vertex_of(const SpaceCell& cell) const {
    const auto height = [&](Index from, Index to, const Point3& offset) {
        return (dot(offset, offset) - sites_.weight_difference(from, to)) / 2;
    };
    std::array<Point3, 3> m;
    std::array<double, 3> h;
    for (std::size_t k = 0; k < 3; ++k) {
        m[k] = sites_.offset(cell[0], cell[k + 1]);
        h[k] = height(cell[0], cell[k + 1], m[k]);
    }
    Point3 v;
    if (meet(m, h, 0x1p-20, v)) [[likely]]
        return v;
    struct Edge {
        std::size_t from;
        std::size_t to;
        double square;
    };
    std::array<Edge, 6> edges;
    std::size_t size = 0;
    for (std::size_t from = 0; from < 4; ++from)
        for (std::size_t to = from + 1; to < 4; ++to) {
            const Point3 offset = sites_.offset(cell[from], cell[to]);
            edges[size++] = {from, to, dot(offset, offset)};
        }
    std::ranges::sort(edges, {}, &Edge::square);
    std::array<std::size_t, 4> part = {0, 1, 2, 3};
    size = 0;
    for (const auto& [from, to, square] : edges) {
        if (part[from] == part[to]) continue;
        std::ranges::replace(part, std::size_t{part[to]}, std::size_t{part[from]});
        m[size] = sites_.offset(cell[from], cell[to]);
        h[size] = height(cell[from], cell[to], m[size]) +
                  dot(m[size], sites_.offset(cell[0], cell[from]));
        ++size;
    }
    return meet(m, h, 0x1p-48, v) ? v : sites_.exact_vertex(cell);
}

std::uint32_t SpaceFaces::where(const Point3& p) const noexcept {
    const Box3& box = sites_.box();
    std::uint32_t result = 0;
    const auto look = [&](double low, double x, double high, unsigned axis) {
        const auto bit = [&](bool is_set, std::uint32_t first) {
            return static_cast<std::uint32_t>(is_set) * first;
        };
        const std::uint32_t two =
            bit(x < low - on_plane, beyond_low_x) | bit(x > high + on_plane, beyond_low_x << 1) |
            bit(x <= low + on_plane, at_low_x) | bit(x >= high - on_plane, at_low_x << 1);
        result |= two << 2 * axis;
        result |= bit(x < low - far_from_box || x > high + far_from_box, far);
    };
    look(box.low.x, p.x, box.high.x, 0);
    look(box.low.y, p.y, box.high.y, 1);
    look(box.low.z, p.z, box.high.z, 2);
    return result;
}

void SpaceFaces::collect_stars() {
    const auto size = static_cast<std::size_t>(dimension_ + 1);
    first_.assign(sites_.size() + 2, 0);
    // Cells with the vertex at infinity have it first.
    for (const auto& [four, neighbours, vertex, where] : cells_)
        if (four[0] >= 0)
            for (std::size_t k = 0; k < size; ++k) ++first_[static_cast<std::size_t>(four[k]) + 2];
    for (std::size_t s = 2; s < first_.size(); ++s) first_[s] += first_[s - 1];
    star_.resize(first_.back());
    // The begin of each star moves to its end.
    for (std::size_t c = 0; c < cells_.size(); ++c) {
        const SpaceCell& four = cells_[c].sites;
        if (four[0] >= 0)
            for (std::size_t k = 0; k < size; ++k)
                star_[first_[static_cast<std::size_t>(four[k]) + 1]++] = static_cast<Index>(c);
    }
    first_.pop_back();
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
        const SpaceCell& four = cell(c).sites;
        const auto place = static_cast<std::size_t>(behind == four[1]) +
                           2 * static_cast<std::size_t>(behind == four[2]) +
                           3 * static_cast<std::size_t>(behind == four[3]);
        c = cell(c).neighbours[place];
        behind = ahead;
        ahead ^= others(cell(c).sites);
    } while (c != neighbour.cell);
}

/// Of flat sites: who shares a cell with both.
void SpaceFaces::collect_around(Index i, Index j) {
    around_.clear();
    for (const Index c : star(i)) {
        const SpaceCell& four = cell(c).sites;
        if (std::ranges::find(four, j) == four.end()) continue;
        for (const Index v : four)
            if (v >= 0 && v != i && v != j) around_.push_back(v);
    }
}

const CutFace* SpaceFaces::cut(Index i, const Neighbour& neighbour) {
    const Index j = neighbour.site;
    touched_ = 0;
    std::uint32_t all = 0;
    std::uint32_t any = far;
    if (dimension_ == 3) {
        walk_around(i, neighbour);
        all = beyond_any;
        any = 0;
        for (const Index c : ring_) {
            const std::uint32_t bits = cell(c).where;
            all &= bits;
            any |= bits;
        }
        if (all != 0) return nullptr;
    } else {
        collect_around(i, j);
    }
    face_.plane = sites_.bisector(i, j);
    if ((any & far) != 0) {
        cut_section(i, j);
    } else {
        join_vertices(i);
        touched_ = any / at_low_x;
        if (touched_ == 0) {
            measure();
            face_.is_narrow = is_narrow(false);
            return &face_;
        }
        cut_by_box(i, touched_);
    }
    if (polygon_.size() < 3) return nullptr;
    measure();
    face_.is_narrow = is_narrow(true);
    if ((any & far) != 0) {
        const Box3 box = box_from(i);
        for (int number = 0; number < 6; ++number) {
            const Side side(number);
            for (const Point3& p : polygon_)
                if (side.beyond(p, side.of(box)) >= -on_plane) touched_ |= 1U << number;
        }
    }
    return &face_;
}

void SpaceFaces::join_vertices(Index i) {
    const Point3& eye = sites_[i].centre;
    polygon_.clear();
    borders_.assign(around_.begin(), around_.end());
    for (const Index c : ring_) {
        const auto& [four, neighbours, vertex, where] = cell(c);
        polygon_.push_back(plus(minus(sites_[four[0]].centre, eye), vertex));
    }
}

Box3 SpaceFaces::box_from(Index i) const noexcept {
    const Point3& eye = sites_[i].centre;
    return {minus(sites_.box().low, eye), minus(sites_.box().high, eye)};
}

Point3 SpaceFaces::point_near_cell(Index i) const noexcept {
    Point3 corner;
    if (dimension_ == 3)
        for (const Index c : star(i)) {
            const auto& [four, neighbours, vertex, where] = cell(c);
            if ((where & far) != 0) continue;
            corner = plus(sites_.offset(i, four[0]), vertex);
            if (where == 0) return corner;
        }
    const Box3 box = box_from(i);
    return {std::clamp(corner.x, box.low.x, box.high.x),
            std::clamp(corner.y, box.low.y, box.high.y),
            std::clamp(corner.z, box.low.z, box.high.z)};
}

/// The polygon the other way around.
void SpaceFaces::turn() {
    std::ranges::reverse(polygon_);
    // A border lies behind its point, which now is in front of it.
    std::reverse(borders_.begin(), borders_.end() - 1);
}

/// The box seen along an axis, counterclockwise from above.
void SpaceFaces::start_with_rectangle(const Box3& box, int axis) {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    polygon_.assign(4, box.low);
    polygon_[1].*axes_of_space[u] = polygon_[2].*axes_of_space[u] = box.high.*axes_of_space[u];
    polygon_[2].*axes_of_space[v] = polygon_[3].*axes_of_space[v] = box.high.*axes_of_space[v];
    borders_ = {name_of_side(2 * v), name_of_side(2 * u + 1), name_of_side(2 * v + 1),
                name_of_side(2 * u)};
}

/// By where k is as near as i and j are, in their bisecting plane: of the two planes that tell, the
/// one that is less parallel to it; by both where both nearly are, for then one may coincide with
/// it, and the other lie far away.
void SpaceFaces::cut_across(Index i, Index j, Index k) {
    const Bisector one = sites_.bisector(i, k);
    Bisector other = sites_.bisector(j, k);
    other.height += dot(other.normal, sites_.offset(i, j));
    const double slope = std::fabs(dot(one.normal, face_.plane.normal));
    const double other_slope = std::fabs(dot(other.normal, face_.plane.normal));
    constexpr double nearly_parallel = 1.0 - 0x1p-30;
    const bool are_both = std::min(slope, other_slope) > nearly_parallel;
    if (are_both || slope <= other_slope) cut_by(one, k);
    if (are_both || slope > other_slope)
        if (!polygon_.empty()) cut_by(other, k);
}

/// The box's section along the plane, as a function over the two axes along which it is least
/// steep, cut by the planes of the sites around.
void SpaceFaces::cut_section(Index i, Index j) {
    const auto& [normal, height, unused] = face_.plane;
    const Box3 box = box_from(i);
    int steepest = 0;
    for (int axis = 1; axis < 3; ++axis)
        if (std::fabs(normal.*axes_of_space[axis]) > std::fabs(normal.*axes_of_space[steepest]))
            steepest = axis;
    double Point3::*const up = axes_of_space[steepest];
    double Point3::*const u = axes_of_space[(steepest + 1) % 3];
    double Point3::*const v = axes_of_space[(steepest + 2) % 3];
    start_with_rectangle(box, steepest);
    for (Point3& p : polygon_)
        p.*up = (height - normal.*u * (p.*u) - normal.*v * (p.*v)) / normal.*up;
    if (normal.*up < 0.0) turn();
    // In a side of the box it is no face, but one of the cells has the side.
    for (const int number : {2 * steepest, 2 * steepest + 1}) {
        const double at = Side(number).of(box);
        if (std::ranges::all_of(polygon_,
                                [&](const Point3& p) { return std::fabs(p.*up - at) <= on_plane; }))
            touched_ |= 1U << number;
    }
    cut_by_box(i, 3U << 2 * steepest);
    for (const Index k : around_)
        if (k >= 0 && !polygon_.empty()) cut_across(i, j, k);
}

/// What is left of the polygon where distances are not positive: nothing, unless some point is on
/// the good side. `put(p)` moves a point onto the plane, to which `beyond` is the name.
template <class Put>
void SpaceFaces::keep_below(Index beyond, const Put& put) {
    points_before_.swap(polygon_);
    borders_before_.swap(borders_);
    polygon_.clear();
    borders_.clear();
    if (std::ranges::none_of(distances_, [](double d) { return d < -on_plane; })) return;
    const std::size_t size = points_before_.size();
    const auto add = [&](const Point3& p, Index border) {
        polygon_.push_back(p);
        borders_.push_back(border);
    };
    for (std::size_t k = 0; k < size; ++k) {
        const std::size_t next = k + 1 < size ? k + 1 : 0;
        const double from = distances_[k];
        const double to = distances_[next];
        const bool is_on = std::fabs(from) <= on_plane;
        if (from <= on_plane) {
            add(points_before_[k], is_on && to > on_plane ? beyond : borders_before_[k]);
            if (is_on) put(polygon_.back());
        }
        const bool leaves = from < -on_plane && to > on_plane;
        if (leaves || (from > on_plane && to < -on_plane)) {
            add(plus(points_before_[k], minus(points_before_[next], points_before_[k]),
                     from / (from - to)),
                leaves ? beyond : borders_before_[k]);
            put(polygon_.back());
        }
    }
}

void SpaceFaces::cut_by_box(Index i, std::uint32_t sides) {
    const Box3 box = box_from(i);
    for (int number = 0; number < 6 && !polygon_.empty(); ++number) {
        if ((sides >> number & 1U) == 0) continue;
        const Side side(number);
        const double at = side.of(box);
        distances_.clear();
        for (const Point3& p : polygon_) distances_.push_back(side.beyond(p, at));
        keep_below(name_of_side(number), [&](Point3& p) { p.*side.axis = at; });
    }
}

/// False where all of the polygon lies in the plane; it is left as it is.
bool SpaceFaces::cut_by(const Bisector& plane, Index beyond) {
    distances_.clear();
    for (const Point3& p : polygon_) distances_.push_back(dot(plane.normal, p) - plane.height);
    if (std::ranges::all_of(distances_, [](double d) { return std::fabs(d) <= on_plane; }))
        return false;
    keep_below(beyond, [](Point3&) {});
    return true;
}

const CutFace* SpaceFaces::cut_side(Index i, int number, std::span<const Neighbour> neighbours) {
    const Side side(number);
    const Box3 box = box_from(i);
    const double outward = side.is_high ? 1.0 : -1.0;
    face_.plane = {};
    face_.plane.normal.*side.axis = outward;
    face_.plane.height = outward * side.of(box);
    start_with_rectangle(box, number / 2);
    for (Point3& p : polygon_) p.*side.axis = side.of(box);
    for (const Neighbour& each : neighbours) {
        const Bisector plane = sites_.bisector(i, each.site);
        // Where the side itself is the plane, the cell lies within the box or outside.
        if (!cut_by(plane, each.site) && dot(plane.normal, face_.plane.normal) < 0.0)
            polygon_.clear();
        if (polygon_.size() < 3) return nullptr;
    }
    if (!side.is_high) turn();
    measure();
    face_.is_narrow = is_narrow(true);
    return &face_;
}

// ---- areas -------------------------------------------------------------------------------------

/// By triangles around the first point.
void SpaceFaces::measure() {
    const Point3& normal = face_.plane.normal;
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
    face_.area = std::fabs(area) / 2;
    face_.moment = plus(plus({}, moment, area < 0.0 ? -1.0 / 6 : 1.0 / 6), first, face_.area);
}

bool SpaceFaces::is_narrow(bool is_cut) const noexcept {
    const double longest = std::sqrt(longest_square_);
    const double distance = length(polygon_.front()) + longest;
    return !(face_.area > least_share * distance * longest) ||
           (is_cut && !(face_.area > least_width * longest));
}

}  // namespace signum
