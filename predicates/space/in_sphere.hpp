#pragma once
/// in_sphere in the power metric of space: does site q conflict with the vertex of i, j, k, l?
///
/// Law: for ccw(i,j,k,l) > 0 it is the sign of minus the 4x4 determinant of the rows
///     (x_m - x_q,  y_m - y_q,  z_m - z_q,  |m - q|² - (w_m - w_q)),   m = i, j, k, l:
/// +1 where q is nearer than the vertex's distance to i, j, k, l, 0 where it is as near.
/// Source: Gavrilova 1998, Theorem 4.4.2, translated to q.

#include <array>

#include "../../core/index.hpp"
#include "../formulas/lifted.hpp"
#include "../power/weight.hpp"
#include "ccw.hpp"

SIGNUM_IEEE_BEGIN

namespace signum::power {

template <class S>
concept PowerSite3 =
    std::same_as<S, Point3> || std::same_as<S, Site3> || std::same_as<S, signum::Site3>;

/// The error of the rounded determinant as a multiple of its magnitude; as in_circle_error.
inline constexpr double in_sphere_error = 18 * filters::epsilon;
inline constexpr auto rounded_lifted_row =
    lifted_row<filters::RoundingCount>(signum::Site3{}, signum::Site3{});
static_assert(in_sphere_determinant(rounded_lifted_row, rounded_lifted_row, rounded_lifted_row,
                                    rounded_lifted_row)
                  .roundings <= 17);

/// The same in double-doubles, whose epsilon is 2^-102; twice that covers the magnitude, rounded in
/// doubles.
inline constexpr double refined_in_sphere_error = 24 * 0x1p-102;
inline constexpr LiftedRow<filters::RoundingCount> refined_lifted_row{
    {filters::RoundingCount(), filters::RoundingCount(), filters::RoundingCount()},
    filters::RoundingCount::of(1)};
static_assert(in_sphere_determinant(refined_lifted_row, refined_lifted_row, refined_lifted_row,
                                    refined_lifted_row)
                  .roundings <= 12);

/// The bound on the error of the determinant, from the largest coordinates and weight.
template <class Number>
[[nodiscard, gnu::always_inline]] constexpr Number bound_of_in_sphere(
    const predicates::Offset3<Number>& largest, const Number& weight) noexcept {
    const Number height =
        largest.x * largest.x + largest.y * largest.y + largest.z * largest.z + weight;
    return 24 * in_sphere_error * ((largest.x * largest.y) * (largest.z * height));
}

/// A determinant beyond it has overflowed.
inline constexpr double largest_double = 0x1.fffffffffffffp1023;

/// A row for the filter, which subtracts, takes magnitudes and compares them two at a time.
struct PairedRow {
    filters::Two xy;  ///< of the centre
    filters::Two zw;  ///< with the weight, of a site its radius

