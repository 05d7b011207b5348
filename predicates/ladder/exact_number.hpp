#pragma once
/// The exact numbers of the last stages. Included by sources only, for it pulls in Boost and GMP.

#include "../../exact/dyadic.hpp"
#include "../../exact/multiprecision.hpp"
#include "../arithmetic.hpp"

namespace signum::predicates {

/// The double itself: as a rational number or, to a judge, as a dyadic one.
template <Arithmetic arithmetic>
[[nodiscard]] auto exactly(double value) {
    if constexpr (arithmetic == Arithmetic::judging) {
        return exact::Dyadic(value);
    } else {
        static_assert(arithmetic == Arithmetic::multiprecision);
        return exact::to_rational(value);
    }
}
template <Arithmetic arithmetic>
using ExactNumber = decltype(exactly<arithmetic>(0.0));

}  // namespace signum::predicates
