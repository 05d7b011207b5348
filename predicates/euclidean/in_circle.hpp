#pragma once
/// in_circle in the Euclidean metric: does site q conflict with the vertex of i, j, k?
///
/// Law: for i, j, k that exist and q that none of them hides (q may hide some of them), with the
/// polynomials of polynomials.hpp, it is
///     Q ≠ 0:  sign(Q) · sign(A - L √Γ),  where A² - L² Γ = ¼ Q H
///     Q = 0:  sign(H) · sign(L), and sign(-C · D_xyp) where L = 0 too:
/// +1 where q is nearer to the centre of the circle than i, j, k, 0 where it is as near. Nothing of
/// degree above 8 is needed. No rounded square root decides: in the filter it carries its error.

#include <array>

#include <signum/core/index.hpp>
#include <signum/core/sign.hpp>
#include <signum/core/site.hpp>
#include <signum/filters/tally.hpp>

namespace signum::euclidean {

/// The sign and the stage that decided. Preconditions: finite numbers, exists(i,j,k), q hidden by
/// none of i, j, k.
[[nodiscard]] Decision in_circle_decision(const Site& i, const Site& j, const Site& k,
                                          const Site& q) noexcept;

/// Under the tie rule, never 0. `ranks` are the places of i, j, k and q in the rule's order
/// (falling radius, rising x, y, index); only their order counts. A q that one of i, j, k hides
/// does not conflict. Preconditions: finite numbers, i, j, k exist under the tie rule.
///
/// Where in_circle is 0: no conflict if q is the last in the order. Otherwise conflict, unless q
/// touches the circle on the arc opposite the last, m, which is exactly when p_mq · p_(other two)
/// is strictly the largest of the three products that enter H (Ptolemy).
[[nodiscard]] Decision in_circle_perturbed_decision(const Site& i, const Site& j, const Site& k,
                                                    const Site& q,
                                                    const std::array<Index, 4>& ranks) noexcept;

}  // namespace signum::euclidean
