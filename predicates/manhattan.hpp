#pragma once
/// The predicates of the Manhattan metric: diamonds, distance |x-cx| + |y-cy| - r.

#include <signum/predicates/additive.hpp>
#include <signum/predicates/rectangular/squares.hpp>

namespace signum::manhattan {

/// The predicates under the tie rule.
template <additive::Stages stages = additive::Stages::exact>
using Perturbed = rectangular::Perturbed<rectangular::Manhattan, stages>;

}  // namespace signum::manhattan
