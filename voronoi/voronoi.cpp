#include "voronoi.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "../core/groups.hpp"
#include "../core/parallel.hpp"
#include "../exact/floating_environment.hpp"
#include "../triangulation/kernels/predicates_of.hpp"
#include "../triangulation/structure/corners.hpp"
#include "far_end.hpp"
#include "in_ieee.hpp"
#include "vector.hpp"

namespace signum {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

/// Whether q touches the circle of a face, exactly.
bool touches(const Tessellation& t, const Face& face, Index q) {
    const std::array<Index, 4> numbers = {face[0], face[1], face[2], q};
    std::array<const Site*, 4> sites{};
    for (std::size_t m = 0; m < 4; ++m) sites[m] = &t.sites()[static_cast<std::size_t>(numbers[m])];
    return triangulation::touches(t.metric(), t.weight_is(), sites, numbers);
}

/// The same tessellation, its lengths divided by 2^exponent, which is to be below 0: so nothing is
/// rounded. Nothing where a weight leaves the doubles.
std::optional<Tessellation> divided(const Tessellation& t, int exponent) {
    std::vector<Site> sites(t.sites().begin(), t.sites().end());
    const int of_weights = t.weight_is() == WeightIs::weight ? 2 * exponent : exponent;
    for (Site& s : sites) {
        s = {std::ldexp(s.x, -exponent), std::ldexp(s.y, -exponent), std::ldexp(s.r, -of_weights)};
        if (!std::isfinite(s.r)) return std::nullopt;
    }
    return Tessellation(t.arrays(), std::move(sites), {});
}

/// Of each face the first of those whose circle is the same, told from neighbour to neighbour.
std::vector<std::size_t> alike_faces(const Tessellation& t, std::span<const DiagramVertex> of_face,
                                     const Workers& workers) {
    using Pair = std::pair<std::size_t, std::size_t>;
    const auto faces = t.faces();
    const auto find = [&](std::size_t begin, std::size_t end, std::vector<Pair>& alike) {
        const exact::IeeeEnvironment environment;
        for (std::size_t f = begin; f < end; ++f) {
            if (!are_finite(of_face[f])) continue;
            for (std::size_t k = 0; k < 3; ++k) {
                const auto g = static_cast<std::size_t>(t.neighbours()[f][k]);
                if (g < f || !are_finite(of_face[g])) continue;
                const auto corner = triangulation::across(t.arrays(), {static_cast<Index>(f), k});
                // Where many squares touch, those of two faces may differ.
                const bool same = of_face[f].x == of_face[g].x && of_face[f].y == of_face[g].y &&
                                  touches(t, faces[f], faces[g][corner.place]);
                if (same) alike.emplace_back(f, g);
            }
        }
    };
    Groups groups(faces.size());
    for (const auto& [f, g] : collected<Pair>(workers, faces.size(), find)) groups.join(f, g);
    std::vector<std::size_t> result(faces.size());
    for (std::size_t f = 0; f < faces.size(); ++f) result[f] = groups.of(f);
    return result;
}

}  // namespace

std::string_view name_of(EdgeKind kind) noexcept {
    constexpr std::string_view names[] = {"point", "segment",  "ray",
                                          "line",  "polyline", "hyperbola"};
    return names[static_cast<int>(kind)];
}

Voronoi::Voronoi(Tessellation tessellation, const VoronoiOptions& options)
    : tessellation_(std::move(tessellation)), hidden_(tessellation_.sites().size(), false) {
    const exact::IeeeEnvironment environment;
    tessellation_.expect_neighbours();
    for (const Hidden& hidden : tessellation_.hidden())
        hidden_[static_cast<std::size_t>(hidden.site)] = true;
    // Products of up to four lengths are to stay within a double's range.
    double largest = 0;
    for (const Site& s : tessellation_.sites()) {
        largest = std::max({largest, std::abs(s.x), std::abs(s.y)});
        if (tessellation_.weight_is() == WeightIs::radius)
            largest = std::max(largest, std::abs(s.r));
    }
    if (largest > 0 && std::abs(std::ilogb(largest)) > 200) exponent_ = std::ilogb(largest);
    const Workers workers(options.threads, tessellation_.faces().size());
    number_vertices(options.merge, workers);
    number_edges(workers);
    collect_cells(workers);
}

