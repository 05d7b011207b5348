#pragma once
/// The working structure of a tessellation of space: cells and their neighbours, without
/// coordinates.
///
/// Laws:
///  1. Vertex k of a cell lies across its facet k, as neighbour k does. The vertex at infinity
///     has the number -1; with it the cells have no boundary.
///  2. A cell without it turns positively: ccw of its four vertices is +1. One with it does so for
///     every place that the hull's facet separates from the sites, in place of the vertex at
///     infinity.
///  3. Cells that no longer are have free for their first vertex, and are used again.

#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "../../core/index.hpp"
#include "../../core/large_array.hpp"
#include "../../core/pages.hpp"
#include "../../core/sign.hpp"

namespace signum::spatial {

inline constexpr Index infinite = -1;
inline constexpr Index unset = -2;

/// Four vertices, or four neighbours.
using Four = std::array<Index, 4>;

/// Where a vertex, or a neighbour, is among the four. Precondition: it is there.
[[nodiscard]] inline std::size_t place_of(Index each, const Four& four) noexcept {
    // Without a branch, which nobody could foretell.
    return static_cast<std::size_t>(each == four[1]) +
           2 * static_cast<std::size_t>(each == four[2]) +
           3 * static_cast<std::size_t>(each == four[3]);
}

/// The places of the vertices of the facet across from one: with that one first they turn as the
/// cell does.
inline constexpr std::array<std::array<std::size_t, 3>, 4> facet_of = {
    {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

class Cells {
 public:
    static constexpr Index free = -3;

    [[nodiscard]] const Four& vertex(Index c) const noexcept {
        return vertex_[static_cast<std::size_t>(c)];
    }
    [[nodiscard]] Four& vertex(Index c) noexcept { return vertex_[static_cast<std::size_t>(c)]; }
    [[nodiscard]] const Four& neighbour(Index c) const noexcept {
        return neighbour_[static_cast<std::size_t>(c)];
    }
    [[nodiscard]] Four& neighbour(Index c) noexcept {
        return neighbour_[static_cast<std::size_t>(c)];
    }
    /// Of those that are and those that are no longer.
    [[nodiscard]] std::size_t size() const noexcept { return neighbour_.size(); }
    [[nodiscard]] bool is_free(Index c) const noexcept { return vertex(c)[0] == free; }
    /// Where the vertex at infinity is among those of a cell; 4 where it is not.
    [[nodiscard]] std::size_t place_of_infinity(Index c) const noexcept {
        const std::size_t place = place_of(infinite, vertex(c));
        return vertex(c)[place] == infinite ? place : 4;
    }

    void reserve(std::size_t cells) {
        vertex_.reserve(cells);
        neighbour_.reserve(cells);
    }
    /// Cells whose vertices and neighbours are to be set.
    void add(std::span<Index> made) {
        std::size_t reused = 0;
        for (; reused < made.size() && !free_.empty(); ++reused) {
            made[reused] = free_.back();
            free_.pop_back();
        }
        const std::size_t first = size();
        const std::size_t end = first + (made.size() - reused);
        if (end > most_cells) throw std::length_error("more than 2^31 - 1 cells");
        vertex_pages_.grow(vertex_, end);
        vertex_.resize(end);
        neighbour_pages_.grow(neighbour_, end);
        neighbour_.resize(end);
        for (std::size_t c = first; c < end; ++c) made[reused++] = static_cast<Index>(c);
    }
    void remove(Index c) {
        vertex(c)[0] = free;
        free_.push_back(c);
    }
    /// A hint that a cell will be looked at soon.
    void prefetch(Index c) const noexcept { __builtin_prefetch(&neighbour(c)); }
    /// The memory of the vertices, which are no longer needed; neighbours stay.
    [[nodiscard]] std::vector<Four> forget_vertices() noexcept { return std::move(vertex_); }
    void forget_neighbours() noexcept { release(neighbour_); }

 private:
    static constexpr std::size_t most_cells = std::numeric_limits<Index>::max() - 1;

    std::vector<Four> vertex_;
    std::vector<Four> neighbour_;
    PagesAhead vertex_pages_;
    PagesAhead neighbour_pages_;
    std::vector<Index> free_;
};

}  // namespace signum::spatial
