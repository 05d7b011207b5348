#include "touching_spheres.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "../../exact/floating_environment.hpp"
#include "../../exact/surd.hpp"
#include "../../filters/bounded.hpp"
#include "../../predicates/formulas/balls.hpp"
#include "exact_vector.hpp"

namespace signum {
namespace {

using balls::along;
using balls::inner;
using balls::sign_of_surd;
using exact::Rational;
using filters::Bounded;

/// Whatever the dimension d, a ball is d+1 numbers, the radius last.
template <std::size_t d, class Number>
using Ball = euclidean::balls::Ball<d, Number>;
template <std::size_t d>
using Balls = std::array<Ball<d, double>, d + 1>;

template <std::size_t d>
using Found = TouchingSphere<Ball<d, double>>;
template <std::size_t d>
using Result = TouchingSpheres<Ball<d, double>>;
template <class S>
void add(TouchingSpheres<S>& result, const TouchingSphere<S>& found) {
    const bool is_first = result.count == SphereCount::none;
    result.spheres[is_first ? 0 : 1] = found;
    result.count = is_first ? SphereCount::one : SphereCount::two;
}

// ---- in double-doubles -------------------------------------------------------------------------

/// The number k of a sphere relative to the first ball, whose row would be p = 0 and a 1 at k: the
/// s of formulas/balls.hpp is then minus twice the number, (A ∓ L √Γ) / 2Q or, without
/// cancellation, G / 2(A ± L √Γ).
template <std::size_t d>
class Root {
 public:
    Root(const euclidean::balls::Tuple<d, Bounded>& t, const Bounded& q, const Bounded& sqrt_gamma,
         std::size_t k)
        : q_(q) {
        euclidean::balls::Row<d, Bounded> unit;
        for (std::size_t other = 0; other < d + 2; ++other)
            unit[other] = Bounded::exactly(other == k ? 1.0 : 0.0);
        const euclidean::balls::WithQuery<d, Bounded> with_unit(t.e, unit);
        a_ = -euclidean::balls::minus_a<Bounded, d, Bounded>(t, with_unit);
        surd_ = euclidean::balls::l<d, Bounded>(with_unit) * sqrt_gamma;
        g_ = euclidean::balls::inner<d, Bounded, euclidean::balls::last<d>,
                                     euclidean::balls::last<d>>(with_unit, with_unit);
    }

    /// Of the sphere of this orientation.
    [[nodiscard]] Bounded value(Sign orientation) const {
        const Bounded surd = orientation > 0 ? surd_ : -surd_;
        if ((a_.value.high > 0.0) != (surd.value.high > 0.0)) return (a_ - surd) / (q_ + q_);
        const Bounded sum = a_ + surd;
        return g_ / (sum + sum);
    }

