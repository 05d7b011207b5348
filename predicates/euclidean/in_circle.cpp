#include <signum/predicates/euclidean/in_circle.hpp>

#include <signum/predicates/euclidean/cold_ladder.hpp>
#include <signum/predicates/euclidean/filter.hpp>
#include <signum/predicates/euclidean/radii.hpp>
#include <signum/predicates/power/in_circle.hpp>

namespace signum::euclidean {
namespace {

/// Of equal radii only equal sites hide one another, and the circle exists where C > 0.
[[nodiscard]] Decision in_circle_of_points(const Site& i, const Site& j, const Site& k,
                                           const Site& q) noexcept {
    return power::in_circle_decision(Point{i.x, i.y}, Point{j.x, j.y}, Point{k.x, k.y},
                                     Point{q.x, q.y});
}

}  // namespace

Decision in_circle_decision(const Site& i, const Site& j, const Site& k, const Site& q) noexcept {
    if (same_radius(i, j, k, q)) return in_circle_of_points(i, j, k, q);
    return decide(
        filter::in_circle, [](const auto& d) { return in_circle(d); }, i, j, k, q);
}

Decision in_circle_perturbed_decision(const Site& i, const Site& j, const Site& k, const Site& q,
                                      const std::array<Index, 4>& ranks) noexcept {
    const auto question = [&ranks](const auto& d) { return in_circle_perturbed(d, ranks); };
    if (same_radius(i, j, k, q)) {
        const Decision decision = in_circle_of_points(i, j, k, q);
        if (decision.sign != 0) return decision;
        return decide_exactly(std::array{i, j, k, q}, question);
    }
    return decide(filter::in_circle_perturbed, question, i, j, k, q);
}

}  // namespace signum::euclidean
