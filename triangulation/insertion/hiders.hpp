#pragma once
/// Who hides whom, settled at the end: the visible site nearest to each hidden site's centre.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "../../core/index.hpp"
#include "../../core/site.hpp"
#include "../options.hpp"
#include "../structure/topology.hpp"

namespace signum::triangulation {

/// The visible sites in boxes within boxes, for who looks for the nearest one from a site with so
/// many neighbours that asking them all for every point would be quadratic.
///
/// No site in a box is nearer to a point than one would be that had the greatest weight of all in
/// it, its centre where the box is nearest to the point, and the first place in the tie rule's
/// order. So a box is judged by the predicate that judges sites, and the answer is exact. O(n log
/// n) to build; a search looks into the boxes that may hold a nearer site: a few, unless many sites
/// are nearest but for little.
template <class Kernel>
class Boxes {
 public:
    /// Of the sites that have a face; others are hidden, or not there at all.
    Boxes(Kernel& kernel, std::span<const Index> face_of) : kernel_(kernel) {
        for (std::size_t i = 0; i < face_of.size(); ++i)
            if (face_of[i] >= 0) sites_.push_back(static_cast<Index>(i));
        enclose(1, sites_);
    }

    /// The site nearest to the centre of q, given any.
    [[nodiscard]] Index nearest(Index q, Index known) {
        search(1, sites_, q, known);
        return known;
    }

 private:
    static constexpr std::size_t few = 8;
    struct Box {
        double left = HUGE_VAL, right = -HUGE_VAL, bottom = HUGE_VAL, top = -HUGE_VAL;
        double weight = -HUGE_VAL;
    };

    /// The boxes of a part of the sites, which are put in order: box 2b and 2b+1 hold the halves of
    /// what box b holds.
    void enclose(std::size_t b, std::span<Index> part) {
        if (b >= boxes_.size()) boxes_.resize(2 * b);
        Box box;
        for (const Index i : part) {
            const Point centre = kernel_.centre(i);
            box.left = std::min(box.left, centre.x);
            box.right = std::max(box.right, centre.x);
            box.bottom = std::min(box.bottom, centre.y);
            box.top = std::max(box.top, centre.y);
            box.weight = std::max(box.weight, kernel_.weight(i));
        }
        boxes_[b] = box;
        if (part.size() <= few) return;
        const bool is_wide = 0.5 * box.right - 0.5 * box.left > 0.5 * box.top - 0.5 * box.bottom;
        const auto place = [&](Index i) {
            const Point centre = kernel_.centre(i);
            return is_wide ? centre.x : centre.y;
        };
        const std::size_t half = part.size() / 2;
        std::nth_element(part.begin(), part.begin() + static_cast<std::ptrdiff_t>(half), part.end(),
                         [&](Index i, Index j) { return place(i) < place(j); });
        enclose(2 * b, part.first(half));
        enclose(2 * b + 1, part.subspan(half));
    }

    void search(std::size_t b, std::span<const Index> part, Index q, Index& nearest) {
        const Box& box = boxes_[b];
        const Point point = kernel_.centre(q);
        const Site best = {std::clamp(point.x, box.left, box.right),
                           std::clamp(point.y, box.bottom, box.top), box.weight};
        if (!kernel_.would_be_nearer(q, best, nearest)) return;
        if (part.size() <= few) {
            for (const Index i : part)
                if (i != nearest && kernel_.is_nearer(q, i, nearest)) nearest = i;
            return;
        }
        const std::size_t half = part.size() / 2;
        search(2 * b, part.first(half), q, nearest);
        search(2 * b + 1, part.subspan(half), q, nearest);
    }

    Kernel& kernel_;
    std::vector<Index> sites_;
    std::vector<Box> boxes_;
};

/// Finds the visible sites nearest to the centres of hidden ones.
template <class Kernel>
class NearestVisible {
 public:
    NearestVisible(const Topology& topology, Kernel& kernel, std::size_t sites)
        : topology_(topology), kernel_(kernel), face_of_(faces_of_vertices(topology, sites)) {}

    /// The visible site nearest to the centre of q, from any visible one: the distance has no local
    /// minimum on the tessellation but the global one, so going to a nearer neighbour as long as
    /// there is one suffices. A walk that takes long goes on from the site found last, once and if
    /// that is nearer: of points that follow one another along a curve the sites are seldom far
    /// apart. It is given up where that does not help, as it does not around a giant; rounded
    /// distances, which may lead around in circles, end there, too.
    [[nodiscard]] Index operator()(Index q, Index start) { return found_last_ = walk(q, start); }

 private:
    [[nodiscard]] Index walk(Index q, Index start) {
        constexpr int many = 64;
        int left = many;
        Index elsewhere = found_last_;
        Index before = infinite;
        Index nearest = start;
        auto least = kernel_.distance(q, nearest);
        for (bool improved = true; improved;) {
            improved = false;
            const Index f = face_of_[static_cast<std::size_t>(nearest)];
            if (f < 0) break;  // the only visible site
            for (const HalfEdge h : topology_.fan(topology_.spoke(f, nearest))) {
                Index v = topology_.target(h);
                if (v == infinite || v == before) continue;
                const bool is_long = --left == 0;
                if (is_long) [[unlikely]] {
                    left = many;
                    v = std::exchange(elsewhere, -1);
                    if (v < 0) return in_boxes(q, nearest);
                }
                const auto distance = kernel_.distance(q, v);
                if (kernel_.is_nearer(q, v, distance, nearest, least)) {
                    before = std::exchange(nearest, v);
                    least = distance;
                    improved = true;
                    break;
                }
                if (is_long) [[unlikely]]
                    return in_boxes(q, nearest);
            }
        }
        return nearest;
    }
    [[nodiscard]] Index in_boxes(Index q, Index known) {
        if (!boxes_) boxes_.emplace(kernel_, face_of_);
        return boxes_->nearest(q, known);
    }

    const Topology& topology_;
    Kernel& kernel_;
    std::vector<Index> face_of_;
    Index found_last_ = -1;
    std::optional<Boxes<Kernel>> boxes_;
};

/// The visible site at the end of the chain of hiders, which become hidden in their turn. The chain
/// is shortened for those who come after. Precondition: the site is hidden.
inline Index end_of_chain(std::span<Index> hidden_by, Index hidden) {
    const auto by = [&](Index i) -> Index& { return hidden_by[static_cast<std::size_t>(i)]; };
    Index end = hidden;
    while (by(end) >= 0) end = by(end);
    while (by(hidden) != end) hidden = std::exchange(by(hidden), end);
    return end;
}

/// Replaces every entry of hidden_by that is not -1, some site met during the construction, by the
/// visible site nearest to the hidden one's centre.
template <class Kernel>
void settle_hiders(const Topology& topology, Kernel& kernel, std::span<Index> hidden_by) {
    if (std::all_of(hidden_by.begin(), hidden_by.end(), [](Index by) { return by < 0; })) return;
    NearestVisible<Kernel> nearest_visible(topology, kernel, hidden_by.size());
    for (std::size_t i = 0; i < hidden_by.size(); ++i) {
        if (hidden_by[i] < 0) continue;
        const Index hidden = static_cast<Index>(i);
        hidden_by[i] = nearest_visible(hidden, end_of_chain(hidden_by, hidden));
    }
}

}  // namespace signum::triangulation
