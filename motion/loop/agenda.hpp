#pragma once
/// The agenda: of every ball the one event that comes next, and which of all is the first.
///
/// The queue's key is the early end of an interval. An entry at the top whose time is not known to
/// the last bit is refined and put back; entries of equal time are in their order when they are
/// exact, and come after those that are not. So what happens is the first event in the exact order.

#include <algorithm>
#include <cstdint>
#include <tuple>

#include "../../core/large_array.hpp"
#include "../event_queue.hpp"
#include "../meeting.hpp"
#include "../partner.hpp"

namespace signum::motion {

/// What a ball strikes first, as far as it knows: when, and whom. It is stale when the partner has
/// struck something else meanwhile.
struct Proposal {
    double early = infinity;
    double late = infinity;
    Partner partner;
    std::uint32_t partner_strikes = 0;
};

/// What the loop knows of a ball, in a cache line.
struct alignas(64) Particle {
    Proposal next;
    double own = infinity;  ///< when the structure changes because of it
    double mass = 0.0;
    std::uint32_t strikes = 0;
    std::uint32_t in_place = 0;
    std::int32_t number = 0;
    std::uint32_t own_at_once = 0;  ///< events of the structure at one time
    /// Of all balls, when own_at_once was last found to be too many.
    std::uint32_t strikes_of_all = 0;
};

class Agenda {
 public:
    explicit Agenda(std::size_t balls) : particles_(balls), queue_(balls) {}

    [[nodiscard]] std::size_t size() const noexcept { return particles_.size(); }
    [[nodiscard]] Particle& operator[](Slot i) noexcept { return particles_[i]; }
    [[nodiscard]] const Particle& operator[](Slot i) const noexcept { return particles_[i]; }

    /// Whose event comes first, and not before when.
    [[nodiscard]] Slot top() { return queue_.top(Before{this}); }
    [[nodiscard]] double key(Slot i) const noexcept { return queue_.key(i); }
    /// A ball's next event has become another one.
    [[gnu::always_inline]] void settle(Slot i) {
        queue_.set(i, std::min(particles_[i].own, particles_[i].next.early), Before{this});
    }
    /// EventQueue::for_each_ahead.
    template <class Visit>
    void for_each_ahead(std::uint32_t& seen, std::uint32_t by, const Visit& visit) const {
        queue_.for_each_ahead(seen, by, visit);
    }

    [[nodiscard]] bool is_stale(const Proposal& p) const noexcept {
        return p.partner.is_ball() && particles_[p.partner.slot()].strikes != p.partner_strikes;
    }
    /// Of two exact proposals of a ball.
    [[nodiscard]] bool is_earlier(Slot i, const Proposal& p, const Proposal& q) const {
        return std::tuple(p.early, rank(i, p)) < std::tuple(q.early, rank(i, q));
    }

 private:
    /// The order of events at one time: ball before wall, then the smaller number, then the larger.
    [[nodiscard]] std::tuple<bool, std::int32_t, std::int32_t> rank(Slot i,
                                                                    const Proposal& p) const {
        const std::int32_t a = particles_[i].number;
        if (p.partner.is_wall()) return {true, a, p.partner.wall()};
        const std::int32_t b = particles_[p.partner.slot()].number;
        return {false, std::min(a, b), std::max(a, b)};
    }
    struct Before {
        const Agenda* agenda;
        bool operator()(Slot i, Slot j) const { return agenda->comes_before(i, j); }
    };
    /// Of two entries of equal key: those that are no exact strikes first.
    [[nodiscard]] bool comes_before(Slot i, Slot j) const {
        const auto is_exact = [this](Slot e) {
            const Proposal& next = particles_[e].next;
            return next.early == next.late && particles_[e].own > next.early &&
                   !next.partner.is_nobody();
        };
        const bool exact_i = is_exact(i);
        const bool exact_j = is_exact(j);
        if (exact_i != exact_j) return exact_j;
        if (!exact_i) return i < j;
        return std::tuple(rank(i, particles_[i].next), i) <
               std::tuple(rank(j, particles_[j].next), j);
    }

    LargeArray<Particle, Pages::large> particles_;
    EventQueue queue_;
};

}  // namespace signum::motion
