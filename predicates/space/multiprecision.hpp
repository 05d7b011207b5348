#pragma once
/// The predicates of space in exact numbers: in rationals the last stage, in dyadic numbers a
/// judge's. Right for every finite double, in any environment.

#include "../../core/sign.hpp"
#include "../../core/site.hpp"
#include "../arithmetic.hpp"

namespace signum::multiprecision {

template <Arithmetic arithmetic = Arithmetic::multiprecision>
[[nodiscard]] Sign ccw(const Point3& a, const Point3& b, const Point3& c, const Point3& d) noexcept;

}  // namespace signum::multiprecision

namespace signum::power::multiprecision {

/// S: Point3, power::Site3 or signum::Site3. Preconditions as of power::in_sphere and
/// nearer_decision.
template <Arithmetic arithmetic = Arithmetic::multiprecision, class S>
[[nodiscard]] Sign in_sphere(const S& i, const S& j, const S& k, const S& l, const S& q) noexcept;
template <Arithmetic arithmetic = Arithmetic::multiprecision, class S>
[[nodiscard]] Sign nearer(const Point3& p, const S& a, const S& b) noexcept;

}  // namespace signum::power::multiprecision

namespace signum::euclidean::multiprecision {

/// +1 or -1, but for in_sphere. Preconditions as of euclidean::in_sphere_decision and the others.
template <Arithmetic arithmetic = Arithmetic::multiprecision>
[[nodiscard]] Sign in_sphere(const Site3& i, const Site3& j, const Site3& k, const Site3& l,
                             const Site3& q) noexcept;
template <Arithmetic arithmetic = Arithmetic::multiprecision>
[[nodiscard]] Sign exists(const Site3& i, const Site3& j, const Site3& k, const Site3& l) noexcept;
template <Arithmetic arithmetic = Arithmetic::multiprecision>
[[nodiscard]] Sign hides(const Site3& i, const Site3& q) noexcept;

}  // namespace signum::euclidean::multiprecision
