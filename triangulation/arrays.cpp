#include "arrays.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace signum {

TessellationArrays ordered_by_index(const TessellationArrays& arrays) {
    TessellationArrays result = arrays;
    if (arrays.order == Order::index) return result;
    result.order = Order::index;
    const bool has_neighbours = arrays.neighbours.size() == arrays.faces.size();
    for (std::size_t f = 0; f < result.faces.size(); ++f) {
        Face& face = result.faces[f];
        const auto first = std::ranges::min_element(face) - face.begin();
        std::rotate(face.begin(), face.begin() + first, face.end());
        if (!has_neighbours) continue;
        Face& neighbours = result.neighbours[f];
        std::rotate(neighbours.begin(), neighbours.begin() + first, neighbours.end());
    }
    std::vector<Index> from(result.faces.size());
    std::iota(from.begin(), from.end(), 0);
    const auto at = [](Index f) { return static_cast<std::size_t>(f); };
    std::ranges::stable_sort(from, {}, [&](Index f) { return result.faces[at(f)]; });
    std::vector<Index> place(from.size());
    for (std::size_t i = 0; i < from.size(); ++i) place[at(from[i])] = static_cast<Index>(i);
    const TessellationArrays turned = result;
    for (std::size_t i = 0; i < from.size(); ++i) {
        result.faces[i] = turned.faces[at(from[i])];
        if (!has_neighbours) continue;
        for (std::size_t k = 0; k < 3; ++k)
            result.neighbours[i][k] = place[at(turned.neighbours[at(from[i])][k])];
    }
    return result;
}

}  // namespace signum
