#pragma once
/// How far balls are from one another, in the numbers of each stage. For sources only.

#include <type_traits>

#include "../exact/dyadic.hpp"
#include "../filters/double_double.hpp"
#include "ball.hpp"

namespace signum::motion {

/// a - b: exactly, but in doubles.
template <class Number>
[[nodiscard, gnu::always_inline]] inline Number difference(double a, double b) noexcept {
    if constexpr (std::is_same_v<Number, double>)
        return a - b;
    else if constexpr (std::is_same_v<Number, filters::DoubleDouble>)
        return filters::exact_difference(a, b);
    else
        return Number(a) - Number(b);
}

/// Of the box, along an axis.
template <class Number, int D>
[[nodiscard, gnu::always_inline]] inline Number length(const Effects<D>& effects,
                                                       int axis) noexcept {
    return difference<Number>(effects.box->high[axis], effects.box->low[axis]);
}

/// a - b along an axis, less as many lengths of the box as the image says.
template <class Number, int D>
[[nodiscard, gnu::always_inline]] inline Number apart(const Vector<D>& a, const Vector<D>& b,
                                                      int axis, const Image<D>& image,
                                                      const Effects<D>& effects) noexcept {
    Number d = difference<Number>(a[axis], b[axis]);
    if (image[axis] != 0) d = d - image[axis] * length<Number>(effects, axis);
    return d;
}

}  // namespace signum::motion
