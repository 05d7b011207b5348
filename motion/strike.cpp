#include "strike.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "../core/error_free.hpp"
#include "../exact/dyadic.hpp"
#include "../exact/multiprecision.hpp"
#include "../exact/surd.hpp"
#include "../filters/double_double.hpp"
#include "meeting.hpp"

namespace signum::motion {
namespace {

using exact::Dyadic;
using exact::Integer;
using exact::Rational;
using exact::to_rational;
using filters::DoubleDouble;
using filters::exact_difference;
using filters::exact_sum;

DoubleDouble operator*(double a, DoubleDouble b) noexcept {
    return DoubleDouble{a, 0.0} * b;
}

/// A quotient, off by at most 2^-98 of itself.
DoubleDouble quotient(DoubleDouble a, DoubleDouble b) noexcept {
    const double first = a.high / b.high;
    const double second = (a - first * b).high / b.high;
    const TwoTerms sum = two_sum(first, second);
    return {sum.high, sum.low};
}

/// Whether all numbers that differ from the double-double by at most the error round to one double,
/// which is stored; a zero is +0.
bool rounds(DoubleDouble number, double error, double& nearest) noexcept {
    nearest = number.high + (number.low - error) + 0.0;
    return nearest == number.high + (number.low + error);
}

double rounded(const Rational& number) {
    return exact::round_to_double(number) + 0.0;
}

/// The length of a box along an axis, exactly.
template <int D>
DoubleDouble length(const Effects<D>& effects, int axis) noexcept {
    return exact_difference(effects.box->high[axis], effects.box->low[axis]);
}
template <int D>
Rational rational_length(const Effects<D>& effects, int axis) {
    return to_rational(effects.box->high[axis]) - to_rational(effects.box->low[axis]);
}

/// x + v s + g s²/2, rounded once, or as many lengths of the box less.
template <int D>
double exact_arrival(const Ball<D>& ball, int axis, double t, const Effects<D>& effects) {
    const Rational s = to_rational(t) - to_rational(ball.time);
    Rational x = to_rational(ball.x[axis]) + to_rational(ball.v[axis]) * s +
                 to_rational(effects.gravity[axis]) * s * s / 2;
    if (effects.periodic) {
        const Rational box = rational_length(effects, axis);
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
Shares shares(double mass_a, double mass_b, double restitution) noexcept {
    const DoubleDouble bounce = exact_sum(1.0, restitution);
    if (mass_a == mass_b) {
        const DoubleDouble half{0.5 * bounce.high, 0.5 * bounce.low};
        return {half, half};
    }
    const DoubleDouble sum = exact_sum(mass_a, mass_b);
    return {bounce * quotient({mass_b, 0.0}, sum), bounce * quotient({mass_a, 0.0}, sum)};
}

/// D and V of two balls at one time.
template <int D>
struct Apart {
    PerAxis<DoubleDouble, D> x;
    PerAxis<DoubleDouble, D> v;
};
template <int D>
Apart<D> apart(const Ball<D>& a, const Ball<D>& b, const Image<D>& image,
               const Effects<D>& effects) noexcept {
    Apart<D> result;
    for (int i = 0; i < D; ++i) {
        result.x[i] = exact_difference(a.x[i], b.x[i]);
        result.v[i] = exact_difference(a.v[i], b.v[i]);
        if (image[i] != 0) result.x[i] = result.x[i] - double(image[i]) * length(effects, i);
    }
    return result;
}

/// The rational law; the velocities after it.
template <int D>
struct RationalLaw {
    RationalLaw(const Ball<D>& a, const Ball<D>& b, const Image<D>& image,
                const Effects<D>& effects) {
        for (int i = 0; i < D; ++i) {
            x[i] = to_rational(a.x[i]) - to_rational(b.x[i]);
            if (image[i] != 0) x[i] -= image[i] * rational_length(effects, i);
            const Rational v = to_rational(a.v[i]) - to_rational(b.v[i]);
            product += x[i] * v;
            square += x[i] * x[i];
        }
    }
    PerAxis<Rational, D> x;
    Rational product;
    Rational square;
};

Rational bounce(double restitution) {
    return 1 + to_rational(restitution);
}

template <int D>
bool change(Ball<D>& ball, const Vector<D>& v) noexcept {
    bool changed = false;
    for (int i = 0; i < D; ++i) changed |= v[i] != ball.v[i];
    ball.v = v;
    return changed;
}

Rational rational(const Dyadic& number) {
    const Rational significand = number.significand();
    const Rational power = exact::Integer(1) << std::abs(number.exponent());
    return number.exponent() < 0 ? Rational(significand / power) : Rational(significand * power);
}

/// The velocities after a strike, components that double-doubles could not tell marked by NaN.
template <int D>
struct After {
    Vector<D> of_a;
    Vector<D> of_b;
};

/// The law times both denominators, in dyadic numbers; so a velocity that becomes 0, which
/// double-doubles cannot tell from a small one, is found without a fraction. Fills in what is
/// marked.
template <int D>
class ExactLaw {
 public:
    ExactLaw(const Ball<D>& a, const Ball<D>& b, const Image<D>& image, const Effects<D>& effects) {
        for (int i = 0; i < D; ++i) {
            x_[i] = Dyadic(a.x[i]) - Dyadic(b.x[i]);
            if (image[i] != 0)
                x_[i] =
                    x_[i] - image[i] * (Dyadic(effects.box->high[i]) - Dyadic(effects.box->low[i]));
            product_ += x_[i] * (Dyadic(a.v[i]) - Dyadic(b.v[i]));
            square_ += x_[i] * x_[i];
        }
    }
    [[nodiscard]] bool approaches() const noexcept { return product_.sign() < 0; }
    [[nodiscard]] double product() const { return std::fabs(rounded(rational(product_))); }
    [[nodiscard]] double square() const { return rounded(rational(square_)); }

    void fill(After<D>& after, const Ball<D>& a, const Ball<D>& b, double mass_a, double mass_b,
              double restitution) const {
        const Dyadic denominator = square_ * (Dyadic(mass_a) + Dyadic(mass_b));
        const Dyadic step = (Dyadic(1.0) + Dyadic(restitution)) * product_;
        const auto fill_one = [&](double& marked, double v, const Dyadic& change) {
            if (!std::isnan(marked)) return;
            const Dyadic numerator = Dyadic(v) * denominator + change;
            marked = numerator.sign() == 0
                         ? 0.0
                         : rounded(Rational(rational(numerator) / rational(denominator)));
        };
        for (int i = 0; i < D; ++i) {
            fill_one(after.of_a[i], a.v[i], -(step * x_[i] * Dyadic(mass_b)));
            fill_one(after.of_b[i], b.v[i], step * x_[i] * Dyadic(mass_a));
        }
    }

 private:
    PerAxis<Dyadic, D> x_;
    Dyadic product_;
    Dyadic square_;
};

}  // namespace

template <int D>
Ball<D> arrived(const Ball<D>& ball, double t, const Effects<D>& effects, StrikeTally& tally) {
    Ball<D> result = ball;
    result.time = t;
    const DoubleDouble s = exact_difference(t, ball.time);
    for (int i = 0; i < D; ++i) {
        if (s.low == 0.0 && effects.gravity[i] == 0.0) {
            // One operation that rounds once; 0 without its sign.
            const double x = __builtin_fma(ball.v[i], s.high, ball.x[i]) + 0.0;
            if (!effects.periodic || (x > effects.box->low[i] && x < effects.box->high[i])) {
                ++tally.refined;
                result.x[i] = x;
                continue;
            }
        }
        const DoubleDouble flown = ball.v[i] * s;
        DoubleDouble x = DoubleDouble{ball.x[i], 0.0} + flown;
        double size = std::fabs(ball.x[i]) + std::fabs(flown.high);
        if (const double gravity = effects.gravity[i]; gravity != 0.0) {
            const DoubleDouble faster = gravity * s;
            const DoubleDouble fallen = 0.5 * (faster * s);
            x = x + fallen;
            size += std::fabs(fallen.high);
            if (!rounds(DoubleDouble{ball.v[i], 0.0} + faster,
                        0x1p-98 * (std::fabs(ball.v[i]) + std::fabs(faster.high)), result.v[i])) {
                ++tally.exact;
                result.v[i] =
                    rounded(to_rational(ball.v[i]) +
                            to_rational(gravity) * (to_rational(t) - to_rational(ball.time)));
            }
        }
        bool certain = true;
        if (effects.periodic) {
            const double low = effects.box->low[i];
            const double high = effects.box->high[i];
            const double turns =
                x.high >= low && x.high < high ? 0.0 : std::floor((x.high - low) / (high - low));
            if (turns != 0.0) {
                const DoubleDouble shift = turns * length(effects, i);
                x = x - shift;
                size += std::fabs(shift.high);
            }
            // Clearly inside, so that the number of turns is the right one.
            const double margin = 0x1p-40 * (size + std::fabs(low) + std::fabs(high));
            certain = x.high > low + margin && x.high < high - margin;
        }
        if (!certain || !rounds(x, 0x1p-97 * size, result.x[i])) {
            ++tally.exact;
            result.x[i] = exact_arrival(ball, i, t, effects);
        } else {
            ++tally.refined;
        }
    }
    return result;
}

template <int D>
Exchange strike(Ball<D>& a, Ball<D>& b, const Image<D>& image, double mass_a, double mass_b,
                const Effects<D>& effects, StrikeTally& tally) {
    const Apart<D> d = apart(a, b, image, effects);
    DoubleDouble product{0.0, 0.0};
    DoubleDouble square{0.0, 0.0};
    double size = 0.0;
    for (int i = 0; i < D; ++i) {
        const DoubleDouble term = d.x[i] * d.v[i];
        product = product + term;
        size += std::fabs(term.high);
        square = square + d.x[i] * d.x[i];
    }
    const double product_error = 0x1p-98 * size;
    if (product.high > product_error) return {};
    const Shares share = shares(mass_a, mass_b, effects.restitution);
    After<D> after;
    bool certain = true;
    double approach = -product.high;
    double distance = square.high;
    if (const double relative = product_error / approach; relative < 0x1p-60 && approach > 0x1p-800)
        [[likely]] {
        const DoubleDouble ratio = quotient(product, square);
        // Elastic, and equal masses.
        const bool is_one = share.of_a.high == 1.0 && share.of_a.low == 0.0;
        const auto round_one = [&](double v, DoubleDouble step, double& nearest) {
            const double error =
                (0x1p-94 + relative) * std::fabs(step.high) + 0x1p-100 * std::fabs(v) + 0x1p-1060;
            if (rounds(DoubleDouble{v, 0.0} + step, error, nearest)) [[likely]]
                return;
            nearest = std::numeric_limits<double>::quiet_NaN();
            certain = false;
        };
        for (int i = 0; i < D; ++i) {
            const DoubleDouble step = ratio * d.x[i];
            const DoubleDouble of_a = is_one ? step : share.of_a * step;
            const DoubleDouble of_b = mass_a == mass_b ? of_a : share.of_b * step;
            round_one(a.v[i], DoubleDouble{-of_a.high, -of_a.low}, after.of_a[i]);
            round_one(b.v[i], of_b, after.of_b[i]);
        }
    } else {
        after.of_a.fill(std::numeric_limits<double>::quiet_NaN());
        after.of_b.fill(std::numeric_limits<double>::quiet_NaN());
        certain = false;
    }
    if (certain) [[likely]] {
        ++tally.refined;
    } else {
        ++tally.exact;
        const ExactLaw<D> law(a, b, image, effects);
        if (!law.approaches()) return {};
        law.fill(after, a, b, mass_a, mass_b, effects.restitution);
        approach = law.product();
        distance = law.square();
    }
    const bool changed_a = change(a, after.of_a);
    const bool changed_b = change(b, after.of_b);
    return {changed_a || changed_b, approach, distance, mass_a * share.of_a.high * approach};
}

template <int D>
double impulse(const Ball<D>& a, const Ball<D>& b, const Image<D>& image, double mass_a,
               double mass_b, const Effects<D>& effects, StrikeTally& tally) {
    const Apart<D> d = apart(a, b, image, effects);
    DoubleDouble product{0.0, 0.0};
    DoubleDouble square{0.0, 0.0};
    double size = 0.0;
    for (int i = 0; i < D; ++i) {
        const DoubleDouble term = d.x[i] * d.v[i];
        product = product + term;
        size += std::fabs(term.high);
        square = square + d.x[i] * d.x[i];
    }
    const double relative = 0x1p-98 * size / std::fabs(product.high);
    if (relative < 0x1p-60 && std::fabs(product.high) > 0x1p-800 && square.high > 0x1p-800) {
        const double first = std::sqrt(square.high);
        const TwoTerms root =
            two_sum(first, (square - first * DoubleDouble{first, 0.0}).high / (2.0 * first));
        const Shares share = shares(mass_a, mass_b, effects.restitution);
        const DoubleDouble momentum =
            mass_a * (share.of_a * quotient(product, {root.high, root.low}));
        double nearest = 0.0;
        if (rounds(momentum, (0x1p-92 + relative) * std::fabs(momentum.high), nearest))
            return std::fabs(nearest);
    }
    ++tally.exact;
    const RationalLaw<D> law(a, b, image, effects);
    const Rational factor = bounce(effects.restitution) * abs(law.product) * to_rational(mass_a) *
                            to_rational(mass_b) /
                            ((to_rational(mass_a) + to_rational(mass_b)) * law.square);
    if (factor.is_zero()) return 0.0;
    return exact::round_surd(Rational(0), factor, law.square);
}

namespace {

template <int D>
double size_of(const Ball<D>& ball) noexcept {
    double size = ball.radius;
    for (const double x : ball.x) size = std::max(size, std::fabs(x));
    return size;
}
template <int D>
bool in_place(const Ball<D>& ball, double before, const Rational& approach,
              const Rational& square) {
    const Rational flown = approach * (to_rational(ball.time) - to_rational(before));
    const Rational size = to_rational(size_of(ball)) / (Integer(1) << 40);
    return flown * flown <= size * size * square;
}

}  // namespace

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
    const RationalLaw<D> law(a, b, image, effects);
    return in_place(a, before, law.product, law.square);
}
template <int D>
bool stayed_in_place_exactly(const Ball<D>& ball, Wall wall, double before) {
    return in_place(ball, before, to_rational(ball.v[wall / 2]), Rational(1));
}

template <int D>
bool strike(Ball<D>& ball, Wall wall, const Effects<D>& effects) {
    double& v = ball.v[wall / 2];
    const double inwards = wall % 2 != 0 ? -v : v;
    if (inwards >= 0.0) return false;
    const double after = 0.0 - effects.wall_restitution * v;
    if (after == v) return false;
    v = after;
    return true;
}

template <int D>
double impulse(const Ball<D>& ball, Wall wall, double mass, const Effects<D>& effects) {
    const double v = std::fabs(ball.v[wall / 2]);
    return rounded(bounce(effects.wall_restitution) * to_rational(mass) * to_rational(v));
}

#define SIGNUM_STRIKES_OF(D)                                                                 \
    template Ball<D> arrived(const Ball<D>&, double, const Effects<D>&, StrikeTally&);       \
    template Exchange strike(Ball<D>&, Ball<D>&, const Image<D>&, double, double,            \
                             const Effects<D>&, StrikeTally&);                               \
    template double impulse(const Ball<D>&, const Ball<D>&, const Image<D>&, double, double, \
                            const Effects<D>&, StrikeTally&);                                \
    template InPlace stayed_in_place(const Ball<D>&, double, double, double) noexcept;       \
    template bool stayed_in_place_exactly(const Ball<D>&, const Ball<D>&, const Image<D>&,   \
                                          const Effects<D>&, double);                        \
    template bool stayed_in_place_exactly(const Ball<D>&, Wall, double);                     \
    template bool strike(Ball<D>&, Wall, const Effects<D>&);                                 \
    template double impulse(const Ball<D>&, Wall, double, const Effects<D>&);
SIGNUM_STRIKES_OF(2)
SIGNUM_STRIKES_OF(3)
#undef SIGNUM_STRIKES_OF

}  // namespace signum::motion
