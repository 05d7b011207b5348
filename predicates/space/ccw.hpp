#pragma once
/// ccw in space: the orientation of four points, exact for all finite doubles.
///
/// Law: ccw(a,b,c,d) is the sign of det(b-a, c-a, d-a): +1 where d lies on the side of the plane of
/// a, b, c from which these turn counterclockwise, 0 where the four are coplanar, -1 otherwise. It
/// is exact and never perturbed. The laws of all predicates: predicates/ccw.hpp.

#include <concepts>
#include <cstddef>

#include "../../core/contract.hpp"
#include "../../core/sign.hpp"
#include "../../core/site.hpp"
#include "../../filters/bounds.hpp"
#include "../../filters/environment.hpp"
#include "../../filters/interval.hpp"
#include "../../filters/rounding_count.hpp"
#include "../../filters/tally.hpp"
#include "../../filters/verdict.hpp"
#include "../formulas/orientation.hpp"
#include "../ladder/decision.hpp"

SIGNUM_IEEE_BEGIN

namespace signum {
/// A point of space, or a site of any kind there.
template <class S>
concept HasCentre3 = std::same_as<decltype(S::x), double> && std::same_as<decltype(S::y), double> &&
    std::same_as<decltype(S::z), double>;

/// Its centre alone.
template <HasCentre3 S>
[[nodiscard]] constexpr Point3 centre3(const S& s) noexcept {
    return {s.x, s.y, s.z};
}

namespace predicates {

/// The largest coordinates of three or four offsets, in magnitude.
template <class Number>
[[nodiscard]] inline Offset3<Number> reach(const Offset3<Number>& b, const Offset3<Number>& c,
                                           const Offset3<Number>& d) noexcept {
    using filters::magnitude;
    using filters::max;
    const auto largest = [](const Number& p, const Number& q, const Number& r) {
        return max(max(magnitude(p), magnitude(q)), magnitude(r));
    };
    return {largest(b.x, c.x, d.x), largest(b.y, c.y, d.y), largest(b.z, c.z, d.z)};
}
/// Whether the largest offsets along all axes are from 2^-150 to 2^150, so that in a product of up
/// to five of them, or of them and a height, no part of it over- or underflows.
[[nodiscard]] inline bool in_filter_window(const Offset3<double>& largest) noexcept {
    using filters::max;
    using filters::min;
    return min(min(largest.x, largest.y), largest.z) >= 0x1p-150 &&
           max(max(largest.x, largest.y), largest.z) <= 0x1p150;
}

/// The error of the rounded determinant, as a multiple of the product of the largest coordinates:
/// its magnitude is at most six times that. The lemma of rounding_count.hpp gives (1+e)^8 - 1; one
/// more e pays for the terms in e² and for the roundings of the bound itself.
inline constexpr double ccw3_error = 6 * 9 * filters::epsilon;
inline constexpr auto rounded_offset = offset<filters::RoundingCount>(Point3{}, Point3{});
static_assert(ccw_determinant(rounded_offset, rounded_offset, rounded_offset).roundings == 8);

/// The bound on the error of the determinant.
template <class Number>
[[nodiscard, gnu::always_inline]] constexpr Number bound_of_ccw(
    const Offset3<Number>& largest) noexcept {
    return ccw3_error * (largest.x * largest.y * largest.z);
}

/// Decides almost every call. Underflow: a product of two coordinates loses at most 2^-1074, and
/// the whole at most 2^-1070 times the largest coordinate and 1; in the window the bound is at
/// least 2^-498. Overflow is out of the question there, and a NaN fails the comparison.
template <HasCentre3 S>
[[nodiscard]] inline filters::Verdict ccw_filter(const S& a, const S& b, const S& c,
                                                 const S& d) noexcept {
    const Point3 origin = filters::pinned(centre3(a));
    const Offset3<double> u = offset(filters::pinned(centre3(b)), origin);
    const Offset3<double> v = offset(filters::pinned(centre3(c)), origin);
    const Offset3<double> w = offset(filters::pinned(centre3(d)), origin);
    const double determinant = ccw_determinant(u, v, w);
    const Offset3<double> largest = reach(u, v, w);
    const double bound = bound_of_ccw(largest);
    if (!filters::environment_is_default() || !in_filter_window(largest)) [[unlikely]]
        return filters::Verdict::uncertain();
    if (!(filters::magnitude(determinant) > bound)) [[unlikely]]
        return filters::Verdict::uncertain();
    return filters::Verdict::certain(filters::sign_of_nonzero(determinant));
}

/// The filter's determinant with its magnitude itself for a bound.
template <class Number>
[[nodiscard]] inline filters::Compared<Number> compared_ccw_finely(
    const Offset3<Number>& u, const Offset3<Number>& v, const Offset3<Number>& w) noexcept {
    const auto absolute = [](const Offset3<Number>& offset) {
        using filters::magnitude;
        return Offset3<Number>{magnitude(offset.x), magnitude(offset.y), magnitude(offset.z)};
    };
    const Offset3<Number> a = absolute(u);
    const Offset3<Number> b = absolute(v);
    const Offset3<Number> c = absolute(w);
    const Number magnitude = a.x * (b.y * c.z + b.z * c.y) + a.y * (b.z * c.x + b.x * c.z) +
                             a.z * (b.x * c.y + b.y * c.x);
    return {ccw_determinant(u, v, w), 9 * filters::epsilon * magnitude};
}

/// The formula. Exchanging any two of the four turns the sign.
struct Ccw3 {
    /// Whose place is the origin's.
    static constexpr std::size_t origin = 0;
    static constexpr int window = 200;

