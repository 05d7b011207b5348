#pragma once
/// signum voronoi for sites in space.

#include <span>

#include "voronoi_call.hpp"

namespace signum::cli {

/// From sites that were read to files and summary. Throws CallError where the call asks for what is
/// of the plane alone.
void voronoi_in_space(const VoronoiCall& call, const InputSites& sites,
                      std::span<const Target> targets);

}  // namespace signum::cli
