#pragma once
/// A Voronoi diagram as a picture: cells in tints that tell neighbours apart, their edges as the
/// lines and arcs that they are, the sites over them.
///
/// Laws: those of svg.hpp.

#include "../../voronoi/clip.hpp"

#include <cstddef>
#include <iosfwd>
#include <optional>

namespace signum {

struct VoronoiSvgOptions {
    /// Cells with a tint and a number of their own; of more none is tinted.
    std::size_t cell_limit = 20'000;
    /// Sites with an outline and a number of their own.
    std::size_t site_limit = 10'000;
    std::size_t line_limit = 60'000;
};

/// The picture shows `box`, or the sites with some room around them. Check the stream for errors of
/// writing. O(n log n).
void write_voronoi_svg(std::ostream& out, const Voronoi& voronoi,
                       const std::optional<Box>& box = std::nullopt,
                       const VoronoiSvgOptions& options = {});

}  // namespace signum
