#pragma once
/// A tree of boxes around items of any kind: whoever asks about items passes over those together
/// whose box tells enough. For sources only.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace signum {

/// From the least to the greatest of each of so many numbers: coordinates, and radii and weights.
template <std::size_t numbers>
struct Bounds {
    std::array<double, numbers> low;
    std::array<double, numbers> high;

    /// Of what has no extent.
    [[nodiscard]] static Bounds point(const std::array<double, numbers>& at) { return {at, at}; }
    void include(const Bounds& other) noexcept {
        for (std::size_t k = 0; k < numbers; ++k) {
            low[k] = std::min(low[k], other.low[k]);
            high[k] = std::max(high[k], other.high[k]);
        }
    }
};

/// Items have places: their order in the tree, in which near ones are near.
template <std::size_t numbers>
class BoxTree {
 public:
    using Bounds = signum::Bounds<numbers>;
    struct Node : Bounds {
        std::uint32_t first, last;  ///< places
        std::uint32_t second;  ///< its second half; the first one is the next node. 0 of a leaf
    };

    BoxTree() = default;
    /// Of items 0 … items - 1, of which bounds_of tells the bounds. They are halved, down to so
    /// many in a leaf, along that of the first `axes` numbers in which they differ most; with no
    /// axes as they come: along a curve, in O(n).
    template <class BoundsOf>
    BoxTree(std::size_t items, std::uint32_t most_in_a_leaf, std::size_t axes,
            const BoundsOf& bounds_of)
        : BoxTree(items, most_in_a_leaf, axes, bounds_of, items,
                  [](const auto& first, const auto& second) {
                      first();
                      second();
                  }) {}
    /// The same tree with the halves of more than `most_alone` items built by both(first, second),
    /// which calls the two, at the same time if it likes.
    template <class BoundsOf, class Both>
    BoxTree(std::size_t items, std::uint32_t most_in_a_leaf, std::size_t axes,
            const BoundsOf& bounds_of, std::size_t most_alone, const Both& both)
        : order_(items) {
        if (items == 0) return;
        std::iota(order_.begin(), order_.end(), 0U);
        nodes_.reserve(4 * items / most_in_a_leaf + 1);
        std::vector<Keyed> keyed(axes > 0 ? items : 0);
        const auto build = [&](const auto& self, std::vector<Node>& nodes, std::uint32_t first,
                               std::uint32_t last) -> void {
            const std::size_t number = nodes.size();
            const bool is_leaf = last - first <= most_in_a_leaf;
            Node node{bounds_of(order_[first]), first, last, 0};
            if (is_leaf || axes > 0)
                for (std::uint32_t place = first + 1; place < last; ++place)
                    node.include(bounds_of(order_[place]));
            nodes.push_back(node);
            if (is_leaf) return;
            const std::uint32_t middle = first + (last - first) / 2;
            if (axes > 0) halve(node, middle, axes, bounds_of, keyed);
            if (last - first <= most_alone) {
                self(self, nodes, first, middle);
                nodes[number].second = static_cast<std::uint32_t>(nodes.size());
                self(self, nodes, middle, last);
            } else {
                std::array<std::vector<Node>, 2> halves;
                both([&] { self(self, halves[0], first, middle); },
                     [&] { self(self, halves[1], middle, last); });
                append(nodes, halves[0]);
                nodes[number].second = static_cast<std::uint32_t>(nodes.size());
                append(nodes, halves[1]);
            }
            if (axes > 0) return;
            nodes[number].include(nodes[number + 1]);
            nodes[number].include(nodes[nodes[number].second]);
        };
        build(build, nodes_, 0, static_cast<std::uint32_t>(items));
    }

    [[nodiscard]] const std::vector<Node>& nodes() const noexcept { return nodes_; }
    /// The items by their places.
    [[nodiscard]] const std::vector<std::uint32_t>& order() const noexcept { return order_; }
    [[nodiscard]] std::size_t number_of(const Node& node) const noexcept {
        return static_cast<std::size_t>(&node - nodes_.data());
    }

    /// Depth first: leaf(node) for each leaf that enter(node) does not refuse, nor what it is in,
    /// until one returns false. Of two halves the first comes first unless is_later(first, second).
    template <class Enter, class IsLater, class Leaf>
    bool visit(const Enter& enter, const IsLater& is_later, const Leaf& leaf) const {
        return nodes_.empty() || visit(0, enter, is_later, leaf);
    }
    /// The same in the order of places; item(place) for each in such a leaf.
    template <class Enter, class Item>
    void visit(const Enter& enter, const Item& item) const {
        const auto never = [](const Node&, const Node&) { return false; };
        visit(enter, never, [&](const Node& node) {
            for (std::uint32_t place = node.first; place < node.last; ++place) item(place);
            return true;
        });
    }

 private:
    struct Keyed {
        double key;
        std::uint32_t item;
    };
    /// Nodes that name one another by their numbers among themselves.
    static void append(std::vector<Node>& nodes, const std::vector<Node>& more) {
        const auto before = static_cast<std::uint32_t>(nodes.size());
        for (Node node : more) {
            if (node.second != 0) node.second += before;
            nodes.push_back(node);
        }
    }
    /// Halves of numbers, which do not overflow, are compared.
    template <class BoundsOf>
    void halve(const Node& node, std::uint32_t middle, std::size_t axes, const BoundsOf& bounds_of,
               std::vector<Keyed>& keyed) {
        const auto extent = [&](std::size_t k) { return 0.5 * node.high[k] - 0.5 * node.low[k]; };
        std::size_t axis = 0;
        for (std::size_t k = 1; k < axes; ++k)
            if (extent(k) > extent(axis)) axis = k;
        for (std::uint32_t place = node.first; place < node.last; ++place) {
            const Bounds bounds = bounds_of(order_[place]);
            const double key = 0.5 * bounds.low[axis] + 0.5 * bounds.high[axis];
            keyed[place] = {std::isfinite(key) ? key : 0.0, order_[place]};
        }
        const auto begin = keyed.begin();
        std::nth_element(begin + node.first, begin + middle, begin + node.last,
                         [](const Keyed& a, const Keyed& b) { return a.key < b.key; });
        for (std::uint32_t place = node.first; place < node.last; ++place)
            order_[place] = keyed[place].item;
    }

    template <class Enter, class IsLater, class Leaf>
    bool visit(std::uint32_t number, const Enter& enter, const IsLater& is_later,
               const Leaf& leaf) const {
        const Node& node = nodes_[number];
        if (!enter(node)) return true;
        if (node.second == 0) return leaf(node);
        std::uint32_t one = number + 1, other = node.second;
        if (is_later(nodes_[one], nodes_[other])) std::swap(one, other);
        return visit(one, enter, is_later, leaf) && visit(other, enter, is_later, leaf);
    }

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> order_;
};

}  // namespace signum
