#pragma once
/// Balls in flight. All numbers are doubles and are taken as exact ones.

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "effects.hpp"
#include "vector.hpp"

SIGNUM_IEEE_BEGIN

namespace signum::motion {

/// A disc (D = 2) or ball (D = 3). At `time` its centre is x and its velocity v; until its next
/// strike it flies on x + v s + g s²/2, s = t - time. One of space fills a cache line.
template <int D>
struct alignas(D == 3 ? 64 : 16) Ball {
    Vector<D> x{};        ///< the centre at its time
    Vector<D> v{};        ///< the velocity then
    double radius = 0.0;  ///< at time 0, where radii grow
    double time = 0.0;    ///< its own
};

/// The rate at which a ball's radius grows: at time t it is radius + rate · t.
template <int D>
[[nodiscard, gnu::always_inline]] inline double growth_of(const Ball<D>& ball,
                                                          const Effects<D>& effects) noexcept {
    return effects.growth ? effects.growth->rate * ball.radius : 0.0;
}

/// By how many times the radius it had at time 0 a ball's radius is larger in the end, at most.
[[nodiscard]] inline double largest_growth(const Growth& growth) noexcept {
    return (1.0 + growth.rate * growth.until) * (1.0 + 0x1p-40);
}

/// A ball's radius at the time of the state it is taken from, rounded.
template <int D>
[[nodiscard]] inline double radius_at(const Ball<D>& ball, double t,
                                      const Effects<D>& effects) noexcept {
    const bool grows = effects.growth && t < effects.growth->until;
    return grows ? ball.radius + growth_of(ball, effects) * t : ball.radius;
}

/// The acceleration of flights: gravity, but where it acts by kicks.
template <int D>
[[nodiscard, gnu::always_inline]] inline double fall_of(const Effects<D>& effects,
                                                        int axis) noexcept {
    return effects.time_step > 0.0 ? 0.0 : effects.gravity[axis];
}

/// Where a ball's centre is along an axis at a time, rounded.
template <int D>
[[nodiscard, gnu::always_inline]] inline double coordinate(const Ball<D>& ball, int axis, double t,
                                                           const Effects<D>& effects) noexcept {
    const double s = t - ball.time;
    return ball.x[axis] + ball.v[axis] * s + 0.5 * fall_of(effects, axis) * (s * s);
}
/// How fast it is there, rounded.
template <int D>
[[nodiscard, gnu::always_inline]] inline double speed(const Ball<D>& ball, int axis, double t,
                                                      const Effects<D>& effects) noexcept {
    return ball.v[axis] + fall_of(effects, axis) * (t - ball.time);
}
/// Where its centre is at a time, rounded.
template <int D>
[[nodiscard]] inline Vector<D> centre(const Ball<D>& ball, double t,
                                      const Effects<D>& effects) noexcept {
    Vector<D> x;
    for (int k = 0; k < D; ++k) x[k] = coordinate(ball, k, t, effects);
    return x;
}
/// How it flies there, rounded.
template <int D>
[[nodiscard]] inline Vector<D> velocity(const Ball<D>& ball, double t,
                                        const Effects<D>& effects) noexcept {
    Vector<D> v;
    for (int k = 0; k < D; ++k) v[k] = speed(ball, k, t, effects);
    return v;
}
/// A place along an axis, less as many lengths of a periodic box as bring it into it, rounded; the
/// place itself in any other world.
template <int D>
[[nodiscard]] inline double in_box(double x, int axis, const Effects<D>& effects) noexcept {
    if (!effects.periodic) return x;
    const double low = effects.box->low[axis];
    const double length = effects.box->high[axis] - low;
    return x - length * std::floor((x - low) / length);
}
/// Where its centre is at a time, in the box where it is periodic, rounded.
template <int D>
[[nodiscard]] inline Vector<D> centre_in_box(const Ball<D>& ball, double t,
                                             const Effects<D>& effects) noexcept {
    Vector<D> x = centre(ball, t, effects);
    for (int k = 0; k < D; ++k) x[k] = in_box(x[k], k, effects);
    return x;
}

/// All places where the sides of a box are, if it shakes.
template <int D>
[[nodiscard]] Box<D> swept(Box<D> box, const Effects<D>& effects) noexcept {
    if (!effects.shake) return box;
    for (int k = 0; k < D; ++k) {
        box.low[k] -= std::fabs(effects.shake->amplitude[k]);
        box.high[k] += std::fabs(effects.shake->amplitude[k]);
    }
    return box;
}

/// How signs and times are computed: exactly, or in plain doubles.
enum class Kernel { exact, naive };

/// A ball's place in the arrays of a simulation; its number in the input is another one.
using Slot = std::uint32_t;

/// By how many lengths of a periodic box a ball's partner is seen shifted, along each axis.
template <int D>
using Image = PerAxis<int, D>;

/// Of doubles about as large the units are the last places.
inline constexpr double where_doubles_are_integers = 0x1.8p52;
/// Precondition: |x| < 2^51.
[[nodiscard, gnu::always_inline]] inline double nearest_integer(double x) noexcept {
    return (x + where_doubles_are_integers) - where_doubles_are_integers;
}

/// That in which b is nearest to a.
template <int D>
[[nodiscard]] inline Image<D> nearest_image(const Vector<D>& a, const Vector<D>& b,
                                            const Effects<D>& effects) noexcept {
    Image<D> image;
    if (!effects.periodic) return image;
    for (int k = 0; k < D; ++k) {
        const double length = effects.box->high[k] - effects.box->low[k];
        const double d = a[k] - b[k];
        // Nearly always, and without a division.
        if (std::fabs(d) < 0.4 * length) continue;
        image[k] = static_cast<int>(nearest_integer(d / length));
    }
    return image;
}

/// The number of a side of the box: 2 · axis, 1 more for the upper one.
using Wall = std::int32_t;

}  // namespace signum::motion

SIGNUM_IEEE_END
