#pragma once
/// When two balls meet, or a ball and a wall: one rule.
///
/// Let F(t) be |D(t)|² - R², D the difference of the centres and R the sum of the radii (wall: the
/// distance of the centre less the radius), and T the later of the two balls' own times. They meet
/// at the least t >= T at which F(t) <= 0 and F falls right after t. The meeting time is the double
/// nearest to it, halves to even, and T where that would be below T. Infinity stands for never.
/// So it is a function of two states and of nothing else.
///
/// What it means: F falls, they approach. Touching or overlapping at T and approaching: T. Receding:
/// never (radii that outgrow the motion and walls under gravity come back: F is concave there).
/// Where F only touches 0 they graze, and exchange no impulse: never.
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

/// The first stage. Its bounds, with u = 2^-53, E = extent, W = speed:
///
/// Of the place of a ball: dt = fl(t - time), x + v dt. Both the ball's own x and the place of the
/// one that asks are at most E in each coordinate, so the product is at most 2E + |D_i|, and D_i, a
/// difference of two places less a multiple of the box's length, errs by less than u (14 E + 4
/// |D_i|) <= 24 u E. With gravity, v dt and g dt²/2 are asked whether they are below E, and D_i
/// errs by less than 32 u E. V errs by u a component, with gravity by 3 u W. For D <= 3, |D|² <= 12 E²:
///     B = D·V     |error| <= 80 u E √A + 21 u E W
///     C = D·D-R²  |error| <= 520 u E²
///     B² - AC     |error| <= 1800 u E² A + 340 u E² √A W <= K (A + W²),   K = 2048 u E²
/// and of s = C / (-B + √disc), since s √A <= |D| and s A = -B - √disc,
///     |error| <= (K + s K W/E + s K (A + W²)/√disc) / (-B + √disc),
/// which is at most K/√disc where W = 0. Twice that is taken, for the bounds are computed in rounded
/// numbers and disc may be twice its error.
template <int D, bool Falls>
class MeetingFilter {
 public:
    explicit MeetingFilter(const Effects<D>& effects) : gravity_(effects.gravity) {
        if (effects.box) {
            for (int i = 0; i < D; ++i) {
                include(effects.box->low[i]);
                include(effects.box->high[i]);
                length_[i] = effects.box->high[i] - effects.box->low[i];
                inverse_length_[i] = 1.0 / length_[i];
            }
        }
        periodic_ = effects.periodic;
    }

    /// Takes a ball into the bounds, as it is at its own time.
    void include(const Ball<D>& ball) noexcept {
        for (const double x : ball.x) include(x);
        include(2.0 * ball.radius);
        if constexpr (Falls)
            for (const double v : ball.v) speed_ = std::max(speed_, filters::magnitude(v));
        set_bounds();
    }

    /// Where a ball is now; the bounds then hold for questions asked from there.
    [[nodiscard]] Place<D> enter(const Ball<D>& ball, double now) noexcept {
        Place<D> place;
        const double dt = now - ball.time;
        double farthest = 0.0;
        double fastest = 0.0;
        for (int i = 0; i < D; ++i) {
            const double flown = ball.v[i] * dt;
            place.x[i] = ball.x[i] + flown;
            place.v[i] = ball.v[i];
            if constexpr (Falls) {
                const double fallen = 0.5 * gravity_[i] * (dt * dt);
                place.x[i] += fallen;
                place.v[i] += gravity_[i] * dt;
                farthest = std::max(
                    {farthest, filters::magnitude(flown), filters::magnitude(fallen)});
                fastest = std::max(fastest, filters::magnitude(place.v[i]));
            }
            farthest = std::max(farthest, filters::magnitude(place.x[i]));
        }
        if (farthest > extent_ || (Falls && fastest > speed_)) [[unlikely]] {
            extent_ = std::max(extent_, farthest);
            speed_ = std::max(speed_, fastest);
            set_bounds();
        }
        return place;
    }

