#pragma once
/// The clock: a ball that flies too far from one double to the next is refused, with a sentence.

#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>

#include "system.hpp"

namespace signum::motion {

/// By so many margins of the structure a ball may fly.
inline constexpr double margins_to_fly = 0x1p50;

/// At time t a ball of speed v along an axis flies v 2^-53 t while an event is told late by a
/// rounding, and its place, x + v (t - T), is rounded by at most twice that and what the margin has
/// besides. Where v t is at most 2^50 margins all that is less than half a margin an axis.
template <int D, Known known>
inline void see_clock(System<D, known>& system, Slot i) noexcept {
    const World<D>& world = system.world;
    for (int k = 0; k < D; ++k)
        if (!(std::fabs(speed(world.balls[i], k, system.now, world.effects)) * system.now <=
              system.farthest)) [[unlikely]]
            system.late = Partner::ball(i);
}

template <int D, Known known>
[[noreturn, gnu::cold]] void refuse(const System<D, known>& system, Slot i) {
    throw std::range_error("ball " + std::to_string(system.agenda[i].number) + " at time " +
                           std::to_string(system.now) +
                           " flies too far from one double to the next; use slower balls, or a "
                           "shorter time");
}

/// Ends of a ball's projections change places with all others', at one time, at most; but after a
/// strike at that time anew.
template <int D, Known known>
inline void refuse_standstill(System<D, known>& system, Slot i) {
    Particle& particle = system.agenda[i];
    if (particle.own > system.now) [[likely]] {
        particle.own_at_once = 0;
    } else if (++particle.own_at_once > 1000 + 8 * system.agenda.size()) [[unlikely]] {
        const auto strikes = static_cast<std::uint32_t>(system.counts.strikes);
        if (std::exchange(particle.strikes_of_all, strikes) == strikes) refuse(system, i);
        particle.own_at_once = 0;
    }
}

/// Where balls fly so far from one tick of the clock to the next that those which meet are apart at
/// the rounded time.
template <int D, Known known>
inline void refuse_missed_strike(const System<D, known>& system, Slot i, Slot j, const Ball<D>& a,
                                 const Ball<D>& b, double square) {
    const double radii = system.grown_radius(a) + system.grown_radius(b);
    if (std::fabs(square - radii * radii) < 0x1p-10 * (radii * radii)) [[likely]]
        return;
    // Contacts that stand may overlap a little (waits()).
    const auto pair = system.pair_of(i, Partner::ball(j));
    if (system.kernel == Kernel::naive || system.contacts.has(pair)) return;
    throw std::range_error(
        "balls " + std::to_string(pair.first) + " and " + std::to_string(pair.second.code()) +
        " meet at time " + std::to_string(a.time) +
        ", but they fly too far from one double to the next for a strike then; use slower balls, "
        "or a shorter time");
}

/// The same of walls behind which there is room.
template <int D, Known known>
void refuse_missed_wall(const System<D, known>& system, Slot i, Wall wall, const Ball<D>& ball) {
    const double depth = system.walls.depth(ball, wall);
    if (depth == infinity) return;
    Ball<D> grown = ball;
    grown.radius = system.grown_radius(ball);
    if (std::fabs(system.walls.gap(grown, wall)) <= 0x1p-10 * depth) [[likely]]
        return;
    throw std::range_error("ball " + std::to_string(system.agenda[i].number) + " meets wall " +
                           std::to_string(wall) + " at time " + std::to_string(ball.time) +
                           ", but is too small beside what its place is rounded by; use a larger "
                           "radius, slower balls, or a shorter time");
}

}  // namespace signum::motion
