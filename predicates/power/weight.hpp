#pragma once
/// The one thing in which the three kinds of power sites differ, in the plane and in space: the
/// difference of two weights.
///
/// A Point weighs nothing (Delaunay), a power::Site carries w, a Site the radius of w = r². The
/// rounded difference r_i² - r_j² is taken as (r_i - r_j)(r_i + r_j), which does not cancel.

#include <concepts>

#include "../../core/site.hpp"
#include "../../filters/bounds.hpp"

SIGNUM_IEEE_BEGIN

namespace signum::power {

template <class S>
concept PowerSite =
    std::same_as<S, Point> || std::same_as<S, Site> || std::same_as<S, signum::Site>;

/// w_i - w_q, in doubles with a relative error of at most three roundings.
template <class Number = double, class S>
[[nodiscard]] constexpr Number weight_difference(const S& i, const S& q) noexcept {
    if constexpr (requires { i.w; })
        return Number(i.w) - Number(q.w);
    else if constexpr (requires { i.r; })
        return (Number(i.r) - Number(q.r)) * (Number(i.r) + Number(q.r));
    else
        return Number(0.0);
}

/// A number that orders sites of one kind by weight: w itself, or |r|, exactly.
template <class S>
[[nodiscard]] inline double weight_key(const S& s) noexcept {
    if constexpr (requires { s.w; })
        return s.w;
    else if constexpr (requires { s.r; })
        return filters::magnitude(s.r);
    else
        return 0.0;
}

template <PowerSite S>
[[nodiscard]] inline Point centre(const S& s) noexcept {
    return {s.x, s.y};
}

}  // namespace signum::power

SIGNUM_IEEE_END
