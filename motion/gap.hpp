#pragma once
/// How far the surfaces of two balls in flight are apart, and which of two pairs is closer. For
/// sources only.
///
/// The gap is √q - R, q the square of the distance of the centres and R the sum of the radii. While
/// nothing strikes, q is a polynomial of degree 2 in time: all fall alike, so that the difference
/// of two centres is linear.
///
/// The order of two gaps. With c = R_p - R_q >= 0 (else the two change places),
///     (√p - R_p) - (√q - R_q) = √p - (√q + c),    of the sign of p - (√q + c)² = m - 2c √q,
///     m = p - q - c²,
/// so it is that of p - q where c = 0, negative where m < 0, that of E = m² - 4 c² q where m > 0,
/// and that of -q where m = 0. All of these are polynomials, E of degree 4. The gaps are equal at
/// roots of E alone, so that between two roots their order stays. Where E is 0 everywhere and c is
/// not, q = l² and p = q + 2cl + c² = (l + c)² with l = m / 2c, which is linear: the gaps are equal
/// where l >= 0 and the first one is less where l < 0, so that their order changes at the root of q
/// alone.

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>

#include "../exact/surd.hpp"
#include "../filters/interval.hpp"
#include "../roots/polynomial.hpp"
#include "apart.hpp"

namespace signum::motion {

/// Two balls, the second one seen shifted by so many lengths of a periodic box.
template <int D>
struct Couple {
    const Ball<D>* a;
    const Ball<D>* b;
    Image<D> image;
};

template <class Number>
using Linear = roots::PolynomialIn<Number, 1>;
template <class Number>
using Quadratic = roots::PolynomialIn<Number, 2>;

/// x_a - x_b of the centres at from + u, in powers of u.
template <class Number, int D>
[[nodiscard]] PerAxis<Linear<Number>, D> difference_of_centres(const Couple<D>& couple,
                                                               const Effects<D>& effects,
                                                               double from) {
    const auto number = [](double x) { return Number(filters::pinned(x)); };
    const Ball<D>& a = *couple.a;
    const Ball<D>& b = *couple.b;
    const Number since_a = number(from) - number(a.time);
    const Number since_b = number(from) - number(b.time);
    const Number longer = number(b.time) - number(a.time);  // since_a - since_b, and 0 if it is 0
    PerAxis<Linear<Number>, D> d;
    for (int k = 0; k < D; ++k) {
        Number& place = d[k].c[0];
        Number& speed = d[k].c[1];
        speed = number(a.v[k]) - number(b.v[k]);
        place = number(a.x[k]) - number(b.x[k]) + (speed * since_a + number(b.v[k]) * longer);
        if (effects.gravity[k] != 0.0) {
            const Number gained = number(effects.gravity[k]) * longer;
            speed = speed + gained;
            place = place + number(0.5) * gained * (since_a + since_b);
        }
        if (couple.image[k] != 0) place = place - couple.image[k] * length<Number>(effects, k);
    }
    return d;
}

/// The square of the distance of the centres at from + u, in powers of u.
template <class Number, int D>
[[nodiscard]] Quadratic<Number> square_of_distance(const Couple<D>& couple,
                                                   const Effects<D>& effects, double from) {
    const PerAxis<Linear<Number>, D> d = difference_of_centres<Number>(couple, effects, from);
    return dot(d, d);
}

/// The sum of the radii of the first pair less that of the second.
template <class Number, int D>
[[nodiscard]] Number excess_of_radii(const Couple<D>& p, const Couple<D>& q) {
    const auto radii = [](const Couple<D>& couple) {
        return Number(filters::pinned(couple.a->radius)) +
               Number(filters::pinned(couple.b->radius));
    };
    return radii(p) - radii(q);
}

/// A gap at one time, exactly.
struct Gap {
    exact::Dyadic square;
    exact::Dyadic radii;

    template <int D>
    Gap(const Couple<D>& couple, const Effects<D>& effects, double time)
        : square(square_of_distance<exact::Dyadic>(couple, effects, time).c[0]),
          radii(exact::Dyadic(couple.a->radius) + exact::Dyadic(couple.b->radius)) {}

    /// The sign of the one less the other.
    friend Sign compare(const Gap& p, const Gap& q) {
        const exact::Dyadic c = p.radii - q.radii;
        if (c.sign() < 0) return -compare(q, p);
        const exact::Dyadic m = p.square - q.square - c * c;
        if (c.sign() == 0 || m.sign() < 0) return m.sign();
        return (m * m - 4 * (c * c * q.square)).sign();
    }
    /// Halves to even; infinity beyond the doubles.
    [[nodiscard]] double nearest_double() const {
        const exact::Rational less = -exact::to_rational(radii);
        const double gap = square.sign() == 0
                               ? exact::round_to_double(less)
                               : exact::round_surd(less, 1, exact::to_rational(square));
        return std::isnan(gap) ? std::numeric_limits<double>::infinity() : gap;
    }
};

/// One of the polynomials by which two gaps are compared, in u, the time since `from`.
template <int D>
struct GapForm {
    enum class Kind { second, difference, excess, crossing };
    Couple<D> p;
    Couple<D> q;
    const Effects<D>* effects;
    double from;
    Kind kind;

