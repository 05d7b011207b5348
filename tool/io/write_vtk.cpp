#include "write_vtk.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace signum {
namespace {

/// The columns that a point has.
template <class Sites>
std::vector<VtkColumn> columns_of(const Sites& sites, WeightIs weight_is,
                                  std::span<const Hidden> hidden) {
    VtkColumn third = {std::string(name_of(weight_is)), false, {}};
    for (const auto& site : sites) third.values.push_back(site.r);
    VtkColumn is_hidden = {"hidden", true, std::vector<double>(sites.size(), 0.0)};
    for (const auto& [site, by] : hidden) is_hidden.values[static_cast<std::size_t>(site)] = 1.0;
    return {std::move(third), std::move(is_hidden)};
}

/// Those between sites that no finite face has, sorted.
std::vector<Edge> edges_without_face(const Tessellation& tessellation) {
    std::vector<Edge> bounding;
    for (const Face& face : tessellation.faces()) {
        if (face[0] == infinite) continue;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [a, b] = std::minmax(face[k], face[(k + 1) % 3]);
            bounding.push_back({a, b});
        }
    }
    std::ranges::sort(bounding);
    std::vector<Edge> result;
    for (const Edge& edge : tessellation.edges())
        if (edge[0] != infinite && !std::ranges::binary_search(bounding, edge))
            result.push_back(edge);
    return result;
}

}  // namespace

VtkGrid vtk_grid(const Tessellation& tessellation) {
    VtkGrid grid;
    grid.title = fmt::format("signum: {} tessellation", name_of(tessellation.metric()));
    for (const Site& site : tessellation.sites()) grid.points.push_back({site.x, site.y, 0.0});
    for (const Edge& edge : edges_without_face(tessellation)) grid.add_cell(VtkCell::line, edge);
    for (const Face& face : tessellation.faces())
        if (face[0] != infinite) grid.add_cell(VtkCell::triangle, face);
    grid.of_points =
        columns_of(tessellation.sites(), tessellation.weight_is(), tessellation.hidden());
    return grid;
}

VtkGrid vtk_grid(const SpaceTessellation& tessellation, std::span<const Site3> sites,
                 WeightIs weight_is) {
    constexpr std::array kinds = {VtkCell::vertex, VtkCell::line, VtkCell::triangle,
                                  VtkCell::tetrahedron};
    const auto dimension = static_cast<std::size_t>(tessellation.dimension);
    VtkGrid grid;
    grid.title = "signum: power tessellation of space";
    for (const auto& [x, y, z, r] : sites) grid.points.push_back({x, y, z});
    for (const SpaceCell& cell : tessellation.cells)
        if (cell[0] != infinite)
            grid.add_cell(kinds.at(dimension), std::span(cell).first(dimension + 1));
    grid.of_points = columns_of(sites, weight_is, tessellation.hidden);
    return grid;
}

}  // namespace signum
