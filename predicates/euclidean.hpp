#pragma once
/// The predicates of the additively weighted Euclidean metric (discs, Apollonius): distance
/// |x-c| - r.
///
/// Sites are signum::Site, discs of any finite radii, negative ones included: only differences of
/// radii matter. They may intersect, touch, nest and coincide.

#include <signum/predicates/additive.hpp>
#include <signum/predicates/euclidean/discs.hpp>
