#include "tessellation.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <utility>

#include "../core/handle.hpp"
#include "../exact/floating_environment.hpp"
#include "../predicates/ccw.hpp"
#include "kernels/predicates_of.hpp"
#include "structure/corners.hpp"

namespace signum {
namespace {

std::size_t at(Index i) noexcept {
    return static_cast<std::size_t>(i);
}

/// Whether all numbers are less than `end`, the first of each triple `least_first` or more and the
/// others `least`: the signs of differences, put together without a branch.
bool are_within(std::span<const Face> triples, Index least_first, Index least,
                std::size_t end) noexcept {
    const std::uint32_t last = static_cast<std::uint32_t>(end) - 1;
    const auto outside = [last](Index i, Index from) {
        const auto number = static_cast<std::uint32_t>(i);
        return (number - static_cast<std::uint32_t>(from)) | (last - number);
    };
    std::uint32_t signs = 0;
    for (const Face& triple : triples)
        signs |=
            outside(triple[0], least_first) | outside(triple[1], least) | outside(triple[2], least);
    return signs >> 31 == 0;
}

/// Throws where a number names no site or face.
void expect_handles(const TessellationArrays& arrays, std::size_t sites) {
    const auto require = [](bool holds, const char* otherwise) {
        if (!holds) throw std::invalid_argument(otherwise);
    };
    const std::size_t faces = arrays.faces.size();
    require(arrays.neighbours.size() == faces || arrays.neighbours.empty(),
            "the neighbours are not those of as many faces");
    if (!are_within(arrays.faces, infinite, 0, sites))
        require(false, are_within(arrays.faces, infinite, infinite, sites)
                           ? "infinity is not the first vertex of its face"
                           : "a vertex of a face is no site");
    require(are_within(arrays.neighbours, 0, 0, faces), "a neighbour is no face");
    for (const Hidden& hidden : arrays.hidden)
        require(at(hidden.site) < sites && at(hidden.by) < sites,
                "a hidden site, or who hides it, is no site");
}

void expect_finite(Point point) {
    if (!std::isfinite(point.x) || !std::isfinite(point.y))
        throw std::invalid_argument("the point is not finite");
}

}  // namespace

Tessellation::Tessellation(TessellationArrays arrays, std::vector<Site> sites,
                           Statistics statistics)
    : arrays_(std::move(arrays)), sites_(std::move(sites)), statistics_(statistics) {
    expect_handles(arrays_, sites_.size());
    find_faces_of_sites();
}

Tessellation triangulation::constructed(TessellationArrays arrays, std::vector<Site> sites,
                                        const Statistics& statistics) {
    Tessellation result;
    result.arrays_ = std::move(arrays);
    result.sites_ = std::move(sites);
    result.statistics_ = statistics;
    result.find_faces_of_sites();
    return result;
}

void Tessellation::find_faces_of_sites() {
    face_of_site_.assign(sites_.size(), -1);
    for (std::size_t f = arrays_.faces.size(); f-- > 0;)
        for (const Index v : arrays_.faces[f])
            if (v != infinite) face_of_site_[at(v)] = static_cast<Index>(f);
}

void Tessellation::expect_neighbours() const {
    if (arrays_.neighbours.size() != arrays_.faces.size())
        throw std::invalid_argument("the tessellation was made without its neighbours");
}

std::vector<Edge> Tessellation::edges() const {
    std::vector<Edge> result;
    result.reserve(arrays_.faces.size() * 3 / 2);
    for (std::size_t f = 0; f < arrays_.faces.size(); ++f)
        for (std::size_t k = 0; k < 3; ++k) {
            // An edge is listed by that of its two faces in which it runs from smaller to larger.
            const Index from = arrays_.faces[f][(k + 1) % 3];
            const Index to = arrays_.faces[f][(k + 2) % 3];
            if (from < to) result.push_back({from, to});
        }
    std::sort(result.begin(), result.end());
    return result;
}

std::vector<Index> Tessellation::neighbours(Index site) const {
    expect_neighbours();
    std::vector<Index> result;
    const Index first = face_of_site_[checked("site", site, sites_.size())];
    if (first < 0) return result;
    for (const auto corner : triangulation::fan(arrays_, first, site))
        result.push_back(arrays_.faces[at(corner.face)][corner.next()]);
    std::rotate(result.begin(), std::min_element(result.begin(), result.end()), result.end());
    return result;
}

Index Tessellation::locate(Point point) const {
    expect_finite(point);
    expect_neighbours();
    const exact::IeeeEnvironment environment;
    if (arrays_.faces.empty()) return -1;
    return traits_of(metric()).edges_are_straight ? locate_straight(point)
                                                  : face_of_site_[at(nearest(point))];
}

Index Tessellation::locate_straight(Point point) const noexcept {
    Index f = face_of_site_[at(visible_sample(point))];
    if (arrays_.faces[at(f)][0] == infinite) f = arrays_.neighbours[at(f)][0];
    if (arrays_.faces[at(f)][0] == infinite) return locate_beside_line(point);
    // No face is visited twice (Edelsbrunner 1989), unless inexact arithmetic made the faces: then
    // any face has to do.
    for (std::size_t steps = arrays_.faces.size(); steps > 0; --steps) {
        const Face& face = arrays_.faces[at(f)];
        if (face[0] == infinite) break;
        std::size_t k = 0;
        while (k < 3 && ccw(centre(face[(k + 1) % 3]), centre(face[(k + 2) % 3]), point) >= 0) ++k;
        if (k == 3) break;
        f = arrays_.neighbours[at(f)][k];
    }
    return f;
}

Index Tessellation::nearest(Point point) const {
    expect_finite(point);
    expect_neighbours();
    const exact::IeeeEnvironment environment;
    if (sites_.empty()) return -1;
    if (arrays_.faces.empty()) {
        // One visible site: the only one that no entry of the sorted list names.
        Index visible = 0;
        for (const Hidden& hidden : arrays_.hidden)
            visible += static_cast<Index>(hidden.site == visible);
        return visible;
    }
    const auto is_nearer = triangulation::with_predicates(
        metric(), weight_is(), []<class Predicates>(Predicates) { return &Predicates::is_nearer; });
    const auto site = [&](Index i) -> const Site& { return sites_[at(i)]; };
    Index nearest = traits_of(metric()).edges_are_straight
                        ? arrays_.faces[at(locate_straight(point))][1]
                        : visible_sample(point);
    // Cells are star-shaped: every site but the nearest has a neighbour that is nearer, the one
    // whose cell the segment to the point enters.
    for (Index start = -1; start != nearest;) {
        start = nearest;
        for (const auto corner : triangulation::fan(arrays_, face_of_site_[at(start)], start)) {
            const Index v = arrays_.faces[at(corner.face)][corner.next()];
            if (v != infinite && is_nearer(point, site(v), v, site(nearest), nearest)) nearest = v;
        }
    }
    return nearest;
}

Point Tessellation::centre(Index site) const noexcept {
    return {sites_[at(site)].x, sites_[at(site)].y};
}

Index Tessellation::nearest_of_samples(Point point) const noexcept {
    const auto samples = static_cast<std::size_t>(std::cbrt(static_cast<double>(sites_.size())));
    Index nearest = 0;
    double least = HUGE_VAL;
    for (std::size_t i = 0; i < samples; ++i) {
        const auto v = static_cast<Index>(i * (sites_.size() / samples));
        const double distance = std::hypot(centre(v).x - point.x, centre(v).y - point.y);
        if (face_of_site_[at(v)] < 0 || !(distance < least)) continue;
        least = distance;
        nearest = v;
    }
    return nearest;
}

Index Tessellation::visible_sample(Point point) const noexcept {
    const Index sample = nearest_of_samples(point);
    // The second vertex of a face is never infinity.
    return face_of_site_[at(sample)] >= 0 ? sample : arrays_.faces.back()[1];
}

Index Tessellation::locate_beside_line(Point point) const noexcept {
    Index on_line = 0;
    for (std::size_t f = 0; f < arrays_.faces.size(); ++f) {
        const Point from = centre(arrays_.faces[f][2]);
        const Point to = centre(arrays_.faces[f][1]);
        const Sign side = ccw(from, to, point);
        if (side < 0) return static_cast<Index>(f);
        const auto order = [](Point p, Point q) { return p.x != q.x ? p.x < q.x : p.y <= q.y; };
        if (side == 0 && order(from, point) && order(point, to)) on_line = static_cast<Index>(f);
    }
    return on_line;
}

}  // namespace signum
