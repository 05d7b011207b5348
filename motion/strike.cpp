#include "strike.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "../core/error_free.hpp"
#include "../core/processor.hpp"
#include "../exact/surd.hpp"
#include "apart.hpp"
#include "in_place.hpp"

namespace signum::motion {
namespace {

using exact::Dyadic;
using exact::Integer;
using exact::Rational;
using exact::to_rational;
using filters::DoubleDouble;
using filters::exact_difference;
using filters::exact_sum;
using filters::Flags;
using filters::Four;
using filters::FourDoubleDoubles;
using filters::magnitude;

/// A quotient, off by at most 2^-102 of itself: of the remainder r of the first division, told
/// exactly by one fused operation, three small terms are lost, and r is divided by b.high alone.
[[gnu::always_inline]] inline DoubleDouble quotient(DoubleDouble a, DoubleDouble b) noexcept {
    const double first = a.high / b.high;
    const double rest = __builtin_fma(-first, b.high, a.high);
    const TwoTerms sum = quick_two_sum(first, (rest + (a.low - first * b.low)) / b.high);
    return {sum.high, sum.low};
}

/// Whether all numbers that differ from the double-double by at most the error round to one double,
/// which is stored; a zero is +0.
[[gnu::always_inline]] inline bool rounds(DoubleDouble number, double error,
                                          double& nearest) noexcept {
    nearest = number.high + (number.low - error) + 0.0;
    return nearest == number.high + (number.low + error);
}

double rounded(const Rational& number) {
    return exact::round_to_double(number) + 0.0;
}

/// x + v s + g s²/2, rounded once, or as many lengths of the box less.
template <int D>
double exact_arrival(const Ball<D>& ball, int axis, double t, const Effects<D>& effects) {
    const Rational s = to_rational(t) - to_rational(ball.time);
    Rational x = to_rational(ball.x[axis]) + to_rational(ball.v[axis]) * s +
                 to_rational(effects.gravity[axis]) * s * s / 2;
    if (effects.periodic) {
        const Rational box = to_rational(length<Dyadic>(effects, axis));
        const Rational turns = (x - to_rational(effects.box->low[axis])) / box;
        Integer whole;
        Integer rest;
        divide_qr(numerator(turns), denominator(turns), whole, rest);
        if (rest.sign() < 0) --whole;
        x -= whole * box;
    }
    return rounded(x);
}

/// (1+e) m/(m_a+m_b), of which equal masses leave (1+e)/2.
struct Shares {
    DoubleDouble of_a;
    DoubleDouble of_b;
};
[[gnu::always_inline]] inline Shares shares(double mass_a, double mass_b,
                                            double restitution) noexcept {
    const DoubleDouble bounce = exact_sum(1.0, restitution);
    if (mass_a == mass_b) {
        const DoubleDouble half{0.5 * bounce.high, 0.5 * bounce.low};
        return {half, half};
    }
    const DoubleDouble sum = exact_sum(mass_a, mass_b);
    return {bounce * quotient({mass_b, 0.0}, sum), bounce * quotient({mass_a, 0.0}, sum)};
}

Rational bounce(double restitution) {
    return 1 + to_rational(restitution);
}

template <int D>
bool change(Ball<D>& ball, const Vector<D>& v) noexcept {
    return std::exchange(ball.v, v) != v;
}

/// Off by at most 2^-98 of itself.
[[gnu::always_inline]] inline DoubleDouble root_of(DoubleDouble square) noexcept {
    const double first = std::sqrt(square.high);
    const TwoTerms root =
        two_sum(first, (square - first * DoubleDouble{first, 0.0}).high / (2.0 * first));
    return {root.high, root.low};
}

/// What products lose that are too small for their error to be a double.
constexpr double underflow = 0x1p-1060;

/// D, D·V - ρ √(D·D) and D·D of two balls at one time, in double-doubles.
template <int D>
struct RefinedSeparation {
    [[gnu::always_inline]] RefinedSeparation(const Ball<D>& a, const Ball<D>& b,
                                             const Image<D>& image, const Law& law,
                                             const Effects<D>& effects) noexcept {
        Four shifts;
        x = apart(a.x, b.x, image, effects, shifts);
        Four of_a;
        Four of_b;
        load(of_a, a.v);
        load(of_b, b.v);
        const FourDoubleDoubles v = exact_difference(of_a, of_b);
        product = filters::dot<D>(x, v);
        square = filters::dot<D>(x, x);
        Four distance;
        Four speed;
        magnitude(distance, x.high);
        magnitude(speed, v.high);
        size = filters::sum_of((distance + shifts) * speed);
        shift = filters::sum_of(shifts);
        if (law.growth != 0.0) [[unlikely]] {
            const DoubleDouble grown = law.growth * root_of(square);
            product = product - grown;
            size += grown.high;
        }
    }
    [[nodiscard, gnu::always_inline]] double product_error() const noexcept {
        return 0x1p-98 * size + underflow;
    }
    /// Of the quotient of product and square.
    [[nodiscard, gnu::always_inline]] double relative_error() const noexcept {
        const double relative = product_error() / std::fabs(product.high);
        return shift > 0.0 ? relative + 0x1p-96 * shift / std::sqrt(square.high) : relative;
    }

