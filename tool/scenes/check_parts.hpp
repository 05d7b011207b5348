#pragma once
/// What several checks of a run ask of its effects and its state. For checks.cpp, gas_checks.cpp
/// and force_checks.cpp.

#include <algorithm>
#include <numeric>

#include "beside_wall.hpp"
#include "checks.hpp"

namespace signum {

[[nodiscard]] inline Judgement judged(bool is_good) {
    return is_good ? Judgement::good : Judgement::not_good;
}

template <int D>
[[nodiscard]] bool has_moving_walls(const motion::Effects<D>& effects) {
    return effects.shake || std::ranges::any_of(effects.obstacles, [](const auto& obstacle) {
               return motion::is_moving(obstacle);
           });
}

template <int D>
[[nodiscard]] bool has_walls(const motion::Effects<D>& effects) {
    return first_wall(effects) < end_of_walls(effects);
}

/// Nothing but elastic strikes and gravity acts.
template <int D>
[[nodiscard]] bool is_elastic(const motion::Effects<D>& effects) {
    return effects.restitution == 1.0 && (!has_walls(effects) || effects.wall_restitution == 1.0) &&
           !effects.friction && !effects.growth && !effects.fluid && !effects.contacts &&
           effects.time_step == 0.0;
}

template <int D>
[[nodiscard]] bool has_gravity(const motion::Effects<D>& effects) {
    return effects.gravity != motion::Vector<D>{};
}

/// In a periodic box with nothing else in it.
template <int D>
[[nodiscard]] bool is_endless(const motion::Effects<D>& effects) {
    return effects.periodic && effects.obstacles.empty() && !has_gravity(effects);
}

template <int D>
[[nodiscard]] double mass_of(const motion::State<D>& state) {
    return std::accumulate(state.masses.begin(), state.masses.end(), 0.0);
}

}  // namespace signum
