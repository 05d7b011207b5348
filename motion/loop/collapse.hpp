#pragma once
/// The rule for a collapse: a run ends when a ball has struck so many times in a row in place,
/// without room to grow, or ever faster in a gap that walls close.

#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>

#include "system.hpp"

namespace signum::motion {

inline constexpr std::uint32_t most_without_room = 10'000;
/// A strike that comes sooner after the last one than this part of the clock, some 2^7 of its
/// ticks, comes at once.
inline constexpr double no_time = 0x1p-45;
/// A gap is narrow where a ball flies no farther than this part of its radius from strike to
/// strike, and wide from that part on.
inline constexpr double narrow = 0x1p-8;
inline constexpr double wide = 0x1p-4;
/// A narrow gap is no room where balls would still grow by so many times its width.
inline constexpr double growth_to_a_jam = 16.0;

/// Counts a strike in a narrow gap, and whether the gap closes. Between walls that come to them
/// balls that lose nothing fly ever faster: N strikes in a row leave gaps as 1 / (N0 + N), and last
/// as long as 1 / N0 - 1 / (N0 + N). The second half of them comes to last no longer than the
/// quarter before when the gap is a third as wide; in a gas that is dense it lasts twice as long.
/// And who strikes so often within the duration of one contact is pressed by a heavy ball, or what
/// else there is, and loses nothing meanwhile.
[[nodiscard]] inline bool closes_on(Pressed& pressed, double t, double contact_duration) noexcept {
    constexpr std::uint32_t least_by_a_wall = 1 << 14;
    constexpr std::uint32_t least_in_a_contact = 1 << 18;
    if (!std::has_single_bit(++pressed.strikes)) [[likely]]
        return false;
    const bool closes =
        (pressed.by_wall && pressed.strikes >= least_by_a_wall &&
         t - pressed.half <= pressed.half - pressed.quarter) ||
        (pressed.strikes >= least_in_a_contact && t - pressed.quarter <= contact_duration);
    pressed.quarter = pressed.half;
    pressed.half = t;
    return closes;
}

/// Counts a strike of a ball where balls grow, walls move or contacts last, and returns whether
/// growth will have closed a narrow gap long before it ends. `by_wall`: whether it strikes a wall
/// that moves. A ball that hops on a floor flies as
/// short ways as in such a gap, but as slowly as it falls.
template <int D, Known known>
[[nodiscard, gnu::noinline]] bool count_in_gap(System<D, known>& system, Slot i,
                                               const Ball<D>& came, double speed, double growth,
                                               bool by_wall) {
    const World<D>& world = system.world;
    Pressed& pressed = system.pressed[i];
    const double since = came.time - std::exchange(pressed.last, came.time);
    const double radius = system.grown_radius(came);
    const double flown = speed * since;
    if (!(flown < wide * radius)) {
        pressed = {.last = came.time};
        return false;
    }
    pressed.by_wall |= by_wall;
    if (!(flown <= narrow * radius && narrow * speed >= world.pull * since)) return false;
    system.collapses |= closes_on(pressed, came.time, world.effects.contact_duration);
    const auto& grows = world.effects.growth;
    return grows && growth_to_a_jam * flown <= growth * (grows->until - came.time);
}

/// Counts a strike of a ball, which is given as it was when it came. `growth`: the speed at which
/// the radii of the two grow. `by_wall`: whether it strikes a wall that moves.
template <int D, Known known, class Exactly>
inline void count_in_place(System<D, known>& system, Slot i, const Ball<D>& came, double approach,
                           double square, double growth, const Exactly& exactly,
                           bool by_wall = false) {
    Particle& particle = system.agenda[i];
    const double since = came.time - system.world.balls[i].time;
    const InPlace in_place = stayed_in_place(came, since, approach, square);
    const bool stayed = in_place == InPlace::yes || since <= no_time * came.time ||
                        (in_place == InPlace::uncertain && exactly());
    const bool has_no_room =
        !system.pressed.empty() &&
        count_in_gap(system, i, came, approach / std::sqrt(square), growth, by_wall);
    if (!stayed && !has_no_room) [[likely]] {
        particle.in_place = 0;
    } else if (++particle.in_place >= (stayed ? system.most_in_place : most_without_room)) {
        system.collapses = true;
        particle.in_place = 0;
    }
}

}  // namespace signum::motion
