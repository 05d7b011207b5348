#pragma once
/// The predicates of the supremum metric: squares, distance max(|x-cx|, |y-cy|) - r.

#include <signum/predicates/additive.hpp>
#include <signum/predicates/rectangular/squares.hpp>

namespace signum::supremum {

/// The predicates under the tie rule.
template <additive::Stages stages = additive::Stages::exact>
using Perturbed = rectangular::Perturbed<rectangular::Supremum, stages>;

}  // namespace signum::supremum
