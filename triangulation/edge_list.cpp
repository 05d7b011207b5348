#include "edge_list.hpp"

#include <array>
#include <stdexcept>
#include <string>

namespace signum {
namespace {

/// Half-edge k of a face goes out across the edge that leads from its corner k+1 to its corner k+2,
/// and has the cell of the latter on its left.
constexpr std::size_t on_the_right(std::size_t k) noexcept {
    return (k + 1) % 3;
}
constexpr std::size_t on_the_left(std::size_t k) noexcept {
    return (k + 2) % 3;
}

}  // namespace

EdgeList::EdgeList(const TessellationArrays& arrays)
    : half_edges_(3 * arrays.faces.size()),
      edge_of_cell_(static_cast<std::size_t>(arrays.sites) + 1, -1) {
    rest_.metric = arrays.metric;
    rest_.weight_is = arrays.weight_is;
    rest_.sites = arrays.sites;
    rest_.hidden = arrays.hidden;

    const auto fail = [](std::size_t f) {
        throw std::invalid_argument("face " + std::to_string(f) +
                                    " has neighbours that do not fit it");
    };
    if (arrays.neighbours.size() != arrays.faces.size()) fail(arrays.faces.size());
    for (std::size_t f = 0; f < arrays.faces.size(); ++f)
        for (std::size_t k = 0; k < 3; ++k) {
            const Face& face = arrays.faces[f];
            const Index left = face[on_the_left(k)];
            const Index right = face[on_the_right(k)];
            const Index across = arrays.neighbours[f][k];
            if (across < 0 || static_cast<std::size_t>(across) >= arrays.faces.size() ||
                left < infinite || left >= arrays.sites || left == right)
                fail(f);
            const auto g = static_cast<std::size_t>(across);
            std::size_t back = 0;
            while (back < 3 && !(arrays.neighbours[g][back] == static_cast<Index>(f) &&
                                 arrays.faces[g][on_the_left(back)] == right &&
                                 arrays.faces[g][on_the_right(back)] == left))
                ++back;
            if (back == 3) fail(f);
            // The cell of `left` comes again with the next half-edge out of g but one.
            const auto h = static_cast<Index>(3 * f + k);
            const auto next = static_cast<Index>(3 * g + (back + 2) % 3);
            HalfEdge& half_edge = half_edges_[static_cast<std::size_t>(h)];
            half_edge.origin = static_cast<Index>(f);
            half_edge.twin = static_cast<Index>(3 * g + back);
            half_edge.next = next;
            half_edge.cell = left;
            half_edges_[static_cast<std::size_t>(next)].previous = h;
            Index& first = edge_of_cell_[static_cast<std::size_t>(left + 1)];
            if (first < 0) first = h;
        }
}

TessellationArrays EdgeList::arrays() const {
    TessellationArrays result = rest_;
    const std::size_t count = half_edges_.size() / 3;
    result.faces.resize(count);
    result.neighbours.resize(count);
    for (std::size_t f = 0; f < count; ++f)
        for (std::size_t k = 0; k < 3; ++k) {
            const HalfEdge& half_edge = half_edges_[3 * f + k];
            result.faces[f][on_the_left(k)] = half_edge.cell;
            result.neighbours[f][k] = (*this)[half_edge.twin].origin;
        }
    return result;
}

}  // namespace signum
