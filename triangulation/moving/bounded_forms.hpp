#pragma once
/// The two determinants that nearly all questions are about, approximately: in plain doubles, with
/// bounds on the errors of all coefficients that take less work than their values. For sources
/// only.
///
/// What is relative to the last site carries its own error, as it may have cancelled. Let P(s) =
/// X + V s, where X is the largest of all |x| and |y| and V of their velocities, and W the largest
/// size of the weights. Let coordinates be known to h times a coefficient of P, weights to 4
/// epsilon W, and let the determinant's formula round k times (counted by machine). Then
///     |cross| <= 2 P²,    |height| <= 2 P² + W,
/// coefficient by coefficient, in the sense of the formula with all signs positive. So an error is
/// at most ((1 + epsilon)^(k + 4) (1 + h)^4 - 1) times the coefficient of
///     3 (2 P² + W) 2 P² = 12 P^4 + 6 W P²
/// (of the turn: of 2 P²), which is less than (4.1 h + 1.01 (k + 4) epsilon) times it as long as
/// h < 2^-10. Of the degree there is one for every site that moves, and one more for the heights:
/// what is beyond is 0.
///
/// Underflow: X and V are 0 or within 2^±200, W within 2^±400. A product of values loses 2^-1074
/// at most, while the product of their sizes, which is in the bound, is above 2^-800.

#include <algorithm>
#include <cstddef>
#include <optional>

#include "../../filters/bounds.hpp"
#include "../../filters/interval.hpp"
#include "../../filters/rounding_count.hpp"
#include "../../filters/verdict.hpp"
#include "../../roots/approximation.hpp"
#include "forms.hpp"

SIGNUM_IEEE_BEGIN

namespace signum::kinetic {

using roots::Approximation;

namespace bounded {

using filters::epsilon;
using filters::magnitude;

inline constexpr int roundings_of_determinant = [] {
    const Relative<filters::RoundingCount> any;
    int most = 0;
    for (const auto& c : determinant(any, any, any).c) most = std::max(most, c.roundings);
    return most;
}();
inline constexpr int roundings_of_cross = [] {
    const Relative<filters::RoundingCount> any;
    int most = 0;
    for (const auto& c : cross(any, any).c) most = std::max(most, c.roundings);
    return most;
}();

/// Where a site is, in doubles, and how well that is known.
struct Here {
    PolynomialIn<double, 1> x;
    PolynomialIn<double, 1> y;
    double r;
    double place_error = 0.0;
    double speed_error = 0.0;

    Here(const MovingSite& m, const Frame& at)
        : x{{filters::pinned(m.x), filters::pinned(m.vx)}},
          y{{filters::pinned(m.y), filters::pinned(m.vy)}},
          r(filters::pinned(m.r)) {
        const double flown = filters::pinned(at.origin) - filters::pinned(m.time);
        if (flown == 0.0) return;
        const double speed = filters::max(magnitude(x.c[1]), magnitude(y.c[1]));
        if (at.fall.x == 0.0 && at.fall.y == 0.0) {
            x.c[0] += flown * x.c[1];
            y.c[0] += flown * y.c[1];
            // Three roundings, of which each is half an epsilon.
            place_error = 1.01 * epsilon *
                              (magnitude(flown) * speed +
                               filters::max(magnitude(x.c[0]), magnitude(y.c[0]))) +
                          (speed == 0.0 ? 0.0 : Approximation::underflow);
            return;
        }
        const double gained_x = filters::pinned(at.fall.x) * flown;
        const double gained_y = filters::pinned(at.fall.y) * flown;
        const double gained = filters::max(magnitude(gained_x), magnitude(gained_y));
        x.c[0] += flown * (x.c[1] + 0.5 * gained_x);
        y.c[0] += flown * (y.c[1] + 0.5 * gained_y);
        x.c[1] += gained_x;
        y.c[1] += gained_y;
        // At most five roundings in what is added.
        place_error = epsilon * (3.0 * (magnitude(flown) * (speed + gained)) +
                                 filters::max(magnitude(x.c[0]), magnitude(y.c[0]))) +
                      Approximation::underflow;
        speed_error =
            epsilon * (1.01 * gained + filters::max(magnitude(x.c[1]), magnitude(y.c[1]))) +
            Approximation::underflow;
    }
};

/// Sizes of all sites relative to the last one, and of their errors.
struct Sizes {
    PolynomialIn<double, 1> p{};
    PolynomialIn<double, 1> error{};
    double weight = 0.0;
    int movers = 0;
    bool underflows = false;

