#pragma once
/// The broad phase: which pairs are asked when they meet. It holds the structure, and asks balls
/// about those that the structure proposes.
///
/// For every ball one proposal is kept, what it strikes first, as far as it knows: an interval that
/// contains the exact time, and the partner. The invariant: of two balls whose next strike is with
/// each other at t, one has a proposal that is at t or before. For when a ball is asked, all pairs
/// with it are, and a pair is left out only where the ball keeps an earlier one or the partner has
/// one that is surely earlier; and at that time, whatever becomes of it, the ball or the partner is
/// asked again. A proposal whose partner has struck something else meanwhile is stale, and found to
/// be so when its turn comes.

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <utility>

#include "../cells.hpp"
#include "clock.hpp"
#include "inquiry.hpp"

namespace signum::motion {

template <int D, template <int> class StructureOf, Known known>
class BroadPhase {
 public:
    BroadPhase(System<D, known>& system, Structure kind)
        : system_(system),
          kind_(kind),
          structure_(std::in_place, system.world, kind),
          // Of fewer balls all lies near the processor.
          fetches_(system.agenda.size() > 8192),
          width_(widest_now()) {
        system_.farthest = margins_to_fly * structure_->margin();
    }

    /// Finds anew what a ball strikes first.
    void ask(Slot i) {
        begin(inquiries_[0], i);
        close(system_, inquiries_[0]);
    }
    /// The same of balls that fly or lie otherwise than before.
    void ask_after_change(std::initializer_list<Slot> balls) {
        for (const Slot i : balls) {
            see_clock(system_, i);
            system_.agenda[i].own = structure_->next(i, system_.now);
            system_.agenda[i].next = {};
        }
        // What the second one needs is computed while the first one's is awaited.
        Inquiry<D>* inquiry = inquiries_.data();
        for (const Slot i : balls) begin(*inquiry++, i);
        inquiry = inquiries_.data();
        for (std::size_t k = 0; k < balls.size(); ++k) close(system_, *inquiry++);
    }
    /// The same of all balls.
    void ask_all() {
        begin_all(infinity);
        for (Slot i = 0; i < system_.agenda.size(); ++i)
            ask_once(i, [&](const auto& visit) { for_each_near_once(i, visit); });
    }
    /// The same at a turn, when all balls' own times are now. What comes after the next turn need
    /// not be known.
    void ask_all_until_turn() {
        NotedPairs<D>& noted = system_.noted;
        if (!system_.notes_pairs() || system_.world.effects.growth) {
            ask_all();
            return;
        }
        if (!noted.hold_until(system_.turn)) note_pairs();
        begin_all(system_.turn);
        const double way = noted.way_in(system_.turn - system_.now);
        for (Slot i = 0; i < system_.agenda.size(); ++i)
            ask_once(i, [&](const auto& visit) {
                for (const Slot j : noted.of(i))
                    if (j > i && !is_farther(i, j, way)) visit(j);
            });
    }

    /// The structure changes because of a ball; false where nothing meets any more, as far as that
    /// is looked for.
    [[nodiscard]] bool own_event(Slot i) {
        if (!system_.world.effects.box && --own_events_left_ == 0) [[unlikely]]
            // In a structure made anew the ball has no event now.
            return spread();
        Counts& counts = system_.counts;
        const double now = system_.now;
        ++counts.own;
        const std::uint64_t asked_before = counts.checks;
        Inquiry<D>& inquiry = inquiries_[0];
        open(system_, inquiry, i, system_.agenda[i].next);
        const auto propose_now = [&](Slot j) {
            propose(system_, inquiry, j);
            if (system_.notes_pairs() && system_.noted.hold_until(now)) [[unlikely]]
                system_.noted.add(i, j);
        };
        structure_->own_event(i, now, propose_now, [&](Slot j) { touch(j); });
        system_.agenda[i].own = structure_->next(i, now);
        refuse_standstill(system_, i);
        see_clock(system_, i);
        look(system_, inquiry);
        counts.own_checks += counts.checks - asked_before;
        close(system_, inquiry);
        if constexpr (requires { structure_->is_crowded(); })
            if (structure_->is_crowded()) [[unlikely]]
                make_anew();
        return true;
    }
    /// A ball flies too far. Of a structure made anew the margin is larger where balls have flown
    /// far apart.
    [[gnu::cold, gnu::noinline]] void relieve() {
        const Slot late = std::exchange(system_.late, Partner()).slot();
        const bool has_box = system_.world.effects.box.has_value();
        if (!has_box) make_anew();
        if (has_box || !system_.late.is_nobody()) refuse(system_, late);
    }

