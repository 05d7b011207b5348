#pragma once
/// The vertex of the diagram that belongs to one face, metric by metric. All numbers are rounded
/// once; NaN in all three where the three sites have no vertex (a face that inexact arithmetic
/// made) or have it at infinity. In the default floating-point environment.

#include <array>

#include "../../core/index.hpp"
#include "../../core/site.hpp"
#include "../vertices.hpp"

namespace signum::triangulation {

/// The point of equal power distance; the sites are power::Site or Site.
template <class S>
[[nodiscard]] DiagramVertex power_vertex(const S& i, const S& j, const S& k);

/// The circle that i, j and k touch counterclockwise.
[[nodiscard]] DiagramVertex euclidean_vertex(const Site& i, const Site& j, const Site& k);

/// The square (diamond) that i, j and k touch counterclockwise under the tie rule, without its
/// infinitesimals. Directions are those of predicates/ladder/forms.hpp, `ranks` the places of
/// the sites in the tie rule's order; only their order counts.
template <class Directions>
[[nodiscard]] DiagramVertex rectangular_vertex(const Site& i, const Site& j, const Site& k,
                                               const std::array<Index, 3>& ranks);

/// No vertex, or none in the plane.
[[nodiscard]] DiagramVertex no_vertex() noexcept;

}  // namespace signum::triangulation
