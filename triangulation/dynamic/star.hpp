#pragma once
/// The star of a visible site, asked which centres lie in it (power metric).

#include <algorithm>
#include <cstddef>
#include <vector>

#include "../../core/index.hpp"
#include "../structure/topology.hpp"

namespace signum::triangulation {

/// Law: a centre is in the star where it is in the closure of a finite face. O(degree) to make it;
/// a question takes O(log degree): a giant may have as many neighbours as it keeps hidden sites.
template <class Kernel>
class Star {
 public:
    /// Of the origin of a half-edge. Neither is copied.
    Star(const Topology& topology, Kernel& kernel, HalfEdge spoke)
        : kernel_(kernel), site_(topology.origin(spoke)) {
        for (const HalfEdge of : topology.fan(spoke)) ends_.push_back(topology.target(of));
        const auto infinity = std::find(ends_.begin(), ends_.end(), infinite);
        if (infinity == ends_.end()) {
            ends_.push_back(ends_.front());
        } else {
            std::rotate(ends_.begin(), infinity, ends_.end());
            ends_.erase(ends_.begin());
        }
        if (faces() > few) {
            const auto later = std::partition_point(
                ends_.begin() + 1, ends_.end() - 1,
                [&](Index end) { return kernel_.ccw(site_, ends_.front(), end) > 0; });
            half_ = static_cast<std::size_t>(later - ends_.begin());
        }
    }

    [[nodiscard]] bool contains(Index q) {
        if (faces() > few)
            return is_among(0, half_, q) || is_in(half_ - 1, q) || is_among(half_, faces(), q) ||
                   is_in(faces() - 1, q);
        for (std::size_t k = 0; k < faces(); ++k)
            if (is_in(k, q)) return true;
        return false;
    }

 private:
    static constexpr std::size_t few = 16;

    [[nodiscard]] std::size_t faces() const noexcept { return ends_.size() - 1; }
    /// Whether the face between spokes k and k + 1 holds it.
    [[nodiscard]] bool is_in(std::size_t k, Index q) {
        const Index a = ends_[k];
        const Index b = ends_[k + 1];
        return kernel_.ccw(site_, a, q) >= 0 && kernel_.ccw(a, b, q) >= 0 &&
               kernel_.ccw(b, site_, q) >= 0;
    }
    /// Whether one of the faces between the spokes from `first` to before `end` does, which turn by
    /// less than half a turn: those come first that it is not on the right of.
    [[nodiscard]] bool is_among(std::size_t first, std::size_t end, Index q) {
        const auto begin = ends_.begin();
        const auto beyond = std::partition_point(
            begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(end),
            [&](Index a) { return kernel_.ccw(site_, a, q) >= 0; });
        const auto k = static_cast<std::size_t>(beyond - begin);
        // On a spoke it is in the faces at both sides, of which one may be beyond the last spoke.
        return (k >= first + 1 && k < end && is_in(k - 1, q)) ||
               (k >= first + 2 && is_in(k - 2, q));
    }

    Kernel& kernel_;
    Index site_;
    /// Where the spokes end, counterclockwise: from one at the hull to the other one, or from one
    /// back to itself. Those before half_ are less than half a turn from the first one.
    std::vector<Index> ends_;
    std::size_t half_ = 0;
};

}  // namespace signum::triangulation
