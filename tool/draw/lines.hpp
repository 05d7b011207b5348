#pragma once
/// The lines of a picture: straight ones and arcs.

#include "../../voronoi/clip.hpp"
#include "frame.hpp"
#include "legend.hpp"
#include "svg_text.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace signum {

/// The diagram in what the picture shows, lengths divided by its exponent. Nothing where doubles
/// are too coarse for it, see note_rounding(), or not of usual size beside a site out of it.
/// Threads as Options::threads, here and below.
[[nodiscard]] std::optional<ClippedVoronoi> clipped_to(const Frame& frame, const Voronoi& voronoi,
                                                       int threads = 0);

/// The edges of the diagram that lie in the picture, in pixels.
[[nodiscard]] std::vector<Conic> cell_edges(const Voronoi& voronoi, const Frame& frame,
                                            int threads = 0);
/// The same of what clipped_to() gave.
[[nodiscard]] std::vector<Conic> cell_edges(const std::optional<ClippedVoronoi>& clipped,
                                            const Frame& frame);

/// Says how far off cells are, or that they are not drawn, where the picture is so small and so far
/// from the origin that neighbouring doubles are pixels apart.
void note_rounding(Legend& legend, const Frame& frame);

/// A conic with its points in pixels instead of what `clipped` divided.
[[nodiscard]] Conic in_pixels(const Conic& divided, int exponent, const Frame& frame) noexcept;

/// Continues a path from where the conic begins: L or Q commands, less than a tenth of a pixel off.
void write_stretch(SvgText& text, const Conic& conic);

/// The median of the lengths from end to end; `otherwise` where there are none.
[[nodiscard]] double median_length(std::span<const Conic> lines, double otherwise);

/// The lines of one kind. Of too many, those too short to be seen go first; of still too many, all
/// but those in the middle of the picture, so that a part of it is complete.
void write_lines(SvgText& text, Legend& legend, std::string_view kind, std::string_view label,
                 std::span<const Conic> lines, const Frame& frame, std::size_t limit);

/// Thinning out, what is least goes first: the size, a multiple of `step`, from which on things are
/// drawn so that at most `limit` of them are; 0 where all are. Equal sizes stay or go together.
/// Precondition: no size is negative.
[[nodiscard]] double smallest_drawn(std::span<const double> sizes, std::size_t limit, double step);

}  // namespace signum
