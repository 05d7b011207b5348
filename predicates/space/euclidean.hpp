#pragma once
/// The predicates of the Euclidean metric of space with additive weights (balls): distance
/// |x-c| - r.
///
/// Sites are signum::Site3, balls of any finite radii, negative ones included: only differences of
/// radii matter. They may intersect, touch, nest and coincide.
///
/// Laws:
///  1. Exact for all finite doubles, in every floating-point environment, in constant time; never
///     perturbed: 0 is said where something touches.
///  2. A sphere with centre c and radius rho touches ball i from outside where the distance
///     |c - c_i| is rho + r_i; rho may be negative. At most two spheres touch four balls, but for
///     degenerate ones. The points of contact of the one turn as i, j, k, l do in ccw(i,j,k,l) > 0,
///     those of the other the other way. Of equal radii the first one exists where ccw(i,j,k,l) >
///     0, and in_sphere is that of points.
/// Source: Gavrilova 1998, 4.5; the identities of formulas/balls.hpp.

#include <concepts>

#include "../../core/contract.hpp"
#include "../../core/sign.hpp"
#include "../../core/site.hpp"
#include "../../filters/tally.hpp"
#include "../arithmetic.hpp"

namespace signum::euclidean {

/// Whether a sphere touches i, j, k and l from outside, its points of contact positively oriented:
/// +1 or -1, with the stage that decided. Precondition of all: finite numbers.
[[nodiscard]] Decision exists_decision(const Site3& i, const Site3& j, const Site3& k,
                                       const Site3& l) noexcept;
/// The sign alone, as a yes or a no.
[[nodiscard]] inline bool exists(const Site3& i, const Site3& j, const Site3& k,
                                 const Site3& l) noexcept {
    SIGNUM_EXPECTS(are_finite(i, j, k, l));
    return exists_decision(i, j, k, l).sign > 0;
}

/// Of the sphere that exists(i,j,k,l): +1 where q conflicts with it (is nearer to its centre than
/// they are), 0 where q touches it, -1 otherwise; q may be hidden. Precondition: exists(i,j,k,l).
[[nodiscard]] Decision in_sphere_decision(const Site3& i, const Site3& j, const Site3& k,
                                          const Site3& l, const Site3& q) noexcept;
/// The sign alone.
[[nodiscard]] inline Sign in_sphere(const Site3& i, const Site3& j, const Site3& k, const Site3& l,
                                    const Site3& q) noexcept {
    SIGNUM_EXPECTS(are_finite(i, j, k, l, q));
    return in_sphere_decision(i, j, k, l, q).sign;
}

/// Whether i alone hides q: covers it, |c_i - c_q| <= r_i - r_q, the same place and size included;
/// +1 or -1.
[[nodiscard]] Decision hides_decision(const Site3& i, const Site3& q) noexcept;
/// The same. (A template, so that three numbers in braces stay a site of the plane.)
template <std::same_as<Site3> S>
[[nodiscard]] inline bool hidden(const S& q, const S& i) noexcept {
    SIGNUM_EXPECTS(are_finite(q, i));
    return hides_decision(i, q).sign > 0;
}

/// The same text in the plane, where euclidean.hpp has predicates of its own.
namespace balls {

[[nodiscard]] Decision exists_decision(const Site& i, const Site& j, const Site& k) noexcept;
[[nodiscard]] Decision in_circle_decision(const Site& i, const Site& j, const Site& k,
                                          const Site& q) noexcept;
[[nodiscard]] Decision hides_decision(const Site& i, const Site& q) noexcept;

}  // namespace balls
}  // namespace signum::euclidean
