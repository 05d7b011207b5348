#pragma once
/// The vertex of the diagram that belongs to one face, metric by metric. All numbers are rounded
/// once; NaN in all three where the three sites have no vertex (a face that inexact arithmetic
/// made) or have it at infinity. In the default floating-point environment.

#include <array>

#include "../../core/site.hpp"
#include "../vertices.hpp"

namespace signum::triangulation {

/// The circle of the metric that the sites of a face touch counterclockwise; under the tie rule,
/// without its infinitesimals. Each metric has its own, in a source of its own.
template <class Metric>
[[nodiscard]] DiagramVertex vertex_of_face(const std::array<const Site*, 3>& sites,
                                           const Face& face, WeightIs weight_is);

/// No vertex, or none in the plane.
[[nodiscard]] DiagramVertex no_vertex() noexcept;

}  // namespace signum::triangulation