    template <class Number>
    [[nodiscard]] roots::PolynomialIn<Number, 4> in() const {
        roots::PolynomialIn<Number, 4> result;
        const auto of = [&](const Couple<D>& couple) {
            return square_of_distance<Number>(couple, *effects, from);
        };
        const Quadratic<Number> square = of(q);
        if (kind == Kind::second) {
            std::ranges::copy(square.c, result.c.begin());
            return result;
        }
        Quadratic<Number> m = of(p) - square;
        const Number c = excess_of_radii<Number>(p, q);
        if (kind != Kind::difference) m.c[0] = m.c[0] - c * c;
        if (kind == Kind::crossing)
            return m * m - roots::PolynomialIn<Number, 0>{{4 * (c * c)}} * square;
        std::ranges::copy(m.c, result.c.begin());
        return result;
    }
};

/// A form and its polynomial, which stay where they are.
template <class Form>
struct Curve {
    Form form;
    roots::Polynomial polynomial;
    explicit Curve(const Form& of) : form(of), polynomial(form) {}
    Curve(const Curve&) = delete;
    Curve& operator=(const Curve&) = delete;
};

/// A time since `from`: the index-th root of a curve, or 0.
template <int D>
struct Moment {
    std::shared_ptr<const Curve<GapForm<D>>> curve;
    roots::Root root{};
    int index = 0;

    [[nodiscard]] Sign sign_after(const roots::Polynomial& p) const {
        return curve ? p.sign_after({curve->polynomial, root}) : p.sign_after(0.0);
    }
    friend Sign compare(const Moment& a, const Moment& b) {
        if (!a.curve) return b.curve ? -compare(b, a) : 0;
        const roots::RootOf of_a{a.curve->polynomial, a.root};
        return b.curve ? compare(of_a, roots::RootOf{b.curve->polynomial, b.root})
                       : compare(of_a, 0.0);
    }
    /// The double nearest to the time itself. Its polynomial, in the powers of that, has the same
    /// roots in the same order.
    [[nodiscard]] double nearest_time(double from) const {
        if (!curve) return from;
        GapForm<D> form = curve->form;
        form.from = 0.0;
        const roots::Polynomial polynomial(form);
        return polynomial.nearest_double(polynomial.real_roots()[index]);
    }
};

/// The order of the gaps of two pairs as time goes on.
template <int D>
class GapOrder {
 public:
    GapOrder(const Couple<D>& p, const Couple<D>& q, const Effects<D>& effects, double from)
        : swapped_(excess_of_radii<exact::Dyadic>(p, q).sign() < 0),
          form_{swapped_ ? q : p, swapped_ ? p : q, &effects, from, Kind::difference},
          radii_are_equal_(excess_of_radii<exact::Dyadic>(p, q).sign() == 0) {}

    /// The sign of the first gap less the second one right after a moment; 0 only where they are
    /// equal for some time.
    [[nodiscard]] Sign after(const Moment<D>& moment) {
        const Sign sign = ordered_after(moment);
        return swapped_ ? -sign : sign;
    }
    /// The first moment after one, and before an end, right after which the first gap is less; with
    /// `no_greater` less or equal. Precondition: right after the moment itself it is not.
    template <class IsBeforeEnd>
    [[nodiscard]] std::optional<Moment<D>> first_less(const Moment<D>& moment, bool no_greater,
                                                      const IsBeforeEnd& is_before_end) {
        const auto& curve = where_they_may_change_places();
        const roots::RealRoots roots = curve->polynomial.real_roots();
        for (int i = 0; i < roots.size(); ++i) {
            const Moment<D> next{curve, curve->polynomial.narrowed(roots[i]), i};
            if (compare(next, moment) <= 0) continue;
            if (!is_before_end(next)) break;
            const Sign sign = after(next);
            if (sign < 0 || (no_greater && sign == 0)) return next;
        }
        return {};
    }

 private:
    using Kind = typename GapForm<D>::Kind;

    [[nodiscard]] Sign ordered_after(const Moment<D>& moment) {
        const auto sign = [&](Kind kind) { return moment.sign_after(curve(kind)->polynomial); };
        if (radii_are_equal_) return sign(Kind::difference);
        const Sign excess = sign(Kind::excess);
        if (excess < 0) return excess;
        return excess > 0 ? sign(Kind::crossing) : -sign(Kind::second);
    }
    /// The order changes at roots of this one alone.
    [[nodiscard]] const std::shared_ptr<const Curve<GapForm<D>>>& where_they_may_change_places() {
        if (radii_are_equal_) return curve(Kind::difference);
        const auto& crossing = curve(Kind::crossing);
        return crossing->polynomial.is_zero() ? curve(Kind::second) : crossing;
    }
    [[nodiscard]] const std::shared_ptr<const Curve<GapForm<D>>>& curve(Kind kind) {
        auto& known = curves_[static_cast<std::size_t>(kind)];
        if (!known) {
            GapForm<D> form = form_;
            form.kind = kind;
            known = std::make_shared<const Curve<GapForm<D>>>(form);
        }
        return known;
    }

    bool swapped_;
    GapForm<D> form_;
    bool radii_are_equal_;
    std::array<std::shared_ptr<const Curve<GapForm<D>>>, 4> curves_;
};

}  // namespace signum::motion
