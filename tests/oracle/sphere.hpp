#pragma once
/// The canonical form of faces, and what every tessellation has to be: a triangulated sphere.

#include "oracle.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace signum::oracle {

/// The vertex at infinity.
inline constexpr std::int32_t at_infinity = -1;

/// The same triple, rotated so that its smallest number comes first.
std::array<std::int32_t, 3> canonical(std::array<std::int32_t, 3> face);

/// Throws std::logic_error, saying what is wrong, unless `tessellation` is a sphere over the
/// `visible` sites (visible[i] says whether site i is) and infinity: n visible sites and infinity
/// are v = n + 1 vertices, with e = 3n - 3 edges and f = 2n - 2 faces (n <= 1: no face at all);
/// every visible site and no hidden one is in a face; no face names a vertex twice; u -> v is an
/// edge of a face as often as v -> u; the faces around each vertex hang together, and so do all
/// faces; faces are canonical and sorted; hidden lists the other sites, each with a visible one.
void check_sphere(const Tessellation& tessellation, const std::vector<bool>& visible);

}  // namespace signum::oracle
