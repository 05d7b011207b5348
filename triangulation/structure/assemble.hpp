#pragma once
/// From the working structure to the canonical arrays of the result.

#include <span>

#include "../../core/index.hpp"
#include "../../core/parallel.hpp"
#include "../arrays.hpp"
#include "topology.hpp"

namespace signum::triangulation {

/// Faces as triples of input numbers, rotated and sorted, with their neighbours: laws 1 to 3 of
/// tessellation.hpp. original[v] is the input number of vertex v. Consumes the topology. O(n) but
/// for the sorting of faces that share their smallest vertex.
void assemble(Topology topology, std::span<const Index> original, TessellationArrays& result,
              const Workers& workers);

}  // namespace signum::triangulation