void Voronoi::number_vertices(bool merge, const Workers& workers) {
    const auto faces = tessellation_.faces();
    const std::vector<DiagramVertex> of_face = signum::vertices(tessellation_, workers.count());
    // Where coordinates are denormal, vertices rounded to doubles may lie anywhere between sites.
    constexpr int nearly_denormal = -900;
    std::vector<DiagramVertex> divided_of_face;
    if (exponent_ < nearly_denormal)
        if (const auto t = divided(tessellation_, exponent_))
            divided_of_face = signum::vertices(*t, workers.count());
    // The first face of those that share a vertex stands for them; without merging each for itself.
    std::vector<std::size_t> first_alike;
    if (merge) first_alike = alike_faces(tessellation_, of_face, workers);
    const auto stands_for_itself = [&](std::size_t f) {
        return first_alike.empty() || first_alike[f] == f;
    };
    make_room(workers, faces.size(), vertex_of_face_);
    static_cast<void>(deal(
        workers, faces.size(), 1,
        [&](std::size_t f) { return are_finite(of_face[f]) && stands_for_itself(f) ? 0U : 1U; },
        [&](std::size_t count) {
            make_room(workers, count, vertices_);
            if (!divided_of_face.empty()) make_room(workers, count, divided_vertices_);
        },
        [&](std::size_t f, std::size_t place) {
            vertex_of_face_[f] = static_cast<Index>(place);
            vertices_[place] = of_face[f];
            if (!divided_of_face.empty())
                divided_vertices_[place] = {divided_of_face[f].x, divided_of_face[f].y};
        }));
    workers.each_range(faces.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f) {
            if (!are_finite(of_face[f]))
                vertex_of_face_[f] = at_infinity;
            else if (!stands_for_itself(f))
                vertex_of_face_[f] = vertex_of_face_[first_alike[f]];
        }
    });
}

void Voronoi::number_edges(const Workers& workers) {
    const auto faces = tessellation_.faces();
    const auto neighbours = tessellation_.neighbours();
    make_room(workers, 3 * faces.size(), edge_of_);
    workers.each_range(edge_of_.size(), [&](std::size_t begin, std::size_t end) {
        std::fill(edge_of_.data() + begin, edge_of_.data() + end, -1);
    });
    // Each from the lesser of its faces.
    const auto is_edge = [&](std::size_t f, std::size_t k) {
        return static_cast<std::size_t>(neighbours[f][k]) >= f &&
               faces[f][(k + 1) % 3] != infinite && faces[f][(k + 2) % 3] != infinite;
    };
    static_cast<void>(deal(
        workers, 3 * faces.size(), 1,
        [&](std::size_t corner) { return is_edge(corner / 3, corner % 3) ? 0U : 1U; },
        [&](std::size_t count) { make_room(workers, count, edges_); },
        [&](std::size_t from, std::size_t place) {
            const auto f = static_cast<Index>(from / 3);
            const std::size_t k = from % 3;
            const auto [g, there] = triangulation::across(tessellation_.arrays(), {f, k});
            edge_of_[from] = edge_of_[3 * static_cast<std::size_t>(g) + there] =
                static_cast<Index>(place);
            const Face& sites = faces[static_cast<std::size_t>(f)];
            // f lies on the left of a -> b, so that the edge, with a on its left, leads to it.
            edges_[place] = {sites[(k + 1) % 3],
                             sites[(k + 2) % 3],
                             vertex_of_face_[static_cast<std::size_t>(g)],
                             vertex_of_face_[static_cast<std::size_t>(f)],
                             g,
                             f};
        }));
}

void Voronoi::collect_cells(const Workers& workers) {
    const auto faces = tessellation_.faces();
    const std::size_t sites = tessellation_.sites().size();
    // Around each site from its first face, or the last one that lies at infinity.
    std::vector<Index> start(sites, -1);
    for (std::size_t f = 0; f < faces.size(); ++f)
        for (const Index site : faces[f]) {
            if (site == infinite) continue;
            Index& of = start[static_cast<std::size_t>(site)];
            if (of < 0 || vertex_of_face_[f] == at_infinity) of = static_cast<Index>(f);
        }
    make_room(workers, sites + 1, first_step_);
    const auto walk = [&](std::size_t begin, std::size_t end, std::vector<VoronoiStep>& steps) {
        for (std::size_t site = begin; site < end; ++site) {
            const std::size_t before = steps.size();
            if (start[site] >= 0) {
                for (const auto corner : triangulation::fan(tessellation_.arrays(), start[site],
                                                            static_cast<Index>(site))) {
                    const Index edge =
                        edge_of_[3 * static_cast<std::size_t>(corner.face) + corner.next()];
                    if (edge >= 0)
                        steps.push_back({edge, edges_[static_cast<std::size_t>(edge)].left ==
                                                   static_cast<Index>(site)});
                }
            }
            first_step_[site + 1] = steps.size() - before;
        }
    };
    steps_ = collected<VoronoiStep>(workers, sites, walk);
    std::partial_sum(first_step_.begin(), first_step_.end(), first_step_.begin());
}

