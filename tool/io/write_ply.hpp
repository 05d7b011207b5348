#pragma once
/// Sites and faces as a PLY file in ASCII, whose vertices read_sites() reads back to the same
/// doubles.

#include <ostream>
#include <span>

#include "../../triangulation/tessellation.hpp"

namespace signum {

/// A vertex a site, at z = 0, with its radius or weight, and the finite faces.
void write_ply(std::ostream& out, const Tessellation& tessellation);
/// A vertex a site, with its radius or weight, and no faces.
void write_ply(std::ostream& out, std::span<const Site3> sites, WeightIs weight_is);

}  // namespace signum
