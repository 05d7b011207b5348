#pragma once
/// Indices: sites, faces and half-edges are numbered by 32-bit integers.

#include <cstdint>

namespace signum {

/// The number of a site, a face, a half-edge: from 0, in the order of the input or of the array.
using Index = std::int32_t;

/// The vertex at infinity, in every triple of vertices.
inline constexpr Index infinite = -1;

/// n sites have 2n-2 faces and so fewer than 6n half-edges, which must stay below 2^31.
inline constexpr std::int64_t max_sites = 357'913'941;
/// Sites that lie at random in space have seven cells each, of which there may be 2^31 - 1.
inline constexpr std::int64_t max_sites_in_space = std::int64_t{1} << 28;

}  // namespace signum
