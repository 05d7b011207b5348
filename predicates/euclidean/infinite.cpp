#include <signum/predicates/euclidean/infinite.hpp>

#include <signum/predicates/ccw.hpp>
#include <signum/predicates/euclidean/cold_ladder.hpp>
#include <signum/predicates/euclidean/filter.hpp>
#include <signum/predicates/euclidean/radii.hpp>

namespace signum::euclidean {
namespace {

/// Of equal radii s = z = 0.
[[nodiscard]] Decision side(const Site& a, const Site& b, const Site& q) noexcept {
    const Decision turn = ccw_decision(a, b, q);
    return {-turn.sign, turn.stage};
}

}  // namespace

Decision in_circle_infinite_decision(const Site& a, const Site& b, const Site& q) noexcept {
    if (same_radius(a, b, q)) return side(a, b, q);
    return decide(
        filter::in_circle_infinite,
        [](const auto& d) { return in_circle_infinite(d[0], d[1], d[2]); }, a, b, q);
}

Decision in_circle_infinite_perturbed_decision(const Site& a, const Site& b, const Site& q,
                                               const std::array<Index, 3>& ranks) noexcept {
    const auto question = [&ranks](const auto& d) {
        return in_circle_infinite_perturbed(d, ranks);
    };
    if (same_radius(a, b, q)) {
        const Decision decision = side(a, b, q);
        if (decision.sign != 0) return decision;
        return decide_exactly(std::array{a, b, q}, question);
    }
    return decide(filter::in_circle_infinite, question, a, b, q);
}

}  // namespace signum::euclidean
