#pragma once
/// The cubes and the octahedra that touch four sites from outside: the problem of Apollonius in the
/// supremum and the Manhattan metric of space, for distances to a centre less r. (That of balls:
/// touching_spheres.hpp.)
///
/// A sphere of the metric with centre c and radius rho touches site i from outside where the
/// distance |c - c_i| is rho + r_i. Radii of sites may be negative, and rho may.
///
/// Laws:
///  1. the sites are any, and how many spheres touch them is told exactly: cubes at most two,
///     octahedra at most six, or infinitely many, where facets that all four touch leave a sphere
///     free to move or to grow;
///  2. the spheres come in the order of predicates/space/rectangular.hpp, whatever the order of the
///     sites: cubes by their centres' x, then y, then z;
///  3. every number is rounded once, to the nearest double, halves to even; an infinity where it
///     lies beyond the doubles;
///  4. the same in every floating-point environment.

#include <span>
#include <vector>

#include "../../core/site.hpp"
#include "../../triangulation/metric.hpp"

namespace signum {

/// All cubes or octahedra that touch four.
struct RectangularSpheres {
    bool infinitely_many = false;  ///< then none of them is listed
    /// Else all of them: centres and radii.
    std::vector<Site3> spheres;
};

/// Throws std::invalid_argument for a metric of balls, where the sites are not four, and, naming
/// the site, for NaN or infinity.
[[nodiscard]] RectangularSpheres touching_spheres(std::span<const Site3> four, Metric metric);

}  // namespace signum
