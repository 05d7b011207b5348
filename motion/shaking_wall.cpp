/// The gap is P(t) - a sin(ω t + φ), P a parabola with dyadic coefficients. All is exact but for
/// sines and cosines, which are enclosed as narrowly as they are asked for.
///
/// Why the signs can be told at every dyadic t: the sine and the cosine of an algebraic number
/// other than 0 are transcendental (Lindemann), so that the gap and its derivatives are 0 there
/// only where their rational parts say so. A narrow enough enclosure then does not contain 0, and
/// the meeting rounds one way.
///
/// Why the search for the first meeting ends: time is cut into pieces, from the left to the right,
/// until in each one the gap is above 0, rises, falls, or is concave or convex. Small enough
/// pieces are one of these unless both derivatives of the gap are 0 at one point. There sin² + cos²
/// = 1 is an equation for t with algebraic coefficients. If t solves it, it is algebraic, and so is
/// the sine of ω t + φ, which is then 0 (Lindemann again), and with it P''. If the equation is an
/// identity, P is straight, too. So P is a straight line as steep as the sine is at most: the gap
/// rises or falls all the time, which is seen at once.
///
/// Where a convex gap has its least value, this is not 0, for the same reason, unless ω t + φ = 0:
/// an exception that is looked up in rationals.

#include "shaking_wall.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include "../core/contract.hpp"
#include "../exact/elementary.hpp"
#include "../exact/nearest_double.hpp"
#include "../exact/polynomial.hpp"
#include "descent.hpp"
#include "nearby_time.hpp"

namespace signum::motion {
namespace {

using exact::Dyadic;
using exact::Integer;

constexpr int least_bits = 128;
constexpr int most_bits = 2048;

[[noreturn]] void refuse() {
    throw std::domain_error(
        "meeting_time: 2048 bits do not tell when the ball meets the shaking wall");
}

Dyadic magnitude_of(const Dyadic& x) {
    return x.sign() < 0 ? -x : x;
}

/// A number of which bounds are known.
struct Bounded {
    Dyadic low;
    Dyadic high;

    friend Bounded operator+(const Dyadic& a, const Bounded& b) { return {a + b.low, a + b.high}; }
    friend Bounded operator*(const Dyadic& a, const Bounded& b) {
        return a.sign() < 0 ? Bounded{a * b.high, a * b.low} : Bounded{a * b.low, a * b.high};
    }
};

using Function = Dyadic (*)(const Dyadic& x, int bits);

/// The sine or cosine of x, |x| at most 2^(-bits / 4). Its series alternates: x - x³/6 + x⁵/120,
/// and 1 - x²/2 + x⁴/24.
Bounded enclose_near_zero(Function function, const Dyadic& x, int bits) {
    static const Dyadic half(0.5);
    static const Dyadic sixteenth(0.0625);
    const Dyadic square = x * x;
    if (function == exact::cosine) {
        const Dyadic value = Dyadic(1.0) - half * square;
        return {value, value + sixteenth * square * square};
    }
    const Integer sixth = (Integer(1) << bits) / 6;
    const Dyadic cube = square * x;
    const Dyadic rest = sixteenth * cube * square;
    const Bounded third = -cube * Bounded{Dyadic(sixth, -bits), Dyadic(Integer(sixth + 1), -bits)};
    return {x + third.low + std::min(rest, Dyadic()), x + third.high + std::max(rest, Dyadic())};
}

/// The sine or cosine of x. Where x is tiny, its series is nearer.
Bounded enclose(Function function, const Dyadic& x, int bits) {
    const bool is_sine = function == exact::sine;
    const double at_zero = is_sine ? 0.0 : 1.0;
    if (x.sign() == 0) return {Dyadic(at_zero), Dyadic(at_zero)};
    const int size = exact::size_of(x);
    if (-4 * size >= bits) return enclose_near_zero(function, x, bits);
    const Dyadic value = function(x, bits);
    const Dyadic error(Integer(1), (is_sine ? std::min(size, 0) : 0) - bits);
    return {value - error, value + error};
}

/// bounds_in(bits) -> Bounded, of a number that is not 0.
template <class BoundsIn>
Sign sign_of(const BoundsIn& bounds_in) {
    for (int bits = least_bits; bits <= most_bits; bits *= 2) {
        const Bounded bounds = bounds_in(bits);
        if (bounds.low.sign() == bounds.high.sign()) return bounds.low.sign();
    }
    refuse();
}

/// What the gap is in a piece of time. It is a rising, falling, concave or convex one also where a
/// derivative is 0 at single points; a gap that is constant counts as rising.
enum class Shape { apart, rising, falling, concave, convex, unknown };

class ShakingGap {
 public:
    template <int D>
    ShakingGap(const GrowingBall<D>& ball, const ShakingWall& wall, const Effects<D>& effects)
        : start_(ball.time), omega_(wall.frequency), phi_(wall.phase) {
        const int axis = wall.wall / 2;
        const auto inwards = [&](double number) {
            return Dyadic(wall.wall % 2 != 0 ? -number : number);
        };
        static const Dyadic half(0.5);
        const Dyadic v = inwards(ball.v[axis]);
        const Dyadic g = inwards(effects.gravity[axis]);
        const Dyadic since(start_);
        p_ = {inwards(ball.x[axis]) + (half * g * since - v) * since - inwards(wall.level) -
                  Dyadic(ball.radius),
              v - g * since - Dyadic(ball.growth), half * g};
        a_ = inwards(wall.amplitude);
        a_omega_ = a_ * omega_;
        a_omega2_ = a_omega_ * omega_;
        // With t = -φ/ω: P(t) ω² = 0 and P'(t) ω = a ω².
        grazes_ =
            (p_[2] * phi_ * phi_ - p_[1] * phi_ * omega_ + p_[0] * omega_ * omega_).sign() == 0 &&
            (p_[1] * omega_ - 2 * p_[2] * phi_ - a_omega2_).sign() == 0;
    }

