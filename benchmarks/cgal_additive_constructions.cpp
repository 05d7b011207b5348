#include <CGAL/Apollonius_graph_filtered_traits_2.h>
#include <CGAL/Apollonius_graph_hierarchy_2.h>
#include <CGAL/Segment_Delaunay_graph_Linf_filtered_traits_2.h>
#include <CGAL/Segment_Delaunay_graph_Linf_hierarchy_2.h>
#include <CGAL/Simple_cartesian.h>

#include "cgal_constructions.hpp"

namespace signum::benchmarks::cgal {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;

template <class Graph, class Input>
Construction construction(std::vector<Input> input, std::int64_t (*visible)(const Graph&)) {
    return [input = std::move(input), visible] {
        const auto graph = std::make_shared<Graph>(input.begin(), input.end());
        return Built{visible(*graph), graph};
    };
}

}  // namespace

Construction apollonius(const std::vector<Site>& sites) {
    using Traits = CGAL::Apollonius_graph_filtered_traits_2<Kernel>;
    using Graph = CGAL::Apollonius_graph_hierarchy_2<Traits>;
    std::vector<Graph::Site_2> input;
    input.reserve(sites.size());
    for (const Site& site : sites) input.emplace_back(Kernel::Point_2(site.x, site.y), site.r);
    return construction<Graph>(std::move(input), [](const Graph& graph) {
        return static_cast<std::int64_t>(graph.number_of_visible_sites());
    });
}

Construction linf(const std::vector<Site>& sites) {
    using Traits = CGAL::Segment_Delaunay_graph_Linf_filtered_traits_without_intersections_2<
        Kernel, CGAL::Field_with_sqrt_tag>;
    using Graph = CGAL::Segment_Delaunay_graph_Linf_hierarchy_2<Traits>;
    std::vector<Kernel::Point_2> input;
    input.reserve(sites.size());
    for (const Site& site : sites) input.emplace_back(site.x, site.y);
    return construction<Graph>(std::move(input), [](const Graph& graph) {
        return static_cast<std::int64_t>(graph.number_of_vertices());
    });
}

}  // namespace signum::benchmarks::cgal
