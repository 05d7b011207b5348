#pragma once
/// The predicates of the additively weighted Euclidean metric (Apollonius, discs): distance
/// |x-c| - r.
///
/// Sites are signum::Site, discs of any finite radii, negative ones included: only differences of
/// radii matter. They may intersect, touch, nest and coincide. Each predicate is exact for all
/// finite doubles, in any floating-point environment. `ranks` are places in the tie rule's order:
/// falling radius, rising x, y, index; only their order counts. The rule thinks of every radius as
/// reduced by its own infinitesimal, infinitely larger for the later site.

#include <array>

#include <signum/predicates/euclidean/edge.hpp>
#include <signum/predicates/euclidean/exists.hpp>
#include <signum/predicates/euclidean/hidden.hpp>
#include <signum/predicates/euclidean/in_circle.hpp>
#include <signum/predicates/euclidean/infinite.hpp>
#include <signum/predicates/euclidean/multiprecision.hpp>
#include <signum/predicates/euclidean/naive.hpp>

namespace signum::euclidean {

/// Whether the disc i contains the disc q: |c_i - c_q| <= r_i - r_q. Equal sites contain each
/// other.
[[nodiscard]] inline bool hides(const Site& i, const Site& q) noexcept {
    return hides_decision(i, q).sign > 0;
}

/// Whether i hides q under the tie rule: of equal sites the earlier one hides the later.
[[nodiscard]] inline bool hides_perturbed(const Site& i, const Site& q,
                                          bool i_precedes_q) noexcept {
    return hides_perturbed_decision(i, q, i_precedes_q).sign > 0;
}

/// +1 where the point p is nearer to a than to b, 0 where both are as near, -1 otherwise.
[[nodiscard]] inline Sign nearer(Point p, const Site& a, const Site& b) noexcept {
    return nearer_decision(p, a, b).sign;
}

/// Whether a finite circle touches i, j, k counterclockwise; never where one hides another.
[[nodiscard]] inline bool exists(const Site& i, const Site& j, const Site& k) noexcept {
    return exists_decision(i, j, k).sign > 0;
}

/// The same under the tie rule.
[[nodiscard]] inline bool exists_perturbed(const Site& i, const Site& j, const Site& k,
                                           const std::array<Index, 3>& ranks) noexcept {
    return exists_perturbed_decision(i, j, k, ranks).sign > 0;
}

/// +1 where q conflicts with the vertex of i, j, k (is nearer than they are), 0 where it touches,
/// -1 otherwise. Preconditions: exists(i,j,k), q hidden by none of i, j, k.
[[nodiscard]] inline Sign in_circle(const Site& i, const Site& j, const Site& k,
                                    const Site& q) noexcept {
    return in_circle_decision(i, j, k, q).sign;
}

/// in_circle under the tie rule, never 0; q may be hidden, which is no conflict. Precondition:
/// exists_perturbed(i,j,k).
[[nodiscard]] inline Sign in_circle_perturbed(const Site& i, const Site& j, const Site& k,
                                              const Site& q,
                                              const std::array<Index, 4>& ranks) noexcept {
    return in_circle_perturbed_decision(i, j, k, q, ranks).sign;
}

/// The same at the hull edge a -> b, all other sites on its left: +1 where q conflicts with the
/// vertex at infinity, 0 where it touches, -1 otherwise. Precondition: neither hides the other.
[[nodiscard]] inline Sign in_circle_infinite(const Site& a, const Site& b, const Site& q) noexcept {
    return in_circle_infinite_decision(a, b, q).sign;
}

/// in_circle_infinite under the tie rule, never 0; q may be hidden, which is no conflict.
[[nodiscard]] inline Sign in_circle_infinite_perturbed(const Site& a, const Site& b, const Site& q,
                                                       const std::array<Index, 3>& ranks) noexcept {
    return in_circle_infinite_perturbed_decision(a, b, q, ranks).sign;
}

}  // namespace signum::euclidean
