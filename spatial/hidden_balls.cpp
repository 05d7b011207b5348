#include "hidden_balls.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#include "../predicates/space/euclidean.hpp"
#include "ball_tree.hpp"

namespace signum::spatial {
namespace {

[[nodiscard]] bool hides(const BallSet& balls, Index i, Index q) noexcept {
    if (i == q || euclidean::hides_decision(balls[i], balls[q]).sign < 0) return false;
    return i < q || euclidean::hides_decision(balls[q], balls[i]).sign < 0;
}
/// Calls visit(i) for all that may hide q, until it returns false.
template <class Visit>
bool visit_hiders(const BallTree& tree, std::size_t number, const Site3& q, const Visit& visit) {
    const BallTree::Node& node = tree.nodes()[number];
    const double more = node.greatest_radius - q.r;
    if (more < 0.0) return true;
    const std::array<double, 3> centre{q.x, q.y, q.z};
    double square = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
        const double away = std::max({node.low[k] - centre[k], centre[k] - node.high[k], 0.0});
        square += away * away;
    }
    if (square * (1.0 - 0x1p-48) > more * more + 0x1p-1000) return true;
    if (node.second != 0)
        return visit_hiders(tree, number + 1, q, visit) &&
               visit_hiders(tree, node.second, q, visit);
    for (std::size_t place = node.first; place < node.last; ++place)
        if (tree.ball(place).r >= q.r && !visit(tree.name(place))) return false;
    return true;
}

}  // namespace

std::vector<Hidden> hidden_balls(const BallSet& balls) {
    std::vector<Hidden> result;
    std::vector<Index> all(balls.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<Index>(i);
    if (all.empty()) return result;
    const BallTree tree = balls.tree_of(all);
    std::vector<char> is_hidden(balls.size());
    for (const Index q : all) {
        const auto is_no_hider = [&](Index i) { return !hides(balls, i, q); };
        if (visit_hiders(tree, 0, balls.scaled(q), is_no_hider)) continue;
        is_hidden[static_cast<std::size_t>(q)] = 1;
        result.push_back({q, q});
    }
    for (Hidden& hidden : result) {
        const Index q = hidden.site;
        hidden.by = std::numeric_limits<Index>::max();
        const auto note = [&](Index i) {
            if (i < hidden.by && is_hidden[static_cast<std::size_t>(i)] == 0 && hides(balls, i, q))
                hidden.by = i;
            return true;
        };
        visit_hiders(tree, 0, balls.scaled(q), note);
    }
    return result;
}

}  // namespace signum::spatial
