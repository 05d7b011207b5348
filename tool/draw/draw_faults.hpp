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

/// SVG. The faces' numbers are those of sites, or such as there are not, which are not drawn.
void draw_faults(std::ostream& out, std::span<const std::array<Index, 3>> faces,
                 const StridedSites& sites, const FiniteValidation& judged);

}  // namespace signum
