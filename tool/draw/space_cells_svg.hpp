#pragma once
/// Cells of space as solids in a still picture: SVG, seen as draw/space_view.hpp says.
///
/// Laws: those of draw/svg.hpp. Drawn are the cells that the box does not cut, and where it cuts
/// all of them, all. Beyond the limit the nearest faces are drawn; the legend says so. Of two power
/// cells the one whose site is nearer to the eye is nowhere behind the other one, so that drawing
/// them in that order hides what is hidden.

#include "../../voronoi/space/cells.hpp"
#include "../../voronoi/space/polyhedra.hpp"

#include <cstddef>
#include <iosfwd>
#include <span>

namespace signum {

struct SpaceCellsSvgOptions {
    std::size_t face_limit = 40'000;
};

/// Writes the solids and the box around them. `polyhedra` are those of all sites, in order, in the
/// box of `cells`. Check the stream for errors of writing. O(n log n).
void write_space_cells_svg(std::ostream& out, std::span<const Site3> sites, const SpaceCells& cells,
                           std::span<const SpacePolyhedron> polyhedra,
                           const SpaceCellsSvgOptions& options = {});

}  // namespace signum
