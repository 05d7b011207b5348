#pragma once
/// The look of a picture: how thick things are, and in which colours.

#include "svg_text.hpp"

#include <cstddef>
#include <string_view>

namespace signum {

/// Of a ball by its number, as #rrggbb: of Okabe and Ito's, which colour blindness keeps apart.
[[nodiscard]] const char* ball_colour(std::size_t number) noexcept;

/// Pixels: in a picture printed 8 cm wide it is five points high.
inline constexpr double font_size = 20.0;

/// In pixels: thinner where sites crowd.
struct Pens {
    double cell;
    double edge;   // and outlines; different edges twice as thick
    double wrong;  // and flipped edges
    double dot;    // a radius
    double hatch;  // from line to line

    /// `spacing` is the typical distance of neighbours.
    explicit Pens(double spacing);
    /// Half the side of the x at a hidden centre.
    [[nodiscard]] double cross() const noexcept { return 1.5 * dot; }
};

/// The classes of style are site, hidden, dot, hidden-dot for elements, and for paths cell, edge,
/// wrong, different, flipped, dots, crosses, border (of the cells of a diagram) and tint with
/// tint0 to tint5; number and hidden-number for text; axes and legend for groups.
void write_style(SvgText& text, const Pens& pens);

}  // namespace signum