 private:
    Bounded a_, surd_, g_, q_;
};

/// Certainly positive: +1, certainly negative: -1; else 0.
[[nodiscard]] Sign certain_sign(const Bounded& number) {
    return static_cast<int>(number.is_positive()) - static_cast<int>((-number).is_positive());
}

/// Nothing where it cannot tell how many there are, or to which of two doubles a number is nearer.
template <std::size_t d>
[[nodiscard]] std::optional<Result<d>> fast_spheres(const Balls<d>& balls) {
    using euclidean::balls::row;
    using euclidean::balls::Row;
    // Exact, but where a difference overflows; then nothing is certain.
    const auto difference = [&](std::size_t m, std::size_t from) {
        Row<d, Bounded> result;
        for (std::size_t k = 0; k <= d; ++k)
            result[k] = Bounded::exactly(filters::exact_difference(balls[m][k], balls[from][k]));
        result[d + 1] = euclidean::balls::power_of<d, Bounded>(result);
        return result;
    };
    std::array<Row<d, Bounded>, d> to;
    for (std::size_t m = 0; m < d; ++m) to[m] = difference(m + 1, 0);
    std::array<Row<d, Bounded>, d*(d - 1) / 2> between;
    std::size_t pairs = 0;
    for (std::size_t m = 1; m < d; ++m)
        for (std::size_t other = m + 1; other <= d; ++other)
            between[pairs++] = difference(other, m);
    const auto least_sign = [](const auto& rows) {
        Sign least = 1;
        for (const auto& each : rows) {
            const Sign sign = certain_sign(each[d + 1]);
            if (sign < 0) return -1;
            if (sign == 0) least = 0;
        }
        return least;
    };
    const Sign apart = std::min(least_sign(to), least_sign(between));
    if (apart < 0) return Result<d>();  // one ball inside another
    if (apart == 0) return std::nullopt;
    const Bounded four_gamma = euclidean::balls::four_gamma<d, Bounded>(to, between);
    const Sign of_gamma = certain_sign(four_gamma);
    if (of_gamma < 0) return Result<d>();
    if (of_gamma == 0) return std::nullopt;

    const Bounded sqrt_gamma = Bounded::exactly(0.5) * sqrt(four_gamma);
    const euclidean::balls::Tuple<d, Bounded> t(to);
    const Bounded q = t.q();
    if (certain_sign(q) == 0) return std::nullopt;
    const Root<d> distance(t, q, sqrt_gamma, d);
    Result<d> result;
    for (const Sign orientation : {1, -1}) {
        const Bounded value = distance.value(orientation);
        // Of all balls the distances have one sign.
        const Sign sign = certain_sign(value);
        if (sign == 0) return std::nullopt;
        if (sign < 0) continue;
        Found<d> found{{}, orientation};
        for (std::size_t k = 0; k <= d; ++k) {
            const Bounded start = Bounded::exactly(balls[0][k]);
            const auto rounded =
                (k == d ? value - start : Root<d>(t, q, sqrt_gamma, k).value(orientation) + start)
                    .rounded();
            if (!rounded) return std::nullopt;
            found.sphere[k] = *rounded;
        }
        add(result, found);
    }
    return result;
}

// ---- in rationals ------------------------------------------------------------------------------

/// a + b √g, g >= 0.
[[nodiscard]] double rounded_surd(const Rational& a, const Rational& b, const Rational& g) {
    const double value = g.is_zero() ? exact::round_to_double(a) : exact::round_surd(a, b, g);
    if (!std::isnan(value)) return value;
    return sign_of_surd(a, b, g) * std::numeric_limits<double>::infinity();
}

template <std::size_t d>
class Tangency {
    using Vector = balls::Vector<d + 1>;
    using System = balls::System<d + 1>;

 public:
    explicit Tangency(const Balls<d>& balls) {
        for (std::size_t k = 0; k <= d; ++k) first_[k] = exact::to_rational(balls[0][k]);
        for (std::size_t m = 0; m < d; ++m)
            for (std::size_t k = 0; k <= d; ++k)
                others_[m][k] = exact::to_rational(balls[m + 1][k]) - first_[k];
    }

    [[nodiscard]] Result<d> spheres() const {
        std::vector<Rational> values;
        for (const Vector& other : others_) values.push_back(inner(other, other) / 2);
        const System system({others_.begin(), others_.end()}, std::move(values));
        if (!system.is_solvable()) return {};
        if (system.rank() == d) return on_line(system);
        return on_flat(system);
    }

 private:
    [[nodiscard]] static Result<d> infinitely_many() { return {SphereCount::infinitely_many, {}}; }

    /// Where <v, v> = <v, n> = <n, n> = 0 all solutions v + t n would be multiples of n, and
    /// orthogonal to all others; so these would be multiples of n, too, and the rank 1.
    [[nodiscard]] Result<d> on_line(const System& system) const {
        const Vector n = system.directions().front();
        // <v, n> of a solution tells its side: it is the determinant of the rows (c_i - c, rho +
        // r_i), but for a factor that is that of the rows n, (X, R).
        std::array<Vector, d + 1> rows = {n};
        std::ranges::copy(others_, rows.begin() + 1);
        const Sign of_rows = balls::determinant(rows).sign();
        const Sign turn = d % 2 == 0 ? -of_rows : of_rows;
        Result<d> result;
        balls::for_points_on_cone(
            system.solution(), n, turn,
            [&](const Vector& start, const Vector& step, const Rational& g, Sign side) {
                add_if_it_touches(result, start, step, g, turn * side);
            });
        return result;
    }

    /// The sphere start + step √g.
    void add_if_it_touches(Result<d>& result, const Vector& start, const Vector& step,
                           const Rational& g, Sign orientation) const {
        if (sign_of_surd(start[d], step[d], g) < 0) return;
        for (const Vector& other : others_)
            if (sign_of_surd(start[d] + other[d], step[d], g) < 0) return;
        Found<d> found{{}, orientation};
        for (std::size_t k = 0; k <= d; ++k)
            found.sphere[k] =
                rounded_surd(k == d ? start[k] - first_[k] : start[k] + first_[k], step[k], g);
        add(result, found);
    }

