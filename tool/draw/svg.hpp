#pragma once
/// A tessellation as a picture: SVG that a browser opens and a person can read.
///
/// Laws:
///  1. Same tessellation, same options: the same bytes.
///  2. The file stays below 20 MB and a browser bears it: beyond the limits the smallest things are
///     left out, and the legend says which and how many.
///  3. No number in it is NaN, infinite or far outside the picture, whatever the input.

#include "../../triangulation/tessellation.hpp"
#include "../../voronoi/conic.hpp"

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
};

/// Writes the sites as discs in true size (at least a dot), the edges of the diagram's cells, the
/// tessellation over them, and a legend. Check the stream for errors of writing. O(n log n).
void write_svg(std::ostream& out, const Tessellation& tessellation, const SvgOptions& options = {});

}  // namespace signum
