#pragma once
/// Comparing two sites along nothing but a point of space: which of them is nearer in the power
/// metric.

#include "../../filters/tally.hpp"
#include "in_sphere.hpp"

SIGNUM_IEEE_BEGIN

namespace signum::power {

/// The error of the rounded difference as a multiple of the sum of its three terms' magnitudes. One
/// more e than there are roundings pays for the terms in e², another one for those of the sum.
inline constexpr double nearer_error = 9 * filters::epsilon;
static_assert(nearer_difference<filters::RoundingCount>(Point3{}, signum::Site3{}, signum::Site3{})
                  .roundings <= 7);

/// The difference, and the sum of its terms' magnitudes: the bound is so many times that.
template <class Number, PowerSite3 S>
[[nodiscard, gnu::always_inline]] constexpr filters::Compared<Number> compared_nearer(
    const Point3& p, const S& a, const S& b) noexcept {
    using filters::magnitude;
    const Number to_a = squared_distance<Number>(p, a);
    const Number to_b = squared_distance<Number>(p, b);
    const Number weight = weight_difference<Number>(a, b);
    return {(to_b - to_a) + weight, to_a + to_b + magnitude(weight)};
}

/// Decides almost every call. Underflow: a product loses at most 2^-1074, and the bound is at least
/// 2^-950. Overflow: the bound is infinite then or a NaN, and the comparison fails.
template <PowerSite3 S>
[[nodiscard]] inline filters::Verdict nearer_filter(const Point3& p, const S& a,
                                                    const S& b) noexcept {
    const Point3 eye = filters::pinned(p);
    const S one = filters::pinned(a);
    const S other = filters::pinned(b);
    const auto [difference, magnitude] = compared_nearer<double>(eye, one, other);
    if (!filters::environment_is_default() || !(magnitude >= 0x1p-890)) [[unlikely]]
        return filters::Verdict::uncertain();
    if (!(filters::magnitude(difference) > nearer_error * magnitude)) [[unlikely]]
        return filters::Verdict::uncertain();
    return filters::Verdict::certain(filters::sign_of_nonzero(difference));
}

/// The formula. It has no window: long doubles hold squares of all doubles, and their bound tells
/// nearly all that the filter leaves open.
struct Nearer3 {
    template <class Number, PowerSite3 S>
    [[nodiscard, gnu::always_inline]] static constexpr auto value(const Point3& p, const S& a,
                                                                  const S& b) noexcept {
        return nearer_difference<Number>(p, a, b);
    }
    template <PowerSite3 S>
    [[nodiscard]] static filters::Verdict filter(const Point3& p, const S& a, const S& b) noexcept {
        return nearer_filter(p, a, b);
    }
    template <Arithmetic arithmetic, PowerSite3 S>
    [[nodiscard, gnu::cold]] static Decision behind(const Point3& p, const S& a,
                                                    const S& b) noexcept;
};

/// +1 where the point p is nearer to a than to b, 0 where both are as near, -1 otherwise: the sign
/// of (|p-b|² - w_b) - (|p-a|² - w_a). Exact. Precondition: finite numbers.
template <PowerSite3 S>
[[nodiscard]] inline Decision nearer_decision(const Point3& p, const S& a, const S& b) noexcept {
    return predicates::decide<Arithmetic::exact, Nearer3>(p, a, b);
}

}  // namespace signum::power

SIGNUM_IEEE_END