    /// The solutions are a flat of two dimensions or more, orthogonal in <,> to the span W of the
    /// balls, of at most two. Of <,> on W the determinant of products tells the kind.
    [[nodiscard]] Result<d> on_flat(const System& system) const {
        const std::size_t rank = system.rank();
        if (rank == 0) return infinitely_many();
        // To a row (X, R) the vector of W is (X, -R): <,> with it is the scalar product with the
        // row.
        std::array<Vector, 2> w;
        for (std::size_t m = 0; m < rank; ++m) {
            w[m] = system.row(m);
            w[m][d] = -w[m][d];
        }
        const Rational g00 = inner(w[0], w[0]);
        const Rational g01 = rank == 1 ? Rational(0) : inner(w[0], w[1]);
        const Rational g11 = rank == 1 ? Rational(1) : inner(w[1], w[1]);
        const Rational determinant = g00 * g11 - g01 * g01;
        // Where <,> > 0 on W: the flat has directions with <,> < 0, along which it goes from the
        // inside of the cone <v, v> = 0, h > 0, to the outside.
        if (determinant.sign() > 0) return infinitely_many();
        const Rational h0 = system.value(0);
        const Rational h1 = rank == 1 ? Rational(0) : system.value(1);
        const auto in_w = [&w](const Rational& first, const Rational& second) {
            return along(along<d + 1>({}, first, w[0]), second, w[1]);
        };
        if (determinant.sign() < 0)
            return on_level_flat(
                in_w((h0 * g11 - h1 * g01) / determinant, (h1 * g00 - h0 * g01) / determinant));

        // W touches the cone along n; all of W is orthogonal to it.
        Vector n = w[0];
        Rational value = h0;
        if (rank == 2) {
            const Rational first = g00.is_zero() ? g11 : Rational(-g01);
            const Rational second = g00.is_zero() ? Rational(0) : g00;
            n = in_w(first, second);
            value = first * h0 + second * h1;
        }
        // <n, v> = value is the same for all solutions, and for their differences to all balls. Of
        // two vectors of the cone with h > 0 it is negative, but 0 for multiples of one another;
        // and multiples of n touch where all balls are multiples of n.
        const Sign side = value.sign() * n[d].sign();
        return side < 0 || (side == 0 && rank == 1) ? infinitely_many() : Result<d>();
    }

    /// W has a direction with <w, w> < 0, so that all directions of the flat have <,> > 0: with v
    /// its point in W, and y orthogonal to W, <v + y, v + y> = <v, v> + <y, y>. All that it is 0
    /// for are on one side of a ball, that of v.
    [[nodiscard]] Result<d> on_level_flat(const Vector& v) const {
        const Sign square = inner(v, v).sign();
        if (square > 0) return {};
        if (square == 0) {
            Result<d> result;
            add_if_it_touches(result, v, {}, 0, 0);
            return result;
        }
        if (v[d].sign() < 0) return {};
        for (const Vector& other : others_)
            if (Rational(v[d] + other[d]).sign() < 0) return {};
        return infinitely_many();
    }

    Vector first_;
    std::array<Vector, d> others_;  // relative to the first
};

// ---- both --------------------------------------------------------------------------------------

template <std::size_t d>
[[nodiscard]] Result<d> spheres_of(const Balls<d>& balls) {
    if (const auto fast = fast_spheres<d>(balls)) return *fast;
    return Tangency<d>(balls).spheres();
}

template <std::size_t d, class S>
[[nodiscard]] TouchingSpheres<S> touching(std::span<const S> sites, const char* wrong_number) {
    if (sites.size() != d + 1) throw std::invalid_argument(wrong_number);
    Balls<d> balls;
    for (std::size_t m = 0; m <= d; ++m) {
        if (!are_finite(sites[m]))
            throw std::invalid_argument("touching_spheres: ball " + std::to_string(m) +
                                        " is not finite");
        balls[m] = std::bit_cast<Ball<d, double>>(sites[m]);  // the same numbers in this order
    }
    const Result<d> result = exact::in_ieee_environment(spheres_of<d>, balls);
    TouchingSpheres<S> touching{result.count, {}};
    for (std::size_t k = 0; k < 2; ++k)
        touching.spheres[k] = {std::bit_cast<S>(result.spheres[k].sphere),
                               result.spheres[k].orientation};
    return touching;
}

}  // namespace

TouchingSpheres<Site3> touching_spheres(std::span<const Site3> four) {
    return touching<3>(four, "touching_spheres: four balls");
}
TouchingSpheres<Site> touching_spheres(std::span<const Site> three) {
    return touching<2>(three, "touching_spheres: three discs");
}

}  // namespace signum
