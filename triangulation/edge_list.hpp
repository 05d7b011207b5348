#pragma once
/// The Voronoi diagram as a doubly connected edge list (Muller and Preparata 1978; Preparata and
/// Shamos 1985, chapter 1): what algorithms that walk along cells and around vertices expect.
///
/// It is the dual of the tessellation, and converts to and from its arrays. Vertex v of the diagram
/// is face v of the tessellation, cell s is site s; the cell of -1 is what lies at infinity, and
/// the vertices of infinite faces lie there. Laws:
///  1. A half-edge leads from its origin to that of its twin, its cell on its left, and the next
///     one goes on around that cell. With those at infinity they cover the sphere: 2n-2 vertices,
///     3n-3 edges and n+1 cells for n >= 2 visible sites; none for fewer.
///  2. Half-edges 3v, 3v+1 and 3v+2 leave vertex v, counterclockwise; every vertex has three, also
///     where sites are cocircular and vertices coincide.
///  3. A walk around a cell is counterclockwise, around infinity too, as seen from there.

#include <cstddef>
#include <iterator>
#include <span>
#include <vector>

#include "../core/handle.hpp"
#include "../core/index.hpp"
#include "tessellation.hpp"

namespace signum {

/// The list of all half-edges; walks along it cost O(1) a step.
class EdgeList {
    struct AroundCell;
    struct AroundVertex;

 public:
    /// One side of an edge.
    struct HalfEdge {
        Index origin;    ///< a vertex
        Index twin;      ///< the other half, a half-edge as the next two
        Index next;      ///< around the cell
        Index previous;  ///< around the cell
        Index cell;      ///< on the left; -1 is infinity
        friend bool operator==(const HalfEdge&, const HalfEdge&) = default;
    };

    /// Half-edges one after the other until they come round, for range-for.
    template <class Step>
    class Loop {
     public:
        /// Goes along a loop once.
        class Iterator {
         public:
            using value_type = Index;                ///< a half-edge
            using difference_type = std::ptrdiff_t;  ///< of iterators
            /// At the first half-edge of a loop, which must outlive it.
            Iterator(const Loop& loop) noexcept : loop_(&loop), at_(loop.first_) {}
            /// The half-edge at hand.
            [[nodiscard]] Index operator*() const noexcept { return at_; }
            /// To the next one.
            Iterator& operator++() noexcept {
                at_ = Step::from(*loop_->list_, at_);
                round_ = at_ == loop_->first_;
                return *this;
            }
            /// To the next one.
            void operator++(int) noexcept { ++*this; }
            /// Whether it has come round.
            [[nodiscard]] bool operator==(std::default_sentinel_t) const noexcept {
                return round_ || at_ < 0;
            }

         private:
            const Loop* loop_;
            Index at_;
            bool round_ = false;
        };

        /// At the first half-edge.
        [[nodiscard]] Iterator begin() const noexcept { return {*this}; }
        /// When it has come round.
        [[nodiscard]] std::default_sentinel_t end() const noexcept { return {}; }

     private:
        friend EdgeList;
        Loop(const EdgeList& list, Index first) noexcept : list_(&list), first_(first) {}

        const EdgeList* list_;
        Index first_;
    };
    EdgeList() = default;
    /// From the arrays of a tessellation, whoever made it. Throws std::invalid_argument where the
    /// neighbours do not fit the faces. O(n).
    explicit EdgeList(const TessellationArrays& arrays);

    /// All of them; law 2 says where which one stands.
    [[nodiscard]] std::span<const HalfEdge> half_edges() const noexcept { return half_edges_; }
    /// This and what follows throws std::out_of_range for a number that names nothing.
    [[nodiscard]] const HalfEdge& operator[](Index h) const {
        return half_edges_[checked("half-edge", h, half_edges_.size())];
    }
    /// How many vertices.
    [[nodiscard]] Index vertices() const noexcept {
        return static_cast<Index>(half_edges_.size() / 3);
    }
    /// Where a half-edge ends.
    [[nodiscard]] Index target(Index h) const { return at((*this)[h].twin).origin; }
    /// The first half-edge around the cell of a site, or of infinity (-1); -1 where the site is
    /// hidden or alone.
    [[nodiscard]] Index edge_of_cell(Index site) const {
        if (half_edges_.empty() && site == infinite) return -1;
        const std::size_t sites = edge_of_cell_.empty() ? 0 : edge_of_cell_.size() - 1;
        return edge_of_cell_[site == infinite ? 0 : checked("cell", site, sites) + 1];
    }

    /// The half-edges around a cell (-1: infinity), counterclockwise; none for a hidden site.
    [[nodiscard]] Loop<AroundCell> around_cell(Index site) const {
        return {*this, edge_of_cell(site)};
    }
    /// The three half-edges out of a vertex, counterclockwise.
    [[nodiscard]] Loop<AroundVertex> around_vertex(Index vertex) const {
        const std::size_t count = half_edges_.size() / 3;
        return {*this, static_cast<Index>(3 * checked("vertex", vertex, count))};
    }

    /// The tessellation that this is the dual of: the arrays it came from. O(n).
    [[nodiscard]] TessellationArrays arrays() const;

 private:
    struct AroundCell {
        [[nodiscard]] static Index from(const EdgeList& list, Index h) noexcept {
            return list.at(h).next;
        }
    };
    struct AroundVertex {
        [[nodiscard]] static Index from(const EdgeList&, Index h) noexcept {
            return h % 3 == 2 ? h - 2 : h + 1;
        }
    };

    [[nodiscard]] const HalfEdge& at(Index h) const noexcept {
        return half_edges_[static_cast<std::size_t>(h)];
    }

    TessellationArrays rest_;  ///< all but faces and neighbours
    std::vector<HalfEdge> half_edges_;
    std::vector<Index> edge_of_cell_ = {-1};
};

}  // namespace signum
