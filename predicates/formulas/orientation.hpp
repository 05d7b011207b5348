#pragma once
/// The determinants of the orientation of three points of the plane and of four of space, for any
/// type of number.

#include "../../core/site.hpp"
#include "difference.hpp"

SIGNUM_IEEE_BEGIN

namespace signum::predicates {

/// The 2x2 determinant of the differences to one point.
template <class Number>
[[nodiscard, gnu::always_inline]] constexpr auto ccw_determinant(const Number& ax, const Number& ay,
                                                                 const Number& bx,
                                                                 const Number& by) {
    return ax * by - ay * bx;
}

/// A place relative to another one.
template <class Number>
struct Offset3 {
    Number x;
    Number y;
    Number z;
};
template <class Number = double, class S>
[[nodiscard, gnu::always_inline]] constexpr auto offset(const S& to, const S& from) noexcept {
    return Offset3<decltype(difference<Number>(to.x, from.x))>{difference<Number>(to.x, from.x),
                                                               difference<Number>(to.y, from.y),
                                                               difference<Number>(to.z, from.z)};
}

/// det(b, c, d).
template <class Number>
[[nodiscard, gnu::always_inline]] constexpr auto ccw_determinant(const Offset3<Number>& b,
                                                                 const Offset3<Number>& c,
                                                                 const Offset3<Number>& d) {
    return b.x * (c.y * d.z - c.z * d.y) + b.y * (c.z * d.x - c.x * d.z) +
           b.z * (c.x * d.y - c.y * d.x);
}

}  // namespace signum::predicates

SIGNUM_IEEE_END