    /// Tells the processor what memory will be needed some events from now: of many balls it is far
    /// away. First the balls, then whom they may strike, then the lists of both.
    void fetch_ahead() {
        if constexpr (requires { structure_->list(Slot{}); }) {
            if (!fetches_) return;
            const auto partner_of = [&](Slot i) { return system_.agenda[i].next.partner; };
            system_.agenda.for_each_ahead(fetched_[0], 5, [&](Slot i) { fetch(i); });
            system_.agenda.for_each_ahead(fetched_[1], 3, [&](Slot i) {
                __builtin_prefetch(structure_->list(i).data());
                if (const Partner j = partner_of(i); j.is_ball()) fetch(j.slot());
            });
            system_.agenda.for_each_ahead(fetched_[2], 2, [&](Slot i) {
                fetch_list(i);
                if (const Partner j = partner_of(i); j.is_ball()) fetch_list(j.slot());
            });
        }
    }
    void sketch(Sketch<D>& sketch) const { structure_->sketch(system_.now, sketch); }

 private:
    static constexpr std::uint64_t own_events_a_ball = 16;

    void begin(Inquiry<D>& inquiry, Slot i) {
        open(system_, inquiry, i);
        if (system_.notes_pairs() && system_.noted.hold_until(system_.turn)) [[unlikely]] {
            assign(system_, inquiry, system_.noted.of(i));
        } else if constexpr (requires { structure_->list(i); }) {
            assign(system_, inquiry, structure_->list(i));
        } else {
            structure_->near(i, [&](Slot j) { propose(system_, inquiry, j); });
        }
        look(system_, inquiry);
    }
    void begin_all(double until) {
        for (Slot i = 0; i < system_.agenda.size(); ++i) {
            see_clock(system_, i);
            Particle& particle = system_.agenda[i];
            if constexpr (requires { structure_->next(i, until, until); })
                particle.own = structure_->next(i, system_.now, until);
            else
                particle.own = structure_->next(i, system_.now);
            particle.next = {};
        }
    }
    /// Each pair is asked once, whichever of the two it becomes a proposal of: when its time comes,
    /// the ball is asked for all pairs.
    template <class Source>
    void ask_once(Slot i, const Source& source) {
        Inquiry<D>& inquiry = inquiries_[0];
        open(system_, inquiry, i);
        source([&](Slot j) { propose(system_, inquiry, j); });
        look(system_, inquiry);
        close(system_, inquiry);
    }
    template <class Visit>
    void for_each_near_once(Slot i, const Visit& visit) const {
        const auto visit_later = [&](Slot j) {
            if (j > i) visit(j);
        };
        if constexpr (requires { structure_->list(i); })
            std::ranges::for_each(structure_->list(i), visit_later);
        else if constexpr (requires { structure_->near_once(i, visit); })
            structure_->near_once(i, visit);
        else
            structure_->near(i, visit_later);
    }
    /// Finds anew when the structure changes because of a ball.
    void touch(Slot i) {
        system_.agenda[i].own = structure_->next(i, system_.now);
        system_.agenda.settle(i);
    }

