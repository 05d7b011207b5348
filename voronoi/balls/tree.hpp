#pragma once
/// A tree of boxes around balls, with the least and the greatest radius in each. For sources only.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "../../core/index.hpp"
#include "../../core/site.hpp"

namespace signum::spatial {

class BallTree {
 public:
    struct Node {
        std::array<double, 3> low, high;
        double least_radius, greatest_radius;
        /// The balls in it, in the order of the tree.
        std::uint32_t first, last;
        /// Its second half; the first one is the next node. 0 of a leaf.
        std::uint32_t second;
    };

    BallTree(std::vector<Site3> balls, std::vector<Index> names)
        : balls_(std::move(balls)), names_(std::move(names)) {
        if (!balls_.empty()) build();
    }

    [[nodiscard]] const std::vector<Node>& nodes() const noexcept { return nodes_; }
    /// In the order of the tree, in which what is near in space is near.
    [[nodiscard]] const Site3& ball(std::size_t place) const noexcept { return balls_[place]; }
    [[nodiscard]] Index name(std::size_t place) const noexcept { return names_[place]; }
    [[nodiscard]] std::size_t size() const noexcept { return balls_.size(); }

 private:
    static constexpr std::uint32_t most_in_a_leaf = 6;

    void build() {
        order_.resize(balls_.size());
        std::iota(order_.begin(), order_.end(), 0U);
        build(0, static_cast<std::uint32_t>(balls_.size()));
        std::vector<Site3> balls;
        std::vector<Index> names;
        for (const std::uint32_t i : order_) {
            balls.push_back(balls_[i]);
            names.push_back(names_[i]);
        }
        balls_ = std::move(balls);
        names_ = std::move(names);
        order_ = {};
    }
    void build(std::uint32_t first, std::uint32_t last) {
        const std::size_t number = nodes_.size();
        const Site3& any = balls_[order_[first]];
        Node node{{any.x, any.y, any.z}, {any.x, any.y, any.z}, any.r, any.r, first, last, 0};
        for (std::uint32_t i = first; i < last; ++i) {
            const Site3& ball = balls_[order_[i]];
            const std::array<double, 3> centre{ball.x, ball.y, ball.z};
            for (std::size_t k = 0; k < 3; ++k) {
                node.low[k] = std::min(node.low[k], centre[k]);
                node.high[k] = std::max(node.high[k], centre[k]);
            }
            node.least_radius = std::min(node.least_radius, ball.r);
            node.greatest_radius = std::max(node.greatest_radius, ball.r);
        }
        nodes_.push_back(node);
        if (last - first <= most_in_a_leaf) return;
        const auto extent = [&](std::size_t k) { return node.high[k] - node.low[k]; };
        std::size_t axis = extent(1) > extent(0) ? 1 : 0;
        if (extent(2) > extent(axis)) axis = 2;
        static constexpr double Site3::*const axes[] = {&Site3::x, &Site3::y, &Site3::z};
        const auto at = axes[axis];
        const std::uint32_t middle = first + (last - first) / 2;
        std::nth_element(
            order_.begin() + first, order_.begin() + middle, order_.begin() + last,
            [&](std::uint32_t i, std::uint32_t j) { return balls_[i].*at < balls_[j].*at; });
        build(first, middle);
        nodes_[number].second = static_cast<std::uint32_t>(nodes_.size());
        build(middle, last);
    }

    std::vector<Site3> balls_;
    std::vector<Index> names_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
};

}  // namespace signum::spatial
