#pragma once
/// in_circle in the Euclidean metric with one vertex at infinity.
///
/// Law: a directed line has the discs a and then b on its left and touches both (the hull edge
/// a -> b, face (b, a, ∞)). Site q conflicts where it reaches across the line: with
/// u = c_b - c_a, s = r_b - r_a, w = c_q - c_a, z = r_q - r_a, the sign of
///     (z |u|² - s u·w) - √p_ab (u x w),
/// whose resultant is |u|² · ¼ H(p_ab, p_aq, p_bq).

#include <array>

#include <signum/core/index.hpp>
#include <signum/core/sign.hpp>
#include <signum/core/site.hpp>
#include <signum/filters/tally.hpp>

namespace signum::euclidean {

/// +1 where q conflicts, 0 where it touches the line, -1 otherwise. Preconditions: finite numbers,
/// neither of a and b hides the other.
[[nodiscard]] Decision in_circle_infinite_decision(const Site& a, const Site& b,
                                                   const Site& q) noexcept;

/// Under the tie rule, never 0. `ranks` are the places of a, b and q in the rule's order. A q that
/// a or b hides does not conflict; q may hide a or b. Preconditions as above.
///
/// Where in_circle_infinite is 0: no conflict if q is the last. Otherwise conflict, unless p of the
/// last and q is strictly larger than p_ab and than p of q and the other.
[[nodiscard]] Decision in_circle_infinite_perturbed_decision(
    const Site& a, const Site& b, const Site& q, const std::array<Index, 3>& ranks) noexcept;

}  // namespace signum::euclidean