    /// Pieces are at most a radian long where the sine matters. Where it does not, for the parabola
    /// is too far or too steep, they grow.
    [[nodiscard]] double first_descent(double since) const {
        const double start = std::max(start_, since);
        if (a_.sign() == 0 || (omega_.sign() == 0 && phi_.sign() == 0))
            return motion::first_descent({p_[0], p_[1], p_[2]}, start);
        const Dyadic end(Integer(1), 1024);
        int least_size = 0;
        if (omega_.sign() != 0)
            least_size = -omega_.exponent() - static_cast<int>(msb(abs(omega_.significand()))) - 1;
        int size = least_size;
        for (Dyadic low(start); low < end;) {
            const Dyadic high = low + Dyadic(Integer(1), size);
            const Shape known = shape(low, high);
            if (known == Shape::unknown && size > least_size) {
                --size;
                continue;
            }
            const std::optional<double> time =
                known == Shape::unknown ? meeting(low, high, 0) : meeting(low, high, known);
            if (time) return *time;
            if (known != Shape::unknown) ++size;
            low = high;
        }
        return infinity;
    }

    /// The double nearest to where the gap falls through 0, next to `about`; NaN where one look at
    /// the gap there does not tell it.
    ///
    /// With F and F' at `about`, and |F''| <= B, the root next to it is about - F/F' (1 + θ), |θ|
    /// <= |B F / F'²|, as long as that is small.
    [[nodiscard]] double falls_near(double about) const {
        constexpr double none = std::numeric_limits<double>::quiet_NaN();
        if (!(about >= start_ && about < 0x1p500)) return none;
        constexpr int bits = 160;
        const Dyadic t(about);
        const Bounded gap = value(t, bits);
        const Bounded fall = slope(t, bits);
        const double f = round_to_double(gap.low);
        const double steep = round_to_double(fall.high);
        if (!(steep < -0x1p-400 && round_to_double(fall.low) > steep * (1.0 + 0x1p-30)))
            return none;
        const double bend =
            std::fabs(round_to_double(2 * p_[2])) + std::fabs(round_to_double(a_omega2_));
        const double delta = -f / steep;
        const double theta = std::fabs(bend * delta / steep);
        if (!(theta < 0x1p-20)) return none;
        const double error = std::fabs(delta) * (0x1p-29 + 2.0 * theta) +
                             2.0 * round_to_double(gap.high - gap.low) / -steep;
        return nearby_time(about, delta, error, start_);
    }

