#include "inner_edges.hpp"

#include <algorithm>

#include "../../triangulation/structure/corners.hpp"

namespace signum::study {

std::vector<std::array<Index, 4>> inner_edges(const Tessellation& tessellation) {
    std::vector<std::array<Index, 4>> result;
    const auto faces = tessellation.faces();
    for (std::size_t f = 0; f < faces.size(); ++f) {
        if (faces[f][0] == infinite) continue;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto g = static_cast<std::size_t>(tessellation.neighbours()[f][k]);
            if (g < f || faces[g][0] == infinite) continue;
            const auto corner =
                triangulation::across(tessellation.arrays(), {static_cast<Index>(f), k});
            const Index q = faces[g][corner.place];
            // Two sites with two edges and one site between them: nothing is asked.
            if (std::ranges::find(faces[f], q) == faces[f].end())
                result.push_back({faces[f][0], faces[f][1], faces[f][2], q});
        }
    }
    return result;
}

std::vector<std::array<Index, 5>> inner_facets(const SpaceTessellation& tessellation) {
    std::vector<std::array<Index, 5>> result;
    if (tessellation.dimension < 3) return result;
    for (std::size_t c = 0; c < tessellation.cells.size(); ++c) {
        const SpaceCell& cell = tessellation.cells[c];
        if (cell[0] == infinite) continue;
        for (const Index n : tessellation.neighbours[c]) {
            const SpaceCell& other = tessellation.cells[static_cast<std::size_t>(n)];
            if (static_cast<std::size_t>(n) < c || other[0] == infinite) continue;
            const auto across = std::ranges::find_if(
                other, [&](Index v) { return std::ranges::find(cell, v) == cell.end(); });
            if (across != other.end())
                result.push_back({cell[0], cell[1], cell[2], cell[3], *across});
        }
    }
    return result;
}

}  // namespace signum::study
