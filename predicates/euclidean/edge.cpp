#include <signum/predicates/euclidean/edge.hpp>

#include <signum/predicates/ccw.hpp>
#include <signum/predicates/euclidean/cold_ladder.hpp>
#include <signum/predicates/euclidean/filter.hpp>
#include <signum/predicates/euclidean/radii.hpp>

namespace signum::euclidean {
namespace {

[[nodiscard]] filters::Verdict bounded_filter(const Site& i, const Site& j,
                                              const Site& k) noexcept {
    if (!filters::environment_is_default()) [[unlikely]]
        return filters::Verdict::uncertain();
    const filter::Triple t(i, j, k);
    return t.in_window() ? t.sign_of_q() : filters::Verdict::uncertain();
}

/// The point as a site of the radius of a, so that it adds no digit to the radii.
[[nodiscard]] filters::Verdict nearer_filter(const Site& p, const Site& a, const Site& b) noexcept {
    return filter::nearer({p.x, p.y}, a, b);
}

}  // namespace

Decision nearer_decision(Point p, const Site& a, const Site& b) noexcept {
    return decide(
        nearer_filter, [](const auto& d) { return nearer(d); }, Site{p.x, p.y, a.r}, a, b);
}

Decision edge_bounded_decision(const Site& i, const Site& j, const Site& k) noexcept {
    if (same_radius(i, j, k)) {  // Q = -C²
        const Decision turn = ccw_decision(i, j, k);
        return {turn.sign != 0 ? -1 : 0, turn.stage};
    }
    return decide(
        bounded_filter, [](const auto& d) { return edge_bounded(d); }, i, j, k);
}

}  // namespace signum::euclidean
