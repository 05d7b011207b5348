#pragma once
/// An inquiry: what one ball strikes first, of all partners that are proposed to it.

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>

#include "meetings.hpp"

namespace signum::motion {

/// What a ball strikes first, of those that have been considered.
template <int D>
struct Inquiry {
    Slot ball = 0;
    typename MeetingFilter<D>::Asker asker;
    Proposal best;
    Crowd crowd;
    bool asks_walls = false;  ///< but sides at rest, which are asked at once
};

/// The earlier of two proposals of a ball.
template <int D, Known known>
inline void take(System<D, known>& system, Slot i, Proposal candidate, Proposal& best) {
    if (candidate.late < best.early) {
        best = candidate;
    } else if (candidate.early <= best.late) {
        if (best.partner.is_nobody()) {
            best = candidate;
            return;
        }
        if (system.agenda.is_stale(best)) {
            // At its turn, not after either begins, the ball is asked again for all: others have
            // left out pairs with it since its turn would come before them. The candidate may turn
            // out to be later than these.
            best.early = std::min(best.early, candidate.early);
            return;
        }
        make_exact(system, i, best);
        make_exact(system, i, candidate);
        if (system.agenda.is_earlier(i, candidate, best)) best = candidate;
    }
}

template <int D, Known known>
inline void consider(System<D, known>& system, Slot i, Slot j, Meeting meeting, Proposal& best) {
    if (!(meeting.early <= best.late)) return;
    if (meeting.early == -infinity) [[unlikely]] {
        if (waits_for_turn(system, i, Partner::ball(j))) return;
        meeting = exactly(system, i, j);
        if (!(meeting.early <= best.late)) return;
    }
    if (meeting.early == infinity) return;
    const Particle& other = system.agenda[j];
    // The partner strikes something before, and is then asked again.
    if (meeting.early > other.next.late) return;
    Proposal candidate{meeting.early, meeting.late, Partner::ball(j), other.strikes};
    if (!system.passed.is_empty() && is_passed(system, i, candidate)) return;
    take(system, i, candidate, best);
}
template <int D, Known known>
inline void consider_all(System<D, known>& system, Inquiry<D>& inquiry) {
    Crowd& crowd = inquiry.crowd;
    const std::size_t size = std::exchange(crowd.size, 0);
    if (size == 0) return;
    Proposal& best = inquiry.best;
    // Most are never met. Written, and perhaps forgotten: which is anybody's guess.
    std::array<std::uint8_t, Crowd::capacity> met;
    std::size_t left = 0;
    for (std::size_t k = 0; k < size; ++k) {
        met[left] = static_cast<std::uint8_t>(k);
        left += static_cast<std::size_t>(crowd.early[k] < infinity);
    }
    // Those that may be the first of all; and where these turn out to strike others before, those
    // that may be the first of the rest.
    for (double latest = std::min(best.late, crowd.soonest); left > 0;) {
        double soonest = infinity;
        const std::size_t asked = std::exchange(left, 0);
        for (std::size_t m = 0; m < asked; ++m) {
            const std::size_t k = met[m];
            if (crowd.early[k] <= latest) {
                consider(system, inquiry.ball, crowd.who[k], {crowd.early[k], crowd.late[k]}, best);
            } else {
                met[left++] = static_cast<std::uint8_t>(k);
                soonest = std::min(soonest, crowd.late[k]);
            }
        }
        if (!(latest < best.late)) return;
        latest = std::min(best.late, soonest);
    }
}

template <int D, Known known>
inline void consider_wall(System<D, known>& system, Inquiry<D>& inquiry, Wall wall,
                          Meeting meeting) {
    const Slot i = inquiry.ball;
    Proposal& best = inquiry.best;
    if (!(meeting.early <= best.late)) return;
    if (meeting.early == -infinity) [[unlikely]] {
        ++system.counts.exact;
        const double t = system.walls.exact_meeting(system.world.balls[i], wall);
        meeting = {t, t};
    }
    if (meeting.early == infinity) return;
    Proposal candidate{meeting.early, meeting.late, Partner::wall(wall), 0};
    if (!system.passed.is_empty() && is_passed(system, i, candidate)) return;
    take(system, i, candidate, best);
}
/// A side of the box at rest.
template <int D, Known known>
inline void consider_side(System<D, known>& system, Inquiry<D>& inquiry, Wall wall) {
    const Box<D>& box = *system.world.effects.box;
    const double side = wall % 2 != 0 ? box.high[wall / 2] : box.low[wall / 2];
    consider_wall(system, inquiry, wall, inquiry.asker.meeting(wall, side));
}
template <int D, Known known>
inline void consider_walls(System<D, known>& system, Inquiry<D>& inquiry) {
    for (const Wall wall : system.walls.numbers()) {
        if (waits_for_turn(system, inquiry.ball, Partner::wall(wall))) continue;
        const double latest = std::min(inquiry.best.late, system.turn);
        const Meeting meeting = meeting_of(system, wall, inquiry.ball, inquiry.asker, latest);
        if (meeting.early <= latest) consider_wall(system, inquiry, wall, meeting);
    }
}

template <int D, Known known>
inline void open(System<D, known>& system, Inquiry<D>& inquiry, Slot i, const Proposal& best) {
    inquiry.ball = i;
    inquiry.asker = system.filter.asker(system.world.balls[i], system.now);
    inquiry.best = best;
    inquiry.asks_walls = false;
}
/// Of all walls, too.
template <int D, Known known>
inline void open(System<D, known>& system, Inquiry<D>& inquiry, Slot i) {
    open(system, inquiry, i, {});
    if constexpr (System<D, known>::has_walls())
        inquiry.asks_walls = !system.walls.numbers().empty();
    for (const Wall wall : system.sides) consider_side(system, inquiry, wall);
}
/// Asks the filter about those proposed.
template <int D, Known known>
inline void look(System<D, known>& system, Inquiry<D>& inquiry) {
    system.counts.checks += inquiry.crowd.size;
    if (inquiry.crowd.size > 0) inquiry.asker.meetings(system.world.balls.data(), inquiry.crowd);
}
/// Lets a ball know of another one, now or soon.
template <int D, Known known>
inline void propose(System<D, known>& system, Inquiry<D>& inquiry, Slot j) {
    inquiry.crowd.push(j);
    if (!inquiry.crowd.is_full()) [[likely]]
        return;
    look(system, inquiry);
    consider_all(system, inquiry);
}
template <int D, Known known>
inline void assign(System<D, known>& system, Inquiry<D>& inquiry, std::span<const Slot> list) {
    for (; list.size() > Crowd::capacity; list = list.subspan(Crowd::capacity)) {
        inquiry.crowd.assign(list.first(Crowd::capacity));
        look(system, inquiry);
        consider_all(system, inquiry);
    }
    inquiry.crowd.assign(list);
}
/// What was looked at is considered, and the first strike is the ball's proposal.
template <int D, Known known>
inline void close(System<D, known>& system, Inquiry<D>& inquiry) {
    consider_all(system, inquiry);
    if constexpr (System<D, known>::has_walls())
        if (inquiry.asks_walls) [[unlikely]]
            consider_walls(system, inquiry);
    system.agenda[inquiry.ball].next = inquiry.best;
    system.agenda.settle(inquiry.ball);
}

}  // namespace signum::motion
