#pragma once
/// Whether arrays are a power tessellation of the plane, from the definition: finite faces turn
/// counterclockwise and tile the hull of the centres, all their edges are those of two faces, no
/// site is in conflict with a face, and hidden sites name a visible one that none is nearer than.
/// Ties may be decided any way. In rationals, each face with every face and every site.

#include "../../core/site.hpp"

#include "oracle.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace signum::oracle {

/// The faces across from the vertices of each face.
using Neighbours = std::vector<std::array<std::int32_t, 3>>;

/// Why the arrays are none; empty if they are one. Faces may have any order and begin with any of
/// their vertices; neighbours may be missing, all of them. The weight of a site is the exact square
/// of its radius.
[[nodiscard]] std::string what_is_wrong(const Tessellation& tessellation,
                                        const Neighbours& neighbours,
                                        std::span<const signum::Site> sites);
/// The sites carry their weights themselves.
[[nodiscard]] std::string what_is_wrong(const Tessellation& tessellation,
                                        const Neighbours& neighbours,
                                        std::span<const signum::power::Site> sites);

}  // namespace signum::oracle
