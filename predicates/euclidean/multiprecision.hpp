#pragma once
/// The Euclidean predicates in rationals: the last stage of the exact kernel, and the whole of the
/// multiprecision kernel that judges the others. Right for every finite double, in any environment.
/// Signs, preconditions and `ranks` are those of the decisions of the same names.

#include <array>

#include <signum/core/index.hpp>
#include <signum/core/sign.hpp>
#include <signum/core/site.hpp>

namespace signum::euclidean::multiprecision {

[[nodiscard]] bool hides(const Site& i, const Site& q) noexcept;
[[nodiscard]] bool hides_perturbed(const Site& i, const Site& q, bool i_precedes_q) noexcept;
[[nodiscard]] Sign nearer(Point p, const Site& a, const Site& b) noexcept;
[[nodiscard]] Sign edge_bounded(const Site& i, const Site& j, const Site& k) noexcept;
[[nodiscard]] Sign exists(const Site& i, const Site& j, const Site& k) noexcept;
[[nodiscard]] Sign exists_perturbed(const Site& i, const Site& j, const Site& k,
                                    const std::array<Index, 3>& ranks) noexcept;
[[nodiscard]] Sign in_circle(const Site& i, const Site& j, const Site& k, const Site& q) noexcept;
[[nodiscard]] Sign in_circle_perturbed(const Site& i, const Site& j, const Site& k, const Site& q,
                                       const std::array<Index, 4>& ranks) noexcept;
[[nodiscard]] Sign in_circle_infinite(const Site& a, const Site& b, const Site& q) noexcept;
[[nodiscard]] Sign in_circle_infinite_perturbed(const Site& a, const Site& b, const Site& q,
                                                const std::array<Index, 3>& ranks) noexcept;

}  // namespace signum::euclidean::multiprecision
