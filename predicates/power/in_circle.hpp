#pragma once
/// in_circle in the power metric: does site q conflict with the vertex of i, j, k?
///
/// Law: for ccw(i,j,k) > 0 it is the sign of the 3x3 determinant of the rows
///     (x_m - x_q,  y_m - y_q,  (x_m - x_q)² + (y_m - y_q)² - (w_m - w_q)),   m = i, j, k:
/// +1 where q is nearer than the vertex's distance to i, j, k, 0 where it is as near.
/// Source: Gavrilova 1998, Theorem 4.4.1, translated to q.

#include <array>
#include <cstddef>
#include <optional>

#include "../../core/contract.hpp"
#include "../../core/sign.hpp"
#include "../../filters/bounds.hpp"
#include "../../filters/rounding_count.hpp"
#include "../../filters/tally.hpp"
#include "../../filters/verdict.hpp"
#include "../ccw.hpp"
#include "../formulas/lifted.hpp"
#include "weight.hpp"

SIGNUM_IEEE_BEGIN

namespace signum::power {

/// The error of the rounded determinant as a multiple of its magnitude: the lemma of
/// rounding_count.hpp gives (1+e)^12 - 1 < 12e(1 + 12e), and one more e pays for the second-order
/// terms and for the rounded magnitude and bound, together fewer than 30 roundings.
/// The weights of signum::Site are the costliest.
inline constexpr double in_circle_error = 13 * filters::epsilon;
inline constexpr auto rounded_row = row<filters::RoundingCount>(signum::Site{}, signum::Site{});
static_assert(in_circle_determinant(rounded_row, rounded_row, rounded_row).roundings == 12);

/// The determinant and its bound.
template <class Number>
[[nodiscard, gnu::always_inline]] constexpr filters::Compared<Number> compared_in_circle(
    const Row<Number>& a, const Row<Number>& b, const Row<Number>& c) noexcept {
    using filters::magnitude;
    const Number a_square = a.x * a.x + a.y * a.y;
    const Number b_square = b.x * b.x + b.y * b.y;
    const Number c_square = c.x * c.x + c.y * c.y;
    const Number s = (a_square + magnitude(a.weight)) + (b_square + magnitude(b.weight)) +
                     (c_square + magnitude(c.weight));
    return {in_circle_determinant(a, b, c),
            5 * filters::epsilon * (s * s) + (0x1p-1000 * s + 0x1p-1000)};
}

/// The determinant with every operand replaced by its absolute value, every difference by a sum.
template <class Number>
[[nodiscard]] constexpr Number determinant_magnitude(const Row<Number>& a, const Row<Number>& b,
                                                     const Row<Number>& c) noexcept {
    using filters::magnitude;
    const auto absolute = [](const Row<Number>& row) {
        return Row<Number>{magnitude(row.x), magnitude(row.y), magnitude(row.weight)};
    };
    const Row<Number> i = absolute(a);
    const Row<Number> j = absolute(b);
    const Row<Number> k = absolute(c);
    return (i.x * i.x + i.y * i.y + i.weight) * (j.x * k.y + k.x * j.y) +
           (j.x * j.x + j.y * j.y + j.weight) * (k.x * i.y + i.x * k.y) +
           (k.x * k.x + k.y * k.y + k.weight) * (i.x * j.y + j.x * i.y);
}

/// Inside the window nothing under- or overflows; the same below.
template <class Number>
[[nodiscard]] constexpr filters::Compared<Number> compared_in_circle_finely(
    const Row<Number>& a, const Row<Number>& b, const Row<Number>& c) noexcept {
    return {in_circle_determinant(a, b, c), in_circle_error * determinant_magnitude(a, b, c)};
}

/// Decides almost every call.
///
/// *Bound.* With h_m = |m-q|² + |w_m - w_q| and s = h_i + h_j + h_k the magnitude of the
/// determinant is at most h_i h_j + h_j h_k + h_k h_i <= s²/3, since |x_j y_k| + |x_k y_j| is at
/// most
/// (|j-q|² + |k-q|²)/2; and 13e/3 < 5e. The bound is coarse for slivers, but it costs a few
/// operations where the magnitude itself would cost twenty; that one is asked next (in_circle.cpp).
///
/// *Underflow.* Each product commits at most 2^-1074 more, so a minor at most 2^-1073, a lifted
/// height 3·2^-1074, and the determinant at most 2^-1071 (s + 1).
///
/// *Overflow.* No term and no partial sum of the determinant exceeds s²/2, so that where one
/// overflows s² has, and the comparison fails.
///
/// *On a grid.* Who knows a power of two u, u⁴ at least 2^-960, of which all coordinates and radii
/// are multiples, and of whose square all weights are, gives 4u⁴ for `exact_below`: a smaller bound
/// says that nothing was rounded, so that the sign is certain, 0 too. For then 5e s² < 4u⁴ but for
/// roundings far smaller than the rest, s² < 2^52 u⁴, and s < 2^26 u². No difference was rounded:
/// one that is not a double exceeds 2^53 u, and s the square of that, or a factor of a weight does,
/// and so does s unless the other factor is 0. Squares, weights, their sums and the minors are
/// multiples of u² below 2^53 u², all terms and sums of the determinant of u⁴ below 2^53 u⁴:
/// doubles, all of them.
template <PowerSite S>
[[nodiscard]] inline filters::Verdict in_circle_filter(const S& i, const S& j, const S& k,
                                                       const S& q,
                                                       double exact_below = 0.0) noexcept {
    const S origin = filters::pinned(q);
    const Row<double> a = row(filters::pinned(i), origin);
    const Row<double> b = row(filters::pinned(j), origin);
    const Row<double> c = row(filters::pinned(k), origin);
    const auto [determinant, bound] = compared_in_circle(a, b, c);
    if (!filters::environment_is_default()) [[unlikely]]
        return filters::Verdict::uncertain();
    if (!(filters::magnitude(determinant) > bound)) [[unlikely]]
        return bound < exact_below ? filters::Verdict::certain(sign_of(determinant))
                                   : filters::Verdict::uncertain();
    return filters::Verdict::certain(filters::sign_of_nonzero(determinant));
}

/// The same of two circles and one site: lane by lane the operations of the filter above, so that
/// its proof holds. Whether the site lies inside; nothing where either is uncertain.
template <PowerSite S>
[[nodiscard, gnu::always_inline]] inline std::optional<std::array<bool, 2>> in_circles_filter(
    const std::array<const S*, 3>& first, const std::array<const S*, 3>& second,
    const S& q) noexcept {
    using filters::Two;
    const S origin = filters::pinned(q);
    const auto beside = [&](std::size_t m) {
        const Row<double> a = row(filters::pinned(*first[m]), origin);
        const Row<double> b = row(filters::pinned(*second[m]), origin);
        return Row<Two>{Two{a.x, b.x}, Two{a.y, b.y}, Two{a.weight, b.weight}};
    };
    const auto [determinants, bounds] = compared_in_circle(beside(0), beside(1), beside(2));
    if (!filters::environment_is_default()) [[unlikely]]
        return std::nullopt;
    if (!filters::all_exceed(filters::magnitude(determinants), bounds)) [[unlikely]]
        return std::nullopt;
    return std::array{filters::sign_of_nonzero(determinants[0]) > 0,
                      filters::sign_of_nonzero(determinants[1]) > 0};
}

/// The formula.
struct InCircle {
    static constexpr std::size_t origin = 3;
    static constexpr int window = 200;

