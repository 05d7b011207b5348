#pragma once
/// What the Delaunay tessellations of balls with equal radii know of their diagram beforehand. For
/// sources only.
///
/// A sphere that touches four balls of equal radii, and with which no ball conflicts, is empty of
/// the others of this radius, too: it is a vertex of the Voronoi diagram of their centres, which a
/// Delaunay tessellation gives, however many centres lie on one sphere or in one plane. So such
/// balls need not be tried four by four, and three by three; in crystals, where there are few
/// radii, little else is left.
///
/// Laws, of balls of a kind, that is of one radius, of which there are some:
///  1. each empty sphere that touches four of them, whose centres are not in a plane, is that of
///     one of `fours`, and only of one;
///  2. each curve that touches three of them, and no sphere of which any of them conflicts with, is
///     that of one of `threes`, and only of one, if no vertex lies on it. This is so of centres in
///     a plane alone: spheres through three points come by all that lie beside their plane.
/// They are rising, and of all that it might be the first in the order of words.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "../core/index.hpp"
#include "../triangulation/options.hpp"
#include "ball_set.hpp"

namespace signum::spatial {

class EqualRadii {
 public:
    /// 0 of those whose radius few have.
    using Kind = std::uint32_t;

    EqualRadii(const BallSet& balls, std::span<const Index> visible, const Options& options);

    [[nodiscard]] Kind kind(Index i) const noexcept { return kinds_[static_cast<std::size_t>(i)]; }
    template <std::size_t n>
    [[nodiscard]] bool are_of_a_kind(const std::array<Index, n>& names) const noexcept {
        for (const Index i : names)
            if (kind(i) != kind(names[0])) return false;
        return kind(names[0]) != 0;
    }

    /// Those whose first ball, the first of its kind that touches the sphere or along the curve, is
    /// this.
    [[nodiscard]] std::span<const Quadruple> fours(Index first) const {
        return with(first, fours_);
    }
    [[nodiscard]] std::span<const Triple> threes(Index first) const { return with(first, threes_); }

 private:
    template <std::size_t n>
    [[nodiscard]] static std::span<const std::array<Index, n>> with(
        Index first, const std::vector<std::array<Index, n>>& all) {
        const auto range = std::ranges::equal_range(
            all, first, {}, [](const std::array<Index, n>& tuple) { return tuple[0]; });
        return {range.begin(), range.end()};
    }
    void tessellate(const BallSet& balls, std::span<const Index> kind, const Options& options);

    std::vector<Kind> kinds_;
    std::vector<Quadruple> fours_;
    std::vector<Triple> threes_;
};

}  // namespace signum::spatial