    Relative<double> relative(const Here& m, const Here& q) noexcept {
        Relative<double> r;
        for (std::size_t k = 0; k < 2; ++k) {
            r.x.c[k] = m.x.c[k] - q.x.c[k];
            r.y.c[k] = m.y.c[k] - q.y.c[k];
        }
        const double place = filters::max(magnitude(r.x.c[0]), magnitude(r.y.c[0]));
        const double speed = filters::max(magnitude(r.x.c[1]), magnitude(r.y.c[1]));
        const double speed_error = (m.speed_error + q.speed_error) + epsilon * speed;
        p.c[0] = filters::max(p.c[0], place);
        p.c[1] = filters::max(p.c[1], speed);
        error.c[0] = filters::max(error.c[0], (m.place_error + q.place_error) + epsilon * place);
        error.c[1] = filters::max(error.c[1], speed_error);
        movers += static_cast<int>(speed + speed_error > 0.0);
        const double less = m.r - q.r;
        const double sum = m.r + q.r;
        r.weight.c[0] = less * sum;
        weight = filters::max(weight, magnitude(r.weight.c[0]));
        // A square that has underflown is not 0.
        underflows |= r.weight.c[0] == 0.0 && less != 0.0 && sum != 0.0;
        return r;
    }

    /// h, or infinity where something is out of range.
    [[nodiscard]] double relative_error() const noexcept {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        double most = 0.0;
        for (std::size_t k = 0; k < 2; ++k) {
            if (p.c[k] == 0.0 && error.c[k] == 0.0) continue;
            if (!(p.c[k] > 0x1p-200 && p.c[k] < 0x1p200)) return infinity;
            most = filters::max(most, error.c[k] / p.c[k]);
        }
        const bool usual = weight == 0.0 || (weight > 0x1p-400 && weight < 0x1p400);
        return usual && !underflows ? most : infinity;
    }
};

template <std::size_t n>
[[nodiscard]] std::optional<PolynomialIn<Approximation, 4>> with_errors(
    const std::array<double, n>& value, const std::array<double, n>& size, const Sizes& sizes,
    int roundings, int degree) {
    const double error = sizes.relative_error();
    if (!(error < 0x1p-10)) return std::nullopt;
    const double factor = 4.1 * error + 1.01 * (roundings + 4) * epsilon;
    PolynomialIn<Approximation, 4> result;
    for (std::size_t i = 0; i < n; ++i)
        result.c[i] = {value[i], static_cast<int>(i) <= degree ? factor * size[i] : 0.0};
    return result;
}

}  // namespace bounded

/// As in_circle<Approximation>; nothing where sizes are out of range, or hardly known.
[[nodiscard]] inline std::optional<PolynomialIn<Approximation, 4>> bounded_in_circle(
    const MovingSite& a, const MovingSite& b, const MovingSite& c, const MovingSite& q,
    const Frame& at) {
    using namespace bounded;
    const Here last(q, at);
    Sizes sizes;
    const Relative<double> i = sizes.relative({a, at}, last);
    const Relative<double> j = sizes.relative({b, at}, last);
    const Relative<double> k = sizes.relative({c, at}, last);
    const auto [x, v] = sizes.p.c;
    const double xx = x * x;
    const double xv = x * v;
    const double vv = v * v;
    const double w = 6.0 * sizes.weight;
    return with_errors<5>(determinant(i, j, k).c,
                          {xx * (12.0 * xx + w), xv * (48.0 * xx + 2.0 * w),
                           72.0 * (xv * xv) + w * vv, 48.0 * (xv * vv), 12.0 * (vv * vv)},
                          sizes, roundings_of_determinant,
                          sizes.movers == 0 ? 0 : sizes.movers + 1);
}

/// As orientation<Approximation>.
[[nodiscard]] inline std::optional<PolynomialIn<Approximation, 4>> bounded_orientation(
    const MovingSite& a, const MovingSite& b, const MovingSite& q, const Frame& at) {
    using namespace bounded;
    const Here last(q, at);
    Sizes sizes;
    const Relative<double> i = sizes.relative({a, at}, last);
    const Relative<double> j = sizes.relative({b, at}, last);
    const auto [x, v] = sizes.p.c;
    return with_errors<3>(cross(i, j).c, {2.0 * (x * x), 4.0 * (x * v), 2.0 * (v * v)}, sizes,
                          roundings_of_cross, sizes.movers);
}

/// The sign of orientation at all times within a radius of the origin. Coordinates x relative to
/// the last site are off by e at most, what they change within the radius included, so that the
/// turn is off by 2 (2 x e + e²) and its own roundings.
[[nodiscard]] inline filters::Verdict bounded_turn(const MovingSite& a, const MovingSite& b,
                                                   const MovingSite& q, const Frame& at,
                                                   double radius) {
    using namespace bounded;
    const Here last(q, at);
    Sizes sizes;
    const Relative<double> i = sizes.relative({a, at}, last);
    const Relative<double> j = sizes.relative({b, at}, last);
    const double x = sizes.p.c[0];
    const double e = sizes.error.c[0] + 1.01 * radius * (sizes.p.c[1] + sizes.error.c[1]);
    const double turn = i.x.c[0] * j.y.c[0] - i.y.c[0] * j.x.c[0];
    const double bound = 4.04 * (x * e) + 2.02 * (e * e) + (4.0 * epsilon * (x * x) + 0x1p-900);
    if (!(magnitude(turn) > bound) || !filters::environment_is_default())
        return filters::Verdict::uncertain();
    return filters::Verdict::certain(filters::sign_of_nonzero(turn));
}

}  // namespace signum::kinetic

SIGNUM_IEEE_END
