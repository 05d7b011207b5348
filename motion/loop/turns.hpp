#pragma once
/// Turns: what happens to all balls at once. Radii cease to grow, or a time step begins or ends.

#include <algorithm>

#include "contacts.hpp"

namespace signum::motion {

template <int D, Known known>
[[nodiscard]] inline bool growth_ends_next(const System<D, known>& system) noexcept {
    const auto& growth = system.world.effects.growth;
    return growth && growth->until == system.turn;
}
/// Of a turn and strikes at one time: radii cease to grow first, so that a state knows by its time
/// whether they do; and a step begins first that follows another one, so that nobody need be asked
/// between the two.
template <int D, Known known>
[[nodiscard]] inline bool is_before_strikes(const System<D, known>& system) noexcept {
    return growth_ends_next(system) || system.steps.follows();
}
/// Whether what happens then comes after a step that is to begin then.
template <int D, Known known>
[[nodiscard]] inline bool waits_for_step(const System<D, known>& system, double time) noexcept {
    return system.has_turns() && time == system.turn && is_before_strikes(system);
}
template <int D, Known known>
[[nodiscard]] inline bool is_turn_due(const System<D, known>& system, double until) noexcept {
    if (growth_ends_next(system)) return system.turn <= until;
    // The state between two steps is that before the next one begins.
    return system.steps.begins() ? system.turn < until : system.turn <= until;
}

template <int D, Known known>
void end_growth(System<D, known>& system) {
    World<D>& world = system.world;
    for (Ball<D>& ball : world.balls) ball.radius = grown_at(ball, system.turn, world.effects);
    world.effects.growth.reset();
    world.swelling = 1.0;
    system.filter = MeetingFilter<D>(world.effects, system.kernel);
    system.passed.clear();
}
template <int D, Known known>
void kick(System<D, known>& system) {
    TimeSteps<D>& steps = system.steps;
    const std::size_t balls = system.agenda.size();
    if (!steps.is_idle()) {
        for (Slot i = 0; i < balls; ++i) {
            Ball<D>& ball = system.world.balls[i];
            ball.v = steps.kicks().kicked(ball.x, ball.v, system.grown_radius(ball),
                                          system.agenda[i].mass);
            system.agenda[i].in_place = 0;
        }
        system.counts.predictions += steps.begins() ? balls : 0;
    }
    system.passed.clear();
    if (system.laws.has_contacts() && steps.begins())
        react(system, system.turn, steps.length(), all_contacts);
    steps.advance();
}
/// Then all balls are to be asked anew.
template <int D, Known known>
[[gnu::cold, gnu::noinline]] void take_turn(System<D, known>& system, double until) {
    system.now = std::max(system.now, system.turn);
    const std::size_t balls = system.agenda.size();
    StrikeTally tally;
    for (Slot i = 0; i < balls; ++i) system.world.balls[i] = system.arrive(i, system.turn, tally);
    if (growth_ends_next(system)) {
        end_growth(system);
    } else {
        kick(system);
        if (system.steps.begins() && is_turn_due(system, until)) kick(system);
    }
    for (Slot i = 0; i < balls; ++i) {
        ++system.agenda[i].strikes;
        system.filter.include(system.world.balls[i]);
        system.noted.fly(system.world.balls[i].v);
    }
    system.set_turn();
    // Between two steps nothing strikes, and whether a contact may wait is not in the state.
    if (system.laws.has_contacts() && !system.steps.begins()) pass_contacts(system, all_contacts);
}

}  // namespace signum::motion
