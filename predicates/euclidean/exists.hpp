#pragma once
/// Existence of a Voronoi vertex: does a circle touch i, j, k counterclockwise?
///
/// Law: where no site hides another (all p > 0), with C, Q and 2ab of polynomials.hpp, it does
/// where
///     Q < 0 and C > 0,  or  Q > 0 and 2ab > 0,  or  Q = 0, C > 0 and 2ab > 0.
/// Under the tie rule also where Q = 0, C and 2ab differ in sign, and p of the two others is
/// strictly larger than both p at the last site: a line touches all three, the last recedes, and a
/// circle of nearly infinite radius takes the place of the line.

#include <array>

#include <signum/core/index.hpp>
#include <signum/core/sign.hpp>
#include <signum/core/site.hpp>
#include <signum/filters/tally.hpp>

namespace signum::euclidean {

/// +1 where a finite circle touches i, j, k counterclockwise, -1 where none does, which includes
/// that one hides another or touches it from inside. Never 0. Precondition: finite numbers.
[[nodiscard]] Decision exists_decision(const Site& i, const Site& j, const Site& k) noexcept;

/// The same under the tie rule. `ranks` are the places of i, j and k in the rule's order.
[[nodiscard]] Decision exists_perturbed_decision(const Site& i, const Site& j, const Site& k,
                                                 const std::array<Index, 3>& ranks) noexcept;

}  // namespace signum::euclidean
