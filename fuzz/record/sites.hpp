#pragma once
/// The sites of a configuration, as the library's and as the oracles'.

#include <array>
#include <cstddef>

#include "../../core/site.hpp"
#include "ledger.hpp"
#include "scaled.hpp"

namespace signum::fuzz {

/// The library's sites: Point, power::Site, Site and those of space.
template <class Site>
[[nodiscard]] Site site_of(const Ball<2>& ball) {
    if constexpr (
        requires { Site::w; } || requires { Site::r; })
        return {ball.centre[0], ball.centre[1], ball.size};
    else
        return {ball.centre[0], ball.centre[1]};
}
template <class Site>
[[nodiscard]] Site site_of(const Ball<3>& ball) {
    if constexpr (
        requires { Site::w; } || requires { Site::r; })
        return {ball.centre[0], ball.centre[1], ball.centre[2], ball.size};
    else
        return {ball.centre[0], ball.centre[1], ball.centre[2]};
}

/// Those of the oracles at these places.
template <std::size_t d, std::size_t n>
[[nodiscard]] std::array<const Exact<d>*, n> chosen(const Scaled<d, d + 2>& scaled,
                                                    const std::array<std::size_t, n>& at) {
    std::array<const Exact<d>*, n> sites;
    for (std::size_t m = 0; m < n; ++m) sites[m] = &scaled.balls[at[m]];
    return sites;
}
/// And their places in the tie rule's order.
template <std::size_t d, std::size_t n>
[[nodiscard]] std::array<std::int32_t, n> ranks(const Configuration<d>& given,
                                                const std::array<std::size_t, n>& at) {
    std::array<const Ball<d>*, n> balls;
    for (std::size_t m = 0; m < n; ++m) balls[m] = &given.balls[at[m]];
    return ranks_of<n, d>(given.kind, balls);
}

}  // namespace signum::fuzz
