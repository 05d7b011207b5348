#pragma once
/// Balls in a tree of boxes, in which nodes that are far from one another are passed over together:
/// whatever crowds they lie in, and whatever their sizes. For sources only.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "../core/box_tree.hpp"
#include "meeting.hpp"
#include "vector.hpp"

namespace signum::motion {

template <int D>
class PairTree {
 public:
    /// Where a ball is.
    struct Place {
        Box<D> box;
        double radius = 0.0;
    };

    PairTree(const std::vector<Place>& balls, const Effects<D>& effects)
        : tree_(balls.size(), 4, D, [&](std::size_t i) { return bounds_of(balls[i]); }) {
        length_.fill(infinity);
        if (effects.periodic) length_ = effects.box->lengths();
        for (const std::uint32_t i : tree_.order()) balls_.push_back(bounds_of(balls[i]));
    }

    /// Calls visit(i, j), i != j, once for each pair of balls whose gap may be bound() or less,
    /// until it returns false.
    template <class Bound, class Visit>
    bool visit_pairs(const Bound& bound, const Visit& visit) const {
        return Search<Bound, Visit>{*this, bound, visit}.within(0);
    }

 private:
    /// The last number is the radius.
    using Tree = BoxTree<D + 1>;
    using Bounds = typename Tree::Bounds;

    [[nodiscard]] static Bounds bounds_of(const Place& ball) noexcept {
        Bounds bounds;
        bounds.low[D] = bounds.high[D] = ball.radius;
        std::copy_n(ball.box.low.begin(), D, bounds.low.begin());
        std::copy_n(ball.box.high.begin(), D, bounds.high.begin());
        return bounds;
    }
    /// How far two boxes are apart along an axis, or less.
    [[nodiscard]] double apart(const Bounds& a, const Bounds& b, int axis) const noexcept {
        const auto k = static_cast<std::size_t>(axis);
        const double from = a.low[k] - b.high[k];
        const double to = a.high[k] - b.low[k];
        const double length = length_[axis];
        if (length == infinity) return std::max({0.0, from, -to});
        const double over = from - length * std::floor(from / length);
        const double under = length - (over + (to - from));
        const double error = 0x1p-48 * (std::fabs(from) + std::fabs(to) + length);
        // NaN where a box has no end.
        const double least = std::min(over, under) - error;
        return least > 0.0 ? least : 0.0;
    }
    /// Whether all gaps between balls of the two are certainly above the bound. Each sum and
    /// product errs by a few parts in 2^53, in every rounding mode.
    [[nodiscard]] bool are_apart(const Bounds& a, const Bounds& b, double bound) const noexcept {
        const double radii = a.high[D] + b.high[D];
        const double reach = (radii + bound) + 0x1p-48 * (radii + std::fabs(bound));
        if (reach < 0.0) return true;
        double square = 0.0;
        for (int k = 0; k < D; ++k) {
            const double d = apart(a, b, k);
            square += d * d;
        }
        return square * (1.0 - 0x1p-48) > reach * reach + 0x1p-1000;
    }

    template <class Bound, class Visit>
    struct Search {
        const PairTree& all;
        const Bound& bound;
        const Visit& visit;

        bool pair(std::uint32_t i, std::uint32_t j) const {
            if (all.are_apart(all.balls_[i], all.balls_[j], bound())) return true;
            return visit(all.tree_.order()[i], all.tree_.order()[j]);
        }
        bool within(std::uint32_t number) const {
            const auto& node = all.tree_.nodes()[number];
            if (node.second != 0)
                return within(number + 1) && within(node.second) &&
                       between(number + 1, node.second);
            for (std::uint32_t i = node.first; i < node.last; ++i)
                for (std::uint32_t j = node.first; j < i; ++j)
                    if (!pair(i, j)) return false;
            return true;
        }
        bool between(std::uint32_t one, std::uint32_t other) const {
            const auto& a = all.tree_.nodes()[one];
            const auto& b = all.tree_.nodes()[other];
            if (all.are_apart(a, b, bound())) return true;
            if (a.second == 0 && b.second == 0) {
                for (std::uint32_t i = a.first; i < a.last; ++i)
                    for (std::uint32_t j = b.first; j < b.last; ++j)
                        if (!pair(i, j)) return false;
                return true;
            }
            if (b.second == 0 || (a.second != 0 && a.last - a.first >= b.last - b.first))
                return between(one + 1, other) && between(a.second, other);
            return between(one, other + 1) && between(one, b.second);
        }
    };

    Vector<D> length_;  // of a periodic box; infinite of a world without images
    Tree tree_;
    std::vector<Bounds> balls_;  // by their places in it
};

}  // namespace signum::motion
