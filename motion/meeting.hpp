#pragma once
/// When two balls meet, or a ball and a wall: one rule.
///
/// Let F(t) be |D(t)|² - R², D the difference of the centres and R the sum of the radii (wall: the
/// distance of the centre less the radius), and T the later of the two balls' own times. They meet
/// at the least t >= T at which F(t) <= 0 and F falls right after t. The meeting time is the double
/// nearest to it, halves to even, and T where that would be below T. Infinity stands for never.
/// So it is a function of two states and of nothing else.
///
/// What it means: F falls, they approach. Touching or overlapping at T and approaching: T.
/// Receding: never (radii that outgrow the motion and walls under gravity come back: F is concave
/// there). Where F only touches 0 they graze, and exchange no impulse: never.
///
/// Three stages: doubles with a bound (MeetingFilter, inline), which tell an interval that contains
/// the meeting time, or never, or nothing; exact(), double-doubles that nearly always tell the one
/// double, and rationals.

#include <algorithm>
#include <cmath>
#include <limits>

#include "../filters/bounds.hpp"
#include "ball.hpp"

namespace signum::motion {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// The meeting time lies in [early, late].
struct Meeting {
    double early = infinity;
    double late = infinity;
};
inline constexpr Meeting never{infinity, infinity};
inline constexpr Meeting unknown{-infinity, infinity};

/// Where a ball is at a moment, rounded.
template <int D>
struct Place {
    Vector<D> x;
    Vector<D> v;
};

/// Precondition: |x| < 2^51.
[[nodiscard, gnu::always_inline]] inline double nearest_integer(double x) noexcept {
    return (x + 0x1.8p52) - 0x1.8p52;
}

/// D·V, V·V, D·D - R² and the discriminant of a pair now; possible is 0 where it surely never
/// meets.
struct Approach {
    double product;
    double square;
    double gap;
    double discriminant;
    int possible;
};

template <int D>
struct Bounds {
    Vector<D> gravity{};
    /// Of a periodic box. Who is nearer than `far`, the square of half of the least one, is not
    /// seen shifted.
    Vector<D> length{};
    Vector<D> inverse_length{};
    double far = 0.0;
    double extent = 0.0;
    double speed = 0.0;
    double gap = 0.0;       ///< K, of C and per square of speed of the discriminant
    double approach = 0.0;  ///< (128 u E)², of (D·V)² per square of speed
    double w = 0.0;         ///< W²
};

inline constexpr double least_square = 0x1p-600;

/// s from now on, but for an error; the bounds of t's own rounding included.
[[nodiscard, gnu::always_inline]] inline Meeting around(double now, double s,
                                                        double error) noexcept {
    const double t = now + s;
    const double either_way = 2.0 * error + 0x1p-50 * t;
    return {std::max(t - either_way, now), t + either_way};
}

/// How long until gap + v s + g s²/2 falls through 0 or, where it is not above, begins to fall; in
/// plain doubles.
[[nodiscard]] inline double naive_descent(double gap, double v, double g) noexcept {
    if (v >= 0.0 && g >= 0.0) return infinity;
    if (gap <= 0.0) return v < 0.0 ? 0.0 : v / -g * (v * v > 2.0 * g * gap ? 2.0 : 1.0);
    const double square = v * v - 2.0 * g * gap;
    if (square <= 0.0) return infinity;
    return v < 0.0 ? 2.0 * gap / (std::sqrt(square) - v) : (v + std::sqrt(square)) / -g;
}

/// The first stage. Its bounds, with u = 2^-53, E = extent, W = speed:
///
/// Of the place of a ball: dt = fl(t - time), x + v dt. Both the ball's own x and the place of the
/// one that asks are at most E in each coordinate, so the product is at most 2E + |D_i|, and D_i, a
/// difference of two places less a multiple of the box's length, errs by less than u (14 E + 4
/// |D_i|) <= 24 u E. With gravity, v dt and g dt²/2 are asked whether they are below E, and D_i
/// errs by less than 32 u E. V errs by u a component, with gravity by 3 u W. For D <= 3, |D|² <= 12
/// E²:
///     B = D·V     |error| <= 80 u E √A + 21 u E W
///     C = D·D-R²  |error| <= 520 u E²
///     B² - AC     |error| <= 1800 u E² A + 340 u E² √A W <= K (A + W²),   K = 2048 u E²
/// and of s = C / (-B + √disc), since s √A <= |D| and s A = -B - √disc,
///     |error| <= (K + s K W/E + s K (A + W²)/√disc) / (-B + √disc),
/// which is at most K/√disc where W = 0. Twice that is taken, for the bounds are computed in
/// rounded numbers and disc may be twice its error.
template <int D, bool Falls, Kernel kernel>
class MeetingFilter {
 public:
    explicit MeetingFilter(const Effects<D>& effects) {
        bounds_.gravity = effects.gravity;
        bounds_.far = infinity;
        if (effects.box) {
            for (int i = 0; i < D; ++i) {
                include(effects.box->low[i]);
                include(effects.box->high[i]);
                const double length = effects.box->high[i] - effects.box->low[i];
                bounds_.length[i] = length;
                bounds_.inverse_length[i] = 1.0 / length;
                if (effects.periodic)
                    bounds_.far = std::min(bounds_.far, 0.25 * length * length * (1.0 - 0x1p-20));
            }
        }
    }

