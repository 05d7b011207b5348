#pragma once
/// The predicates of the supremum metric: squares, distance max(|x-cx|, |y-cy|) - r.

#include "additive.hpp"
#include "rectangular/squares.hpp"

namespace signum::supremum {

/// The predicates under the tie rule.
template <Arithmetic arithmetic = Arithmetic::exact>
using Perturbed = rectangular::Perturbed<rectangular::Supremum, arithmetic>;

// The meanings stand at the templates in additive.hpp.

/// Whether a square touches i, j, k counterclockwise, ties decided by the tie rule.
inline constexpr auto& exists = additive::exists<Perturbed<>>;
/// +1 where q conflicts with the vertex of i, j, k (is nearer than they are), 0 where it touches,
/// -1 otherwise.
inline constexpr auto& in_circle =
    additive::in_circle<rectangular::in_circle_decision<rectangular::Supremum>>;
/// The same at the hull edge a -> b.
inline constexpr auto& in_circle_infinite =
    additive::in_circle_infinite<rectangular::in_circle_infinite_decision<rectangular::Supremum>>;
/// Whether i alone hides q.
[[nodiscard]] inline bool hidden(const Site& q, const Site& i) noexcept {
    return additive::hidden<Perturbed<>>(q, i);
}
/// Which of two sites is nearer to a point.
inline constexpr auto& nearer = additive::nearer_site<Perturbed<>>;
/// Under the tie rule, never 0.
inline constexpr auto& in_circle_perturbed = additive::in_circle_perturbed<Perturbed<>>;
/// Under the tie rule, never 0.
inline constexpr auto& in_circle_infinite_perturbed =
    additive::in_circle_infinite_perturbed<Perturbed<>>;

}  // namespace signum::supremum
