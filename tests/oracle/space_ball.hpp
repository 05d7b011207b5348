#pragma once
/// Balls of the plane and of space, in rationals. Which points they hold is up to the metric.

#include "../../core/site.hpp"

#include "linear_form.hpp"

#include <array>
#include <cstddef>

namespace signum::oracle {

/// Centre and radius, which may be negative.
template <int D>
struct SpaceBall {
    std::array<Rational, static_cast<std::size_t>(D)> c{};
    Rational r = 0;
    friend bool operator==(const SpaceBall&, const SpaceBall&) = default;
};

/// Every finite double; throws std::invalid_argument for the others.
inline SpaceBall<2> exact_ball(const Site& site) {
    return {{exactly(site.x), exactly(site.y)}, exactly(site.r)};
}
inline SpaceBall<3> exact_ball(const Site3& site) {
    return {{exactly(site.x), exactly(site.y), exactly(site.z)}, exactly(site.r)};
}

template <int D>
using BallTuple = std::array<SpaceBall<D>, static_cast<std::size_t>(D + 1)>;

}  // namespace signum::oracle
