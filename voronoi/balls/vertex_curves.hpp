#pragma once
/// The edges that leave a vertex of the diagram of balls. For sources only.
///
/// From the centre c of the vertex's sphere one moves by v; then ball m, which touches in the
/// direction d_m (a unit vector), comes nearer by d_m·v, and nearest is that of the greatest. So
/// edges leave along the normals of the facets of the hull of the d_m, outward, of which every one
/// is a corner of the hull; and seen from one of them the others, as directions, have the hull of
/// points in a plane. Where more than three lie in the plane of a facet, all of them may touch
/// along one curve; else it is told in second order which ball conflicts with which curve
/// (ExactSphere::is_only_one_free_of). Where all lie in one plane, edges leave to both sides.

#include <vector>

#include "../../core/index.hpp"
#include "exact_sphere.hpp"
#include "set.hpp"
#include "vertices.hpp"

namespace signum::balls {

struct VertexCurve {
    /// All balls that touch along it, rising.
    std::vector<Index> touching;
    /// Whether an edge begins here or ends, forward along the curve of the first three
    /// (exact_sphere.hpp).
    bool is_start, is_end;
};

/// Of m balls that touch, about m² steps for those in no plane; m⁴ where there are m in the plane
/// of a facet that do not touch along one curve.
[[nodiscard]] std::vector<VertexCurve> curves_at(const BallSet& balls, const BallVertex& vertex);

[[nodiscard]] ExactSphere exact_sphere_of(const BallSet& balls, const BallVertex& vertex);

}  // namespace signum::balls