    /// Of the ball at a place, of radius r, and another one; now is not before either's own time,
    /// and the two have not met between T and now.
    [[nodiscard, gnu::always_inline]] Meeting operator()(const Place<D>& a, double radius,
                                                         const Ball<D>& b,
                                                         double now) const noexcept {
        const double dt = now - b.time;
        Vector<D> d;
        Vector<D> v;
        double largest = 0.0;
        for (int i = 0; i < D; ++i) {
            const double flown = b.v[i] * dt;
            if constexpr (Falls) {
                const double fallen = 0.5 * gravity_[i] * (dt * dt);
                d[i] = a.x[i] - (b.x[i] + flown + fallen);
                v[i] = a.v[i] - (b.v[i] + gravity_[i] * dt);
                largest = std::max({largest, filters::magnitude(flown), filters::magnitude(fallen)});
            } else {
                d[i] = a.x[i] - (b.x[i] + flown);
                v[i] = a.v[i] - b.v[i];
            }
        }
        if (periodic_)
            for (int i = 0; i < D; ++i) d[i] -= length_[i] * nearest_integer(d[i] * inverse_length_[i]);
        if (Falls && largest > extent_) [[unlikely]]
            return unknown;
        const double r = radius + b.radius;
        const double product = dot<D>(d, v);
        const double square = dot<D>(v, v);
        if (product > 0.0 && product * product > approach_bound_ * (square + w_)) return never;
        const double gap = dot<D>(d, d) - r * r;
        const double discriminant = product * product - square * gap;
        const double bound = bound_ * (square + w_);
        if (discriminant < -bound) return never;
        if (!(discriminant > 2.0 * bound && gap > bound_ && square > least_square)) [[unlikely]]
            return unknown;
        const double root = std::sqrt(discriminant);
        const double s = gap / (root - product);
        const double t = now + s;
        double error = bound_ / root;
        if constexpr (Falls)
            error = bound_ * (1.0 + s * (speed_ / extent_ + (square + w_) / root)) / (root - product);
        error = 2.0 * error + 0x1p-50 * t;
        return {std::max(t - error, now), t + error};
    }

    /// Of the ball at a place and a side of the box: F = x - side - r, x counted inwards. With
    /// errors of 24 u E in F and 3 u W in the speed, those of the root as above.
    [[nodiscard]] Meeting operator()(const Place<D>& a, double radius, Wall wall, double side,
                                     double now) const noexcept {
        const int axis = wall / 2;
        const double inwards = wall % 2 != 0 ? -1.0 : 1.0;
        const double v = inwards * a.v[axis];
        const double g = Falls ? inwards * gravity_[axis] : 0.0;
        const double gap_error = 0x1p-47 * extent_;
        const double gap = inwards * (a.x[axis] - side) - radius;
        if (g == 0.0) {
            if (v >= 0.0) return never;
            if (!(gap > gap_error && v < -0x1p-300)) return unknown;
            const double s = gap / -v;
            return around(now, s, gap_error / -v);
        }
        const double v_error = 0x1p-50 * speed_;
        if (!(gap > gap_error)) return unknown;
        if (g > 0.0 && v > v_error) return never;
        const double discriminant = v * v - 2.0 * g * gap;
        const double error = 0x1p-48 * (speed_ * speed_) + 2.0 * filters::magnitude(g) * gap_error;
        if (discriminant < -error && g > 0.0) return never;
        if (!(discriminant > 2.0 * error && (g < 0.0 || v < -v_error))) return unknown;
        const double root = std::sqrt(discriminant);
        const double root_error = v_error + error / root;
        if (v < 0.0) {
            const double s = 2.0 * gap / (root - v);
            return around(now, s, (2.0 * gap_error + s * root_error) / (root - v));
        }
        return around(now, (v + root) / -g, root_error / -g);
    }

 private:
    static constexpr double least_square = 0x1p-600;

    static Meeting around(double now, double s, double error) noexcept {
        const double t = now + s;
        error = 2.0 * error + 0x1p-50 * t;
        return {std::max(t - error, now), t + error};
    }

    void include(double coordinate) noexcept {
        extent_ = std::max(extent_, filters::magnitude(coordinate));
    }
    void set_bounds() noexcept {
        bound_ = 0x1p-42 * extent_ * extent_;
        approach_bound_ = 0x1p-92 * extent_ * extent_;
        if constexpr (Falls) w_ = speed_ * speed_;
    }

    Vector<D> gravity_{};
    Vector<D> length_{};
    Vector<D> inverse_length_{};
    bool periodic_ = false;
    double extent_ = 0.0;
    double speed_ = 0.0;
    double bound_ = 0.0;           // K
    double approach_bound_ = 0.0;  // (128 u E)²
    double w_ = 0.0;               // W²
};

}  // namespace signum::motion
