#include "exact_meeting.hpp"

#include <algorithm>
#include <cmath>

#include "../core/processor.hpp"
#include "../exact/surd.hpp"
#include "apart.hpp"
#include "meeting_time.hpp"
#include "nearby_time.hpp"

namespace signum::motion {
namespace {

using exact::Dyadic;
using exact::Rational;
using exact::to_rational;
using filters::add_magnitude;
using filters::DoubleDouble;
using filters::Four;
using filters::FourDoubleDoubles;
using filters::magnitude;

/// F(T + s) = a s² + 2 b s + c.
struct Quadratic {
    Dyadic a;
    Dyadic b;
    Dyadic c;
};

/// The meeting time of F, by the rule: what descent.hpp tells of any polynomial, where a root is a
/// formula and needs no isolation.
double first_descent(const Quadratic& f, double start) {
    const int bends = f.a.sign();
    const int slope = f.b.sign();
    const bool falls = slope < 0 || (slope == 0 && bends < 0);
    if (!falls && bends >= 0) return infinity;
    if (falls && f.c.sign() <= 0) return start;

    const Rational t = to_rational(start);
    const Rational a = to_rational(f.a);
    const Rational b = to_rational(f.b);
    const Rational c = to_rational(f.c);
    const auto rounded = [start](double time) {
        return std::isnan(time) ? infinity : std::max(time, start);
    };
    if (bends == 0) return rounded(exact::round_to_double(Rational(t - c / (2 * b))));
    const Rational discriminant = b * b - a * c;
    if (discriminant.sign() <= 0) {
        if (bends > 0) return infinity;
        // F does not rise above 0: it falls from its peak.
        return rounded(exact::round_to_double(Rational(t - b / a)));
    }
    return rounded(exact::round_surd(Rational(t - b / a), Rational(-1 / a), discriminant));
}

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// With F(t + δ) = F + 2 P δ + A δ², P = D·V at t, the root next to t is δ = -F/2P (1 + θ),
/// |θ| <= 2 |A δ / P| as long as that is small: F falls there, since P < 0. F comes of
/// double-doubles; of P and A doubles suffice, for δ is small.
template <int D>
[[gnu::always_inline]] inline double refined(const Ball<D>& a, const Ball<D>& b,
                                             const Image<D>& image, const Effects<D>& effects,
                                             double about) noexcept {
    const double start = std::max(a.time, b.time);
    if (!(about >= start && about < 0x1p500)) return none;
    const DoubleDouble since_a = filters::exact_difference(about, a.time);
    const DoubleDouble since_b = filters::exact_difference(about, b.time);
    Four shift;
    Four of_a;
    Four of_b;
    FourDoubleDoubles d = apart(a.x, b.x, image, effects, shift);
    load(of_a, a.v);
    load(of_b, b.v);
    const FourDoubleDoubles flown_a = of_a * filters::four_times(since_a);
    const FourDoubleDoubles flown_b = of_b * filters::four_times(since_b);
    d = (d + flown_a) - flown_b;
    Four v = of_a - of_b;
    // The sum of the magnitudes of what is added up.
    Four size = shift;
    Four speed{};
    add_magnitude(speed, of_a);
    add_magnitude(speed, of_b);
    for (const Vector<D>* const x : {&a.x, &b.x}) {
        Four place;
        load(place, *x);
        add_magnitude(size, place);
    }
    add_magnitude(size, flown_a.high);
    add_magnitude(size, flown_b.high);
    if (effects.gravity != Vector<D>{}) {
        const DoubleDouble later_a = filters::exact_difference(b.time, a.time);
        Four gravity;
        load(gravity, effects.gravity);
        const FourDoubleDoubles fallen =
            (0.5 * gravity) * filters::four_times(later_a * (since_a + since_b));
        d = d + fallen;
        v += gravity * later_a.high;
        add_magnitude(size, fallen.high);
        add_magnitude(speed, gravity * later_a.high);
    }
    DoubleDouble radii = filters::exact_sum(a.radius, b.radius);
    double rate = 0.0;
    if (effects.growth) {
        const DoubleDouble rates = filters::exact_sum(growth_of(a, effects), growth_of(b, effects));
        rate = rates.high;
        radii = radii + about * rates;
    }
    const DoubleDouble f = filters::dot<D>(d, d) - radii * radii;
    Four distance;
    magnitude(distance, d.high);
    const double f_error =
        0x1p-96 * (filters::sum_of(distance * (size + distance)) + radii.high * radii.high);
    const double p = filters::sum_of(d.high * v) - radii.high * rate;
    const double p_error = 0x1p-49 * (filters::sum_of(distance * speed) + radii.high * rate);
    const double square = filters::sum_of(v * v) + rate * rate;
    const double delta = -f.high / (2.0 * p);
    const double bend = std::fabs(square * delta / p);
    if (!(p < -0x1p-400 && p_error < -0x1p-20 * p && bend < 0x1p-20)) return none;
    const double error = f_error / -p + std::fabs(delta) * (0x1p-50 + 2.0 * (bend + p_error / -p));
    return nearby_time(about, delta, error, start);
}

}  // namespace

template <int D>
double exact_meeting(const Ball<D>& a, const Ball<D>& b, const Image<D>& image,
                     const Effects<D>& effects) {
    if (effects.growth)
        return meeting_time(GrowingBall<D>{a, growth_of(a, effects)},
                            GrowingBall<D>{b, growth_of(b, effects)}, image, effects);
    const double start = std::max(a.time, b.time);
    const ExactPlace<D> of_a(a, effects, start);
    const ExactPlace<D> of_b(b, effects, start);
    const PerAxis<Dyadic, D> v = of_a.v - of_b.v;
    PerAxis<Dyadic, D> d = of_a.x - of_b.x;
    for (int i = 0; i < D; ++i)
        if (image[i] != 0) d[i] = d[i] - image[i] * length<Dyadic>(effects, i);
    const Dyadic radii = Dyadic(a.radius) + Dyadic(b.radius);
    return first_descent({dot(v, v), dot(d, v), dot(d, d) - radii * radii}, start);
}

template <int D>
double exact_meeting(const Ball<D>& ball, Wall wall, const Effects<D>& effects) {
    const Dyadic rate(growth_of(ball, effects));
    const Dyadic grown = Dyadic(ball.radius) + rate * Dyadic(ball.time);
    const int axis = wall / 2;
    const bool upper = wall % 2 != 0;
    const auto inwards = [upper](double number) { return Dyadic(upper ? -number : number); };
    static const Dyadic half(0.5);
    const double side = upper ? effects.box->high[axis] : effects.box->low[axis];
    return first_descent(
        {half * inwards(effects.gravity[axis]), half * (inwards(ball.v[axis]) - rate),
         inwards(ball.x[axis]) - inwards(side) - grown},
        ball.time);
}

template <int D>
double refined_meeting(const Ball<D>& a, const Ball<D>& b, const Image<D>& image,
                       const Effects<D>& effects, double about) noexcept {
    return as_wide_as_possible([&]() __attribute__((always_inline)) {
        return refined(a, b, image, effects, about);
    });
}

template <int D>
double refined_meeting(const Ball<D>& ball, Wall wall, const Effects<D>& effects,
                       double about) noexcept {
    if (!(about >= ball.time && about < 0x1p500)) return none;
    const int axis = wall / 2;
    const double inwards = wall % 2 != 0 ? -1.0 : 1.0;
    const double v = inwards * ball.v[axis];
    const double gravity = inwards * effects.gravity[axis];
    const double side = wall % 2 != 0 ? effects.box->high[axis] : effects.box->low[axis];
    const DoubleDouble since = filters::exact_difference(about, ball.time);
    const DoubleDouble flown = v * since;
    const double rate = growth_of(ball, effects);
    const DoubleDouble radius = DoubleDouble{ball.radius, 0.0} + rate * DoubleDouble{about, 0.0};
    DoubleDouble f =
        (filters::exact_difference(inwards * ball.x[axis], inwards * side) - radius) + flown;
    double size = std::fabs(ball.x[axis]) + std::fabs(side) + radius.high + std::fabs(flown.high);
    double slope = v - rate;
    double slope_error = 0x1p-50 * rate;
    if (gravity != 0.0) {
        const DoubleDouble fallen = 0.5 * gravity * (since * since);
        f = f + fallen;
        size += std::fabs(fallen.high);
        slope += gravity * since.high;
        slope_error = 0x1p-50 * (std::fabs(v) + rate + std::fabs(gravity * since.high));
    }
    const double delta = -f.high / slope;
    const double bend = std::fabs(gravity * delta / slope);
    if (!(slope < -0x1p-400 && slope_error < -0x1p-20 * slope && bend < 0x1p-20)) return none;
    const double error = 0x1p-97 * size / -slope +
                         std::fabs(delta) * (0x1p-50 + 2.0 * (bend + slope_error / -slope));
    return nearby_time(about, delta, error, ball.time);
}

template double refined_meeting(const Ball<2>&, Wall, const Effects<2>&, double) noexcept;
template double refined_meeting(const Ball<3>&, Wall, const Effects<3>&, double) noexcept;
template double exact_meeting(const Ball<2>&, const Ball<2>&, const Image<2>&, const Effects<2>&);
template double exact_meeting(const Ball<3>&, const Ball<3>&, const Image<3>&, const Effects<3>&);
template double exact_meeting(const Ball<2>&, Wall, const Effects<2>&);
template double exact_meeting(const Ball<3>&, Wall, const Effects<3>&);
template double refined_meeting(const Ball<2>&, const Ball<2>&, const Image<2>&, const Effects<2>&,
                                double) noexcept;
template double refined_meeting(const Ball<3>&, const Ball<3>&, const Image<3>&, const Effects<3>&,
                                double) noexcept;

}  // namespace signum::motion
