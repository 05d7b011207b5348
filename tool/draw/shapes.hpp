#pragma once
/// What sites and cells look like in a metric. A metric is drawn by adding its Shapes.

#include "../../triangulation/tessellation.hpp"
#include "../../voronoi/conic.hpp"
#include "svg_text.hpp"

#include <string_view>
#include <vector>

namespace signum {

/// The outline of a site: an SVG element and the attributes that give its place and size. Its
/// points are `radius` away from the centre in the metric.
struct Outline {
    std::string_view element;
    void (*write_geometry)(SvgText& text, Point centre, double radius);
    /// The length of a vector in the metric.
    double (*norm)(Point vector);
    /// Vectors n so that n·(p - centre) <= radius bounds the inside where it is seen from the
    /// direction `towards`, and `angle` to either side.
    std::vector<Point> (*normals)(Point towards, double angle);
};

[[nodiscard]] Outline disc_outline() noexcept;
[[nodiscard]] Outline square_outline() noexcept;
/// A square on a corner.
[[nodiscard]] Outline diamond_outline() noexcept;

struct Shapes {
    std::string_view site;   ///< what a site is called in the legend
    std::string_view cells;  ///< and its cells
    Outline outline;
    /// How large a site is drawn, in units of the plane; 0 means a dot.
    double (*radius)(const Site& site, WeightIs weight_is);
};

[[nodiscard]] const Shapes& shapes_of(Metric metric) noexcept;

/// What the box shows of the inside, as a polygon: for sizes at which renderers, which compute in
/// single precision, err. Less than a tenth of a pixel off if the radius is four times the box's
/// diagonal or more.
[[nodiscard]] std::vector<Point> part_inside(const Outline& outline, Point centre, double radius,
                                             const Box& box);

}  // namespace signum
