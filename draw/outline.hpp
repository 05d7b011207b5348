#pragma once
/// The outline of a site: an SVG element and the attributes that give its place and size. Its
/// points are `radius` away from the centre in the metric.

#include "../core/site.hpp"
#include "svg_text.hpp"

#include <string_view>

namespace signum {

struct Outline {
    std::string_view element;
    void (*write_geometry)(SvgText& text, Point centre, double radius);
};

[[nodiscard]] Outline disc_outline() noexcept;
[[nodiscard]] Outline square_outline() noexcept;
/// A square on a corner.
[[nodiscard]] Outline diamond_outline() noexcept;

}  // namespace signum
