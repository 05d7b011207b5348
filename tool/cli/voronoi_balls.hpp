#pragma once
/// signum voronoi for balls in space, in the Euclidean metric.

#include <span>

#include "voronoi_call.hpp"

namespace signum::cli {

/// From balls that were read to files and summary. Throws CallError where the call asks for what is
/// of other diagrams.
void voronoi_of_balls(const VoronoiCall& call, const InputSites& sites,
                      std::span<const Target> targets);

}  // namespace signum::cli
