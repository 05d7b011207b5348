#pragma once
/// A tree of boxes around balls (a k-d tree), in which nodes that are far from one another are
/// passed over together: whatever crowds they lie in, and whatever their sizes. For sources only.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include "ball.hpp"
#include "meeting.hpp"
#include "vector.hpp"

namespace signum::motion {

/// Boxes around balls, each with the largest radius in it; nodes of a binary tree.
template <int D>
class BoxTree {
 public:
    struct Node {
        Box<D> box;
        double radius = 0.0;
        /// The balls in it, in the order of the tree.
        std::uint32_t first = 0;
        std::uint32_t last = 0;
        /// Its second half; the first one is the next node. 0 of a leaf.
        std::uint32_t second = 0;
    };

    /// `length`: of a periodic box; infinite of a world without images.
    BoxTree(const std::vector<Node>& balls, const Vector<D>& length) : length_(length) {
        order_.resize(balls.size());
        std::iota(order_.begin(), order_.end(), 0U);
        nodes_.reserve(balls.size());
        build(balls, 0, static_cast<std::uint32_t>(balls.size()));
        balls_.reserve(balls.size());
        for (const std::uint32_t i : order_) balls_.push_back(balls[i]);
    }

    /// Calls visit(i, j), i != j, once for each pair of balls whose gap may be bound() or less,
    /// until it returns false.
    template <class Bound, class Visit>
    bool visit_pairs(const Bound& bound, const Visit& visit) const {
        const auto with = Search<Bound, Visit>{*this, bound, visit};
        return with.within(0);
    }

 private:
    static constexpr std::uint32_t most_in_a_leaf = 4;

    std::uint32_t build(const std::vector<Node>& balls, std::uint32_t first, std::uint32_t last) {
        const auto number = static_cast<std::uint32_t>(nodes_.size());
        Node node = balls[order_[first]];
        for (std::uint32_t i = first + 1; i < last; ++i) {
            const Node& ball = balls[order_[i]];
            node.radius = std::max(node.radius, ball.radius);
            for (int k = 0; k < D; ++k) {
                node.box.low[k] = std::min(node.box.low[k], ball.box.low[k]);
                node.box.high[k] = std::max(node.box.high[k], ball.box.high[k]);
            }
        }
        node.first = first;
        node.last = last;
        node.second = 0;
        nodes_.push_back(node);
        if (last - first <= most_in_a_leaf) return number;
        int axis = 0;
        for (int k = 1; k < D; ++k)
            if (node.box.high[k] - node.box.low[k] > node.box.high[axis] - node.box.low[axis])
                axis = k;
        const auto middle = first + (last - first) / 2;
        const auto place = [&](std::uint32_t i) {
            const double twice = balls[i].box.low[axis] + balls[i].box.high[axis];
            return std::isfinite(twice) ? twice : 0.0;
        };
        std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last,
                         [&](std::uint32_t i, std::uint32_t j) { return place(i) < place(j); });
        build(balls, first, middle);
        nodes_[number].second = build(balls, middle, last);
        return number;
    }

    /// How far two boxes are apart along an axis, or less.
    [[nodiscard]] double apart(const Box<D>& a, const Box<D>& b, int axis) const noexcept {
        const double from = a.low[axis] - b.high[axis];
        const double to = a.high[axis] - b.low[axis];
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
    [[nodiscard]] bool are_apart(const Node& a, const Node& b, double bound) const noexcept {
        const double radii = a.radius + b.radius;
        const double reach = (radii + bound) + 0x1p-48 * (radii + std::fabs(bound));
        if (reach < 0.0) return true;
        double square = 0.0;
        for (int k = 0; k < D; ++k) {
            const double d = apart(a.box, b.box, k);
            square += d * d;
        }
        return square * (1.0 - 0x1p-48) > reach * reach + 0x1p-1000;
    }

    template <class Bound, class Visit>
    struct Search {
        const BoxTree& tree;
        const Bound& bound;
        const Visit& visit;

        bool pair(std::uint32_t i, std::uint32_t j) const {
            if (tree.are_apart(tree.balls_[i], tree.balls_[j], bound())) return true;
            return visit(tree.order_[i], tree.order_[j]);
        }
        bool within(std::uint32_t number) const {
            const Node& node = tree.nodes_[number];
            if (node.second != 0)
                return within(number + 1) && within(node.second) &&
                       between(number + 1, node.second);
            for (std::uint32_t i = node.first; i < node.last; ++i)
                for (std::uint32_t j = node.first; j < i; ++j)
                    if (!pair(i, j)) return false;
            return true;
        }
        bool between(std::uint32_t one, std::uint32_t other) const {
            const Node& a = tree.nodes_[one];
            const Node& b = tree.nodes_[other];
            if (tree.are_apart(a, b, bound())) return true;
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

    Vector<D> length_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
    std::vector<Node> balls_;  // in that order
};

}  // namespace signum::motion