    FourDoubleDoubles x;
    DoubleDouble product;
    DoubleDouble square;
    /// A component of D errs by 2^-100 of its shift, the product by 2^-98 size.
    double size;
    double shift;
};
/// The same, exactly.
template <int D>
struct ExactSeparation {
    ExactSeparation(const Ball<D>& a, const Ball<D>& b, const Image<D>& image,
                    const Effects<D>& effects)
        : x(apart<Dyadic>(a.x, b.x, image, effects)),
          product(dot(x, dyadic(a.v) - dyadic(b.v))),
          square(dot(x, x)) {}

    PerAxis<Dyadic, D> x;
    Dyadic product;
    Dyadic square;
};

constexpr double untold = std::numeric_limits<double>::quiet_NaN();

/// The velocities after a strike, or `untold` components.
template <int D>
struct After {
    Vector<D> of_a;
    Vector<D> of_b;
    /// Whether they surely do not approach, or all is told.
    bool recedes = false;
    bool certain = false;
    /// |V·D| and D·D, and whether they are told well.
    double approach = 0.0;
    double square = 0.0;
    bool measured = false;
};

/// The law in double-doubles.
template <int D>
[[gnu::always_inline]] inline After<D> refined_strike(const Ball<D>& a, const Ball<D>& b,
                                                      const Image<D>& image, double mass_a,
                                                      double mass_b, const Law& law,
                                                      const Effects<D>& effects) noexcept {
    const RefinedSeparation<D> d(a, b, image, law, effects);
    After<D> after;
    after.approach = -d.product.high;
    after.square = d.square.high;
    after.of_a.fill(untold);
    after.of_b.fill(untold);
    const double relative = d.relative_error();
    after.recedes = d.product.high > d.product_error();
    if (!(relative < 0x1p-60 && after.approach > 0x1p-800)) return after;
    after.measured = true;
    const DoubleDouble ratio = quotient(d.product, d.square);
    if (!(std::fabs(ratio.high) > 0x1p-800 && after.square > 0x1p-800)) return after;
    const Shares share = shares(mass_a, mass_b, law.restitution);
    // Elastic, and equal masses.
    const bool is_one = share.of_a.high == 1.0 && share.of_a.low == 0.0;
    const double shifted = std::fabs(ratio.high) * 0x1p-97 * d.shift;
    const FourDoubleDoubles step = filters::four_times(ratio) * d.x;
    const FourDoubleDoubles of_a = is_one ? step : filters::four_times(share.of_a) * step;
    const FourDoubleDoubles of_b = mass_a == mass_b ? of_a : filters::four_times(share.of_b) * step;
    const auto add = [&](const Vector<D>& v, const FourDoubleDoubles& change, Vector<D>& nearest)
        __attribute__((always_inline)) {
        Four before;
        Four speed;
        Four changed;
        load(before, v);
        magnitude(speed, before);
        magnitude(changed, change.high);
        const auto sum = two_sum(before, change.high);
        const Four error =
            (0x1p-94 + relative) * changed + (shifted + underflow) + 0x1p-100 * speed;
        const Four low = sum.low + change.low;
        const Four after = sum.high + (low - error) + 0.0;
        const Flags tells = after == sum.high + (low + error);
        bool all = true;
        for (int k = 0; k < D; ++k) {
            nearest[k] = tells[k] != 0 ? after[k] : untold;
            all = all && tells[k] != 0;
        }
        return all;
    };
    const bool tells_a = add(a.v, {-of_a.high, -of_a.low}, after.of_a);
    const bool tells_b = add(b.v, of_b, after.of_b);
    after.certain = tells_a && tells_b;
    return after;
}

/// The law times both denominators, in dyadic numbers; so a velocity that becomes 0, which
/// double-doubles cannot tell from a small one, is found without a fraction. Fills in what is
/// untold; false where the two do not approach.
template <int D>
[[gnu::cold, gnu::noinline]] bool strike_exactly(After<D>& after, const Ball<D>& a,
                                                 const Ball<D>& b, const Image<D>& image,
                                                 double mass_a, double mass_b, const Law& law,
                                                 const Effects<D>& effects) {
    const ExactSeparation<D> d(a, b, image, effects);
    const Dyadic growth(law.growth);
    if (!after.measured) {
        after.square = rounded(to_rational(d.square));
        after.approach =
            std::fabs(rounded(to_rational(d.product)) - law.growth * std::sqrt(after.square));
    }
    // V·D >= ρ √(D·D), both sides not below 0.
    if (d.product.sign() >= 0 && (d.product * d.product - growth * growth * d.square).sign() >= 0)
        return false;
    const Dyadic denominator = d.square * (Dyadic(mass_a) + Dyadic(mass_b));
    const Dyadic bounce = Dyadic(1.0) + Dyadic(law.restitution);
    const auto fill = [&](double& velocity, double v, const Dyadic& share) {
        if (!std::isnan(velocity)) return;
        const Dyadic numerator = Dyadic(v) * denominator + share * d.product;
        if (growth.sign() != 0) {
            velocity =
                exact::round_surd(Rational(to_rational(numerator) / to_rational(denominator)),
                                  Rational(-to_rational(share * growth) / to_rational(denominator)),
                                  to_rational(d.square)) +
                0.0;
            return;
        }
        velocity = numerator.sign() == 0
                       ? 0.0
                       : rounded(Rational(to_rational(numerator) / to_rational(denominator)));
    };
    for (int i = 0; i < D; ++i) {
        fill(after.of_a[i], a.v[i], -(bounce * d.x[i] * Dyadic(mass_b)));
        fill(after.of_b[i], b.v[i], bounce * d.x[i] * Dyadic(mass_a));
    }
    return true;
}

/// x + v s in one operation, which rounds once; 0 without its sign.
template <int D>
[[gnu::always_inline]] inline double glided(const Ball<D>& ball, int axis, double s) noexcept {
    return __builtin_fma(ball.v[axis], s, ball.x[axis]) + 0.0;
}
/// Whether a place needs no bringing back into a periodic box.
template <int D>
[[gnu::always_inline]] inline bool is_at_home(double x, int axis,
                                              const Effects<D>& effects) noexcept {
    return !effects.periodic || (x > effects.box->low[axis] && x < effects.box->high[axis]);
}

/// Brings the ball to time t in one operation a coordinate; false where that is not all there is
/// to it.
template <int D>
[[gnu::always_inline]] inline bool glides(Ball<D>& ball, double t,
                                          const Effects<D>& effects) noexcept {
    const DoubleDouble s = exact_difference(t, ball.time);
    if (s.low != 0.0 || effects.gravity != Vector<D>{}) return false;
    ball.time = t;
    bool at_home = true;
    for (int i = 0; i < D; ++i) {
        ball.x[i] = glided(ball, i, s.high);
        at_home &= is_at_home(ball.x[i], i, effects);
    }
    return at_home;
}

/// The ball at time t, `untold` what double-doubles do not tell.
template <int D>
[[gnu::always_inline]] inline Ball<D> refined_arrival(const Ball<D>& ball, double t,
                                                      const Effects<D>& effects) noexcept {
    Ball<D> result = ball;
    result.time = t;
    const DoubleDouble s = exact_difference(t, ball.time);
    for (int i = 0; i < D; ++i) {
        const double gravity = effects.gravity[i];
        if (s.low == 0.0 && gravity == 0.0) {
            result.x[i] = glided(ball, i, s.high);
            if (is_at_home(result.x[i], i, effects)) continue;
        }
        const DoubleDouble flown = ball.v[i] * s;
        DoubleDouble x = DoubleDouble{ball.x[i], 0.0} + flown;
        double size = std::fabs(ball.x[i]) + std::fabs(flown.high);
        if (gravity != 0.0) {
            const DoubleDouble faster = gravity * s;
            const DoubleDouble fallen = 0.5 * (faster * s);
            x = x + fallen;
            size += std::fabs(fallen.high);
            if (!rounds(DoubleDouble{ball.v[i], 0.0} + faster,
                        0x1p-98 * (std::fabs(ball.v[i]) + std::fabs(faster.high)) + underflow,
                        result.v[i]))
                result.v[i] = untold;
        }
        bool certain = true;
        if (effects.periodic) {
            const double low = effects.box->low[i];
            const double high = effects.box->high[i];
            const double turns =
                x.high >= low && x.high < high ? 0.0 : std::floor((x.high - low) / (high - low));
            if (turns != 0.0) {
                const DoubleDouble shift = turns * length<DoubleDouble>(effects, i);
                x = x - shift;
                size += std::fabs(shift.high);
            }
            // Clearly inside, so that the number of turns is the right one.
            const double margin = 0x1p-40 * (size + std::fabs(low) + std::fabs(high));
            certain = x.high > low + margin && x.high < high - margin;
        }
        if (!rounds(x, 0x1p-97 * size + underflow, result.x[i]) || !certain) result.x[i] = untold;
    }
    return result;
}

}  // namespace

template <int D>
Ball<D> arrived(const Ball<D>& ball, double t, const Effects<D>& effects, StrikeTally& tally) {
    Ball<D> result = ball;
    bool told = false;
    as_wide_as_possible([&]() __attribute__((always_inline)) {
        told = glides(result, t, effects);
        if (!told) result = refined_arrival(ball, t, effects);
    });
    if (told) [[likely]] {
        tally.refined += D;
        return result;
    }
    for (int i = 0; i < D; ++i) {
        if (std::isnan(result.x[i])) [[unlikely]] {
            ++tally.exact;
            result.x[i] = exact_arrival(ball, i, t, effects);
        } else {
            ++tally.refined;
        }
        if (std::isnan(result.v[i])) [[unlikely]] {
            ++tally.exact;
            result.v[i] =
                rounded(to_rational(ball.v[i]) + to_rational(effects.gravity[i]) *
                                                     (to_rational(t) - to_rational(ball.time)));
        }
    }
    return result;
}

template <int D>
Exchange strike(Ball<D>& a, Ball<D>& b, const Image<D>& image, double mass_a, double mass_b,
                const Law& law, const Effects<D>& effects, StrikeTally& tally) {
    After<D> after = as_wide_as_possible([&]() __attribute__((always_inline)) {
        return refined_strike(a, b, image, mass_a, mass_b, law, effects);
    });
    const Exchange nothing{false, 0.0, after.square, 0.0};
    if (after.recedes) return nothing;
    if (after.certain) [[likely]] {
        ++tally.refined;
    } else {
        ++tally.exact;
        if (!strike_exactly(after, a, b, image, mass_a, mass_b, law, effects)) return nothing;
    }
    const bool changed_a = change(a, after.of_a);
    const bool changed_b = change(b, after.of_b);
    const double mass = mass_a * (mass_b / (mass_a + mass_b)) * (1.0 + law.restitution);
    return {changed_a || changed_b, after.approach, after.square, mass * after.approach};
}

template <int D>
double impulse(const Ball<D>& a, const Ball<D>& b, const Image<D>& image, double mass_a,
               double mass_b, const Law& law, const Effects<D>& effects, StrikeTally& tally) {
    const RefinedSeparation<D> d(a, b, image, law, effects);
    const double relative = d.relative_error();
    if (relative < 0x1p-60 && std::fabs(d.product.high) > 0x1p-800 && d.square.high > 0x1p-800) {
        const Shares share = shares(mass_a, mass_b, law.restitution);
        const DoubleDouble momentum =
            mass_a * (share.of_a * quotient(d.product, root_of(d.square)));
        double nearest = 0.0;
        if (rounds(momentum, (0x1p-92 + relative) * std::fabs(momentum.high) + underflow, nearest))
            return std::fabs(nearest);
    }
    ++tally.exact;
    const ExactSeparation<D> exact_d(a, b, image, effects);
    const Rational exact_square = to_rational(exact_d.square);
    const Rational mass = bounce(law.restitution) * to_rational(mass_a) * to_rational(mass_b) /
                          (to_rational(mass_a) + to_rational(mass_b));
    const Rational factor = mass * to_rational(-exact_d.product) / exact_square;
    const Rational of_growth = mass * to_rational(law.growth);
    if (factor.is_zero() && of_growth.is_zero()) return 0.0;
    return std::fabs(exact::round_surd(of_growth, factor, exact_square));
}

template <int D>
InPlace stayed_in_place(const Ball<D>& ball, double since, double approach,
                        double square) noexcept {
    const double size = 0x1p-40 * size_of(ball);
    const double flown = approach * since;
    const double left = flown * flown;
    const double right = size * size * square;
    if (left > right * (1.0 + 0x1p-30) && left > 0x1p-900) [[likely]]
        return InPlace::no;
    if (since == 0.0 || (left < right * (1.0 - 0x1p-30) && right > 0x1p-900)) return InPlace::yes;
    return InPlace::uncertain;
}
template <int D>
bool stayed_in_place_exactly(const Ball<D>& a, const Ball<D>& b, const Image<D>& image,
                             const Effects<D>& effects, double before) {
    const ExactSeparation<D> d(a, b, image, effects);
    return in_place(a, before, to_rational(d.product), to_rational(d.square));
}

template <int D>
bool strike(Ball<D>& ball, Wall wall, const Law& law) {
    double& v = ball.v[wall / 2];
    const double inwards = wall % 2 != 0 ? -v : v;
    if (inwards >= 0.0) return false;
    const double after = 0.0 - law.restitution * v;
    if (after == v) return false;
    v = after;
    return true;
}

template <int D>
double impulse(const Ball<D>& ball, Wall wall, double mass, const Law& law) {
    const double v = std::fabs(ball.v[wall / 2]);
    return rounded(bounce(law.restitution) * to_rational(mass) * to_rational(v));
}

#define SIGNUM_STRIKES_OF(D)                                                                  \
    template Ball<D> arrived(const Ball<D>&, double, const Effects<D>&, StrikeTally&);        \
    template Exchange strike(Ball<D>&, Ball<D>&, const Image<D>&, double, double, const Law&, \
                             const Effects<D>&, StrikeTally&);                                \
    template double impulse(const Ball<D>&, const Ball<D>&, const Image<D>&, double, double,  \
                            const Law&, const Effects<D>&, StrikeTally&);                     \
    template InPlace stayed_in_place(const Ball<D>&, double, double, double) noexcept;        \
    template bool stayed_in_place_exactly(const Ball<D>&, const Ball<D>&, const Image<D>&,    \
                                          const Effects<D>&, double);                         \
    template bool strike(Ball<D>&, Wall, const Law&);                                         \
    template double impulse(const Ball<D>&, Wall, double, const Law&);
SIGNUM_STRIKES_OF(2)
SIGNUM_STRIKES_OF(3)
#undef SIGNUM_STRIKES_OF

}  // namespace signum::motion
