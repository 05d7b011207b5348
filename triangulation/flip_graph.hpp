#pragma once
/// The space of tessellations, their flip graph: all triangulations of the sphere with the same
/// vertices, infinity among them, of which every metric's tessellation of the same visible sites is
/// one. Swapping an edge leads from one to another.
///
/// Laws:
///  1. No edge joins a vertex to itself; two vertices may share several edges, a vertex may have
///     two neighbours only. A swap keeps that: one that would join a vertex to itself is refused.
///  2. Edges keep their numbers when they are swapped. Swapping the same edge twice restores the
///     tessellation.
///  3. Any tessellation of n sites reaches its reduced form in O(n) swaps, any other in O(n²).
///
/// How they get there: swapping every edge across from infinity puts infinity into all faces. What
/// is left of edges between sites is a tree, drawn in the plane; two swaps slide an edge of the
/// tree along the next one at the same site. Slides make the tree a star around the first site,
/// and exchange two neighbours in the star.
/// Source: thesis, chapter 7 (definitions 7.4.2 to 7.4.5, theorem 7.4.2); the way by trees is our
/// own.

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "../core/handle.hpp"
#include "../core/index.hpp"
#include "tessellation.hpp"

namespace signum {

/// One of these tessellations, whose edges can be swapped.
class ExtendedTessellation {
 public:
    /// Edges are numbered in the order of the faces and the corners that they lie across from.
    /// Throws std::invalid_argument where the arrays are no triangulation of a sphere as in law 1;
    /// the sites themselves are not looked at. O(n).
    explicit ExtendedTessellation(const TessellationArrays& arrays);

    /// 3n - 3 of n >= 2 visible sites.
    [[nodiscard]] Index edges() const noexcept { return static_cast<Index>(half_of_.size()); }
    /// The vertices that edge e joins, -1 for infinity. This and what follows throws
    /// std::out_of_range for a number that names no edge or face.
    [[nodiscard]] Edge ends(Index e) const;
    /// The vertices across from it on both sides, which swapping joins instead.
    [[nodiscard]] Edge corners(Index e) const;

    /// 2n - 2, each in its place; a swap changes two of them.
    [[nodiscard]] Index faces() const noexcept { return static_cast<Index>(corner_.size() / 3); }
    /// Three vertices counterclockwise, and the edges across from them.
    [[nodiscard]] Face corners_of(Index f) const;
    /// Across from the corners, in their order.
    [[nodiscard]] Face edges_of(Index f) const;

    /// Whether law 1 holds afterwards. O(1).
    [[nodiscard]] bool can_swap(Index e) const;
    /// Replaces edge e by the other diagonal of its two faces. Throws std::invalid_argument unless
    /// can_swap(e). O(1).
    void swap(Index e);

    /// Faces and neighbours in the order of files; metric, hidden sites and so on as they came. Of
    /// two faces with the same corners the order is not defined. O(n log n).
    [[nodiscard]] TessellationArrays arrays() const;

 private:
    friend class SwapPath;

    /// 3f + k is the side of face f that lies across from its corner k.
    using Half = std::size_t;
    [[nodiscard]] Half half_of(Index e) const {
        return half_of_[checked("edge", e, half_of_.size())];
    }
    [[nodiscard]] Half first_of(Index f) const {
        return 3 * checked("face", f, corner_.size() / 3);
    }
    static Half next(Half h) noexcept { return h % 3 == 2 ? h - 2 : h + 1; }
    static Half previous(Half h) noexcept { return h % 3 == 0 ? h + 2 : h - 1; }
    void put(Half h, Index corner, Half twin, Index edge) noexcept;

    TessellationArrays origin_;  ///< without faces
    std::vector<Index> corner_;
    std::vector<Half> twin_;
    std::vector<Index> edge_;
    std::vector<Half> half_of_;
};

/// Brings the tessellation into its reduced form, in which the last visible site has three edges,
/// to the first two and to infinity, and gives the edges swapped for it, in order; at most 8n.
/// With fewer than three visible sites it is reduced as it is. O(n).
std::vector<Index> reduced_form(ExtendedTessellation& tessellation);

/// The edges to swap, in order and in the numbers of `from`, that make `to` of `from`; at most 2n²
/// + 8n. Throws std::invalid_argument unless both are tessellations of the same visible sites.
/// O(n²).
[[nodiscard]] std::vector<Index> path(const TessellationArrays& from, const TessellationArrays& to);

/// What `from` becomes by swapping edges in order. Throws as swap() does.
[[nodiscard]] TessellationArrays replay(const TessellationArrays& from,
                                        std::span<const Index> swaps);

}  // namespace signum
