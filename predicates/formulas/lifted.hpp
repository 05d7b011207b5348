#pragma once
/// The polynomials of the power metric: determinants of rows of sites lifted by their weights, on a
/// line, in the plane and in space, and the difference of two distances, for any type of number.
///
/// A row is a site's centre relative to the site that is asked about, q, and its weight less q's;
/// its height is |m-q|² - (w_m - w_q). Exchanging any two of the sites, q among them, turns the
/// sign of a determinant, for it is that of rows (1, centre, height) without one column. Source:
/// Gavrilova 1998, Theorems 4.4.1 and 4.4.2, translated to q.

#include "../../core/site.hpp"
#include "difference.hpp"
#include "orientation.hpp"

SIGNUM_IEEE_BEGIN

namespace signum::power {

/// w_m - w_q: the one thing in which the kinds of power sites differ. A Point weighs nothing
/// (Delaunay), a power::Site carries w, a Site the radius of w = r². In doubles with a relative
/// error of three roundings at most.
template <class Number = double, class S>
[[nodiscard, gnu::always_inline]] constexpr auto weight_difference(const S& m,
                                                                   const S& q) noexcept {
    if constexpr (requires { m.w; })
        return predicates::difference<Number>(m.w, q.w);
    else if constexpr (requires { m.r; })
        return predicates::difference_of_squares<Number>(m.r, q.r);
    else
        return predicates::zero<Number>();
}

/// A row of the plane.
template <class Number, class Weight = Number>
struct Row {
    Number x;
    Number y;
    Weight weight;

    [[nodiscard, gnu::always_inline]] constexpr auto height() const {
        return (x * x + y * y) - weight;
    }
};
template <class Number = double, class S>
[[nodiscard, gnu::always_inline]] constexpr auto row(const S& m, const S& q) noexcept {
    using predicates::difference;
    return Row<decltype(difference<Number>(m.x, q.x)), decltype(weight_difference<Number>(m, q))>{
        difference<Number>(m.x, q.x), difference<Number>(m.y, q.y),
        weight_difference<Number>(m, q)};
}

/// (h_a t_b - h_b t_a), t being a coordinate along the line; the caller multiplies by the sign of
/// t_b - t_a.
template <class Row, class Number>
[[nodiscard]] constexpr auto in_segment_determinant(const Row& a, const Row& b, const Number& t_a,
                                                    const Number& t_b) {
    return a.height() * t_b - b.height() * t_a;
}

/// The 3x3 determinant of the rows (x, y, height).
template <class Row>
[[nodiscard, gnu::always_inline]] constexpr auto in_circle_determinant(const Row& i, const Row& j,
                                                                       const Row& k) {
    return i.height() * (j.x * k.y - k.x * j.y) + j.height() * (k.x * i.y - i.x * k.y) +
           k.height() * (i.x * j.y - j.x * i.y);
}

/// A row of space.
template <class Number, class Weight = Number>
struct LiftedRow {
    predicates::Offset3<Number> offset;
    Weight weight;

    [[nodiscard, gnu::always_inline]] constexpr auto height() const {
        const auto& [x, y, z] = offset;
        return (x * x + y * y + z * z) - weight;
    }
};
template <class Number = double, class S>
[[nodiscard, gnu::always_inline]] constexpr auto lifted_row(const S& m, const S& q) noexcept {
    using predicates::difference;
    return LiftedRow<decltype(difference<Number>(m.x, q.x)),
                     decltype(weight_difference<Number>(m, q))>{predicates::offset<Number>(m, q),
                                                                weight_difference<Number>(m, q)};
}

/// Minus the 4x4 determinant of the rows (x, y, z, height): by its last column, minors of pairs
/// shared.
template <class Row>
[[nodiscard, gnu::always_inline]] constexpr auto in_sphere_determinant(const Row& i, const Row& j,
                                                                       const Row& k, const Row& l) {
    const auto& a = i.offset;
    const auto& b = j.offset;
    const auto& c = k.offset;
    const auto& d = l.offset;
    const auto ab = a.x * b.y - b.x * a.y;
    const auto bc = b.x * c.y - c.x * b.y;
    const auto cd = c.x * d.y - d.x * c.y;
    const auto da = d.x * a.y - a.x * d.y;
    const auto ac = a.x * c.y - c.x * a.y;
    const auto bd = b.x * d.y - d.x * b.y;
    return (i.height() * (b.z * cd - c.z * bd + d.z * bc) +
            k.height() * (d.z * ab + a.z * bd + b.z * da)) -
           (j.height() * (c.z * da + d.z * ac + a.z * cd) +
            l.height() * (a.z * bc - b.z * ac + c.z * ab));
}

/// |p - q|².
template <class Number = double, class P, class Q>
[[nodiscard, gnu::always_inline]] constexpr auto squared_distance(const P& p, const Q& q) noexcept {
    using predicates::difference;
    const auto x = difference<Number>(p.x, q.x);
    const auto y = difference<Number>(p.y, q.y);
    if constexpr (requires { q.z; }) {
        const auto z = difference<Number>(p.z, q.z);
        return x * x + y * y + z * z;
    } else {
        return x * x + y * y;
    }
}

/// (|p-b|² - w_b) - (|p-a|² - w_a): above 0 where p is nearer to a.
template <class Number, class P, class S>
[[nodiscard, gnu::always_inline]] constexpr auto nearer_difference(const P& p, const S& a,
                                                                   const S& b) noexcept {
    return (squared_distance<Number>(p, b) - squared_distance<Number>(p, a)) +
           weight_difference<Number>(a, b);
}

}  // namespace signum::power

SIGNUM_IEEE_END
