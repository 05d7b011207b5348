#include <signum/predicates/euclidean/exists.hpp>

#include <signum/predicates/ccw.hpp>
#include <signum/predicates/euclidean/cold_ladder.hpp>
#include <signum/predicates/euclidean/filter.hpp>
#include <signum/predicates/euclidean/radii.hpp>

namespace signum::euclidean {
namespace {

/// Of equal radii Q = -C², and no site hides another where C > 0.
[[nodiscard]] Decision exists_as_points(const Site& i, const Site& j, const Site& k) noexcept {
    const Decision turn = ccw_decision(i, j, k);
    return {turn.sign > 0 ? 1 : -1, turn.stage};
}

}  // namespace

Decision exists_decision(const Site& i, const Site& j, const Site& k) noexcept {
    if (same_radius(i, j, k)) return exists_as_points(i, j, k);
    return decide(
        filter::exists, [](const auto& d) { return exists(d); }, i, j, k);
}

Decision exists_perturbed_decision(const Site& i, const Site& j, const Site& k,
                                   const std::array<Index, 3>& ranks) noexcept {
    if (same_radius(i, j, k)) return exists_as_points(i, j, k);
    return decide(
        filter::exists, [&ranks](const auto& d) { return exists_perturbed(d, ranks); }, i, j, k);
}

}  // namespace signum::euclidean
