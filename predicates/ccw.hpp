#pragma once
/// ccw: the orientation of three points, exact for all finite doubles.
///
/// Laws:
///  1. ccw(a,b,c) is the sign of (a-c) x (b-c): +1 where c lies left of the line from a to b, which
///     is where a, b, c turn counterclockwise, 0 where they are collinear, -1 otherwise.
///  2. It is exact and never perturbed.
/// Laws of all predicates:
///  3. Each is right in every rounding mode, with denormals flushed, also where the environment
///     changes between two calls, and for operands that the caller computes on the spot.
///  4. Where all numbers are at most 2^100 in magnitude no operation is invalid, divides by 0 or
///     overflows, so that traps for these may be enabled. Greater ones raise the flags. A trap for
///     underflow or inexact results will spring.
///  5. No call throws. The last stages claim memory, a few kilobytes at most; where there is none
///     the program ends.

#include <concepts>
#include <cstddef>

#include "../core/contract.hpp"
#include "../core/sign.hpp"
#include "../core/site.hpp"
#include "../filters/bounds.hpp"
#include "../filters/rounding_count.hpp"
#include "../filters/tally.hpp"
#include "../filters/verdict.hpp"
#include "formulas/orientation.hpp"
#include "ladder/decision.hpp"

SIGNUM_IEEE_BEGIN

namespace signum {
/// A point of the plane, or a site of any kind: what has a centre.
template <class S>
concept HasCentre =
    std::same_as<decltype(S::x), double> && std::same_as<decltype(S::y), double> && !requires {
    S::z;
};

namespace predicates {

/// The error of the rounded determinant, as a multiple of the sum of its two products' magnitudes.
/// The lemma of rounding_count.hpp gives (1+e)^4 - 1; one more e pays for the terms in e² and for
/// the roundings of the bound itself, 4e(1 + 8e) < 5e.
inline constexpr double ccw_error = 5 * filters::epsilon;
static_assert(ccw_determinant(filters::rounded_difference, filters::rounded_difference,
                              filters::rounded_difference, filters::rounded_difference)
                  .roundings == 4);

/// The determinant and its bound, from the differences to c.
template <class Number>
[[nodiscard, gnu::always_inline]] constexpr filters::Compared<Number> compared_ccw(
    const Number& ax, const Number& ay, const Number& bx, const Number& by) noexcept {
    using filters::magnitude;
    return {ccw_determinant(ax, ay, bx, by), ccw_error * magnitude(ax * by + ay * bx) + 0x1p-1000};
}

/// Decides almost every call. Where the two products have one sign, the magnitude of their sum is
/// the sum of their magnitudes; where they have not, no cancellation happens and any bound below 1
/// would do. Underflow of a product costs at most 2^-1074 each, which 2^-1000 covers; underflow of
/// a difference costs nothing where it is gradual. Overflow of a product or a difference gives
/// infinity or NaN on the right, and the comparison fails.
template <HasCentre S>
[[nodiscard]] inline filters::Verdict ccw_filter(const S& a, const S& b, const S& c) noexcept {
    const Point origin = {filters::opaque(c.x), filters::opaque(c.y)};
    const double ax = filters::pinned(a.x) - origin.x;
    const double ay = filters::pinned(a.y) - origin.y;
    const double bx = filters::pinned(b.x) - origin.x;
    const double by = filters::pinned(b.y) - origin.y;
    const auto [determinant, bound] = compared_ccw(ax, ay, bx, by);
    if (!filters::environment_is_default()) [[unlikely]]
        return filters::Verdict::uncertain();
    if (!(filters::magnitude(determinant) > bound)) [[unlikely]]
        return filters::Verdict::uncertain();
    return filters::Verdict::certain(filters::sign_of_nonzero(determinant));
}

/// The formula. Law 1 of any three: exchanging two of them turns the sign.
struct Ccw {
    /// Whose place is the origin's.
    static constexpr std::size_t origin = 2;
    /// In which expansions and sums hold it: from 2^-window to 2^window.
    static constexpr int window = 200;

    template <class Number, HasCentre S>
    [[nodiscard, gnu::always_inline]] static constexpr auto value(const S& a, const S& b,
                                                                  const S& c) noexcept {
        return ccw_determinant(difference<Number>(a.x, c.x), difference<Number>(a.y, c.y),
                               difference<Number>(b.x, c.x), difference<Number>(b.y, c.y));
    }
    template <HasCentre S>
    [[nodiscard]] static filters::Verdict filter(const S& a, const S& b, const S& c) noexcept {
        return ccw_filter(a, b, c);
    }
    /// Out of line and by reference: the filter need not keep copies of its operands for this call.
    template <Arithmetic arithmetic, HasCentre S>
    [[nodiscard, gnu::cold, gnu::pure, gnu::noinline]] static Decision behind(const S& a,
                                                                              const S& b,
                                                                              const S& c) noexcept {
        return of_points<arithmetic>({a.x, a.y}, {b.x, b.y}, {c.x, c.y});
    }
    template <Arithmetic arithmetic>
    [[nodiscard, gnu::pure]] static Decision of_points(Point a, Point b, Point c) noexcept;
};

}  // namespace predicates

/// The orientation of three points, or of the centres of three sites, with the stage that decided.
/// Precondition: finite coordinates.
template <HasCentre S>
[[nodiscard]] inline Decision ccw_decision(const S& a, const S& b, const S& c) noexcept {
    return predicates::decide<Arithmetic::exact, predicates::Ccw>(a, b, c);
}

/// The orientation: +1 counterclockwise, 0 collinear, -1 clockwise. Exact.
/// Precondition: finite coordinates.
template <HasCentre S>
[[nodiscard]] inline Sign ccw(const S& a, const S& b, const S& c) noexcept {
    SIGNUM_EXPECTS(are_finite(a, b, c));
    return ccw_decision(a, b, c).sign;
}

/// The same for points in braces.
[[nodiscard]] inline Decision ccw_decision(const Point& a, const Point& b,
                                           const Point& c) noexcept {
    return ccw_decision<Point>(a, b, c);
}
/// The same of points, so that braces suffice: ccw({0, 0}, {1, 0}, {0, 1}).
[[nodiscard]] inline Sign ccw(const Point& a, const Point& b, const Point& c) noexcept {
    return ccw<Point>(a, b, c);
}

}  // namespace signum

SIGNUM_IEEE_END