    /// A skin of some steps' way, as long as that is not far beside the balls.
    void note_pairs() {
        NotedPairs<D>& noted = system_.noted;
        noted.forget_speeds();
        for (const Ball<D>& ball : system_.world.balls) noted.fly(ball.v);
        const double way = noted.way_in(system_.turn - system_.now);
        const double skin = way + std::clamp(15.0 * way, 0.03 * apart_, 0.5 * apart_);
        noted.note(system_.now, skin, [&](Slot i, const auto& note) {
            for_each_near_once(i, [&](Slot j) {
                if (!is_farther(i, j, skin)) note(j);
            });
        });
    }
    /// Whether the surfaces of two balls are farther apart than that: a difference of doubles errs
    /// by 2^-53 of itself, and where an image is nearer by some units of the box's last place.
    [[nodiscard]] bool is_farther(Slot i, Slot j, double way) const noexcept {
        const World<D>& world = system_.world;
        const Ball<D>& a = world.balls[i];
        const Ball<D>& b = world.balls[j];
        Vector<D> d = a.x - b.x;
        const double square = world.nearest_square(d);
        double reach = (a.radius + b.radius + way) * (1.0 + 0x1p-40);
        if (world.effects.periodic)
            for (int k = 0; k < D; ++k) reach += 0x1p-40 * world.length[k];
        return square > reach * reach;
    }

    /// Balls that fly apart would cross ever more cells, or leave ever more shells, that were made
    /// when they were near one another: now and then the structure is made anew. False where
    /// nothing meets any more, as far as that is looked for.
    [[nodiscard]] bool spread() {
        constexpr std::size_t few = 2048;
        constexpr std::size_t most = 1 << 17;
        const std::size_t balls = system_.agenda.size();
        own_events_left_ = own_events_a_ball * balls;
        if (std::exchange(strikes_before_, system_.counts.strikes) != system_.counts.strikes) {
            quiet_rounds_ = 0;
        } else if (++quiet_rounds_, balls <= most && quiet_rounds_ > balls / few &&
                                        std::has_single_bit(quiet_rounds_)) {
            // As rarely as asking all pairs takes no longer than the rounds before.
            if (!any_meets(system_)) return false;
        }
        if (widest_now() > 2.0 * width_) make_anew();
        return true;
    }
    void make_anew() {
        width_ = widest_now();
        system_.world.start = system_.now;
        structure_.emplace(system_.world, kind_);
        system_.farthest = margins_to_fly * structure_->margin();
        system_.noted.forget();
        ask_all();
    }
    /// How far the balls are spread, along the axis where that is farthest.
    [[nodiscard]] double widest_now() const {
        double widest = 0.0;
        for (int k = 0; k < D; ++k) {
            double low = infinity;
            double high = -infinity;
            for (Slot i = 0; i < system_.agenda.size(); ++i) {
                const double x = system_.world.centre(i, system_.now)[k];
                low = std::min(low, x);
                high = std::max(high, x);
            }
            widest = std::max(widest, high - low);
        }
        return widest;
    }

    // Inline, for the compiler takes a call that does nothing but fetch for one that does nothing.
    [[gnu::always_inline]] void fetch(Slot i) const noexcept {
        __builtin_prefetch(&system_.world.balls[i]);
        __builtin_prefetch(&system_.agenda[i]);
        structure_->fetch(i);
    }
    [[gnu::always_inline]] void fetch_list(Slot i) const noexcept {
        for (const Slot j : structure_->list(i)) __builtin_prefetch(&system_.world.balls[j]);
    }

    System<D, known>& system_;
    std::array<Inquiry<D>, 2> inquiries_;
    Structure kind_;
    std::optional<StructureOf<D>> structure_;
    bool fetches_;
    std::array<std::uint32_t, 3> fetched_{};  // up to which bucket
    std::uint64_t own_events_left_ = own_events_a_ball * system_.agenda.size();
    std::uint64_t strikes_before_ = 0;
    std::uint64_t quiet_rounds_ = 0;
    double width_;
    double apart_ = Spread<D>(system_.world).edge_of(1.0);  // how far balls are from one another
};

}  // namespace signum::motion
