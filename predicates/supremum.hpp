#pragma once
/// The predicates of the supremum metric: squares, distance max(|x-cx|, |y-cy|) - r.

#include <signum/predicates/additive.hpp>
#include <signum/predicates/rectangular/squares.hpp>

namespace signum::supremum {

/// hides, exists, in_circle and in_circle_infinite under the tie rule.
using Perturbed = rectangular::Perturbed<rectangular::Supremum>;

}  // namespace signum::supremum
