#pragma once
/// Who hides whom, settled at the end: the visible site nearest to each hidden site's centre.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "../../core/box_tree.hpp"
#include "../../core/index.hpp"
#include "../../core/parallel.hpp"
#include "../../core/site.hpp"
#include "../../exact/floating_environment.hpp"
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
        tree_ = {sites_.size(), 8, 2, [&](std::size_t k) {
                     const Point centre = kernel_.centre(sites_[k]);
                     return Bounds<3>::point({centre.x, centre.y, kernel_.weight(sites_[k])});
                 }};
    }

    /// The site nearest to the centre of q, given any.
    [[nodiscard]] Index nearest(Index q, Index known) {
        const Point point = kernel_.centre(q);
        const auto may_be_nearer = [&](const Bounds<3>& box) {
            const Site best = {std::clamp(point.x, box.low[0], box.high[0]),
                               std::clamp(point.y, box.low[1], box.high[1]), box.high[2]};
            return kernel_.would_be_nearer(q, best, known);
        };
        tree_.visit(may_be_nearer, [&](std::uint32_t place) {
            const Index i = sites_[tree_.order()[place]];
            if (i != known && kernel_.is_nearer(q, i, known)) known = i;
        });
        return known;
    }

 private:
    Kernel& kernel_;
    std::vector<Index> sites_;
    BoxTree<3> tree_;
};

/// Finds the visible sites nearest to the centres of hidden ones.
template <class Kernel, class InBoxes>
class NearestVisible {
 public:
    /// `face_of` has a face at every visible site; in_boxes(q, known) finds the nearest one by
    /// other means. Nothing is copied but the latter.
    NearestVisible(const Topology& topology, Kernel& kernel, std::span<const Index> face_of,
                   InBoxes in_boxes)
        : topology_(topology), kernel_(kernel), face_of_(face_of), in_boxes_(in_boxes) {}

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
                    if (v < 0) return in_boxes_(q, nearest);
                }
                const auto distance = kernel_.distance(q, v);
                if (kernel_.is_nearer(q, v, distance, nearest, least)) {
                    before = std::exchange(nearest, v);
                    least = distance;
                    improved = true;
                    break;
                }
                if (is_long) [[unlikely]]
                    return in_boxes_(q, nearest);
            }
        }
        return nearest;
    }
    const Topology& topology_;
    Kernel& kernel_;
    std::span<const Index> face_of_;
    InBoxes in_boxes_;
    Index found_last_ = -1;
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
/// visible site nearest to the hidden one's centre. Kernels that count have one worker.
template <class Kernel>
void settle_hiders(const Topology& topology, Kernel& kernel, std::span<Index> hidden_by,
                   const Workers& workers) {
    const std::vector<Index> hidden = collected<Index>(
        workers, hidden_by.size(), [&](std::size_t begin, std::size_t end, auto& list) {
            for (std::size_t i = begin; i < end; ++i)
                if (hidden_by[i] >= 0) list.push_back(static_cast<Index>(i));
        });
    if (hidden.empty()) return;
    for (const Index i : hidden)
        hidden_by[static_cast<std::size_t>(i)] = end_of_chain(hidden_by, i);
    const std::vector<Index> face_of = faces_of_vertices(topology, hidden_by.size(), workers);
    // Boxes are for all; who asks first makes them.
    std::optional<Boxes<Kernel>> boxes;
    std::once_flag are_made;
    const auto in_boxes = [&](Index q, Index known) {
        std::call_once(are_made, [&] { boxes.emplace(kernel, face_of); });
        return boxes->nearest(q, known);
    };
    const auto settle = [&](std::size_t begin, std::size_t end) {
        const exact::IeeeEnvironment environment;
        NearestVisible nearest_visible(topology, kernel, face_of, in_boxes);
        for (std::size_t k = begin; k < end; ++k) {
            Index& by = hidden_by[static_cast<std::size_t>(hidden[k])];
            by = nearest_visible(hidden[k], by);
        }
    };
    if (Kernel::is_exact && !Kernel::counts)
        workers.each_range(hidden.size(), settle);
    else
        settle(0, hidden.size());
}

}  // namespace signum::triangulation
