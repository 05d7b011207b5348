#pragma once
/// The look of a picture: how thick things are, and in which colours.

#include "svg_text.hpp"

#include <string_view>

namespace signum {

/// In pixels: thinner where sites crowd.
struct Pens {
    double cell;
    double edge;   // and outlines; different edges twice as thick
    double wrong;  // and flipped edges
    double dot;    // a radius
    double hatch;  // from line to line

    /// `spacing` is the typical distance of neighbours.
    explicit Pens(double spacing);
};

/// The classes of style are site, hidden, dot, hidden-dot for elements, and for paths cell, edge,
/// wrong, different, flipped, dots, hidden-dots, border (of the cells of a diagram) and tint with
/// tint0 to tint5.
void write_style(SvgText& text, const Pens& pens);

}  // namespace signum
