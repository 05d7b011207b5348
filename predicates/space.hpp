#pragma once
/// The predicates of space: the orientation of four points (ccw); of the power metric in_sphere and
/// who is nearer to a point, each for points, for sites that carry a weight and for balls; of the
/// Euclidean metric with additive weights which spheres exist, in_sphere, and who is hidden; the
/// same of the supremum and the Manhattan metric. Exact for all finite doubles; the laws of all
/// predicates: predicates/ccw.hpp.

#include "space/ccw.hpp"
#include "space/euclidean.hpp"
#include "space/in_sphere.hpp"
#include "space/nearer.hpp"
#include "space/rectangular.hpp"
