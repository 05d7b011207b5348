#pragma once
/// The file around a drawing.

#include "frame.hpp"
#include "legend.hpp"
#include "style.hpp"
#include "svg_text.hpp"

#include <iosfwd>
#include <string_view>

namespace signum {

/// The width of a file, and of the frame in it, which leaves room for the numbers of the axes.
inline constexpr double document_width = 900.0;
inline constexpr double picture_width = 788.0;

/// Writes head, style, the drawing cut off at the frame, the axes around it and the legend below.
void write_document(std::ostream& out, std::string_view title, const Frame& frame, const Pens& pens,
                    Legend& legend, const SvgText& drawing);
/// The same with something else than axes `around` the drawing, which begins at 0 0.
void write_document(std::ostream& out, std::string_view title, const Frame& frame, const Pens& pens,
                    const Legend& legend, const SvgText& drawing, const SvgText& around);

}  // namespace signum
