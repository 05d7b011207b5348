#pragma once
/// A tessellation of space as a still picture: SVG, seen from far away, a little from the right and
/// from above, with what is far paler and behind what is near.
///
/// Laws: those of draw/svg.hpp. Beyond the limits the nearest sites are drawn, and of the edges
/// those of the hull; the legend says so.

#include "../../triangulation/space/triangulate.hpp"

#include <cstddef>
#include <iosfwd>
#include <span>

namespace signum {

struct SpaceSvgOptions {
    std::size_t site_limit = 4000;
    std::size_t line_limit = 6000;
};

/// Writes the sites as discs in true size (at least a dot), the edges between visible ones, where
/// x, y and z point, and a legend. Check the stream for errors of writing. O(n log n).
void write_svg(std::ostream& out, const SpaceTessellation& tessellation,
               std::span<const Site3> sites, WeightIs weight_is,
               const SpaceSvgOptions& options = {});

}  // namespace signum
