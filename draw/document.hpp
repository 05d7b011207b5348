#pragma once
/// The file around a drawing.

#include "frame.hpp"
#include "legend.hpp"
#include "style.hpp"
#include "svg_text.hpp"

#include <iosfwd>
#include <string_view>

namespace signum {

inline constexpr double picture_width = 900.0;

/// Writes head, style, the drawing cut off at the frame, and the legend below it.
void write_document(std::ostream& out, std::string_view title, const Frame& frame, const Pens& pens,
                    const Legend& legend, const SvgText& drawing);

}  // namespace signum
