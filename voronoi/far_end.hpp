#pragma once
/// Which way an edge leads to a vertex that is no pair of doubles: one beyond them, or at infinity.

#include "../core/sign.hpp"
#include "../core/site.hpp"
#include "../triangulation/metric.hpp"
#include "../triangulation/tessellation.hpp"

namespace signum {

/// Of the edge between the cells of a and b that leads to the vertex of a face.
enum class EndOfEdge : bool {
    from,  ///< where it begins, a on its left: the face turns from b to a to the apex
    to     ///< where it ends: the face turns from a to b to the apex
};

/// The side of the line through the centres of a and b on which the vertex of the face with `apex`
/// lies: +1 on the left of the way from a to b, -1 on its right, 0 on it, and where the metric has
/// no such vertex but at infinity (Manhattan, supremum). Of a vertex at infinity, on a common
/// tangent line, the side in which its direction leads. Exact, for faces of exact tessellations.
[[nodiscard]] Sign far_end(Metric metric, WeightIs weight_is, const Site& a, const Site& b,
                           const Site& apex, EndOfEdge end);

}  // namespace signum
