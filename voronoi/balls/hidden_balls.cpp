#include "hidden_balls.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>

#include "../../predicates/space/euclidean.hpp"
#include "tree.hpp"

namespace signum::balls {
namespace {

[[nodiscard]] bool hides(const BallSet& balls, Index i, Index q) noexcept {
    if (i == q || euclidean::hides_decision(balls[i], balls[q]).sign < 0) return false;
    return i < q || euclidean::hides_decision(balls[q], balls[i]).sign < 0;
}
/// Who may hide a ball, of some.
class Hiders {
 public:
    explicit Hiders(BallTree tree) : tree_(std::move(tree)), least_names_(tree_.nodes().size()) {
        // What is in a node follows it.
        for (std::size_t number = least_names_.size(); number-- > 0;) {
            const BallTree::Node& node = tree_.nodes()[number];
            Index& least = least_names_[number] = tree_.name(node.first);
            for (std::size_t place = node.first; node.second == 0 && place < node.last; ++place)
                least = std::min(least, tree_.name(place));
            if (node.second != 0)
                least = std::min(least_names_[number + 1], least_names_[node.second]);
        }
    }

    /// One for which `hides` holds, or none. Of these the largest are asked first.
    template <class Hides>
    [[nodiscard]] Index any(const Site3& q, const Hides& hides) const {
        Index found = none;
        tree_.visit([&](const BallTree::Node& node) { return may_hide(node, q); },
                    [](const BallTree::Node& one, const BallTree::Node& other) {
                        return one.high[3] < other.high[3];
                    },
                    [&](const BallTree::Node& node) {
                        for (std::size_t place = node.first; place < node.last; ++place)
                            if (tree_.ball(place).r >= q.r && hides(tree_.name(place))) {
                                found = tree_.name(place);
                                return false;
                            }
                        return true;
                    });
        return found;
    }
    /// The least for which `hides` holds, or none.
    template <class Hides>
    [[nodiscard]] Index least(const Site3& q, const Hides& hides) const {
        Index least = none;
        const auto least_name = [&](const BallTree::Node& node) {
            return least_names_[tree_.number_of(node)];
        };
        tree_.visit(
            [&](const BallTree::Node& node) {
                return least_name(node) < least && may_hide(node, q);
            },
            [&](const BallTree::Node& one, const BallTree::Node& other) {
                return least_name(other) < least_name(one);
            },
            [&](const BallTree::Node& node) {
                for (std::size_t place = node.first; place < node.last; ++place)
                    if (tree_.name(place) < least && tree_.ball(place).r >= q.r &&
                        hides(tree_.name(place)))
                        least = tree_.name(place);
                return true;
            });
        return least;
    }

    static constexpr Index none = std::numeric_limits<Index>::max();

 private:
    [[nodiscard]] static bool may_hide(const BallTree::Node& node, const Site3& q) {
        const double more = node.high[3] - q.r;
        if (more < 0.0) return false;
        const std::array<double, 3> centre{q.x, q.y, q.z};
        double square = 0.0;
        for (std::size_t k = 0; k < 3; ++k) {
            const double away = std::max({node.low[k] - centre[k], centre[k] - node.high[k], 0.0});
            square += away * away;
        }
        return !(square * (1.0 - 0x1p-48) > more * more + 0x1p-1000);
    }

    BallTree tree_;
    std::vector<Index> least_names_;  // by node
};

/// The first of those that are equal to each.
[[nodiscard]] std::vector<Index> first_equals(const BallSet& balls) {
    const auto numbers = [&](Index i) {
        const Site3& b = balls[i];
        return std::array{b.x, b.y, b.z, b.r};
    };
    std::vector<Index> order(balls.size()), result(balls.size());
    std::iota(order.begin(), order.end(), Index{0});
    std::ranges::sort(order, [&](Index i, Index j) {
        const auto a = numbers(i), b = numbers(j);
        return a != b ? a < b : i < j;
    });
    for (std::size_t k = 0; k < order.size(); ++k) {
        const auto i = static_cast<std::size_t>(order[k]);
        const bool is_first = k == 0 || numbers(order[k - 1]) != numbers(order[k]);
        result[i] = is_first ? order[k] : result[static_cast<std::size_t>(order[k - 1])];
    }
    return result;
}

}  // namespace

std::vector<Hidden> hidden_balls(const BallSet& balls) {
    std::vector<Hidden> result;
    if (balls.size() == 0) return result;
    const std::vector<Index> first = first_equals(balls);
    std::vector<Index> different, visible;
    for (std::size_t i = 0; i < first.size(); ++i)
        if (first[i] == static_cast<Index>(i)) different.push_back(first[i]);
    std::vector<Index> by(balls.size(), Hiders::none);
    const auto hider_of = [&](Index q) -> Index& { return by[static_cast<std::size_t>(q)]; };
    const auto hides_it = [&](Index q) { return [&, q](Index i) { return hides(balls, i, q); }; };
    const Hiders all(balls.tree_of(different));
    for (const Index q : different) {
        hider_of(q) = all.any(balls.scaled(q), hides_it(q));
        if (hider_of(q) == Hiders::none) visible.push_back(q);
    }
    const Hiders largest(balls.tree_of(visible));
    for (const Index q : different)
        if (hider_of(q) != Hiders::none) hider_of(q) = largest.least(balls.scaled(q), hides_it(q));
    for (std::size_t i = 0; i < first.size(); ++i) {
        const auto q = static_cast<Index>(i);
        const Index of_first = hider_of(first[i]);
        if (first[i] != q) {
            result.push_back({q, of_first == Hiders::none ? first[i] : of_first});
        } else if (of_first != Hiders::none) {
            result.push_back({q, of_first});
        }
    }
    return result;
}

}  // namespace signum::balls
