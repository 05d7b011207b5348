#pragma once
/// Tessellations and diagrams as pictures: SVG that a browser opens and a person can read.
///
/// Laws:
///  1. Same arguments: the same bytes.
///  2. The file stays below 20 MB and a browser bears it: beyond the limits the smallest things are
///     left out, and the legend says which and how many.
///  3. No number in it is NaN, infinite or far outside the picture, whatever the input.

#include "../../triangulation/space/triangulate.hpp"
#include "../../triangulation/tessellation.hpp"
#include "../../voronoi/clip.hpp"
#include "../../voronoi/conic.hpp"
#include "../../voronoi/space/cells.hpp"
#include "../../voronoi/space/polyhedra.hpp"

#include <cstddef>
#include <iosfwd>
#include <optional>
#include <span>

namespace signum {

struct SvgOptions {
    /// What the picture shows; without one the sites with some room around them.
    std::optional<Box> box = std::nullopt;
    /// Edges to be drawn thick, and edges to be drawn in other colours, those that are different
    /// thin; those to infinity are not. They join sites of the tessellation, whatever its own edges
    /// are.
    std::span<const Edge> wrong = {};
    std::span<const Edge> different = {};
    std::span<const Edge> flipped = {};
    /// Sites with an outline and a number of their own; the smaller ones become dots.
    std::size_t site_limit = 10'000;
    /// Lines of each kind.
    std::size_t line_limit = 60'000;
    /// That compute the diagram, as Options::threads.
    int threads = 0;
};

/// Writes the sites as discs in true size (at least a dot), the edges of the diagram's cells, the
/// tessellation over them, and a legend. Check the stream for errors of writing. O(n log n).
void write_svg(std::ostream& out, const Tessellation& tessellation, const SvgOptions& options = {});

/// Cells in tints that tell neighbours apart, their edges as the lines and arcs that they are, the
/// sites over them. The picture shows `box`, or the sites with some room around them. Check the
/// stream for errors of writing. O(n log n).
void write_voronoi_svg(std::ostream& out, const Voronoi& voronoi,
                       const std::optional<Box>& box = std::nullopt, int threads = 0);

/// Beyond the limits the nearest sites are drawn, and of the edges those of the hull.
struct SpaceSvgOptions {
    std::size_t site_limit = 4000;
    std::size_t line_limit = 6000;
};

/// Seen from far away as draw/space_view.hpp says, with what is far paler and behind what is near.
/// Writes the sites as discs in true size (at least a dot), the edges between visible ones, where
/// x, y and z point, and a legend. Check the stream for errors of writing. O(n log n).
void write_svg(std::ostream& out, const SpaceTessellation& tessellation,
               std::span<const Site3> sites, WeightIs weight_is,
               const SpaceSvgOptions& options = {});

/// Cells of space as solids, seen in the same way: those that the box does not cut, and where it
/// cuts all of them, all. Of more than `face_limit` faces the nearest are drawn. Of two power cells
/// the one whose site is nearer to the eye is nowhere behind the other one, so that drawing them in
/// that order hides what is hidden. Writes the solids and the box around them. `polyhedra` are
/// those of all sites, in order, in the box of `cells`. Check the stream for errors of writing. O(n
/// log n).
void write_space_cells_svg(std::ostream& out, std::span<const Site3> sites, const SpaceCells& cells,
                           std::span<const SpacePolyhedron> polyhedra,
                           std::size_t face_limit = 40'000);

}  // namespace signum