    template <class Number, PowerSite S>
    [[nodiscard, gnu::always_inline]] static constexpr auto value(const S& i, const S& j,
                                                                  const S& k, const S& q) noexcept {
        return in_circle_determinant(row<Number>(i, q), row<Number>(j, q), row<Number>(k, q));
    }
    template <PowerSite S>
    [[nodiscard]] static filters::Verdict filter(const S& i, const S& j, const S& k,
                                                 const S& q) noexcept {
        return in_circle_filter(i, j, k, q);
    }
    template <PowerSite S>
    [[nodiscard]] static filters::Compared<double> bounded(const S& i, const S& j, const S& k,
                                                           const S& q) noexcept {
        return compared_in_circle_finely(row(i, q), row(j, q), row(k, q));
    }
    template <Arithmetic arithmetic, PowerSite S>
    [[nodiscard, gnu::cold, gnu::pure]] static Decision behind(const S& i, const S& j, const S& k,
                                                               const S& q) noexcept;
};

/// The sign of in_circle with the stage that decided.
/// Preconditions: finite numbers, ccw(i,j,k) > 0.
template <PowerSite S>
[[nodiscard]] inline Decision in_circle_decision(const S& i, const S& j, const S& k,
                                                 const S& q) noexcept {
    SIGNUM_EXPECTS(ccw(i, j, k) > 0);
    return predicates::decide<Arithmetic::exact, InCircle>(i, j, k, q);
}

}  // namespace signum::power

SIGNUM_IEEE_END
