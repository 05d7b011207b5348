#pragma once
/// Sites of any kind and dimension as the predicates see them: coordinates by number, and a weight.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "../../core/site.hpp"
#include "../../filters/bounds.hpp"
#include "../../predicates/power/weight.hpp"
#include "../../predicates/space/in_sphere.hpp"
#include "triangulate.hpp"

namespace signum::any_dimension {

/// Sites of the plane and those of space, beside power::SiteOf<D>.
template <class S>
inline constexpr int dimension_of = power::PowerSite<S> ? 2 : 3;
template <int D>
inline constexpr int dimension_of<power::SiteOf<D>> = D;

template <class S>
[[nodiscard]] constexpr double coordinate(const S& s, std::size_t axis) noexcept {
    if constexpr (requires { s.centre; })
        return s.centre[axis];
    else if constexpr (power::PowerSite<S>)
        return axis == 0 ? s.x : s.y;
    else
        return axis == 0 ? s.x : axis == 1 ? s.y : s.z;
}
template <class S>
[[nodiscard]] bool is_finite(const S& s) noexcept {
    bool result = true;
    for (std::size_t axis = 0; axis < dimension_of<S>; ++axis)
        result &= std::isfinite(coordinate(s, axis));
    return result && std::isfinite(power::weight_key(s));
}
template <class S>
[[nodiscard]] bool have_one_centre(const S& a, const S& b) noexcept {
    for (std::size_t axis = 0; axis < dimension_of<S>; ++axis)
        if (!filters::same_number(coordinate(a, axis), coordinate(b, axis))) return false;
    return true;
}

/// Whether site a (of number i) comes before site b in the tie rule's order: falling weight, rising
/// coordinates, number.
template <class S>
[[nodiscard]] bool precedes(const S& a, Index i, const S& b, Index j) noexcept {
    using filters::compare_numbers;
    if (const int weight = compare_numbers(power::weight_key(a), power::weight_key(b)); weight != 0)
        return weight > 0;
    for (std::size_t axis = 0; axis < dimension_of<S>; ++axis)
        if (const int x = compare_numbers(coordinate(a, axis), coordinate(b, axis)); x != 0)
            return x < 0;
    return i < j;
}

/// m - q along an axis.
template <class Number, class S>
[[nodiscard]] constexpr Number offset(const S& m, const S& q, std::size_t axis) {
    return Number(coordinate(m, axis)) - Number(coordinate(q, axis));
}
/// |m - q|² - (w_m - w_q), along all axes: what lifts m above q.
template <class Number, class S>
[[nodiscard]] constexpr Number height(const S& m, const S& q) {
    Number sum = offset<Number>(m, q, 0) * offset<Number>(m, q, 0);
    for (std::size_t axis = 1; axis < dimension_of<S>; ++axis) {
        const Number x = offset<Number>(m, q, axis);
        sum = sum + x * x;
    }
    return sum - power::weight_difference<Number>(m, q);
}

}  // namespace signum::any_dimension
