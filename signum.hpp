#pragma once
/// All of the library: the predicates of the four metrics, the sign of a sum, tessellations and
/// what is asked of them, Voronoi diagrams, those of space. Who wants a predicate alone includes
/// its header. These are the headers for users: cmake/Install.cmake goes by this list.

#include "core/index.hpp"
#include "core/sign.hpp"
#include "core/site.hpp"
#include "core/strided_sites.hpp"
#include "exact/sign_of_sum.hpp"
#include "motion/meeting_time.hpp"
#include "motion/queries.hpp"
#include "motion/shaking_wall.hpp"
#include "motion/simulation.hpp"
#include "predicates/arithmetic.hpp"
#include "predicates/batch.hpp"
#include "predicates/ccw.hpp"
#include "predicates/euclidean.hpp"
#include "predicates/manhattan.hpp"
#include "predicates/power.hpp"
#include "predicates/space.hpp"
#include "predicates/supremum.hpp"
#include "triangulation/any_dimension/triangulate.hpp"
#include "triangulation/any_dimension/validate.hpp"
#include "triangulation/arrays.hpp"
#include "triangulation/dynamic.hpp"
#include "triangulation/edge_list.hpp"
#include "triangulation/flip_graph.hpp"
#include "triangulation/metric.hpp"
#include "triangulation/moving/kinetic_tessellation.hpp"
#include "triangulation/options.hpp"
#include "triangulation/space/compare.hpp"
#include "triangulation/space/triangulate.hpp"
#include "triangulation/space/validate.hpp"
#include "triangulation/space/vertices.hpp"
#include "triangulation/tessellation.hpp"
#include "triangulation/triangulate.hpp"
#include "triangulation/validate.hpp"
#include "triangulation/validate_finite.hpp"
#include "triangulation/vertices.hpp"
#include "voronoi/balls/diagram.hpp"
#include "voronoi/balls/touching_rectangular.hpp"
#include "voronoi/balls/touching_spheres.hpp"
#include "voronoi/clip.hpp"
#include "voronoi/compare.hpp"
#include "voronoi/conic.hpp"
#include "voronoi/contacts.hpp"
#include "voronoi/curve.hpp"
#include "voronoi/polygon.hpp"
#include "voronoi/space/cells.hpp"
#include "voronoi/space/polyhedra.hpp"
#include "voronoi/voronoi.hpp"

/// All of the library.
namespace signum {
/// The power metric (Laguerre, regular, weighted Delaunay): distance |p-c|² - w.
namespace power {}
/// Discs and balls with additive weights: distance |p-c| - r.
namespace euclidean {}
/// Diamonds and octahedra with additive weights: distance |p-c| - r in the norm |x| + |y|.
namespace manhattan {}
/// Squares and cubes with additive weights: distance |p-c| - r in the norm max(|x|, |y|).
namespace supremum {}
/// The exact sign of a sum, step by step.
namespace exact {}
/// Balls that move and strike.
namespace motion {}
}  // namespace signum