    /// The same row.
    [[nodiscard, gnu::always_inline]] operator LiftedRow<double>() const noexcept {
        return {{xy[0], xy[1], zw[0]}, zw[1]};
    }
};
/// A site's own numbers, pinned.
template <PowerSite3 S>
[[nodiscard, gnu::always_inline]] inline PairedRow pinned_row(const S& m) noexcept {
    double last = 0.0;
    if constexpr (requires { m.w; }) last = m.w;
    if constexpr (requires { m.r; }) last = m.r;
    return {filters::pinned(filters::Two{m.x, m.y}), filters::pinned(filters::Two{m.z, last})};
}
/// The same numbers as lifted_row().
template <PowerSite3 S>
[[nodiscard, gnu::always_inline]] inline PairedRow paired_row(const S& m,
                                                              const PairedRow& origin) noexcept {
    const PairedRow site = pinned_row(m);
    PairedRow row = {site.xy - origin.xy, site.zw - origin.zw};
    if constexpr (requires { m.r; }) row.zw[1] *= site.zw[1] + origin.zw[1];
    return row;
}

/// Decides almost every call. The magnitude is at most 24 times the product of the largest
/// coordinates, an axis each, and the largest height, |m-q|² + |w_m - w_q|. Underflow: in the
/// window a height is above 2^-301 and the bound above 2^-800, and what is lost is below 2^-1000
/// times the largest factors. Overflow: weights may be as large as doubles are. Where a sum of the
/// determinant goes beyond the doubles, which the bound, 2^43 times smaller, need not, it stays
/// infinite or becomes a NaN, and either is uncertain; so it is where the bound is one of them.
template <PowerSite3 S>
[[nodiscard]] inline filters::Verdict in_sphere_filter(const S& i, const S& j, const S& k,
                                                       const S& l, const S& q) noexcept {
    using filters::magnitude;
    using filters::max;
    const PairedRow origin = pinned_row(q);
    const PairedRow a = paired_row(i, origin);
    const PairedRow b = paired_row(j, origin);
    const PairedRow c = paired_row(k, origin);
    const PairedRow d = paired_row(l, origin);
    const filters::Two xy =
        max(max(magnitude(a.xy), magnitude(b.xy)), max(magnitude(c.xy), magnitude(d.xy)));
    const filters::Two zw =
        max(max(magnitude(a.zw), magnitude(b.zw)), max(magnitude(c.zw), magnitude(d.zw)));
    const predicates::Offset3<double> largest = {xy[0], xy[1], zw[0]};
    const double bound = bound_of_in_sphere(largest, zw[1]);
    // After the bound, which is the last to need the magnitudes: the fewer registers are in use.
    const double determinant = in_sphere_determinant<LiftedRow<double>>(a, b, c, d);
    if (!filters::environment_is_default() || !predicates::in_filter_window(largest)) [[unlikely]]
        return filters::Verdict::uncertain();
    if (!(magnitude(determinant) > bound && magnitude(determinant) <= largest_double)) [[unlikely]]
        return filters::Verdict::uncertain();
    return filters::Verdict::certain(filters::sign_of_nonzero(determinant));
}

/// The determinant's magnitude: every operand replaced by its absolute value, every difference by a
/// sum.
[[nodiscard, gnu::always_inline]] inline double determinant_magnitude(
    const LiftedRow<double> (&rows)[4]) noexcept {
    using filters::magnitude;
    const auto of_minor = [&](int j, int k, int l) {
        const auto& [bx, by, bz] = rows[j].offset;
        const auto& [cx, cy, cz] = rows[k].offset;
        const auto& [dx, dy, dz] = rows[l].offset;
        return magnitude(bz) * (magnitude(cx * dy) + magnitude(cy * dx)) +
               magnitude(cz) * (magnitude(dx * by) + magnitude(dy * bx)) +
               magnitude(dz) * (magnitude(bx * cy) + magnitude(by * cx));
    };
    const auto height = [&](int m) {
        const auto& [x, y, z] = rows[m].offset;
        return (x * x + y * y + z * z) + magnitude(rows[m].weight);
    };
    return height(0) * of_minor(1, 2, 3) + height(1) * of_minor(2, 3, 0) +
           height(2) * of_minor(3, 0, 1) + height(3) * of_minor(0, 1, 2);
}

/// The formula.
struct InSphere {
    static constexpr std::size_t origin = 4;
    /// Of double-doubles: terms of degree up to 5, and their errors, are multiples of 2^-1010.
    static constexpr int window = 150;

    template <class Number, PowerSite3 S>
    [[nodiscard, gnu::always_inline]] static constexpr auto value(const S& i, const S& j,
                                                                  const S& k, const S& l,
                                                                  const S& q) noexcept {
        return in_sphere_determinant(lifted_row<Number>(i, q), lifted_row<Number>(j, q),
                                     lifted_row<Number>(k, q), lifted_row<Number>(l, q));
    }
    template <PowerSite3 S>
    [[nodiscard]] static filters::Verdict filter(const S& i, const S& j, const S& k, const S& l,
                                                 const S& q) noexcept {
        return in_sphere_filter(i, j, k, l, q);
    }
    template <Arithmetic arithmetic, PowerSite3 S>
    [[nodiscard, gnu::cold, gnu::pure]] static Decision behind(const S& i, const S& j, const S& k,
                                                               const S& l, const S& q) noexcept;
};

/// The sign of in_sphere with the stage that decided.
/// Preconditions: finite numbers, ccw(i,j,k,l) > 0.
template <PowerSite3 S>
[[nodiscard]] inline Decision in_sphere_decision(const S& i, const S& j, const S& k, const S& l,
                                                 const S& q) noexcept {
    SIGNUM_EXPECTS(ccw(i, j, k, l) > 0);
    return predicates::decide<Arithmetic::exact, InSphere>(i, j, k, l, q);
}

/// +1 where q conflicts with the vertex of i, j, k, l (is nearer than they are), 0 where it
/// touches, -1 otherwise. Preconditions: ccw(i,j,k,l) > 0, finite numbers.
/// Thesis: Theorem 4.4.2.
template <PowerSite3 S>
[[nodiscard]] inline Sign in_sphere(const S& i, const S& j, const S& k, const S& l,
                                    const S& q) noexcept {
    SIGNUM_EXPECTS(are_finite(i, j, k, l, q));
    return in_sphere_decision(i, j, k, l, q).sign;
}

}  // namespace signum::power

SIGNUM_IEEE_END
