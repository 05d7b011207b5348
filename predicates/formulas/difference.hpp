#pragma once
/// How a formula begins, whatever it computes in: with differences of doubles, or of vectors of
/// doubles (batch/lanes.cpp).
///
/// A formula takes what it computes in as its first template parameter: a type of number (double,
/// float, filters::Interval, filters::Wide, exact::Sum, filters::RoundingCount), or a struct that
/// says what numbers become of doubles (ladder/ladder.hpp: expansions, whose types grow with their
/// terms, double-doubles, rationals).

#include "../../filters/environment.hpp"

SIGNUM_IEEE_BEGIN

namespace signum::predicates {

/// a - b.
template <class Number, class Operand>
[[nodiscard, gnu::always_inline]] constexpr auto difference(const Operand& a,
                                                            const Operand& b) noexcept {
    if constexpr (requires { Number::difference(a, b); })
        return Number::difference(a, b);
    else
        return Number(a) - Number(b);
}

/// a² - b², of a rounded number as (a - b)(a + b), which does not cancel.
template <class Number, class Operand>
[[nodiscard, gnu::always_inline]] constexpr auto difference_of_squares(const Operand& a,
                                                                       const Operand& b) noexcept {
    if constexpr (requires { Number::difference_of_squares(a, b); })
        return Number::difference_of_squares(a, b);
    else
        return (Number(a) - Number(b)) * (Number(a) + Number(b));
}

/// 0.
template <class Number>
[[nodiscard, gnu::always_inline]] constexpr auto zero() noexcept {
    if constexpr (requires { Number::zero(); })
        return Number::zero();
    else
        return Number(0.0);
}

}  // namespace signum::predicates

SIGNUM_IEEE_END
