#pragma once
/// The predicates of the supremum and the Manhattan metric of space with additive weights:
/// distances max(|x-cx|, |y-cy|, |z-cz|) - r and |x-cx| + |y-cy| + |z-cz| - r. Their spheres are
/// cubes and octahedra.
///
/// Sites are signum::Site3, cubes (octahedra) of any finite radii, negative ones included: only
/// differences of radii matter. They may intersect, touch, nest and coincide.
///
/// Laws:
///  1. Exact for all finite doubles, in every floating-point environment, in constant time; never
///     perturbed: 0 is said where something touches.
///  2. A sphere with centre c and radius rho touches a site from outside where the distance of the
///     centres is rho + r; rho may be negative. Cubes that touch four sites are at most two,
///     octahedra at most six, or infinitely many.
///  3. No orientation tells the spheres of four sites apart. So they have an order that depends
///     neither on that of the sites nor on arithmetic: of two spheres that one comes first that is
///     touched in the first facet in which not both are. The facets of the cube in their order are
///     +x, -x, +y, -y, +z, -z, which means that the spheres come by x, then y, then z of their
///     centres; those of the octahedron +++, ++-, +-+, +--, -++, -+-, --+, ---.
/// Source: Gavrilova 1998, 4.6; the subdivision of facets.hpp.

#include <array>
#include <concepts>
#include <cstdint>

#include "../../core/contract.hpp"
#include "../../core/sign.hpp"
#include "../../core/site.hpp"
#include "../../filters/tally.hpp"

namespace signum::rectangular {

/// A sphere by four of its facets, in rising order, and a site that touches each: 0 to 3 for i, j,
/// k and l. (The facets are independent; where a site touches in an edge or a corner it may stand
/// here more than once, and another one not at all.)
struct Contacts {
    std::array<std::uint8_t, 4> facets = {};  ///< as facets.hpp numbers them
    std::array<std::uint8_t, 4> sites = {};   ///< by facet
    friend bool operator==(const Contacts&, const Contacts&) = default;
};

/// The spheres that touch four sites.
struct Spheres {
    bool infinitely_many = false;  ///< then none of them is here
    /// Else so many, in the order of law 3.
    std::uint8_t count = 0;
    Stage stage = Stage::filter;           ///< the dearest one that was asked
    std::array<Contacts, 6> spheres = {};  ///< the first `count` of these
};

/// What the metrics differ by: facets.hpp.
struct Cube;
struct Octahedron;

/// The spheres that touch i, j, k and l from outside. Precondition of all: finite numbers.
template <class Shape>
[[nodiscard]] Spheres spheres(const Site3& i, const Site3& j, const Site3& k,
                              const Site3& l) noexcept;

/// Of one of spheres(i,j,k,l): +1 where q conflicts with it (is nearer to its centre than they
/// are), 0 where q touches it, -1 otherwise; q may be hidden.
template <class Shape>
[[nodiscard]] Decision in_sphere_decision(const Site3& i, const Site3& j, const Site3& k,
                                          const Site3& l, const Contacts& sphere,
                                          const Site3& q) noexcept;

/// The same of the sphere number n, from 0 on. Precondition: spheres(i,j,k,l) are finitely many and
/// more than n.
template <class Shape>
[[nodiscard]] inline Sign in_sphere(const Site3& i, const Site3& j, const Site3& k, const Site3& l,
                                    const Site3& q, std::uint8_t n) noexcept {
    SIGNUM_EXPECTS(are_finite(i, j, k, l, q));
    const Spheres all = spheres<Shape>(i, j, k, l);
    SIGNUM_EXPECTS(!all.infinitely_many && n < all.count);
    return in_sphere_decision<Shape>(i, j, k, l, all.spheres[n], q).sign;
}

/// Whether i alone hides q: covers it, dist(c_i, c_q) <= r_i - r_q, the same place and size
/// included; +1 or -1.
template <class Shape>
[[nodiscard]] Decision hides_decision(const Site3& i, const Site3& q) noexcept;

}  // namespace signum::rectangular

namespace signum::supremum {

/// All cubes that touch four sites.
inline constexpr auto& spheres = rectangular::spheres<rectangular::Cube>;
/// Which side of one of them a site is on; see rectangular::in_sphere.
inline constexpr auto& in_sphere = rectangular::in_sphere<rectangular::Cube>;
/// The same, and the stage that decided.
inline constexpr auto& in_sphere_decision = rectangular::in_sphere_decision<rectangular::Cube>;
/// Whether i alone hides q, and the stage that decided.
inline constexpr auto& hides_decision = rectangular::hides_decision<rectangular::Cube>;
/// Whether i alone hides q. (A template, so that three numbers in braces stay a site of the plane.)
template <std::same_as<Site3> S>
[[nodiscard]] inline bool hidden(const S& q, const S& i) noexcept {
    SIGNUM_EXPECTS(are_finite(q, i));
    return hides_decision(i, q).sign > 0;
}

}  // namespace signum::supremum

namespace signum::manhattan {

/// All octahedra that touch four sites.
inline constexpr auto& spheres = rectangular::spheres<rectangular::Octahedron>;
/// Which side of one of them a site is on; see rectangular::in_sphere.
inline constexpr auto& in_sphere = rectangular::in_sphere<rectangular::Octahedron>;
/// The same, and the stage that decided.
inline constexpr auto& in_sphere_decision =
    rectangular::in_sphere_decision<rectangular::Octahedron>;
/// Whether i alone hides q, and the stage that decided.
inline constexpr auto& hides_decision = rectangular::hides_decision<rectangular::Octahedron>;
/// Whether i alone hides q. (A template, so that three numbers in braces stay a site of the plane.)
template <std::same_as<Site3> S>
[[nodiscard]] inline bool hidden(const S& q, const S& i) noexcept {
    SIGNUM_EXPECTS(are_finite(q, i));
    return hides_decision(i, q).sign > 0;
}

}  // namespace signum::manhattan
