#include "inner_edges.hpp"

#include <algorithm>

#include "../triangulation/structure/corners.hpp"

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

}  // namespace signum::study
