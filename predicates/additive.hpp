#pragma once
/// What the three metrics with additive weights share: distance |x-c| - r in some norm.

#include <array>
#include <cstddef>

#include "../core/contract.hpp"
#include "../core/index.hpp"
#include "../core/sign.hpp"
#include "../core/site.hpp"
#include "../filters/bounds.hpp"
#include "../filters/rounding_count.hpp"
#include "../filters/verdict.hpp"
#include "arithmetic.hpp"

SIGNUM_IEEE_BEGIN

namespace signum::additive {

/// How far a point is from a site, in doubles: for who compares many sites at one point.
struct Distance {
    double to_centre;
    double magnitude;  ///< to_centre is off by 3 epsilon of this at most
    double radius;
};

/// How much nearer a is than b, by the distances of their centres and their radii.
template <class Number>
[[nodiscard]] constexpr Number nearer_difference(Number to_a, Number to_b, Number radii) noexcept {
    return (to_b - to_a) + radii;
}

/// Which of two sites is nearer to the point: +1 for a, -1 for b. Rounded distances of 3 roundings
/// and the difference of the radii, of one, make a sum of 5 roundings at most; three more epsilons
/// pay for second-order terms and for the roundings of the bound. Where the distances are those of
/// two pinned sites and points, nothing between them and this may change the environment.
[[nodiscard]] inline filters::Verdict nearer(const Distance& a, const Distance& b) noexcept {
    const double radii = a.radius - b.radius;
    const double difference = nearer_difference(a.to_centre, b.to_centre, radii);
    const double bound =
        8 * filters::epsilon * ((a.magnitude + b.magnitude) + filters::magnitude(radii));
    static_assert(nearer_difference(filters::RoundingCount::of(3), filters::RoundingCount::of(3),
                                    filters::rounded_difference)
                      .roundings == 5);
    if (filters::magnitude(difference) > bound && filters::environment_is_default()) [[likely]]
        return filters::Verdict::certain(filters::sign_of_nonzero(difference));
    return filters::Verdict::uncertain();
}

/// Whether site a (of index a_index) comes before site b in the tie rule's order: by falling
/// radius, then rising x, y and index. The first site of all is hidden by none.
[[nodiscard]] inline bool precedes(const Site& a, Index a_index, const Site& b,
                                   Index b_index) noexcept {
    if (const Sign by_r = filters::compare_numbers(a.r, b.r); by_r != 0) return by_r > 0;
    if (const Sign by_x = filters::compare_numbers(a.x, b.x); by_x != 0) return by_x < 0;
    if (const Sign by_y = filters::compare_numbers(a.y, b.y); by_y != 0) return by_y < 0;
    return a_index < b_index;
}

/// The places of a few sites in the order; `numbers` are their indices.
template <std::size_t n>
[[nodiscard]] inline std::array<Index, n> ranks_of(const std::array<const Site*, n>& sites,
                                                   const std::array<Index, n>& numbers) noexcept {
    std::array<Index, n> ranks{};
    for (std::size_t a = 0; a < n; ++a)
        for (std::size_t b = 0; b < a; ++b)
            ++ranks[precedes(*sites[a], numbers[a], *sites[b], numbers[b]) ? b : a];
    return ranks;
}
/// Of equal ones the first given comes first.
template <std::size_t n>
[[nodiscard]] inline std::array<Index, n> ranks_of(
    const std::array<const Site*, n>& sites) noexcept {
    std::array<Index, n> numbers{};
    for (std::size_t i = 0; i < n; ++i) numbers[i] = static_cast<Index>(i);
    return ranks_of(sites, numbers);
}

// ---- what users call ---------------------------------------------------------------------------
// One text for the three metrics: each header names the functions over its own predicates. Circle
// stands for the disc, diamond or square of the metric.

/// Whether a circle touches i, j, k counterclockwise, ties decided by the tie rule.
template <class Perturbed>
[[nodiscard]] inline bool exists(const Site& i, const Site& j, const Site& k) noexcept {
    SIGNUM_EXPECTS(are_finite(i, j, k));
    return Perturbed::exists(i, j, k, ranks_of<3>({&i, &j, &k})).sign > 0;
}

/// +1 where q conflicts with the vertex of i, j, k (is nearer than they are), 0 where it touches,
/// -1 otherwise. Preconditions: exists(i,j,k), q hidden by none of them, finite numbers.
template <auto decision>
[[nodiscard]] inline Sign in_circle(const Site& i, const Site& j, const Site& k,
                                    const Site& q) noexcept {
    SIGNUM_EXPECTS(are_finite(i, j, k, q));
    return decision(i, j, k, q, ranks_of<4>({&i, &j, &k, &q})).sign;
}

/// The same at the hull edge a -> b, all other sites on its left. Preconditions: neither of a and b
/// hides the other, finite numbers.
template <auto decision>
[[nodiscard]] inline Sign in_circle_infinite(const Site& a, const Site& b, const Site& q) noexcept {
    SIGNUM_EXPECTS(are_finite(a, b, q));
    return decision(a, b, q, ranks_of<3>({&a, &b, &q})).sign;
}

/// Whether i alone hides q: covers it, the same place and size included.
template <class Perturbed>
[[nodiscard]] inline bool hidden(const Site& q, const Site& i) noexcept {
    SIGNUM_EXPECTS(are_finite(q, i));
    return Perturbed::hides(i, q, {0, 1}).sign > 0;
}

/// Whether the point p is nearer to a than to b (+1) or not (-1), a coming first in the tie rule's
/// order where both are as near.
template <class Perturbed>
[[nodiscard]] inline Sign nearer_site(Point p, const Site& a, const Site& b) noexcept {
    SIGNUM_EXPECTS(are_finite(p, a, b));
    return Perturbed::nearer(p, a, b, {0, 1}).sign;
}

/// in_circle under the tie rule, never 0; q may be hidden. `ranks` are the places of i, j, k and q
/// in the rule's order (falling radius, rising x, y, index); only their order counts.
template <class Perturbed>
[[nodiscard]] inline Sign in_circle_perturbed(const Site& i, const Site& j, const Site& k,
                                              const Site& q,
                                              const std::array<Index, 4>& ranks) noexcept {
    SIGNUM_EXPECTS(are_finite(i, j, k, q));
    return Perturbed::in_circle(i, j, k, q, ranks).sign;
}

/// in_circle_infinite under the tie rule, never 0. `ranks` are the places of a, b and q.
template <class Perturbed>
[[nodiscard]] inline Sign in_circle_infinite_perturbed(const Site& a, const Site& b, const Site& q,
                                                       const std::array<Index, 3>& ranks) noexcept {
    SIGNUM_EXPECTS(are_finite(a, b, q));
    return Perturbed::in_circle_infinite(a, b, q, ranks).sign;
}

}  // namespace signum::additive

SIGNUM_IEEE_END
