#pragma once
/// The three kinds of power sites of the plane, and how they are ordered by weight.

#include <concepts>

#include "../../core/site.hpp"
#include "../../filters/bounds.hpp"

SIGNUM_IEEE_BEGIN

namespace signum::power {

template <class S>
concept PowerSite =
    std::same_as<S, Point> || std::same_as<S, Site> || std::same_as<S, signum::Site>;

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

/// A site of the kind S, of one as a view gives it, which says radius for whatever its third number
/// is.
template <PowerSite S>
[[nodiscard]] inline S made_of(const signum::Site& site) noexcept {
    if constexpr (std::same_as<S, Point>)
        return {site.x, site.y};
    else
        return {site.x, site.y, site.r};
}

}  // namespace signum::power

SIGNUM_IEEE_END
