#pragma once
/// The predicates of space: the orientation of four points (ccw), and of the power metric in_sphere
/// and who is nearer to a point, each for points, for sites that carry a weight and for balls.
/// Exact for all finite doubles; the laws of all predicates: predicates/ccw.hpp.

#include "space/ccw.hpp"
#include "space/in_sphere.hpp"
#include "space/nearer.hpp"
