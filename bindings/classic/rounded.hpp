#pragma once
/// The double next to a classic determinant. For sources only.
///
/// Stages: pairs of doubles with a coarse bound; behind them, in the default environment, pairs
/// with a finer one; expansions, or integers.
///
/// Law: sign and 0 are exact, and the result is off by less than one unit in the last place;
/// pair.hpp and rounded.cpp have the proofs.

#include "../../core/processor.hpp"
#include "../../filters/environment.hpp"
#include "determinants.hpp"
#include "pair.hpp"

namespace signum::classic {

/// The stages behind the first.
template <class Determinant>
[[nodiscard, gnu::cold, gnu::noinline]] double rounded_cold(const Determinant& d) noexcept;

/// Underflow: differences are below 2^100, for else the ceiling is above 2^200. A product that
/// loses 2^-1074 is multiplied by four of them at most, and some sixty such losses are less than
/// 2^-660: nothing beside 2^-500. What overflows ends as a NaN, which no comparison lets pass.
template <class Determinant>
[[nodiscard, gnu::always_inline]] inline double rounded(const Determinant& d) noexcept {
    Pair value;
    as_wide_as_possible([&]() __attribute__((always_inline)) {
        value = d.template determinant<Pair>();
    });
    const double result = value.high + value.low;
    const double magnitude = filters::magnitude(result);
    const double ceiling = d.ceiling();
    if (magnitude >= least_of_pairs<Determinant> * ceiling && magnitude >= 0x1p-500 &&
        ceiling <= 0x1p200 && filters::environment_is_default()) [[likely]]
        return result;
    return rounded_cold(d);
}

}  // namespace signum::classic
