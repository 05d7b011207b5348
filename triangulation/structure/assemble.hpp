#pragma once
/// From the working structure to the canonical arrays of the result.

#include <span>

#include "../../core/index.hpp"
#include "../../core/parallel.hpp"
#include "../arrays.hpp"
#include "topology.hpp"

namespace signum::triangulation {

/// Faces as triples of input numbers, rotated and sorted by the ranks of their vertices, with their
/// neighbours: laws 1 to 3 of arrays.hpp. number[v] is the input number of vertex v, rank[v] its
/// place in the order that is asked for; both may be the same. Consumes the topology. O(n) but for
/// the sorting of faces that share their first vertex.
void assemble(Topology topology, std::span<const Index> number, std::span<const Index> rank,
              TessellationArrays& result, const Workers& workers);

}  // namespace signum::triangulation
