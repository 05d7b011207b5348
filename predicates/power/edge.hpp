#pragma once
/// Comparing two sites along nothing but a point: which of them is nearer in the power metric.

#include "../../core/contract.hpp"
#include "../../core/sign.hpp"
#include "../../core/site.hpp"
#include "../../filters/bounds.hpp"
#include "../../filters/rounding_count.hpp"
#include "../../filters/tally.hpp"
#include "../formulas/lifted.hpp"
#include "../ladder/decision.hpp"
#include "weight.hpp"

SIGNUM_IEEE_BEGIN

namespace signum::power {

/// The error of the rounded difference as a multiple of its magnitude: (1+e)^6 - 1 by the lemma,
/// one more e for second-order terms and the roundings of the bound.
inline constexpr double nearer_in_plane_error = 7 * filters::epsilon;
static_assert(nearer_difference<filters::RoundingCount>(Point{}, signum::Site{}, signum::Site{})
                  .roundings == 6);

template <class Number, PowerSite S>
[[nodiscard]] constexpr filters::Compared<Number> compared_nearer(const Point& p, const S& a,
                                                                  const S& b) noexcept {
    using filters::magnitude;
    const Number size = squared_distance<Number>(p, a) + squared_distance<Number>(p, b) +
                        magnitude(weight_difference<Number>(a, b));
    return {nearer_difference<Number>(p, a, b), nearer_in_plane_error * size};
}

/// The formula.
struct Nearer {
    static constexpr int window = 200;

    template <class Number, PowerSite S>
    [[nodiscard, gnu::always_inline]] static constexpr auto value(const Point& p, const S& a,
                                                                  const S& b) noexcept {
        return nearer_difference<Number>(p, a, b);
    }
    template <PowerSite S>
    [[nodiscard]] static filters::Compared<double> bounded(const Point& p, const S& a,
                                                           const S& b) noexcept {
        return compared_nearer<double>(p, a, b);
    }
    template <Arithmetic arithmetic, PowerSite S>
    [[nodiscard, gnu::pure]] static Decision behind(const Point& p, const S& a,
                                                    const S& b) noexcept;
};

/// +1 where the point p is nearer to a than to b, 0 where both are as near, -1 otherwise: the sign
/// of (|p-b|² - w_b) - (|p-a|² - w_a). Exact. Precondition: finite numbers.
template <PowerSite S>
[[nodiscard]] inline Decision nearer_decision(const Point& p, const S& a, const S& b) noexcept {
    return predicates::decide<Arithmetic::exact, Nearer>(p, a, b);
}

}  // namespace signum::power

SIGNUM_IEEE_END
