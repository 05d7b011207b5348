#pragma once
/// The corners of faces in the arrays of a result, and the way around a vertex from one to the
/// next.

#include <cstddef>

#include "../../core/index.hpp"
#include "../arrays.hpp"
#include "cycle.hpp"

namespace signum::triangulation {

/// A face and the place of one of its three vertices.
struct Corner {
    Index face;
    std::size_t place;
    friend bool operator==(const Corner&, const Corner&) = default;

    /// The place that follows counterclockwise. Across from it lies the next face around the
    /// vertex.
    [[nodiscard]] std::size_t next() const noexcept { return (place + 1) % 3; }
};

/// The corner of a face at one of its vertices. Precondition: the face has that vertex.
[[nodiscard]] inline Corner corner_at(const TessellationArrays& arrays, Index face,
                                      Index vertex) noexcept {
    const Face& v = arrays.faces[static_cast<std::size_t>(face)];
    return {face, v[0] == vertex ? 0U : v[1] == vertex ? 1U : 2U};
}

/// The corner across from a corner, over the edge opposite to it: of the face there and over that
/// edge, for two faces may share several. Precondition: the arrays are those of a tessellation.
[[nodiscard]] inline Corner across(const TessellationArrays& arrays, Corner corner) noexcept {
    const auto at = [](Index f) { return static_cast<std::size_t>(f); };
    const Index end = arrays.faces[at(corner.face)][(corner.place + 2) % 3];
    const Index g = arrays.neighbours[at(corner.face)][corner.place];
    std::size_t place = 0;
    while (place < 2 && (arrays.neighbours[at(g)][place] != corner.face ||
                         arrays.faces[at(g)][(place + 1) % 3] != end))
        ++place;
    return {g, place};
}

/// The corners at a vertex, counterclockwise from that of a face that has it: a range.
/// Precondition: the arrays are those of a tessellation.
[[nodiscard]] inline auto fan(const TessellationArrays& arrays, Index face, Index vertex) {
    return Cycle(corner_at(arrays, face, vertex), [&arrays, vertex](const Corner& corner) {
        const Face& across = arrays.neighbours[static_cast<std::size_t>(corner.face)];
        return corner_at(arrays, across[corner.next()], vertex);
    });
}

}  // namespace signum::triangulation
