#pragma once
/// The outline of a site: an SVG element and the attributes that give its place and size.

#include <signum/core/site.hpp>
#include <signum/draw/svg_text.hpp>

#include <string_view>

namespace signum {

struct Outline {
    std::string_view element;
    void (*write_geometry)(SvgText& text, Point centre, double radius);
};

}  // namespace signum