    /// Takes a ball into the bounds, as it is at its own time.
    void include(const Ball<D>& ball) noexcept {
        for (const double x : ball.x) include(x);
        include(2.0 * ball.radius);
        if constexpr (Falls)
            for (const double v : ball.v)
                bounds_.speed = std::max(bounds_.speed, filters::magnitude(v));
        set_bounds();
    }

    /// The questions of one ball at one time.
    class Asker {
     public:
        /// Looks whether another ball may be met at all, without a branch: which of many may is
        /// anybody's guess. Precondition: now is not before its own time, and the two have not met
        /// between T and now.
        [[nodiscard, gnu::always_inline]] Approach look(const Ball<D>& b) const noexcept;
        /// When, of one that may.
        [[nodiscard]] Meeting operator()(const Approach& approach) const noexcept;
        /// Of a side of the box: F = x - side - r, x counted inwards. With errors of 24 u E in F
        /// and 3 u W in the speed, those of the root as above.
        [[nodiscard]] Meeting operator()(Wall wall, double side) const noexcept;

     private:
        friend MeetingFilter;
        Place<D> place_;
        double radius_;
        double now_;
        Bounds<D> bounds_;
    };
    /// The bounds then hold for questions asked from where the ball is now.
    [[nodiscard]] Asker asker(const Ball<D>& ball, double now) noexcept;

 private:
    void include(double coordinate) noexcept {
        bounds_.extent = std::max(bounds_.extent, filters::magnitude(coordinate));
    }
    void set_bounds() noexcept {
        const double square = bounds_.extent * bounds_.extent;
        bounds_.gap = 0x1p-42 * square;
        bounds_.approach = 0x1p-92 * square;
        if constexpr (Falls) bounds_.w = bounds_.speed * bounds_.speed;
    }

