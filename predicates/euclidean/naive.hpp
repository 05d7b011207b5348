#pragma once
/// The Euclidean predicates in plain doubles, rounded, with nothing to catch an error: what goes
/// wrong without the others. A 0 of in_circle stands for no conflict, and so does a q that one of
/// the sites seems to hide.

#include <signum/core/sign.hpp>
#include <signum/core/site.hpp>

namespace signum::euclidean::naive {

[[nodiscard]] bool hides(const Site& i, const Site& q) noexcept;
[[nodiscard]] Sign nearer(Point p, const Site& a, const Site& b) noexcept;
[[nodiscard]] Sign edge_bounded(const Site& i, const Site& j, const Site& k) noexcept;
[[nodiscard]] bool exists(const Site& i, const Site& j, const Site& k) noexcept;
[[nodiscard]] Sign in_circle(const Site& i, const Site& j, const Site& k, const Site& q) noexcept;
[[nodiscard]] Sign in_circle_infinite(const Site& a, const Site& b, const Site& q) noexcept;

}  // namespace signum::euclidean::naive