bool Voronoi::is_unbounded(Index site) const {
    if (is_hidden(site)) return false;
    const auto steps = cell(site);
    // Alone it has all the plane.
    return steps.empty() || std::ranges::any_of(steps, [&](const VoronoiStep& step) {
               const VoronoiEdge& edge = edges_[static_cast<std::size_t>(step.edge)];
               return edge.from == at_infinity || edge.to == at_infinity;
           });
}

namespace {

EdgeKind kind_of(const EdgeGeometry& g, const VoronoiEdge& edge) {
    if (edge.from == edge.to && edge.from != at_infinity) return EdgeKind::point;
    if (!(g.from < g.to)) return EdgeKind::point;
    if (std::holds_alternative<HyperbolaCurve>(g.curve)) return EdgeKind::hyperbola;
    const auto& straight = std::get<StraightCurve>(g.curve);
    if (straight.slopes[0] != 0 || straight.slopes[1] != 0)
        for (const double knot : straight.knots)
            if (g.from < knot && knot < g.to) return EdgeKind::polyline;
    const bool begins = std::isfinite(g.from);
    const bool ends = std::isfinite(g.to);
    return begins && ends ? EdgeKind::segment : begins || ends ? EdgeKind::ray : EdgeKind::line;
}

}  // namespace

std::optional<EdgeGeometry> Voronoi::geometry(Index index, std::optional<Point> focus) const {
    const exact::IeeeEnvironment environment;
    const VoronoiEdge& edge = edges_[checked("edge", index, edges_.size())];
    if (focus && !are_finite(*focus)) throw std::invalid_argument("the focus is not finite");
    const auto site = [&](Index i) -> const Site& {
        return tessellation_.sites()[static_cast<std::size_t>(i)];
    };
    const auto vertex = [&](Index v) -> Point {
        if (v == at_infinity) return {unbounded, unbounded};
        if (!divided_vertices_.empty()) return divided_vertices_[static_cast<std::size_t>(v)];
        const DiagramVertex& at = vertices_[static_cast<std::size_t>(v)];
        return scaled({at.x, at.y}, -exponent_);
    };
    const Point start = vertex(edge.from);
    const Point end = vertex(edge.to);
    const Site& a = site(edge.left);
    const Site& b = site(edge.right);
    if (!focus) {
        // The nearer end: the other one may be far away, and not so well known.
        const Point from = scaled({a.x, a.y}, -exponent_);
        focus = from;
        double least = unbounded;
        for (const Point p : {start, end})
            if (const double away = std::hypot(p.x - from.x, p.y - from.y); away < least) {
                least = away;
                focus = p;
            }
    }

    const auto curve = in_ieee::bisector(tessellation_.metric(), tessellation_.weight_is(),
                                         {a, edge.left}, {b, edge.right}, exponent_, *focus);
    if (!curve) return std::nullopt;
    // A face without infinity whose vertex is not finite: on a common tangent line of its three
    // discs, or beyond the doubles. Which end of the curve is meant, the third site tells.
    const auto parameter = [&](Point p, Index face, EndOfEdge at) {
        if (are_finite(p))
            return std::visit([&](const auto& of) { return in_ieee::parameter(of, p); }, *curve);
        const double expected = at == EndOfEdge::to ? unbounded : -unbounded;
        Index apex = infinite;
        for (const Index v : tessellation_.faces()[static_cast<std::size_t>(face)]) {
            if (v == infinite) return expected;
            if (v != edge.left && v != edge.right) apex = v;
        }
        const Sign side =
            far_end(tessellation_.metric(), tessellation_.weight_is(), a, b, site(apex), at);
        return side == 0 ? expected : side * unbounded;
    };
    EdgeGeometry result = {EdgeKind::point,
                           *curve,
                           parameter(start, edge.from_face, EndOfEdge::from),
                           parameter(end, edge.to_face, EndOfEdge::to),
                           start,
                           end};
    result.kind = kind_of(result, edge);
    return result;
}

}  // namespace signum
