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
/// A kind are all visible balls of one radius, if they are not too few.
///
/// Laws:
///  1. each sphere that touches four of a kind, with centres not in a plane, and that no ball
///     conflicts with, is that of one of `fours`, and only of one. These are rising, and the first
///     touches before all others of the kind;
///  2. each curve that three of a kind touch along, on which no vertex lies, and with none of whose
///     spheres a ball conflicts, is that of one of `curves`, and only of one: all of the kind that
///     touch along it, rising. There are none where the centres lie in no plane, since the spheres
///     through three points come by all that is beside their plane.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "../../core/index.hpp"
#include "../../triangulation/options.hpp"
#include "set.hpp"

namespace signum::balls {

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

    /// Those whose first ball is this.
    [[nodiscard]] std::span<const Quadruple> fours(Index first) const {
        return with(first, fours_);
    }
    [[nodiscard]] std::span<const std::vector<Index>> curves(Index first) const {
        return with(first, curves_);
    }

 private:
    template <class List>
    [[nodiscard]] static std::span<const List> with(Index first, const std::vector<List>& all) {
        const auto first_of = [](const List& list) { return list.front(); };
        return {std::ranges::lower_bound(all, first, {}, first_of),
                std::ranges::upper_bound(all, first, {}, first_of)};
    }
    void tessellate(const BallSet& balls, std::span<const Index> kind, const Options& options);

    std::vector<Kind> kinds_;
    std::vector<Quadruple> fours_;
    std::vector<std::vector<Index>> curves_;
};

}  // namespace signum::balls
