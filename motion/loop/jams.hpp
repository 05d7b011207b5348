#pragma once
/// Jams: strikes that would follow one another without end, instead of which contacts are solved
/// together.

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <set>
#include <vector>

#include "contacts.hpp"

namespace signum::motion {

/// Strikes one after the other, each of which would leave two in contact, need not come to an end:
/// with friction above 1 a ball in a corner is sent from one wall to the other and back. Fast ones
/// need not, in number: a light ball on a floor that a heavy one falls on goes to and fro between
/// the two. So shortly before that would end the run all stay in contact. But where no time is left
/// until the next step each pair waits after one slow strike.
template <int D, Known known>
[[nodiscard]] bool is_jammed(const System<D, known>& system, std::initializer_list<Slot> balls,
                             bool stays, double t) {
    constexpr std::uint32_t strikes_to_a_jam = 100;
    if (!system.laws.has_contacts() || t >= system.turn) return false;
    const std::uint32_t most = system.most_in_place;
    return std::ranges::any_of(balls, [&](Slot i) {
        const std::uint32_t count = system.agenda[i].in_place;
        return (stays && count > 0 && count % strikes_to_a_jam == 0) ||
               (count >= most - most / 10 && count < most);
    });
}

/// Instead of a strike all contacts that hang together with it are solved at once, as at the
/// beginning of a step. It counts as a strike in place, so that the next one is not the same.
/// Returns the balls that fly otherwise.
template <int D, Known known>
[[gnu::cold, gnu::noinline]] std::vector<Slot> settle_jam(System<D, known>& system, Slot i,
                                                          Partner partner, double t) {
    stand(system, i, partner);
    ++system.agenda[i].in_place;
    if (partner.is_ball()) ++system.agenda[partner.slot()].in_place;
    const std::set<std::int32_t> hanging = system.contacts.hanging_with(system.agenda[i].number);
    const auto takes = [&](const auto& pair) { return hanging.contains(pair.first); };
    std::vector<Slot> balls;
    for (const std::int32_t number : hanging) balls.push_back(system.slot_of(number));
    StrikeTally tally;
    for (const Slot j : balls) {
        system.world.balls[j] = system.arrive(j, t, tally);
        ++system.agenda[j].strikes;
    }
    react(system, system.steps.last(), system.turn - t, takes);
    for (const Slot j : balls) {
        system.put(j, system.world.balls[j]);
        release(system, j);
    }
    pass_contacts(system, takes);
    return balls;
}

}  // namespace signum::motion
