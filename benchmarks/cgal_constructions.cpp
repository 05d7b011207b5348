#include "cgal_constructions.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <tuple>
#include <unordered_map>

#include <CGAL/Apollonius_graph_filtered_traits_2.h>
#include <CGAL/Apollonius_graph_hierarchy_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_2.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Segment_Delaunay_graph_Linf_filtered_traits_2.h>
#include <CGAL/Segment_Delaunay_graph_Linf_hierarchy_2.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/version.h>

namespace signum::benchmarks::cgal {
namespace {

using Exact = CGAL::Exact_predicates_inexact_constructions_kernel;
using Double = CGAL::Simple_cartesian<double>;

/// A site of each kind of triangulation: from ours, of a vertex, and as numbers.
struct Delaunay {
    using Graph = CGAL::Delaunay_triangulation_2<Exact>;
    using Input = Exact::Point_2;
    static Input input(const Site& site) { return {site.x, site.y}; }
    static Input input(const Graph::Vertex& vertex) { return vertex.point(); }
    static std::array<double, 3> numbers(const Input& p) { return {p.x(), p.y(), 0.0}; }
};
struct Regular {
    using Graph = CGAL::Regular_triangulation_2<Exact>;
    using Input = Exact::Weighted_point_2;
    static Input input(const Site& site) {
        return Input(Exact::Point_2(site.x, site.y), site.r * site.r);
    }
    static Input input(const Graph::Vertex& vertex) { return vertex.point(); }
    static std::array<double, 3> numbers(const Input& p) { return {p.x(), p.y(), p.weight()}; }
};
struct Apollonius {
    using Graph =
        CGAL::Apollonius_graph_hierarchy_2<CGAL::Apollonius_graph_filtered_traits_2<Double>>;
    using Input = Graph::Site_2;
    static Input input(const Site& site) { return Input(Double::Point_2(site.x, site.y), site.r); }
    static Input input(const Graph::Vertex& vertex) { return vertex.site(); }
    static std::array<double, 3> numbers(const Input& p) { return {p.x(), p.y(), p.weight()}; }
    static auto visible(const Graph& graph) { return graph.number_of_visible_sites(); }
};
struct Linf {
    using Graph = CGAL::Segment_Delaunay_graph_Linf_hierarchy_2<
        CGAL::Segment_Delaunay_graph_Linf_filtered_traits_without_intersections_2<
            Double, CGAL::Field_with_sqrt_tag>>;
    using Input = Double::Point_2;
    static Input input(const Site& site) { return {site.x, site.y}; }
    static Input input(const Graph::Vertex& vertex) { return vertex.site().point(); }
    static std::array<double, 3> numbers(const Input& p) { return {p.x(), p.y(), 0.0}; }
};
struct Delaunay3 {
    using Graph = CGAL::Delaunay_triangulation_3<Exact>;
    using Input = Exact::Point_3;
    static Input input(const Site3& site) { return {site.x, site.y, site.z}; }
};
struct Regular3 {
    using Graph = CGAL::Regular_triangulation_3<Exact>;
    using Input = Exact::Weighted_point_3;
    static Input input(const Site3& site) {
        return Input(Exact::Point_3(site.x, site.y, site.z), site.r * site.r);
    }
};

template <class Kind, class S>
std::vector<typename Kind::Input> inputs(const std::vector<S>& sites) {
    std::vector<typename Kind::Input> result;
    result.reserve(sites.size());
    for (const S& site : sites) result.push_back(Kind::input(site));
    return result;
}

template <class Kind>
void write(const typename Kind::Graph& graph, const std::vector<typename Kind::Input>& input,
           std::vector<Face>& faces, std::vector<Face>& neighbours) {
    std::map<std::array<double, 3>, Index> numbers;
    for (std::size_t i = 0; i < input.size(); ++i)
        numbers.try_emplace(Kind::numbers(input[i]), static_cast<Index>(i));
    std::unordered_map<const void*, Index> places;
    for (auto f = graph.all_faces_begin(); f != graph.all_faces_end(); ++f)
        places.emplace(&*f, static_cast<Index>(places.size()));
    for (auto f = graph.all_faces_begin(); f != graph.all_faces_end(); ++f) {
        Face face;
        Face across;
        for (int k = 0; k < 3; ++k) {
            const auto vertex = f->vertex(k);
            const auto place = static_cast<std::size_t>(k);
            face[place] = graph.is_infinite(vertex)
                              ? infinite
                              : numbers.at(Kind::numbers(Kind::input(*vertex)));
            across[place] = places.at(&*f->neighbor(k));
        }
        faces.push_back(face);
        neighbours.push_back(across);
    }
}

template <class Kind, class S>
Construction construction(const std::vector<S>& sites) {
    return [points = inputs<Kind>(sites)] {
        const auto graph = std::make_shared<typename Kind::Graph>(points.begin(), points.end());
        Built built{0, graph, {}};
        if constexpr (requires { Kind::visible(*graph); })
            built.visible = static_cast<std::int64_t>(Kind::visible(*graph));
        else
            built.visible = static_cast<std::int64_t>(graph->number_of_vertices());
        if constexpr (std::is_same_v<S, Site>)
            built.write = [&of = *graph, &points](std::vector<Face>& faces,
                                                  std::vector<Face>& neighbours) {
                write<Kind>(of, points, faces, neighbours);
            };
        return built;
    };
}

template <class Kind>
std::vector<std::array<Index, 4>> cells_of(const std::vector<Site3>& sites) {
    const std::vector<typename Kind::Input> points = inputs<Kind>(sites);
    std::map<typename Kind::Input, Index> numbers;
    for (std::size_t i = 0; i < points.size(); ++i) numbers[points[i]] = static_cast<Index>(i);
    const typename Kind::Graph triangulation(points.begin(), points.end());
    std::vector<std::array<Index, 4>> result;
    for (auto c = triangulation.finite_cells_begin(); c != triangulation.finite_cells_end(); ++c) {
        std::array<Index, 4> cell{};
        for (int k = 0; k < 4; ++k)
            cell[static_cast<std::size_t>(k)] = numbers.at(c->vertex(k)->point());
        std::ranges::sort(cell);
        result.push_back(cell);
    }
    std::ranges::sort(result);
    return result;
}

/// A face and the vertex opposite each of its edges, by directed edge.
using Opposite = std::map<std::pair<Index, Index>, Index>;

}  // namespace

Construction delaunay(const std::vector<Site>& sites) {
    return construction<Delaunay>(sites);
}
Construction regular(const std::vector<Site>& sites) {
    return construction<Regular>(sites);
}
Construction apollonius(const std::vector<Site>& sites) {
    return construction<Apollonius>(sites);
}
Construction linf(const std::vector<Site>& sites) {
    return construction<Linf>(sites);
}

Construction in_space(const std::vector<Site3>& sites, bool is_regular) {
    return is_regular ? construction<Regular3>(sites) : construction<Delaunay3>(sites);
}
std::vector<std::array<Index, 4>> cells(const std::vector<Site3>& sites, bool is_regular) {
    return is_regular ? cells_of<Regular3>(sites) : cells_of<Delaunay3>(sites);
}

std::string version() {
    return CGAL_VERSION_STR;
}

bool are_regular(const std::vector<Face>& faces, const std::vector<Site>& sites, bool weighted) {
    const auto site = [&](Index i) { return sites[static_cast<std::size_t>(i)]; };
    const auto point = [&](Index i) { return Exact::Point_2(site(i).x, site(i).y); };
    const auto heavy = [&](Index i) { return Regular::input(site(i)); };
    Opposite opposite;
    for (const Face& face : faces)
        for (std::size_t k = 0; k < 3; ++k)
            if (!opposite.emplace(std::pair(face[(k + 1) % 3], face[(k + 2) % 3]), face[k]).second)
                return false;
    const auto turn = [&](Index a, Index b, Index c) {
        return CGAL::orientation(point(a), point(b), point(c));
    };
    for (const auto& [edge, k] : opposite) {
        const auto [i, j] = edge;
        const auto twin = opposite.find({j, i});
        if (twin == opposite.end()) return false;
        if (i == infinite || j == infinite) continue;
        const Index q = twin->second;
        // The hull, counterclockwise from j to i and on, turns left or goes straight on.
        if (k == infinite) {
            const auto next = opposite.find({i, infinite});
            if (next == opposite.end() || turn(j, i, next->second) == CGAL::RIGHT_TURN)
                return false;
            continue;
        }
        if (turn(i, j, k) != CGAL::LEFT_TURN) return false;
        if (q == infinite) continue;
        const CGAL::Oriented_side side =
            weighted
                ? CGAL::power_side_of_oriented_power_circle(heavy(i), heavy(j), heavy(k), heavy(q))
                : CGAL::side_of_oriented_circle(point(i), point(j), point(k), point(q));
        if (side == CGAL::ON_POSITIVE_SIDE) return false;
    }
    return true;
}

}  // namespace signum::benchmarks::cgal