 private:
    [[nodiscard]] Dyadic argument(const Dyadic& t) const { return omega_ * t + phi_; }
    [[nodiscard]] Dyadic parabola(const Dyadic& t) const { return p_[0] + (p_[1] + p_[2] * t) * t; }
    [[nodiscard]] Dyadic parabola_slope(const Dyadic& t) const { return p_[1] + 2 * p_[2] * t; }
    /// Of the gap and its derivative at t.
    [[nodiscard]] Bounded value(const Dyadic& t, int bits) const {
        return parabola(t) + -a_ * enclose(exact::sine, argument(t), bits);
    }
    [[nodiscard]] Bounded slope(const Dyadic& t, int bits) const {
        return parabola_slope(t) + -a_omega_ * enclose(exact::cosine, argument(t), bits);
    }

    /// The sine of an algebraic number is never 1 or -1, the cosine only that of 0.
    [[nodiscard]] Sign sign(const Dyadic& t) const {
        const Dyadic p = parabola(t);
        if (a_.sign() == 0 || argument(t).sign() == 0 || magnitude_of(p) >= magnitude_of(a_))
            return p.sign();
        return sign_of([&](int bits) { return value(t, bits); });
    }

    [[nodiscard]] Sign slope_sign(const Dyadic& t) const {
        const Dyadic p = parabola_slope(t);
        if (argument(t).sign() == 0) return (p - a_omega_).sign();
        if (magnitude_of(p) >= magnitude_of(a_omega_)) return p.sign();
        return sign_of([&](int bits) { return slope(t, bits); });
    }

    /// With bounds of the sine and the cosine in [low, high]. A parabola that is convex is at most
    /// P''/8 · (high - low)² below the lower one of its ends.
    [[nodiscard]] Shape shape(const Dyadic& low, const Dyadic& high, const Bounded& sine,
                              const Bounded& cosine) const {
        const Dyadic width = high - low;
        Dyadic least = std::min(parabola(low), parabola(high));
        if (p_[2].sign() > 0) least = least - Dyadic(0.25) * p_[2] * width * width;
        if ((least + -a_ * sine).low.sign() >= 0) return Shape::apart;
        const auto [least_slope, most_slope] =
            std::minmax({parabola_slope(low), parabola_slope(high)});
        const Bounded of_slope = -a_omega_ * cosine;
        if ((least_slope + of_slope).low.sign() >= 0) return Shape::rising;
        if ((most_slope + of_slope).high.sign() <= 0) return Shape::falling;
        const Bounded bend = 2 * p_[2] + a_omega2_ * sine;
        if (bend.high.sign() <= 0) return Shape::concave;
        if (bend.low.sign() >= 0) return Shape::convex;
        return Shape::unknown;
    }

    /// As far as can be told from the sizes of a, a ω and a ω² alone.
    [[nodiscard]] Shape shape(const Dyadic& low, const Dyadic& high) const {
        static const Bounded wave{Dyadic(-1.0), Dyadic(1.0)};
        return shape(low, high, wave, wave);
    }

    /// In the piece, neither the sine nor the cosine is farther from its value in the middle than
    /// the argument is.
    [[nodiscard]] Shape shape_near_middle(const Dyadic& low, const Dyadic& high, int depth) const {
        static const Dyadic half(0.5);
        const Dyadic middle = half * (low + high);
        const Dyadic way = magnitude_of(half * omega_ * (high - low));
        const auto near_middle = [&](Function function) {
            const Bounded there = enclose(function, argument(middle), least_bits + depth);
            return Bounded{std::max(there.low - way, Dyadic(-1.0)),
                           std::min(there.high + way, Dyadic(1.0))};
        };
        return shape(low, high, near_middle(exact::sine), near_middle(exact::cosine));
    }

    /// Whether a convex gap that is above 0 and falls at `low`, and rises at `high`, is below 0 in
    /// between. It is not below its tangent.
    [[nodiscard]] bool dips(Dyadic low, Dyadic high) const {
        if (grazes_ && argument(low).sign() * argument(high).sign() < 0) return false;
        for (int bits = least_bits; bits <= most_bits; bits += 2) {
            const Dyadic middle = Dyadic(0.5) * (low + high);
            if (sign(middle) < 0) return true;
            const Sign rises = slope_sign(middle);
            if (rises == 0) return false;
            (rises < 0 ? low : high) = middle;
            const Dyadic fall = slope(low, bits).low * (high - low);
            if ((value(low, bits).low + fall).sign() >= 0) return false;
        }
        refuse();
    }

