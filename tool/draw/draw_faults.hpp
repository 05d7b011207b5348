#pragma once
/// A picture of somebody's triangulation, its faces at fault coloured.

#include <array>
#include <ostream>
#include <span>

#include "../../core/strided_sites.hpp"
#include "../../triangulation/validate_finite.hpp"

namespace signum {

/// How many faces without fault are drawn; more are left out, but for what is said beneath.
inline constexpr std::size_t most_faces_drawn = 20'000;

/// SVG. A face that names a site out of range is not drawn. Titles count faces and sites from
/// `numbered_from`.
void draw_faults(std::ostream& out, std::span<const std::array<Index, 3>> faces,
                 const StridedSites& sites, const FiniteValidation& judged, int numbered_from = 0);

}  // namespace signum
