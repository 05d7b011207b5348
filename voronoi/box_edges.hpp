#pragma once
/// What a cell of space has of the edges of the box. Faces end on an edge at points, in which its
/// part of one cell goes over into that of the next; a cell is convex and has one part of an edge
/// at most, so that which end of it each point is tells the whole: no place is compared. For
/// sources only.

#include <cstddef>
#include <span>
#include <vector>

#include "scaled_sites.hpp"

namespace signum {

/// An edge of the box: where two of its sides meet. Edges along x are numbered from 0, along y from
/// 4, along z from 8: first both sides low, then that on the next axis high, then the other.
struct BoxEdge {
    int number;
    explicit constexpr BoxEdge(int of_box) noexcept : number(of_box) {}
    constexpr BoxEdge(Side a, Side b) noexcept : number(0) {
        const int axis = 3 - a.axis_number() - b.axis_number();
        const bool is_next = a.axis_number() == (axis + 1) % 3;
        const Side next = is_next ? a : b;
        const Side last = is_next ? b : a;
        number = 4 * axis + static_cast<int>(next.is_high()) + 2 * static_cast<int>(last.is_high());
    }
    [[nodiscard]] constexpr int axis() const noexcept { return number / 4; }
    [[nodiscard]] constexpr Side next() const noexcept {
        return Side(2 * ((axis() + 1) % 3) + number % 2);
    }
    [[nodiscard]] constexpr Side last() const noexcept {
        return Side(2 * ((axis() + 2) % 3) + number / 2 % 2);
    }
    /// The side in which it begins or ends.
    [[nodiscard]] constexpr Side end(bool is_high) const noexcept {
        return Side(2 * axis() + static_cast<int>(is_high));
    }
};

/// Where a cell's part of an edge of the box begins or ends at a face.
struct EdgeEnd {
    int edge;
    bool is_high;        ///< it ends there
    std::size_t corner;  ///< of the face
    Point3 place;
};
/// A cell's part of an edge of the box; where an end is missing it goes on to the box's corner.
struct EdgePart {
    BoxEdge edge;
    const EdgeEnd* low;
    const EdgeEnd* high;
};
/// From where it begins to where it ends, seen from its site's eye, from where the box is `box`.
[[nodiscard]] Box3 ends_of(const EdgePart& part, const Box3& box) noexcept;
/// Of the two sides that meet there, around which counterclockwise is up.
[[nodiscard]] constexpr Side side_around_which_up(BoxEdge edge) noexcept {
    return edge.next().is_high() == edge.last().is_high() ? edge.next() : edge.last();
}
/// All those of a cell from all ends that its faces make; of one that has the whole box, from none.
/// Valid as long as they are.
[[nodiscard]] std::vector<EdgePart> edge_parts(std::span<const EdgeEnd> ends, bool is_whole_box);

}  // namespace signum
