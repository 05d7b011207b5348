#include "euclidean.hpp"

#include "../ladder/balls.hpp"
#include "ball_filter.hpp"
#include "in_sphere.hpp"

namespace signum::euclidean {
namespace balls {
Decision exists_decision(const Site& i, const Site& j, const Site& k) noexcept {
    return filtered<Exists, 2>(filter::exists<2, Site, Site, Site>, i, j, k);
}
Decision in_circle_decision(const Site& i, const Site& j, const Site& k, const Site& q) noexcept {
    const auto ask = [](const Site& a, const Site& b, const Site& c, const Site& query) {
        return filter::in_sphere<2>(query, a, b, c);
    };
    return filtered<InSphere, 2>(ask, i, j, k, q);
}
Decision hides_decision(const Site& i, const Site& q) noexcept {
    return filtered<Hides, 2>(filter::hides<2, Site>, i, q);
}

}  // namespace balls

namespace {

/// Whether all radii are the same number: then the predicates are those of points, of lower degree.
template <class... Others>
[[nodiscard]] bool same_radius(const Site3& first, const Others&... others) noexcept {
    return (filters::same_number(first.r, others.r) && ...);
}

}  // namespace

Decision exists_decision(const Site3& i, const Site3& j, const Site3& k, const Site3& l) noexcept {
    using namespace balls;
    if (same_radius(i, j, k, l)) {
        const Decision turn = ccw_decision(i, j, k, l);
        return {turn.sign > 0 ? 1 : -1, turn.stage};
    }
    return filtered<Exists, 3>(balls::filter::exists<3, Site3, Site3, Site3, Site3>, i, j, k, l);
}
Decision in_sphere_decision(const Site3& i, const Site3& j, const Site3& k, const Site3& l,
                            const Site3& q) noexcept {
    using namespace balls;
    SIGNUM_EXPECTS(exists(i, j, k, l));
    if (same_radius(i, j, k, l, q))
        return power::in_sphere_decision(centre3(i), centre3(j), centre3(k), centre3(l),
                                         centre3(q));
    const auto ask = [](const Site3& a, const Site3& b, const Site3& c, const Site3& e,
                        const Site3& query) {
        return balls::filter::in_sphere<3>(query, a, b, c, e);
    };
    return filtered<InSphere, 3>(ask, i, j, k, l, q);
}
Decision hides_decision(const Site3& i, const Site3& q) noexcept {
    using namespace balls;
    return filtered<Hides, 3>(balls::filter::hides<3, Site3>, i, q);
}

}  // namespace signum::euclidean
