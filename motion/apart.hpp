#pragma once
/// Places, and how far balls are from one another, in the numbers of each stage. For sources only.

#include <type_traits>

#include "../exact/dyadic.hpp"
#include "../filters/four.hpp"
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

/// The same vector in exact numbers.
template <int D>
[[nodiscard]] PerAxis<exact::Dyadic, D> dyadic(const Vector<D>& v) {
    PerAxis<exact::Dyadic, D> result;
    for (int k = 0; k < D; ++k) result[k] = exact::Dyadic(v[k]);
    return result;
}

/// a - b, less as many lengths of the box as the image says.
template <class Number, int D>
[[nodiscard, gnu::always_inline]] inline PerAxis<Number, D> apart(
    const Vector<D>& a, const Vector<D>& b, const Image<D>& image,
    const Effects<D>& effects) noexcept {
    PerAxis<Number, D> d;
    for (int k = 0; k < D; ++k) {
        d[k] = difference<Number>(a[k], b[k]);
        if (image[k] != 0) d[k] = d[k] - image[k] * length<Number>(effects, k);
    }
    return d;
}

/// A centre and its velocity at a time, exactly.
template <int D>
struct ExactPlace {
    PerAxis<exact::Dyadic, D> x;
    PerAxis<exact::Dyadic, D> v;

    ExactPlace(const Ball<D>& ball, const Effects<D>& effects, double t)
        : x(dyadic(ball.x)), v(dyadic(ball.v)) {
        static const exact::Dyadic half(0.5);
        const exact::Dyadic flown = exact::Dyadic(t) - exact::Dyadic(ball.time);
        for (int k = 0; k < D; ++k) {
            const exact::Dyadic fallen = exact::Dyadic(effects.gravity[k]) * flown;
            x[k] += (v[k] + half * fallen) * flown;
            v[k] += fallen;
        }
    }
};

/// The axes of a vector side by side, and zeros.
template <int D>
[[gnu::always_inline]] inline void load(filters::Four& numbers, const Vector<D>& v) noexcept {
    if constexpr (D == 2)
        numbers = filters::Four{v[0], v[1]};
    else
        numbers = filters::Four{v[0], v[1], v[2]};
}
/// a - b, less as many lengths of the box as the image says, by how much lies in `shift`: each
/// axis errs by less than 2^-100 of that.
template <int D>
[[nodiscard, gnu::always_inline]] inline filters::FourDoubleDoubles apart(
    const Vector<D>& a, const Vector<D>& b, const Image<D>& image, const Effects<D>& effects,
    filters::Four& shift) noexcept {
    filters::Four of_a;
    filters::Four of_b;
    load(of_a, a);
    load(of_b, b);
    filters::FourDoubleDoubles d = filters::exact_difference(of_a, of_b);
    shift = filters::Four{};
    if (image == Image<D>{}) [[likely]]
        return d;
    filters::Four turns{};
    filters::Four low;
    filters::Four high;
    for (int k = 0; k < D; ++k) turns[k] = image[k];
    load(low, effects.box->low);
    load(high, effects.box->high);
    const filters::FourDoubleDoubles shifted = turns * filters::exact_difference(high, low);
    filters::magnitude(shift, shifted.high);
    return d - shifted;
}

}  // namespace signum::motion
