#pragma once
/// The rule for a collapse: a run ends when a ball has struck so many times in a row in place, or
/// without room to grow.

#include <cmath>
#include <cstdint>

#include "system.hpp"

namespace signum::motion {

inline constexpr std::uint32_t most_without_room = 10'000;
/// A strike that comes sooner after the last one than this part of the clock, some 2^7 of its
/// ticks, comes at once.
inline constexpr double no_time = 0x1p-45;
/// A ball that flies no farther than this part of its radius has no room where balls grow, if they
/// would still grow by so many times that way.
inline constexpr double no_room = 0x1p-8;
inline constexpr double growth_to_a_jam = 16.0;

/// Whether balls will have closed the gap that one has flown through long before they cease to
/// grow. A ball that hops on a floor flies as short ways, but as slowly as it falls.
template <int D, Known known>
[[nodiscard]] inline bool has_no_room(const System<D, known>& system, const Ball<D>& came,
                                      double since, double speed, double growth) noexcept {
    const World<D>& world = system.world;
    if (!world.effects.growth) [[likely]]
        return false;
    const double flown = speed * since;
    return flown <= no_room * system.grown_radius(came) && no_room * speed >= world.pull * since &&
           growth_to_a_jam * flown <= growth * (world.effects.growth->until - came.time);
}

/// Counts a strike of a ball, which is given as it was when it came. `growth`: the speed at which
/// the radii of the two grow.
template <int D, Known known, class Exactly>
inline void count_in_place(System<D, known>& system, Slot i, const Ball<D>& came, double approach,
                           double square, double growth, const Exactly& exactly) {
    Particle& particle = system.agenda[i];
    const double since = came.time - system.world.balls[i].time;
    const InPlace in_place = stayed_in_place(came, since, approach, square);
    const bool stayed = in_place == InPlace::yes || since <= no_time * came.time ||
                        (in_place == InPlace::uncertain && exactly());
    if (!stayed && !has_no_room(system, came, since, approach / std::sqrt(square), growth))
        [[likely]] {
        particle.in_place = 0;
    } else if (++particle.in_place >= (stayed ? system.most_in_place : most_without_room)) {
        system.collapses = true;
        particle.in_place = 0;
    }
}

}  // namespace signum::motion
