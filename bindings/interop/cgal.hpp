#pragma once
/// CGAL's triangulations on signum's predicates, and results to and from them.
///
/// Laws:
///  1. Traits<Kernel> is Kernel, whose numbers are doubles, with other predicates: those that the
///     Delaunay and regular triangulations of plane and space ask while they are built, searched
///     and checked. Each has the sign that the kernel's own has, for all finite doubles, so that
///     the triangulation is the same. Points, constructions and all other predicates are the
///     kernel's.
///  2. CGAL decides ties by its own rule, by the order of coordinates. Where all weights are equal
///     signum's rule chooses the same; otherwise either choice is valid.
///  3. CGAL's points carry a weight, signum's Site a radius, whose square need not be a double. So
///     what goes from here to there, or back, are Point, power::Site, Point3 and power::Site3.
///
/// The header is as free as signum is; CGAL's triangulations are under the GPL.

#include "cgal/results.hpp"
#include "cgal/traits.hpp"
