#pragma once
/// The working structure of a tessellation of space: cells and their neighbours, without
/// coordinates.
///
/// Laws:
///  1. vertex[k] of a cell lies across its facet k, as neighbour[k] does. The vertex at infinity
///     has the number -1; with it the cells have no boundary.
///  2. A cell without it turns positively: ccw of its four vertices is +1. One with it does so for
///     every place that the hull's facet separates from the sites, in place of the vertex at
///     infinity.
///  3. Cells that no longer are have vertex[0] == free, and are used again.

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "../core/index.hpp"
#include "../core/large_array.hpp"
#include "../core/sign.hpp"

namespace signum::spatial {

inline constexpr Index infinite = -1;
inline constexpr Index unset = -2;

struct Cell {
    std::array<Index, 4> vertex;
    std::array<Index, 4> neighbour;

    /// Where a vertex, or a neighbour, is among the four. Precondition: it is there.
    [[nodiscard]] int place_of(Index v) const noexcept {
        return v == vertex[0] ? 0 : v == vertex[1] ? 1 : v == vertex[2] ? 2 : 3;
    }
    [[nodiscard]] int place_of_neighbour(Index n) const noexcept {
        return n == neighbour[0] ? 0 : n == neighbour[1] ? 1 : n == neighbour[2] ? 2 : 3;
    }
    /// Where the vertex at infinity is; -1 where it is not.
    [[nodiscard]] int place_of_infinity() const noexcept {
        const int place = place_of(infinite);
        return vertex[static_cast<std::size_t>(place)] == infinite ? place : -1;
    }
};

class Cells {
 public:
    static constexpr Index free = -3;

    [[nodiscard]] const Cell& operator[](Index c) const noexcept {
        return cells_[static_cast<std::size_t>(c)];
    }
    [[nodiscard]] Cell& operator[](Index c) noexcept { return cells_[static_cast<std::size_t>(c)]; }
    /// Of those that are and those that are no longer.
    [[nodiscard]] std::size_t size() const noexcept { return cells_.size(); }
    [[nodiscard]] bool is_free(Index c) const noexcept { return (*this)[c].vertex[0] == free; }

    void reserve(std::size_t cells) { cells_.reserve(cells); }
    [[nodiscard]] Index add(const Cell& cell) {
        if (free_.empty()) {
            cells_.push_back(cell);
            return static_cast<Index>(cells_.size() - 1);
        }
        const Index c = free_.back();
        free_.pop_back();
        (*this)[c] = cell;
        return c;
    }
    void remove(Index c) {
        (*this)[c].vertex[0] = free;
        free_.push_back(c);
    }

 private:
    LargeArray<Cell> cells_;
    std::vector<Index> free_;
};

}  // namespace signum::spatial
