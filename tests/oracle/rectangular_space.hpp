#pragma once
/// Brute force for the supremum and the Manhattan metric with additive weights, dist(p, c) - r, in
/// the plane and in space (D = 2, 3): the spheres of the metric, cubes or cross-polytopes, that
/// touch D + 1 sites, in rationals. No rule for ties: what is degenerate is told as it is.
///
/// A sphere (c, rho) touches a site (c_i, r_i) from outside where dist(c, c_i) = rho + r_i. A
/// distance is the largest of linear functions, one for each facet of the unit ball, and a site is
/// touched in the facets for which this function is the distance.

#include "space_ball.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace signum::oracle {

enum class RectangularMetric { supremum, manhattan };

template <int D>
struct RectangularSphere {
    std::array<Rational, static_cast<std::size_t>(D)> c{};
    Rational rho = 0;
    friend bool operator==(const RectangularSphere&, const RectangularSphere&) = default;
    friend bool operator<(const RectangularSphere& a, const RectangularSphere& b) {
        return a.c != b.c ? a.c < b.c : a.rho < b.rho;
    }
};

template <int D>
struct RectangularSpheres {
    /// The spheres fill a segment or a ray, or more.
    bool infinitely_many = false;
    /// Else all of them, sorted, each once.
    std::vector<RectangularSphere<D>> spheres;
};

/// The spheres that touch all of the sites from outside. These may be any, equal ones too.
template <int D>
RectangularSpheres<D> touching_spheres(RectangularMetric metric, const BallTuple<D>& sites);

/// The sign of dist(c, c_q) - r_q - rho: -1 where q is nearer to c than the sphere's sites and
/// conflicts with it, 0 where it touches, 1 where it does neither.
template <int D>
int side(RectangularMetric metric, const RectangularSphere<D>& sphere, const SpaceBall<D>& q);

/// For every site whether another one contains it, dist(c_i, c_j) <= r_j - r_i; of equal sites the
/// first is not hidden by the others.
template <int D>
std::vector<bool> hidden_sites(RectangularMetric metric, std::span<const SpaceBall<D>> sites);

}  // namespace signum::oracle