    template <class Number, HasCentre3 S>
    [[nodiscard, gnu::always_inline]] static constexpr auto value(const S& a, const S& b,
                                                                  const S& c, const S& d) noexcept {
        return ccw_determinant(offset<Number>(b, a), offset<Number>(c, a), offset<Number>(d, a));
    }
    template <HasCentre3 S>
    [[nodiscard]] static filters::Verdict filter(const S& a, const S& b, const S& c,
                                                 const S& d) noexcept {
        return ccw_filter(a, b, c, d);
    }
    [[nodiscard]] static filters::Compared<double> bounded(const Point3& a, const Point3& b,
                                                           const Point3& c,
                                                           const Point3& d) noexcept {
        return compared_ccw_finely(offset(b, a), offset(c, a), offset(d, a));
    }
    template <Arithmetic arithmetic, HasCentre3 S>
    [[nodiscard, gnu::cold, gnu::pure, gnu::noinline]] static Decision behind(const S& a,
                                                                              const S& b,
                                                                              const S& c,
                                                                              const S& d) noexcept {
        return of_points<arithmetic>(centre3(a), centre3(b), centre3(c), centre3(d));
    }
    template <Arithmetic arithmetic>
    [[nodiscard, gnu::cold, gnu::pure]] static Decision of_points(const Point3& a, const Point3& b,
                                                                  const Point3& c,
                                                                  const Point3& d) noexcept;
};

}  // namespace predicates

/// The orientation of four points, or of the centres of four sites, with the stage that decided.
/// Precondition: finite coordinates.
template <HasCentre3 S>
[[nodiscard]] inline Decision ccw_decision(const S& a, const S& b, const S& c,
                                           const S& d) noexcept {
    return predicates::decide<Arithmetic::exact, predicates::Ccw3>(a, b, c, d);
}

/// The orientation: +1 where det(b-a, c-a, d-a) > 0, 0 where the four are coplanar, -1 otherwise.
/// Exact. Precondition: finite coordinates.
template <HasCentre3 S>
[[nodiscard]] inline Sign ccw(const S& a, const S& b, const S& c, const S& d) noexcept {
    SIGNUM_EXPECTS(are_finite(a, b, c, d));
    return ccw_decision(a, b, c, d).sign;
}

/// The same for points in braces.
[[nodiscard]] inline Decision ccw_decision(const Point3& a, const Point3& b, const Point3& c,
                                           const Point3& d) noexcept {
    return ccw_decision<Point3>(a, b, c, d);
}
/// The sign alone.
[[nodiscard]] inline Sign ccw(const Point3& a, const Point3& b, const Point3& c,
                              const Point3& d) noexcept {
    return ccw<Point3>(a, b, c, d);
}

}  // namespace signum

SIGNUM_IEEE_END
