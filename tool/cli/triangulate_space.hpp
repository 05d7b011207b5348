#pragma once
/// signum triangulate for sites in space.

#include <span>

#include "triangulate_call.hpp"

namespace signum::cli {

/// From sites that were read to files and summary. Throws CallError where the call asks for what is
/// of the plane alone.
void triangulate_in_space(const TriangulateCall& call, const InputSites& sites,
                          std::span<const Target> targets);

}  // namespace signum::cli