    Bounds<D> bounds_;
};

template <int D, bool Falls, Kernel kernel>
auto MeetingFilter<D, Falls, kernel>::asker(const Ball<D>& ball, double now) noexcept -> Asker {
    Asker asker;
    const double dt = now - ball.time;
    double farthest = 0.0;
    double fastest = 0.0;
    for (int i = 0; i < D; ++i) {
        const double flown = ball.v[i] * dt;
        double& x = asker.place_.x[i];
        double& v = asker.place_.v[i];
        x = ball.x[i] + flown;
        v = ball.v[i];
        if constexpr (Falls) {
            const double fallen = 0.5 * bounds_.gravity[i] * (dt * dt);
            x += fallen;
            v += bounds_.gravity[i] * dt;
            farthest = std::max({farthest, filters::magnitude(flown), filters::magnitude(fallen)});
            fastest = std::max(fastest, filters::magnitude(v));
        }
        farthest = std::max(farthest, filters::magnitude(x));
    }
    if (farthest > bounds_.extent || (Falls && fastest > bounds_.speed)) [[unlikely]] {
        bounds_.extent = std::max(bounds_.extent, farthest);
        bounds_.speed = std::max(bounds_.speed, fastest);
        set_bounds();
    }
    asker.radius_ = ball.radius;
    asker.now_ = now;
    asker.bounds_ = bounds_;
    return asker;
}

template <int D, bool Falls, Kernel kernel>
inline Approach MeetingFilter<D, Falls, kernel>::Asker::look(const Ball<D>& b) const noexcept {
    const double dt = now_ - b.time;
    Vector<D> d;
    Vector<D> v;
    double largest = 0.0;
    for (int i = 0; i < D; ++i) {
        const double flown = b.v[i] * dt;
        if constexpr (Falls) {
            const double fallen = 0.5 * bounds_.gravity[i] * (dt * dt);
            d[i] = place_.x[i] - (b.x[i] + flown + fallen);
            v[i] = place_.v[i] - (b.v[i] + bounds_.gravity[i] * dt);
            largest = std::max({largest, filters::magnitude(flown), filters::magnitude(fallen)});
        } else {
            d[i] = place_.x[i] - (b.x[i] + flown);
            v[i] = place_.v[i] - b.v[i];
        }
    }
    double distance = dot(d, d);
    if (distance > bounds_.far) [[unlikely]] {
        for (int i = 0; i < D; ++i)
            d[i] -= bounds_.length[i] * nearest_integer(d[i] * bounds_.inverse_length[i]);
        distance = dot(d, d);
    }
    const double r = radius_ + b.radius;
    Approach approach;
    approach.product = dot(d, v);
    approach.square = dot(v, v);
    approach.gap = distance - r * r;
    approach.discriminant = approach.product * approach.product - approach.square * approach.gap;
    if constexpr (kernel == Kernel::naive) {
        approach.possible = static_cast<int>(approach.product < 0.0) &
                            static_cast<int>(approach.discriminant > 0.0);
        return approach;
    }
    const double size = Falls ? approach.square + bounds_.w : approach.square;
    // Velocities that are the same are so exactly, unless something was added to them.
    int rests = Falls ? 0 : 1;
    if constexpr (!Falls)
        for (const double each : v) rests &= static_cast<int>(each == 0.0);
    const int recedes = static_cast<int>(approach.product * filters::magnitude(approach.product) >
                                         bounds_.approach * size);
    const int misses = static_cast<int>(approach.discriminant < -bounds_.gap * size);
    approach.possible = 1 - (recedes | misses | rests);
    if constexpr (Falls) {
        if (largest > bounds_.extent) [[unlikely]] {
            approach.possible = 1;
            approach.gap = 0.0;
        }
    }
    return approach;
}

template <int D, bool Falls, Kernel kernel>
Meeting MeetingFilter<D, Falls, kernel>::Asker::operator()(
    const Approach& approach) const noexcept {
    if constexpr (kernel == Kernel::naive) {
        const double after = approach.gap / (std::sqrt(approach.discriminant) - approach.product);
        const double t = now_ + std::max(after, 0.0);
        return {t, t};
    }
    const double size = Falls ? approach.square + bounds_.w : approach.square;
    if (!(approach.discriminant > 2.0 * bounds_.gap * size && approach.gap > bounds_.gap &&
          approach.square > least_square)) [[unlikely]]
        return unknown;
    const double root = std::sqrt(approach.discriminant);
    const double s = approach.gap / (root - approach.product);
    double error = bounds_.gap / root;
    if constexpr (Falls)
        error = bounds_.gap * (1.0 + s * (bounds_.speed / bounds_.extent + size / root)) /
                (root - approach.product);
    return around(now_, s, error);
}

template <int D, bool Falls, Kernel kernel>
Meeting MeetingFilter<D, Falls, kernel>::Asker::operator()(Wall wall, double side) const noexcept {
    const int axis = wall / 2;
    const double inwards = wall % 2 != 0 ? -1.0 : 1.0;
    const double v = inwards * place_.v[axis];
    const double g = Falls ? inwards * bounds_.gravity[axis] : 0.0;
    if constexpr (kernel == Kernel::naive) {
        const double t = now_ + naive_descent(inwards * (place_.x[axis] - side) - radius_, v, g);
        return {t, t};
    }
    const double gap_error = 0x1p-47 * bounds_.extent;
    const double gap = inwards * (place_.x[axis] - side) - radius_;
    if (g == 0.0) {
        if (v >= 0.0) return never;
        if (!(gap > gap_error && v < -0x1p-300)) return unknown;
        return around(now_, gap / -v, gap_error / -v);
    }
    const double v_error = 0x1p-50 * bounds_.speed;
    if (!(gap > gap_error)) return unknown;
    if (g > 0.0 && v > v_error) return never;
    const double discriminant = v * v - 2.0 * g * gap;
    const double error = 0x1p-48 * bounds_.w + 2.0 * filters::magnitude(g) * gap_error;
    if (discriminant < -error && g > 0.0) return never;
    if (!(discriminant > 2.0 * error && (g < 0.0 || v < -v_error))) return unknown;
    const double root = std::sqrt(discriminant);
    const double root_error = v_error + error / root;
    if (v < 0.0) {
        const double s = 2.0 * gap / (root - v);
        return around(now_, s, (2.0 * gap_error + s * root_error) / (root - v));
    }
    return around(now_, (v + root) / -g, root_error / -g);
}

}  // namespace signum::motion
