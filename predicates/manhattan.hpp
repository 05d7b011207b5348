#pragma once
/// The predicates of the Manhattan metric: diamonds, distance |x-cx| + |y-cy| - r.

#include <signum/predicates/additive.hpp>
#include <signum/predicates/rectangular/squares.hpp>

namespace signum::manhattan {

/// hides, exists, in_circle and in_circle_infinite under the tie rule.
using Perturbed = rectangular::Perturbed<rectangular::Manhattan>;

}  // namespace signum::manhattan
