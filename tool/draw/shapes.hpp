#pragma once
/// What sites and cells look like in a metric. A metric is drawn by adding its Shapes.

#include "../../triangulation/tessellation.hpp"
#include "outline.hpp"

#include <string_view>

namespace signum {

struct Shapes {
    std::string_view site;   ///< what a site is called in the legend
    std::string_view cells;  ///< and its cells
    Outline outline;
    /// How large a site is drawn, in units of the plane; 0 means a dot.
    double (*radius)(const Site& site, WeightIs weight_is);
};

[[nodiscard]] const Shapes& shapes_of(Metric metric) noexcept;

}  // namespace signum
