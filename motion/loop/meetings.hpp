#pragma once
/// When a ball meets a partner, behind the filter: which meetings count, and their exact times.

#include <cmath>
#include <utility>

#include "../exact_meeting.hpp"
#include "system.hpp"

namespace signum::motion {

template <int D, Known known>
[[gnu::cold, gnu::noinline]] Meeting exactly(System<D, known>& system, Slot i, Slot j) {
    World<D>& world = system.world;
    ++system.counts.exact;
    // It may have flown beyond the filter's bounds.
    system.filter.include(world.balls[j], system.now);
    const double t = exact_meeting(world.balls[i], world.balls[j], system.image(i, j, system.now),
                                   world.effects);
    return {t, t};
}
template <int D, Known known>
inline void make_exact(System<D, known>& system, Slot i, Proposal& p) {
    if (p.early == p.late) return;
    const double about = 0.5 * (p.early + p.late);
    const World<D>& world = system.world;
    const Ball<D>& ball = world.balls[i];
    const auto tell = [&](double refined, const auto& exact) {
        const bool tells = !std::isnan(refined);
        ++(tells ? system.counts.refined : system.counts.exact);
        p.early = p.late = tells ? refined : exact();
    };
    if (p.partner.is_wall()) {
        const Wall wall = p.partner.wall();
        tell(system.walls.refined_meeting(ball, wall, about),
             [&] { return system.walls.exact_meeting(ball, wall); });
        return;
    }
    // Now another image may be nearer than the one that will be struck.
    const Image<D> seen = system.image(i, p.partner.slot(), about);
    const Ball<D>& other = world.balls[p.partner.slot()];
    tell(refined_meeting(ball, other, seen, world.effects, about),
         [&] { return exact_meeting(ball, other, seen, world.effects); });
}

/// Of a wall that is none of the sides at rest. The filter knows nothing of meetings that were
/// passed.
template <int D, Known known>
[[nodiscard]] inline Meeting meeting_of(System<D, known>& system, Wall wall, Slot i,
                                        const typename System<D, known>::Asker& asker,
                                        double latest) {
    const double passed =
        system.passed.is_empty() ? -infinity : system.passed.until(i, Partner::wall(wall));
    if (passed == -infinity) return system.walls.meeting(wall, asker, latest);
    ++system.counts.exact;
    const double t = system.walls.next_meeting(system.world.balls[i], wall, passed);
    return {t, t};
}
template <int D, Known known>
[[nodiscard]] inline bool meets_wall(System<D, known>& system, Slot i,
                                     const typename System<D, known>::Asker& asker) {
    if constexpr (!System<D, known>::has_walls()) return false;
    for (const Wall wall : system.walls.numbers()) {
        Meeting meeting = meeting_of(system, wall, i, asker, infinity);
        if (meeting.early == -infinity)
            meeting.early = system.walls.exact_meeting(system.world.balls[i], wall);
        if (meeting.early < infinity) return true;
    }
    return false;
}
/// Whether anything meets any more, by asking all pairs.
template <int D, Known known>
[[nodiscard]] bool any_meets(System<D, known>& system) {
    if (system.turn < infinity) return true;
    Crowd crowd;
    for (Slot i = 0; i < system.agenda.size(); ++i) {
        const auto asker = system.filter.asker(system.world.balls[i], system.now);
        if (meets_wall(system, i, asker)) return true;
        for (Slot j = 0; j < i; ++j) {
            crowd.push(j);
            if (!crowd.is_full() && j + 1 < i) continue;
            asker.meetings(system.world.balls.data(), crowd);
            for (std::size_t k = std::exchange(crowd.size, 0); k-- > 0;) {
                if (crowd.early[k] == infinity) continue;
                if (crowd.early[k] > -infinity || exactly(system, i, crowd.who[k]).early < infinity)
                    return true;
            }
        }
    }
    return false;
}

/// A pair that is passed over until all are asked anew: when it meets is no question.
template <int D, Known known>
[[nodiscard]] inline bool waits_for_turn(const System<D, known>& system, Slot i,
                                         Partner partner) noexcept {
    return !system.passed.is_empty() && system.turn < infinity &&
           system.passed.until(i, partner) >= system.turn;
}
template <int D, Known known>
[[nodiscard]] inline bool is_passed(System<D, known>& system, Slot i, Proposal& candidate) {
    const double until = system.passed.until(i, candidate.partner);
    if (candidate.early > until) return false;
    // Then all are asked anew.
    if (until == system.turn) return true;
    make_exact(system, i, candidate);
    return candidate.early <= until;
}

}  // namespace signum::motion