    /// The meeting in [low, high), if there is one.
    ///
    /// The meeting is `low` where the gap falls from there on and is not above 0. (Had it been so
    /// before, the meeting would have been found there.)
    [[nodiscard]] std::optional<double> meeting(const Dyadic& low, const Dyadic& high,
                                                Shape shape) const {
        if (shape == Shape::apart || shape == Shape::rising) return std::nullopt;
        const bool falls_first = shape == Shape::falling || slope_sign(low) < 0 ||
                                 (shape == Shape::concave && slope_sign(low) == 0);
        if (falls_first && sign(low) <= 0)
            return exact::nearest_double([&](const Dyadic& x) { return (low - x).sign(); });
        if (shape == Shape::convex) {
            if (!falls_first) return std::nullopt;
            if (slope_sign(high) <= 0) shape = Shape::falling;
        } else if (shape == Shape::concave && slope_sign(high) >= 0) {
            return std::nullopt;
        }
        if (shape == Shape::convex ? !dips(low, high) : sign(high) >= 0) return std::nullopt;
        return exact::nearest_double([&](const Dyadic& x) {
            if (x <= low) return 1;
            if (x >= high) return -1;
            // Convex: it falls through 0 before its least value. Otherwise from the meeting on the
            // gap is not above 0 and does not rise, and before it one of these fails.
            const Sign rises = shape == Shape::falling ? -1 : slope_sign(x);
            if (shape == Shape::convex && rises >= 0) return -1;
            if (shape == Shape::concave && rises > 0) return 1;
            const Sign apart = sign(x);
            return shape == Shape::concave && apart <= 0 ? std::max(rises, apart) : apart;
        });
    }

    /// The same, whatever the shape.
    [[nodiscard]] std::optional<double> meeting(const Dyadic& low, const Dyadic& high,
                                                int depth) const {
        const Shape known = shape_near_middle(low, high, depth);
        if (known != Shape::unknown) return meeting(low, high, known);
        if (depth > most_bits - least_bits) refuse();
        const Dyadic middle = Dyadic(0.5) * (low + high);
        const std::optional<double> time = meeting(low, middle, depth + 1);
        return time ? time : meeting(middle, high, depth + 1);
    }

    double start_;
    std::array<Dyadic, 3> p_;
    Dyadic a_;
    Dyadic omega_;
    Dyadic phi_;
    Dyadic a_omega_;
    Dyadic a_omega2_;
    bool grazes_ = false;  // the gap and its slope are 0 where the sine's argument is
};

/// size · function(frequency · t + phase).
double wave_at(Function function, const Dyadic& size, const ShakingWall& wall, double t) {
    const Dyadic argument = Dyadic(wall.frequency) * Dyadic(t) + Dyadic(wall.phase);
    for (int bits = least_bits; bits <= most_bits; bits *= 2) {
        const Bounded bounds = size * enclose(function, argument, bits);
        const double low = round_to_double(bounds.low);
        if (low == round_to_double(bounds.high)) return low;
    }
    refuse();
}

}  // namespace

template <int D>
double refined_meeting(const GrowingBall<D>& ball, const ShakingWall& wall,
                       const Effects<D>& effects, double about) {
    return ShakingGap(ball, wall, effects).falls_near(about);
}

double speed_at(const ShakingWall& wall, double t) {
    return wave_at(exact::cosine, Dyadic(wall.amplitude) * Dyadic(wall.frequency), wall, t);
}
double shift_at(const ShakingWall& wall, double t) {
    return wave_at(exact::sine, Dyadic(wall.amplitude), wall, t);
}

template <int D>
double meeting_time(const GrowingBall<D>& ball, const ShakingWall& wall, const Effects<D>& effects,
                    double since) {
    SIGNUM_EXPECTS(0 <= wall.wall && wall.wall < 2 * D);
    return ShakingGap(ball, wall, effects).first_descent(since);
}

template double refined_meeting(const GrowingBall<2>&, const ShakingWall&, const Effects<2>&,
                                double);
template double refined_meeting(const GrowingBall<3>&, const ShakingWall&, const Effects<3>&,
                                double);
template double meeting_time(const GrowingBall<2>&, const ShakingWall&, const Effects<2>&, double);
template double meeting_time(const GrowingBall<3>&, const ShakingWall&, const Effects<3>&, double);

}  // namespace signum::motion
