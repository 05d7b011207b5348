#pragma once
/// The loop: takes the earliest event, and proposes what may come next.
///
/// For every ball one proposal is kept, what it strikes first, as far as it knows: an interval that
/// contains the exact time, and the partner. The invariant: of two balls whose next strike is with
/// each other at t, one has a proposal that is at t or before. For when a ball is asked, all pairs
/// with it are, and a pair is left out only where the ball keeps an earlier one or the partner has
/// one that is surely earlier; and at that time, whatever becomes of it, the ball or the partner is
/// asked again. A proposal whose partner has struck something else meanwhile is stale, and found to
/// be so when its turn comes.
///
/// The queue's key is the interval's early end. An entry at the top whose time is not known to the
/// last bit is refined and put back; entries of equal time are in their order when they are exact,
/// and come after those that are not. So what happens is the first event in the exact order.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "apart.hpp"
#include "cells.hpp"
#include "effects/growth.hpp"
#include "engine.hpp"
#include "event_queue.hpp"
#include "exact_meeting.hpp"
#include "in_place.hpp"
#include "laws.hpp"
#include "meeting.hpp"
#include "naive_strike.hpp"
#include "noted_pairs.hpp"
#include "passed_meetings.hpp"
#include "simulation.hpp"
#include "sketch.hpp"
#include "standing_contacts.hpp"
#include "strike.hpp"
#include "time_steps.hpp"
#include "walls.hpp"
#include "world.hpp"

namespace signum::motion {

template <int D, template <int> class StructureOf, Known known = Known{}>
class Loop final : public Simulation<D>::Engine {
 public:
    /// `order`: the balls' numbers in the order in which memory shall hold them.
    Loop(Structure structure, const State<D>& state, const Effects<D>& effects, Kernel kernel,
         const std::vector<std::int32_t>& order)
        : world_{in_order(state.balls, order), in_flight(effects, state.time), state.time},
          kernel_(kernel),
          particles_(order.size()),
          filter_(world_.effects, kernel),
          walls_(world_.effects, kernel),
          kind_(structure),
          structure_(std::in_place, world_, kind_),
          farthest_(margins_to_fly * structure_->margin()),
          queue_(particles_.size()),
          // Of fewer balls all lies near the processor.
          fetches_(order.size() > 8192),
          most_in_place_(effects.restitution < 1.0 || effects.wall_restitution < 1.0 ||
                                 effects.gravity != Vector<D>{}
                             ? most_in_place_dissipative
                             : most_in_place_elastic),
          now_(state.time),
          laws_(effects, order.size()),
          steps_(effects, state.half_steps),
          passed_(order.size()) {
        for (Wall wall = 0; effects.box && !effects.periodic && wall < 2 * D; ++wall)
            if (!has_walls() || !walls_.has(wall)) sides_.push_back(wall);
        std::vector<Slot>& slots = slots_;
        slots.resize(particles_.size());
        for (Slot i = 0; i < slots.size(); ++i) {
            const auto number = static_cast<std::size_t>(order[i]);
            slots[number] = i;
            particles_[i].number = order[i];
            particles_[i].mass = state.masses[number];
            particles_[i].in_place = state.in_place[number];
        }
        laws_.set(state, slots);
        for (const StandingContact<D>& contact : state.contacts)
            contacts_.set({contact.a, contact.b}, {contact.push, contact.rub});
        for (const Passed& passed : state.passed) {
            passed_.pass(slots[static_cast<std::size_t>(passed.a)],
                         passed.b < 0 ? first_wall + static_cast<Slot>(-1 - passed.b)
                                      : slots[static_cast<std::size_t>(passed.b)],
                         passed.time);
        }
        for (const Ball<D>& ball : world_.balls) filter_.include(ball);
        set_turn();
        ask_all();
    }

    Outcome run(const Limits& limits, const typename Simulation<D>::Record& record) override {
        if (world_.balls.empty()) return {Ending::nothing, {}};
        constexpr std::uint32_t turns_between_questions = 4096;
        const double until = limits.until;
        std::uint64_t done = 0;
        std::uint32_t turns = 0;
        while (done < limits.strikes) {
            if (++turns % turns_between_questions == 0 && limits.stop && limits.stop())
                return {Ending::stopped, {}};
            if (late_ != nobody) [[unlikely]]
                relieve();
            const Slot i = queue_.top(before());
            const double key = queue_.key(i);
            if constexpr (has_turns()) {
                if (turn_ <= key && (turn_ < key || is_before_strikes()) && is_turn_due(until))
                    [[unlikely]] {
                    if (limits.stop && limits.stop()) return {Ending::stopped, {}};
                    take_turn(until);
                    continue;
                }
            }
            if (!(key <= until && key < infinity) || waits_for_step(key)) {
                if (until < infinity) now_ = std::max(now_, until);
                return {std::min(key, turn_) < infinity ? Ending::until : Ending::nothing, {}};
            }
            now_ = std::max(now_, key);
            if (fetches_) fetch_ahead();
            Proposal& next = particles_[i].next;
            if (particles_[i].own <= next.early) {
                if (!world_.effects.box && --own_events_left_ == 0) [[unlikely]] {
                    // In a structure made anew the ball has no event now.
                    if (spread()) continue;
                    if (until < infinity) now_ = until;
                    return {Ending::nothing, {}};
                }
                ++counts_.own;
                const std::uint64_t asked_before = counts_.checks;
                Inquiry& inquiry = inquiries_[0];
                open(inquiry, i, next);
                const auto propose_now = [&](Slot j) {
                    propose(inquiry, j);
                    if (notes_pairs() && noted_.hold_until(now_)) [[unlikely]]
                        noted_.add(i, j);
                };
                structure_->own_event(i, now_, propose_now, [&](Slot j) { touch(j); });
                particles_[i].own = structure_->next(i, now_);
                refuse_standstill(i);
                see_clock(i);
                look(inquiry);
                counts_.own_checks += counts_.checks - asked_before;
                end(inquiry);
                if constexpr (requires { structure_->is_crowded(); })
                    if (structure_->is_crowded()) [[unlikely]]
                        make_anew();
            } else if (is_stale(next)) {
                ++counts_.stale;
                ask(i);
            } else if (next.early < next.late) {
                make_exact(i, next);
                settle(i);
            } else {
                done += static_cast<std::uint64_t>(is_wall(next) ? strike_wall(i, record)
                                                                 : strike_ball(i, record));
                if (std::exchange(collapses_, false)) return {Ending::collapse, last_};
            }
        }
        return {Ending::strikes, {}};
    }

    [[nodiscard]] State<D> state() const override {
        const std::size_t n = particles_.size();
        State<D> state{now_,
                       std::vector<Ball<D>>(n),
                       std::vector<double>(n),
                       std::vector<std::uint32_t>(n),
                       {}};
        for (Slot i = 0; i < n; ++i) {
            const auto number = static_cast<std::size_t>(particles_[i].number);
            state.balls[number] = world_.balls[i];
            state.masses[number] = particles_[i].mass;
            state.in_place[number] = particles_[i].in_place;
        }
        for (Slot i = 0; i < n; ++i) {
            for (const auto& [j, time] : passed_.of(i)) {
                if (j < first_wall && particles_[j].number < particles_[i].number) continue;
                state.passed.push_back({particles_[i].number,
                                        j >= first_wall
                                            ? -1 - static_cast<std::int32_t>(j - first_wall)
                                            : particles_[j].number,
                                        time});
            }
        }
        std::ranges::sort(state.passed, {},
                          [](const Passed& each) { return std::pair(each.a, each.b); });
        if (laws_.has_friction()) state.spins.resize(n);
        if (laws_.has_duration()) state.last_strikes.resize(n);
        for (Slot i = 0; i < n; ++i) {
            const auto number = static_cast<std::size_t>(particles_[i].number);
            if (laws_.has_friction()) state.spins[number] = laws_.spin(i);
            if (laws_.has_duration()) state.last_strikes[number] = laws_.last_strike(i);
        }
        state.half_steps = steps_.half_steps();
        for (const auto& [pair, momenta] : contacts_.all())
            state.contacts.push_back({pair.first, pair.second, momenta.push, momenta.rub});
        return state;
    }
    [[nodiscard]] const Counts& counts() const override { return counts_; }
    [[nodiscard]] Sketch<D> sketch() const override {
        Sketch<D> sketch;
        structure_->sketch(now_, sketch);
        std::vector<std::int32_t> numbers;
        for (Slot i = 0; i < particles_.size(); ++i) {
            numbers.push_back(particles_[i].number);
            const Proposal& next = particles_[i].next;
            if (next.partner == nobody || is_stale(next)) continue;
            const auto partner = static_cast<std::int32_t>(next.partner);
            sketch.expected.push_back({static_cast<std::int32_t>(i),
                                       is_wall(next) ? -1 - wall_of(next) : partner, next.early});
        }
        put_in_order<D>(sketch, numbers, world_.effects);
        return sketch;
    }

 private:
    static constexpr Slot nobody = ~Slot{0};
    static constexpr Slot first_wall = nobody - (1 << 20);
    static constexpr std::uint32_t most_in_place_dissipative = 1000;
    static constexpr std::uint32_t most_without_room = 10'000;
    static constexpr std::uint32_t most_in_place_elastic = 100'000;
    /// A strike that comes sooner after the last one than this part of the clock, some 2^7 of its
    /// ticks, comes at once.
    static constexpr double no_time = 0x1p-45;
    /// A ball that flies no farther than this part of its radius has no room where balls grow, if
    /// they would still grow by so many times that way.
    static constexpr double no_room = 0x1p-8;
    static constexpr double growth_to_a_jam = 16.0;
    /// A point has no radius: it may overlap by 2^-40, a 256th of this part, of its largest
    /// coordinate, which is 2^13 roundings.
    static constexpr double of_places = 0x1p-32;
    /// After so many strikes in place contacts that should stand are solved together.
    static constexpr std::uint32_t strikes_to_a_jam = 100;

    using Asker = typename MeetingFilter<D>::Asker;

    struct Proposal {
        double early = infinity;
        double late = infinity;
        Slot partner = nobody;
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

    static Balls<D> in_order(const std::vector<Ball<D>>& balls,
                             const std::vector<std::int32_t>& order) {
        Balls<D> result;
        result.reserve(order.size());
        for (const std::int32_t number : order)
            result.push_back(balls[static_cast<std::size_t>(number)]);
        return result;
    }

    [[nodiscard]] static bool is_wall(const Proposal& p) noexcept {
        return p.partner >= first_wall && p.partner != nobody;
    }
    [[nodiscard]] bool is_stale(const Proposal& p) const noexcept {
        return p.partner < first_wall && particles_[p.partner].strikes != p.partner_strikes;
    }
    [[nodiscard]] static Wall wall_of(const Proposal& p) noexcept {
        return static_cast<Wall>(p.partner - first_wall);
    }

    /// The order of events at one time: ball before wall, then the smaller number, then the larger.
    [[nodiscard]] std::tuple<bool, std::int32_t, std::int32_t> rank(Slot i,
                                                                    const Proposal& p) const {
        if (is_wall(p)) return {true, particles_[i].number, wall_of(p)};
        const std::int32_t a = particles_[i].number;
        const std::int32_t b = particles_[p.partner].number;
        return {false, std::min(a, b), std::max(a, b)};
    }
    /// Of two entries of equal key: those that are no exact strikes first.
    [[nodiscard]] bool comes_before(Slot i, Slot j) const {
        const auto is_exact = [this](Slot e) {
            const Proposal& next = particles_[e].next;
            return next.early == next.late && particles_[e].own > next.early &&
                   next.partner != nobody;
        };
        const bool exact_i = is_exact(i);
        const bool exact_j = is_exact(j);
        if (exact_i != exact_j) return exact_j;
        if (!exact_i) return i < j;
        return std::tuple(rank(i, particles_[i].next), i) <
               std::tuple(rank(j, particles_[j].next), j);
    }
    [[nodiscard]] auto before() const {
        return [this](Slot i, Slot j) { return comes_before(i, j); };
    }

    /// Tells the processor what memory will be needed some events from now: of many balls it is far
    /// away. First the balls, then whom they may strike, then the lists of both.
    void fetch_ahead() {
        if constexpr (requires { structure_->list(Slot{}); }) {
            queue_.for_each_ahead(fetched_[0], 5, [&](Slot i) { fetch(i); });
            queue_.for_each_ahead(fetched_[1], 3, [&](Slot i) {
                __builtin_prefetch(structure_->list(i).data());
                if (const Slot j = particles_[i].next.partner; j < first_wall) fetch(j);
            });
            queue_.for_each_ahead(fetched_[2], 2, [&](Slot i) {
                fetch_list(i);
                if (const Slot j = particles_[i].next.partner; j < first_wall) fetch_list(j);
            });
        }
    }
    void fetch(Slot i) const noexcept {
        __builtin_prefetch(&world_.balls[i]);
        __builtin_prefetch(&particles_[i]);
        structure_->fetch(i);
    }
    void fetch_list(Slot i) const noexcept {
        for (const Slot j : structure_->list(i)) __builtin_prefetch(&world_.balls[j]);
    }

    void settle(Slot i) {
        queue_.set(i, std::min(particles_[i].own, particles_[i].next.early), before());
    }

    /// Balls that fly apart would cross ever more cells, or leave ever more shells, that were made
    /// when they were near one another: now and then the structure is made anew. False where
    /// nothing meets any more, as far as that is looked for.
    [[nodiscard]] bool spread() {
        constexpr std::size_t few = 2048;
        constexpr std::size_t most = 1 << 17;
        const std::size_t balls = particles_.size();
        own_events_left_ = own_events_a_ball * balls;
        if (std::exchange(strikes_before_, counts_.strikes) != counts_.strikes) {
            quiet_rounds_ = 0;
        } else if (++quiet_rounds_, balls <= most && quiet_rounds_ > balls / few &&
                                        std::has_single_bit(quiet_rounds_)) {
            // As rarely as asking all pairs takes no longer than the rounds before.
            if (!any_meets()) return false;
        }
        if (widest_now() > 2.0 * width_) make_anew();
        return true;
    }
    void make_anew() {
        width_ = widest_now();
        world_.start = now_;
        structure_.emplace(world_, kind_);
        farthest_ = margins_to_fly * structure_->margin();
        noted_.forget();
        ask_all();
    }
    /// How far the balls are spread, along the axis where that is farthest.
    [[nodiscard]] double widest_now() const {
        double widest = 0.0;
        for (int k = 0; k < D; ++k) {
            double low = infinity;
            double high = -infinity;
            for (Slot i = 0; i < particles_.size(); ++i) {
                const double x = world_.centre(i, now_)[k];
                low = std::min(low, x);
                high = std::max(high, x);
            }
            widest = std::max(widest, high - low);
        }
        return widest;
    }
    [[nodiscard]] bool any_meets() {
        if (turn_ < infinity) return true;
        Crowd crowd;
        for (Slot i = 0; i < particles_.size(); ++i) {
            const Asker asker = filter_.asker(world_.balls[i], now_);
            if (meets_wall(i, asker)) return true;
            for (Slot j = 0; j < i; ++j) {
                crowd.push(j);
                if (!crowd.is_full() && j + 1 < i) continue;
                asker.meetings(world_.balls.data(), crowd);
                for (std::size_t k = std::exchange(crowd.size, 0); k-- > 0;) {
                    if (crowd.early[k] == infinity) continue;
                    if (crowd.early[k] > -infinity || exactly(i, crowd.who[k]).early < infinity)
                        return true;
                }
            }
        }
        return false;
    }

    [[nodiscard]] bool meets_wall(Slot i, const Asker& asker) {
        if constexpr (!has_walls()) return false;
        for (const Wall wall : walls_.numbers()) {
            Meeting meeting = meeting_of(wall, i, asker, infinity);
            if (meeting.early == -infinity) meeting.early = exactly_at(world_.balls[i], wall);
            if (meeting.early < infinity) return true;
        }
        return false;
    }

    /// Finds anew when the structure changes because of a ball.
    void touch(Slot i) {
        particles_[i].own = structure_->next(i, now_);
        settle(i);
    }

    /// Finds anew what a ball strikes first.
    void ask(Slot i) {
        begin(inquiries_[0], i);
        end(inquiries_[0]);
    }
    /// The same of balls that fly or lie otherwise than before.
    void ask_after_change(std::initializer_list<Slot> balls) {
        for (const Slot i : balls) {
            see_clock(i);
            particles_[i].own = structure_->next(i, now_);
            particles_[i].next = {};
        }
        // What the second one needs is computed while the first one's is awaited.
        Inquiry* inquiry = inquiries_.data();
        for (const Slot i : balls) begin(*inquiry++, i);
        inquiry = inquiries_.data();
        for (std::size_t k = 0; k < balls.size(); ++k) end(*inquiry++);
    }

    /// The same of all balls.
    void ask_all() {
        begin_all(infinity);
        for (Slot i = 0; i < particles_.size(); ++i)
            ask_once(i, [&](const auto& propose) { for_each_near_once(i, propose); });
    }
    /// The same at a turn, when all balls' own times are now. What comes after the next turn need
    /// not be known.
    void ask_all_until_turn() {
        if (!notes_pairs() || world_.effects.growth) {
            ask_all();
            return;
        }
        if (!noted_.hold_until(turn_)) note_pairs();
        begin_all(turn_);
        const double way = noted_.way_in(turn_ - now_);
        for (Slot i = 0; i < particles_.size(); ++i)
            ask_once(i, [&](const auto& propose) {
                for (const Slot j : noted_.of(i))
                    if (j > i && !is_farther(i, j, way)) propose(j);
            });
    }
    void begin_all(double until) {
        for (Slot i = 0; i < particles_.size(); ++i) {
            see_clock(i);
            if constexpr (requires { structure_->next(i, now_, until); })
                particles_[i].own = structure_->next(i, now_, until);
            else
                particles_[i].own = structure_->next(i, now_);
            particles_[i].next = {};
        }
    }
    /// Each pair is asked once, whichever of the two it becomes a proposal of: when its time comes,
    /// the ball is asked for all pairs.
    template <class Source>
    void ask_once(Slot i, const Source& source) {
        Inquiry& inquiry = inquiries_[0];
        open(inquiry, i);
        source([&](Slot j) { propose(inquiry, j); });
        look(inquiry);
        end(inquiry);
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
    /// A skin of some steps' way, as long as that is not far beside the balls.
    void note_pairs() {
        noted_.forget_speeds();
        for (const Ball<D>& ball : world_.balls) noted_.fly(ball.v);
        const double way = noted_.way_in(turn_ - now_);
        const double skin = way + std::clamp(15.0 * way, 0.03 * apart_, 0.5 * apart_);
        noted_.note(now_, skin, [&](Slot i, const auto& note) {
            for_each_near_once(i, [&](Slot j) {
                if (!is_farther(i, j, skin)) note(j);
            });
        });
    }
    /// Whether the surfaces of two balls are farther apart than that: a difference of doubles errs
    /// by 2^-53 of itself, and where an image is nearer by some units of the box's last place.
    [[nodiscard]] bool is_farther(Slot i, Slot j, double way) const noexcept {
        const Ball<D>& a = world_.balls[i];
        const Ball<D>& b = world_.balls[j];
        Vector<D> d;
        for (int k = 0; k < D; ++k) d[k] = a.x[k] - b.x[k];
        const double square = world_.nearest_square(d);
        double reach = (a.radius + b.radius + way) * (1.0 + 0x1p-40);
        if (world_.effects.periodic)
            for (int k = 0; k < D; ++k) reach += 0x1p-40 * world_.length[k];
        return square > reach * reach;
    }

    /// What a ball strikes first, of those that have been considered.
    struct Inquiry {
        Slot ball = nobody;
        Asker asker;
        Proposal best;
        Crowd crowd;
        bool asks_walls = false;  ///< but sides at rest, which are asked at once
    };
    void open(Inquiry& inquiry, Slot i, const Proposal& best) {
        inquiry.ball = i;
        inquiry.asker = filter_.asker(world_.balls[i], now_);
        inquiry.best = best;
        inquiry.asks_walls = false;
    }
    /// Of all walls, too.
    void open(Inquiry& inquiry, Slot i) {
        open(inquiry, i, {});
        if constexpr (has_walls()) inquiry.asks_walls = !walls_.numbers().empty();
        for (const Wall wall : sides_) consider_side(inquiry, wall);
    }
    void begin(Inquiry& inquiry, Slot i) {
        open(inquiry, i);
        if (notes_pairs() && noted_.hold_until(turn_)) [[unlikely]] {
            assign(inquiry, noted_.of(i));
        } else if constexpr (requires { structure_->list(i); }) {
            assign(inquiry, structure_->list(i));
        } else {
            structure_->near(i, [&](Slot j) { propose(inquiry, j); });
        }
        look(inquiry);
    }
    void assign(Inquiry& inquiry, std::span<const Slot> list) {
        for (; list.size() > Crowd::capacity; list = list.subspan(Crowd::capacity)) {
            inquiry.crowd.assign(list.first(Crowd::capacity));
            look(inquiry);
            consider_all(inquiry);
        }
        inquiry.crowd.assign(list);
    }
    void end(Inquiry& inquiry) {
        consider_all(inquiry);
        if constexpr (has_walls())
            if (inquiry.asks_walls) [[unlikely]]
                consider_walls(inquiry);
        particles_[inquiry.ball].next = inquiry.best;
        settle(inquiry.ball);
    }
    /// Lets a ball know of another one, now or soon.
    void propose(Inquiry& inquiry, Slot j) {
        inquiry.crowd.push(j);
        if (!inquiry.crowd.is_full()) [[likely]]
            return;
        look(inquiry);
        consider_all(inquiry);
    }
    void look(Inquiry& inquiry) {
        counts_.checks += inquiry.crowd.size;
        if (inquiry.crowd.size > 0) inquiry.asker.meetings(world_.balls.data(), inquiry.crowd);
    }
    void consider_all(Inquiry& inquiry) {
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
        // Those that may be the first of all; and where these turn out to strike others before,
        // those that may be the first of the rest.
        for (double latest = std::min(best.late, crowd.soonest); left > 0;) {
            double soonest = infinity;
            const std::size_t asked = std::exchange(left, 0);
            for (std::size_t m = 0; m < asked; ++m) {
                const std::size_t k = met[m];
                if (crowd.early[k] <= latest) {
                    consider(inquiry.ball, crowd.who[k], {crowd.early[k], crowd.late[k]}, best);
                } else {
                    met[left++] = static_cast<std::uint8_t>(k);
                    soonest = std::min(soonest, crowd.late[k]);
                }
            }
            if (!(latest < best.late)) return;
            latest = std::min(best.late, soonest);
        }
    }
    void consider(Slot i, Slot j, Meeting meeting, Proposal& best) {
        if (!(meeting.early <= best.late)) return;
        if (meeting.early == -infinity) [[unlikely]] {
            if (waits_for_turn(i, j)) return;
            meeting = exactly(i, j);
            if (!(meeting.early <= best.late)) return;
        }
        if (meeting.early == infinity) return;
        // The partner strikes something before, and is then asked again.
        if (meeting.early > particles_[j].next.late) return;
        Proposal candidate{meeting.early, meeting.late, j, particles_[j].strikes};
        if (!passed_.is_empty() && is_passed(i, candidate)) return;
        take(i, candidate, best);
    }
    void consider_side(Inquiry& inquiry, Wall wall) {
        const Box<D>& box = *world_.effects.box;
        const double side = wall % 2 != 0 ? box.high[wall / 2] : box.low[wall / 2];
        consider_wall(inquiry, wall, inquiry.asker.meeting(wall, side));
    }
    void consider_walls(Inquiry& inquiry) {
        for (const Wall wall : walls_.numbers()) {
            if (waits_for_turn(inquiry.ball, first_wall + static_cast<Slot>(wall))) continue;
            const double latest = std::min(inquiry.best.late, turn_);
            const Meeting meeting = meeting_of(wall, inquiry.ball, inquiry.asker, latest);
            if (meeting.early <= latest) consider_wall(inquiry, wall, meeting);
        }
    }
    /// A pair that is passed over until all are asked anew: when it meets is no question.
    [[nodiscard]] bool waits_for_turn(Slot i, Slot partner) const noexcept {
        return !passed_.is_empty() && turn_ < infinity && passed_.until(i, partner) >= turn_;
    }
    /// Of a wall that is none of the sides at rest. The filter knows nothing of meetings that were
    /// passed.
    [[nodiscard]] Meeting meeting_of(Wall wall, Slot i, const Asker& asker, double latest) {
        const double passed =
            passed_.is_empty() ? -infinity : passed_.until(i, first_wall + static_cast<Slot>(wall));
        if (passed == -infinity) return walls_.meeting(wall, asker, latest);
        ++counts_.exact;
        const double t = walls_.next_meeting(world_.balls[i], wall, passed);
        return {t, t};
    }
    void consider_wall(Inquiry& inquiry, Wall wall, Meeting meeting) {
        const Slot i = inquiry.ball;
        Proposal& best = inquiry.best;
        if (!(meeting.early <= best.late)) return;
        if (meeting.early == -infinity) [[unlikely]] {
            ++counts_.exact;
            const double t = exactly_at(world_.balls[i], wall);
            meeting = {t, t};
        }
        if (meeting.early == infinity) return;
        Proposal candidate{meeting.early, meeting.late, first_wall + static_cast<Slot>(wall), 0};
        if (!passed_.is_empty() && is_passed(i, candidate)) return;
        take(i, candidate, best);
    }
    [[nodiscard]] bool is_side(Wall wall) const noexcept {
        return !has_walls() || walls_.numbers().empty() || !walls_.has(wall);
    }
    [[nodiscard]] double exactly_at(const Ball<D>& ball, Wall wall) const {
        return is_side(wall) ? exact_meeting(ball, wall, world_.effects)
                             : walls_.exact_meeting(ball, wall);
    }
    [[nodiscard]] double refined_at(const Ball<D>& ball, Wall wall, double about) const {
        return is_side(wall) ? refined_meeting(ball, wall, world_.effects, about)
                             : walls_.refined_meeting(ball, wall, about);
    }
    /// The earlier of two proposals of a ball.
    void take(Slot i, Proposal candidate, Proposal& best) {
        if (candidate.late < best.early) {
            best = candidate;
        } else if (candidate.early <= best.late) {
            if (best.partner == nobody) {
                best = candidate;
                return;
            }
            if (is_stale(best)) {
                // At its turn, not after either begins, the ball is asked again for all: others
                // have left out pairs with it since its turn would come before them. The candidate
                // may turn out to be later than these.
                best.early = std::min(best.early, candidate.early);
                return;
            }
            make_exact(i, best);
            make_exact(i, candidate);
            if (std::tuple(candidate.early, rank(i, candidate)) <
                std::tuple(best.early, rank(i, best)))
                best = candidate;
        }
    }

    /// The nearest image of a pair at a time.
    [[nodiscard]] Image<D> image(Slot i, Slot j, double t) const {
        return nearest_image(world_.centre(i, t), world_.centre(j, t), world_.effects);
    }
    [[gnu::cold, gnu::noinline]] Meeting exactly(Slot i, Slot j) {
        ++counts_.exact;
        // It may have flown beyond the filter's bounds.
        filter_.include(world_.balls[j], now_);
        const double t =
            exact_meeting(world_.balls[i], world_.balls[j], image(i, j, now_), world_.effects);
        return {t, t};
    }
    void make_exact(Slot i, Proposal& p) {
        if (p.early == p.late) return;
        const double about = 0.5 * (p.early + p.late);
        const Ball<D>& ball = world_.balls[i];
        const auto tell = [&](double refined, const auto& exact) {
            const bool tells = !std::isnan(refined);
            ++(tells ? counts_.refined : counts_.exact);
            p.early = p.late = tells ? refined : exact();
        };
        if (is_wall(p)) {
            tell(refined_at(ball, wall_of(p), about), [&] { return exactly_at(ball, wall_of(p)); });
            return;
        }
        // Now another image may be nearer than the one that will be struck.
        const Image<D> seen = image(i, p.partner, about);
        const Ball<D>& other = world_.balls[p.partner];
        tell(refined_meeting(ball, other, seen, world_.effects, about),
             [&] { return exact_meeting(ball, other, seen, world_.effects); });
    }

    bool strike_ball(Slot i, const typename Simulation<D>::Record& record) {
        const Slot j = particles_[i].next.partner;
        const double t = particles_[i].next.early;
        StrikeTally tally;
        Ball<D> a = arrive(i, t, tally);
        Ball<D> b = arrive(j, t, tally);
        const Image<D> seen = nearest_image(a.x, b.x, world_.effects);
        const Ball<D> a_before = a;
        const Ball<D> b_before = b;
        Law law{world_.effects.restitution, 0.0};
        Facts facts;
        if (!laws_.is_plain()) [[unlikely]] {
            if (world_.effects.growth)
                law.growth = growth_of(a, world_.effects) + growth_of(b, world_.effects);
            facts = facts_of(a, b, seen, law.growth);
            const auto bounce = laws_.bounce({i, j}, t, law.restitution, facts.approach);
            law.restitution = bounce.restitution;
            facts.stays = bounce.stays;
            facts.rubs = bounce.rubs;
            facts.jams = is_jammed({i, j}, facts.stays, t);
        }
        Exchange exchange;
        const double mass_a = particles_[i].mass;
        const double mass_b = particles_[j].mass;
        if (kernel_ == Kernel::exact)
            exchange = strike(a, b, seen, mass_a, mass_b, law, world_.effects, tally);
        else
            exchange = naive::strike(a, b, seen, mass_a, mass_b, law, world_.effects);
        counts_.rounded += tally.refined;
        counts_.rounded_exactly += tally.exact;
        refuse_missed_strike(i, j, a, b, exchange.square);
        if (facts.stays) [[unlikely]]
            if (waits(i, j, t, facts.approach, facts.distance - (a.radius + b.radius)))
                exchange.struck = false;
        if (facts.jams && exchange.struck) [[unlikely]]
            return settle_jam(i, j, t);
        if (!exchange.struck) {
            passed_.pass(i, j, facts.stays ? std::max(t, turn_) : t);
            if (facts.stays) stand(i, j);
            ask(i);
            return false;
        }
        counts_.virial += exchange.virial;
        const std::int32_t first = std::min(particles_[i].number, particles_[j].number);
        const std::int32_t second = std::max(particles_[i].number, particles_[j].number);
        last_ = {t, false, first, second, 0.0};
        if (record) {
            last_.impulse =
                impulse(a_before, b_before, seen, mass_a, mass_b, law, world_.effects, tally);
            record(last_);
        }
        ++counts_.strikes;
        ++particles_[i].strikes;
        ++particles_[j].strikes;
        count(i, a_before, exchange.approach, exchange.square, law.growth, [&] {
            return stayed_in_place_exactly(a_before, b_before, seen, world_.effects,
                                           world_.balls[i].time);
        });
        count(j, b_before, exchange.approach, exchange.square, law.growth, [&] {
            // D and V of the pair, whichever comes first.
            Image<D> back;
            for (int k = 0; k < D; ++k) back[k] = -seen[k];
            return stayed_in_place_exactly(b_before, a_before, back, world_.effects,
                                           world_.balls[j].time);
        });
        if (!laws_.is_plain()) [[unlikely]] {
            if (facts.rubs) {
                // Sums and products of doubles depend on their order: it is that of the balls'
                // numbers.
                const double push = (1.0 + law.restitution) * facts.approach *
                                    (mass_a * mass_b / (mass_a + mass_b));
                Slider<D> first{a.v, laws_.spin(i), grown_radius(a), mass_a};
                Slider<D> second{b.v, laws_.spin(j), grown_radius(b), mass_b};
                if (particles_[i].number < particles_[j].number) {
                    slide<D>(first, second, facts.normal, facts.sliding, push,
                             *world_.effects.friction);
                } else {
                    for (double& each : facts.normal) each = -each;
                    for (double& each : facts.sliding) each = -each;
                    slide<D>(second, first, facts.normal, facts.sliding, push,
                             *world_.effects.friction);
                }
            }
            laws_.struck(i, t);
            laws_.struck(j, t);
        }
        put(i, a);
        put(j, b);
        if (facts.stays) stand(i, j);
        release(i);
        release(j);
        ask_after_change({i, j});
        return true;
    }
    bool strike_wall(Slot i, const typename Simulation<D>::Record& record) {
        const Wall wall = wall_of(particles_[i].next);
        const double t = particles_[i].next.early;
        StrikeTally tally;
        Ball<D> ball = arrive(i, t, tally);
        const Ball<D> ball_before = ball;
        const double mass = particles_[i].mass;
        last_ = {t, true, particles_[i].number, wall, 0.0};
        Law law{world_.effects.wall_restitution, 0.0};
        if (!laws_.is_plain() || !is_side(wall)) [[unlikely]]
            return strike_surface(i, wall, ball, record);
        if (!strike(ball, wall, law)) return rests(i, wall, t, is_pulled_to(wall));
        if (record) {
            last_.impulse = impulse(ball_before, wall, mass, law);
            record(last_);
        }
        ++counts_.strikes;
        ++particles_[i].strikes;
        count(i, ball_before, std::fabs(ball_before.v[wall / 2]), 1.0, 0.0,
              [&] { return stayed_in_place_exactly(ball_before, wall, world_.balls[i].time); });
        put(i, ball);
        release(i);
        ask_after_change({i});
        return true;
    }
    /// Any wall, by any law.
    [[gnu::cold, gnu::noinline]] bool strike_surface(Slot i, Wall wall, const Ball<D>& came,
                                                     const typename Simulation<D>::Record& record) {
        const double t = came.time;
        Ball<D> ball = came;
        const double mass = particles_[i].mass;
        const Facing<D> faces = is_side(wall) ? facing_side<D>(wall) : walls_.facing(ball, wall);
        const double growth = growth_of(ball, world_.effects);
        const double approach = laws_.is_plain() ? 0.0 : approach_of(ball, faces, growth);
        const auto bounce = laws_.bounce({i}, t, world_.effects.wall_restitution, approach);
        WallExchange exchange = strike(ball, faces, mass, bounce.restitution, growth);
        const Slot partner = first_wall + static_cast<Slot>(wall);
        if (!is_side(wall) && kernel_ == Kernel::exact && !contacts_.has(numbers_of(i, partner)))
            refuse_missed_wall(i, wall, came);
        if (bounce.stays) {
            const Hollow hollow = hollow_of(came, faces, wall);
            if (waits(i, partner, t, approach + hollow.approach, walls_.gap(came, wall))) {
                exchange.struck = false;
            } else if (hollow.approach > 0.0) {
                turn_inwards(ball, hollow);
                exchange.struck = true;
            }
        }
        if (exchange.struck && is_jammed({i}, bounce.stays, t)) return settle_jam(i, partner, t);
        if (!exchange.struck) {
            if (bounce.stays) {
                passed_.pass(i, partner, std::max(t, turn_));
                stand(i, partner);
                ask(i);
                return false;
            }
            return rests(i, wall, t,
                         is_side(wall) ? is_pulled_to(wall) : walls_.bends_down(came, wall));
        }
        if (record) {
            last_.impulse = exchange.impulse;
            record(last_);
        }
        ++counts_.strikes;
        ++particles_[i].strikes;
        count(i, came, exchange.approach, exchange.square, growth,
              [&] { return stayed_in_place_exactly(came, faces, growth, world_.balls[i].time); });
        if (bounce.rubs) {
            Vector<D> sliding = came.v;
            const Vector<D> velocity = walls_.velocity(wall, t);
            for (int k = 0; k < D; ++k) sliding[k] -= velocity[k];
            slide<D>({ball.v, laws_.spin(i), grown_radius(ball), mass}, unit_normal(faces), sliding,
                     exchange.impulse, *world_.effects.friction);
        }
        laws_.struck(i, t);
        put(i, ball);
        if (bounce.stays) stand(i, partner);
        release(i);
        ask_after_change({i});
        return true;
    }
    /// A flight along a hollow wall until the next step.
    struct Hollow {
        double approach = 0.0;  ///< the mean speed at which it would enter; 0 where it does not
        double turn = 0.0;      ///< the sine of the angle by which a chord parts from it
        Vector<D> normal{};
        Vector<D> wall_velocity{};
    };
    [[nodiscard]] Hollow hollow_of(const Ball<D>& ball, const Facing<D>& faces, Wall wall) const {
        const double curvature = walls_.curvature(ball, wall);
        if (!(curvature > 0.0)) return {};
        Hollow hollow{0.0, 0.0, unit_normal(faces), walls_.velocity(wall, ball.time)};
        const double speed =
            StandingContacts<D>::speed_along(ball.v, hollow.wall_velocity, hollow.normal);
        const double length = speed * (turn_ - ball.time);
        hollow.turn = StandingContacts<D>::sine_inwards(curvature, length);
        hollow.approach = 0.5 * curvature * length * speed;
        return hollow;
    }
    /// Makes it a chord, as fast.
    static void turn_inwards(Ball<D>& ball, const Hollow& hollow) noexcept {
        Vector<D> v = ball.v;
        for (int k = 0; k < D; ++k) v[k] -= hollow.wall_velocity[k];
        const double parting = dot(v, hollow.normal);
        const double speed =
            StandingContacts<D>::speed_along(ball.v, hollow.wall_velocity, hollow.normal);
        const double ahead = std::sqrt(1.0 - hollow.turn * hollow.turn);
        for (int k = 0; k < D; ++k)
            ball.v[k] = hollow.wall_velocity[k] + ahead * (v[k] - parting * hollow.normal[k]) +
                        hollow.turn * speed * hollow.normal[k];
    }
    [[nodiscard]] bool is_pulled_to(Wall side) const noexcept {
        const double g = world_.effects.gravity[side / 2];
        return side % 2 != 0 ? g > 0.0 : g < 0.0;
    }
    /// A ball that comes to a wall, and is not changed. Where the gap between them bends down it
    /// lies on it, and would go through.
    [[nodiscard]] bool rests(Slot i, Wall wall, double t, bool bends_down) {
        collapses_ = bends_down;
        if (collapses_) return false;
        passed_.pass(i, first_wall + static_cast<Slot>(wall), t);
        ask(i);
        return false;
    }
    void put(Slot i, const Ball<D>& ball) {
        world_.balls[i] = ball;
        filter_.include(ball);
        if (notes_pairs()) [[unlikely]]
            noted_.fly(ball.v);
    }
    /// What a ball was not to strike it may strike now, but for those in contact that wait.
    void release(Slot i) {
        if (passed_.is_empty()) return;
        if (!laws_.has_contacts()) {
            passed_.release(i);
            return;
        }
        const auto passed = passed_.of(i);
        std::vector<Slot> waiting;
        for (const auto& [partner, until] : passed)
            if (until >= turn_ && waits_still(i, partner)) waiting.push_back(partner);
        passed_.release(i);
        for (const Slot partner : waiting) passed_.pass(i, partner, turn_);
    }
    [[nodiscard]] double grown_radius(const Ball<D>& ball) const noexcept {
        return ball.radius + growth_of(ball, world_.effects) * ball.time;
    }

    /// What laws that are not rational go by: doubles, each operation rounded once.
    struct Facts {
        Vector<D> normal{};   ///< from b to a
        Vector<D> sliding{};  ///< v_a - v_b
        double distance = 0.0;
        double approach = 0.0;
        bool stays = false;
        bool rubs = false;
        bool jams = false;
    };
    [[nodiscard]] Facts facts_of(const Ball<D>& a, const Ball<D>& b, const Image<D>& seen,
                                 double growth = 0.0) const {
        Facts facts;
        for (int k = 0; k < D; ++k) {
            facts.normal[k] = apart<double>(a.x, b.x, k, seen, world_.effects);
            facts.sliding[k] = a.v[k] - b.v[k];
        }
        facts.distance = std::sqrt(dot(facts.normal, facts.normal));
        for (double& each : facts.normal) each /= facts.distance;
        facts.approach = std::max(growth - dot(facts.normal, facts.sliding), 0.0);
        return facts;
    }

    /// At time t a ball of speed v along an axis flies v 2^-53 t while an event is told late by a
    /// rounding, and its place, x + v (t - T), is rounded by at most twice that and what the margin
    /// has besides. Where v t is at most 2^50 margins all that is less than half a margin an axis.
    void see_clock(Slot i) noexcept {
        for (int k = 0; k < D; ++k)
            if (!(std::fabs(speed(world_.balls[i], k, now_, world_.effects)) * now_ <= farthest_))
                [[unlikely]]
                late_ = i;
    }
    /// Of a structure made anew the margin is larger where balls have flown far apart.
    [[gnu::cold, gnu::noinline]] void relieve() {
        const Slot late = std::exchange(late_, nobody);
        if (!world_.effects.box) make_anew();
        if (world_.effects.box || late_ != nobody) refuse(late);
    }
    /// Ends of a ball's projections change places with all others', at one time, at most; but after
    /// a strike at that time anew.
    void refuse_standstill(Slot i) {
        Particle& particle = particles_[i];
        if (particle.own > now_) [[likely]] {
            particle.own_at_once = 0;
        } else if (++particle.own_at_once > 1000 + 8 * particles_.size()) [[unlikely]] {
            const auto strikes = static_cast<std::uint32_t>(counts_.strikes);
            if (std::exchange(particle.strikes_of_all, strikes) == strikes) refuse(i);
            particle.own_at_once = 0;
        }
    }
    [[noreturn, gnu::cold]] void refuse(Slot i) const {
        throw std::range_error("ball " + std::to_string(particles_[i].number) + " at time " +
                               std::to_string(now_) +
                               " flies too far from one double to the next; use slower balls, or "
                               "a shorter time");
    }
    /// Where balls fly so far from one tick of the clock to the next that those which meet are
    /// apart at the rounded time.
    void refuse_missed_strike(Slot i, Slot j, const Ball<D>& a, const Ball<D>& b,
                              double square) const {
        const double radii = grown_radius(a) + grown_radius(b);
        if (std::fabs(square - radii * radii) < 0x1p-10 * (radii * radii)) [[likely]]
            return;
        // Contacts that stand may overlap a little (waits()).
        if (kernel_ == Kernel::naive || contacts_.has(numbers_of(i, j))) return;
        throw std::range_error(
            "balls " + std::to_string(std::min(particles_[i].number, particles_[j].number)) +
            " and " + std::to_string(std::max(particles_[i].number, particles_[j].number)) +
            " meet at time " + std::to_string(a.time) +
            ", but they fly too far from one double to the next for a strike then; use slower "
            "balls, or a shorter time");
    }

    /// The same of walls behind which there is room.
    void refuse_missed_wall(Slot i, Wall wall, const Ball<D>& ball) const {
        const double depth = walls_.depth(ball, wall);
        if (depth == infinity) return;
        Ball<D> grown = ball;
        grown.radius = grown_radius(ball);
        if (std::fabs(walls_.gap(grown, wall)) <= 0x1p-10 * depth) [[likely]]
            return;
        throw std::range_error("ball " + std::to_string(particles_[i].number) + " meets wall " +
                               std::to_string(wall) + " at time " + std::to_string(ball.time) +
                               ", but is too small beside what its place is rounded by; use a "
                               "larger radius, slower balls, or a shorter time");
    }

    [[nodiscard]] Ball<D> arrive(Slot i, double t, StrikeTally& tally) const {
        return kernel_ == Kernel::exact ? arrived(world_.balls[i], t, world_.effects, tally)
                                        : naive::arrived(world_.balls[i], t, world_.effects);
    }

    /// Counts a strike of a ball, which is given as it was when it came. `growth`: the speed at
    /// which the radii of the two grow.
    template <class Exactly>
    void count(Slot i, const Ball<D>& came, double approach, double square, double growth,
               const Exactly& exactly) {
        const double since = came.time - world_.balls[i].time;
        const InPlace in_place = stayed_in_place(came, since, approach, square);
        const bool stayed = in_place == InPlace::yes || since <= no_time * came.time ||
                            (in_place == InPlace::uncertain && exactly());
        if (!stayed && !has_no_room(came, since, approach / std::sqrt(square), growth)) [[likely]] {
            particles_[i].in_place = 0;
        } else if (++particles_[i].in_place >= (stayed ? most_in_place_ : most_without_room)) {
            collapses_ = true;
            particles_[i].in_place = 0;
        }
    }
    /// Whether balls will have closed the gap that one has flown through long before they cease to
    /// grow. A ball that hops on a floor flies as short ways, but as slowly as it falls.
    [[nodiscard]] bool has_no_room(const Ball<D>& came, double since, double speed,
                                   double growth) const noexcept {
        if (!world_.effects.growth) [[likely]]
            return false;
        const double flown = speed * since;
        return flown <= no_room * grown_radius(came) && no_room * speed >= world_.pull * since &&
               growth_to_a_jam * flown <= growth * (world_.effects.growth->until - came.time);
    }

    [[nodiscard]] bool is_passed(Slot i, Proposal& candidate) {
        const double until = passed_.until(i, candidate.partner);
        if (candidate.early > until) return false;
        // Then all are asked anew.
        if (until == turn_) return true;
        make_exact(i, candidate);
        return candidate.early <= until;
    }

    // Turns: what happens to all balls at once.

    [[nodiscard]] static constexpr bool has_turns() noexcept {
        return known.growth || known.time_steps;
    }
    [[nodiscard]] static constexpr bool has_walls() noexcept { return known.walls; }
    [[nodiscard]] bool notes_pairs() const noexcept { return known.time_steps && has_steps_; }
    /// What acts in flight, from a time on.
    [[nodiscard]] static Effects<D> in_flight(Effects<D> effects, double time) {
        if (effects.time_step > 0.0) {
            effects.gravity = {};
            effects.fluid.reset();
        }
        if (effects.growth && time >= effects.growth->until) effects.growth.reset();
        return effects;
    }
    void set_turn() {
        turn_ = steps_.next();
        if (world_.effects.growth) turn_ = std::min(turn_, world_.effects.growth->until);
    }
    [[nodiscard]] bool growth_ends_next() const noexcept {
        return world_.effects.growth && world_.effects.growth->until == turn_;
    }
    /// Of a turn and strikes at one time: radii cease to grow first, so that a state knows by its
    /// time whether they do; and a step begins first that follows another one, so that nobody need
    /// be asked between the two.
    [[nodiscard]] bool is_before_strikes() const noexcept {
        return growth_ends_next() || steps_.follows();
    }
    /// Whether what happens then comes after a step that is to begin then.
    [[nodiscard]] bool waits_for_step(double time) const noexcept {
        return has_turns() && time == turn_ && is_before_strikes();
    }
    [[nodiscard]] bool is_turn_due(double until) const noexcept {
        if (growth_ends_next()) return turn_ <= until;
        // The state between two steps is that before the next one begins.
        return steps_.begins() ? turn_ < until : turn_ <= until;
    }
    [[gnu::cold, gnu::noinline]] void take_turn(double until) {
        now_ = std::max(now_, turn_);
        StrikeTally tally;
        for (Slot i = 0; i < particles_.size(); ++i) world_.balls[i] = arrive(i, turn_, tally);
        if (growth_ends_next()) {
            end_growth();
        } else {
            kick();
            if (steps_.begins() && is_turn_due(until)) kick();
        }
        for (Slot i = 0; i < particles_.size(); ++i) {
            ++particles_[i].strikes;
            filter_.include(world_.balls[i]);
            noted_.fly(world_.balls[i].v);
        }
        set_turn();
        // Between two steps nothing strikes, and whether a contact may wait is not in the state.
        if (laws_.has_contacts() && !steps_.begins()) pass_contacts(all_contacts);
        ask_all_until_turn();
    }
    void end_growth() {
        for (Ball<D>& ball : world_.balls) ball.radius = grown_at(ball, turn_, world_.effects);
        world_.effects.growth.reset();
        world_.swelling = 1.0;
        filter_ = MeetingFilter<D>(world_.effects, kernel_);
        passed_.clear();
    }
    void kick() {
        if (!steps_.is_idle()) {
            Kicks<D>& kicks = steps_.kicks();
            for (Slot i = 0; i < particles_.size(); ++i) {
                Ball<D>& ball = world_.balls[i];
                ball.v = kicks.kicked(ball.x, ball.v, grown_radius(ball), particles_[i].mass);
                particles_[i].in_place = 0;
            }
            counts_.predictions += steps_.begins() ? particles_.size() : 0;
        }
        passed_.clear();
        if (laws_.has_contacts() && steps_.begins()) react(turn_, steps_.length(), all_contacts);
        steps_.advance();
    }

    // Contacts that stand.

    [[nodiscard]] auto numbers_of(Slot i, Slot partner) const {
        const std::int32_t a = particles_[i].number;
        if (partner >= first_wall)
            return std::pair(a, -1 - static_cast<std::int32_t>(partner - first_wall));
        const std::int32_t b = particles_[partner].number;
        return std::pair(std::min(a, b), std::max(a, b));
    }
    /// Two in contact that approach so slowly that they do not overlap by a visible part of a
    /// radius before the next step: that is left to the reactions then. In a chain of contacts each
    /// strike would bring about others, ever slower ones.
    [[nodiscard]] bool waits(Slot i, Slot partner, double t, double approach, double gap) const {
        return approach * (turn_ - t) <= StandingContacts<D>::allowed(gap, scale_of(i, partner)) &&
               contacts_.has(numbers_of(i, partner));
    }
    /// The length of which two in contact may overlap by a visible part: the least radius that is
    /// not 0. Of a point and a wall the overlap is beside what the point's place is rounded by.
    [[nodiscard]] double scale_of(Slot i, Slot partner) const noexcept {
        const Ball<D>& a = world_.balls[i];
        const double other = partner < first_wall ? world_.balls[partner].radius : 0.0;
        if (a.radius > 0.0 && other > 0.0) return std::min(a.radius, other);
        const double radius = std::max(a.radius, other);
        return radius > 0.0 ? radius : of_places * size_of(a);
    }
    /// The same of two that have waited, one of which has struck something else now.
    [[nodiscard]] bool waits_still(Slot i, Slot partner) const {
        if (partner >= first_wall) return false;
        const Ball<D> a = at(i, now_);
        const Ball<D> b = at(partner, now_);
        const Facts facts = facts_of(a, b, nearest_image(a.x, b.x, world_.effects));
        return waits(i, partner, now_, facts.approach, facts.distance - (a.radius + b.radius));
    }
    [[nodiscard]] Ball<D> at(Slot i, double t) const noexcept {
        Ball<D> ball = world_.balls[i];
        ball.x = world_.centre(i, t);
        ball.v = world_.velocity(i, t);
        ball.time = t;
        return ball;
    }
    void stand(Slot i, Slot partner) {
        if (contacts_.join(numbers_of(i, partner))) ++counts_.joins;
    }
    [[nodiscard]] typename StandingContacts<D>::Place place_of(
        std::pair<std::int32_t, std::int32_t> pair) const {
        typename StandingContacts<D>::Place place;
        const Ball<D>& a = world_.balls[slot_of(pair.first)];
        const bool rubs = laws_.has_friction();
        if (pair.second >= 0) {
            const Ball<D>& b = world_.balls[slot_of(pair.second)];
            const Facts facts = facts_of(a, b, nearest_image(a.x, b.x, world_.effects));
            place.normal = facts.normal;
            place.gap = facts.distance - (a.radius + b.radius);
            place.scale = scale_of(slot_of(pair.first), slot_of(pair.second));
            if (rubs) place.friction = world_.effects.friction->coefficient;
            return place;
        }
        const Wall wall = -1 - pair.second;
        const Facing<D> faces = is_side(wall) ? facing_side<D>(wall) : walls_.facing(a, wall);
        place.normal = unit_normal(faces);
        place.gap = walls_.gap(a, wall);
        place.scale = scale_of(slot_of(pair.first), first_wall + static_cast<Slot>(wall));
        place.wall_velocity = wall < 2 * D ? side_velocities_[static_cast<std::size_t>(wall)]
                                           : walls_.velocity(wall, now_);
        place.curvature = walls_.curvature(a, wall);
        if (rubs) place.friction = world_.effects.friction->wall_coefficient;
        return place;
    }
    [[nodiscard]] Slot slot_of(std::int32_t number) const noexcept {
        return slots_[static_cast<std::size_t>(number)];
    }
    static constexpr auto all_contacts = [](const auto&) { return true; };
    /// The contacts that are taken, from now until the step that began then is over.
    template <class Takes>
    void react(double began, double step, const Takes& takes) {
        side_velocities_ = walls_.side_velocities(began, steps_.length());
        const auto body = [&](std::int32_t number) {
            const Slot i = slot_of(number);
            const Ball<D>& ball = world_.balls[i];
            const double mass = particles_[i].mass;
            ContactBody<D> result{ball.v, {}, {mass, ball.radius, 1.0}};
            // A point does not turn.
            if (laws_.has_friction() && ball.radius > 0.0) {
                result.spin = laws_.spin(i);
                result.inert.inertia =
                    world_.effects.friction->inertia * mass * (ball.radius * ball.radius);
            }
            return result;
        };
        const auto take = [&](std::int32_t number, const ContactBody<D>& body_after) {
            const Slot i = slot_of(number);
            world_.balls[i].v = body_after.velocity;
            if (laws_.has_friction() && world_.balls[i].radius > 0.0)
                laws_.spin(i) = body_after.spin;
        };
        const ContactReport report = contacts_.begin_step(
            step, StandingContacts<D>::undone_a_step * (step / steps_.length()),
            *world_.effects.contacts, takes, [&](const auto& pair) { return place_of(pair); }, body,
            take, counts_.breaks);
        counts_.residual = std::max(counts_.residual, report.residual);
        counts_.unsolved += static_cast<std::uint64_t>(!report.converged());
    }
    /// Until the next step they are no strikes, but for those that the reactions found in the
    /// step's sweeps leave too fast.
    template <class Takes>
    void pass_contacts(const Takes& takes) {
        for (const auto& [pair, momenta] : contacts_.all())
            if (momenta.waits && takes(pair))
                passed_.pass(slot_of(pair.first),
                             pair.second >= 0 ? slot_of(pair.second)
                                              : first_wall + static_cast<Slot>(-1 - pair.second),
                             turn_);
    }

    /// Strikes one after the other, each of which would leave two in contact, need not come to an
    /// end: with friction above 1 a ball in a corner is sent from one wall to the other and back.
    /// Fast ones need not, in number: a light ball on a floor that a heavy one falls on goes to and
    /// fro between the two. So shortly before that would end the run all stay in contact. But where
    /// no time is left until the next step each pair waits after one slow strike.
    [[nodiscard]] bool is_jammed(std::initializer_list<Slot> balls, bool stays, double t) const {
        if (!laws_.has_contacts() || t >= turn_) return false;
        return std::ranges::any_of(balls, [&](Slot i) {
            const std::uint32_t count = particles_[i].in_place;
            return (stays && count > 0 && count % strikes_to_a_jam == 0) ||
                   (count >= most_in_place_ - most_in_place_ / 10 && count < most_in_place_);
        });
    }
    /// Instead of a strike all contacts that hang together with it are solved at once, as at the
    /// beginning of a step. It counts as a strike in place, so that the next one is not the same.
    [[gnu::cold, gnu::noinline]] bool settle_jam(Slot i, Slot partner, double t) {
        stand(i, partner);
        ++particles_[i].in_place;
        if (partner < first_wall) ++particles_[partner].in_place;
        const std::set<std::int32_t> hanging = contacts_.hanging_with(particles_[i].number);
        const auto takes = [&](const auto& pair) { return hanging.contains(pair.first); };
        StrikeTally tally;
        for (const std::int32_t number : hanging) {
            const Slot j = slot_of(number);
            world_.balls[j] = arrive(j, t, tally);
            ++particles_[j].strikes;
        }
        react(steps_.last(), turn_ - t, takes);
        for (const std::int32_t number : hanging) {
            const Slot j = slot_of(number);
            put(j, world_.balls[j]);
            release(j);
        }
        pass_contacts(takes);
        for (const std::int32_t number : hanging) ask_after_change({slot_of(number)});
        return false;
    }

    static constexpr std::uint64_t own_events_a_ball = 16;
    static constexpr double margins_to_fly = 0x1p50;

    World<D> world_;
    Kernel kernel_;
    std::array<Inquiry, 2> inquiries_;
    std::array<std::uint32_t, 3> fetched_{};  // up to which bucket
    LargeArray<Particle, Pages::large> particles_;
    MeetingFilter<D> filter_;
    Walls<D> walls_;
    std::vector<Wall> sides_;  // of the box, those at rest
    Structure kind_;
    std::optional<StructureOf<D>> structure_;
    double farthest_;     // to fly from time 0 on
    Slot late_ = nobody;  // who flies farther
    EventQueue queue_;
    bool fetches_;
    std::uint32_t most_in_place_;
    bool collapses_ = false;
    std::uint64_t own_events_left_ = own_events_a_ball * particles_.size();
    std::uint64_t strikes_before_ = 0;
    std::uint64_t quiet_rounds_ = 0;
    double now_;
    double width_ = widest_now();  // after now_, which it needs
    Counts counts_;
    Strike last_;
    Laws<D, known> laws_;
    TimeSteps<D> steps_;
    bool has_steps_ = steps_.length() > 0.0;
    NotedPairs<D> noted_ = NotedPairs<D>(notes_pairs() ? particles_.size() : 0);
    double apart_ = Spread<D>(world_).edge_of(1.0);  // how far balls are from one another
    PassedMeetings passed_;
    StandingContacts<D> contacts_;
    std::array<Vector<D>, 2 * D> side_velocities_{};  // of this step
    std::vector<Slot> slots_;                         // of balls by their numbers
    double turn_ = infinity;                          // when something happens to all
};

template <int D, template <int> class StructureOf>
std::unique_ptr<typename Simulation<D>::Engine> make_engine(
    Structure structure, const State<D>& state, const Effects<D>& effects, Kernel kernel,
    const std::vector<std::int32_t>& order) {
    return std::make_unique<Loop<D, StructureOf>>(structure, state, effects, kernel, order);
}

/// Compiles the loops over a structure, in a source of its own.
#define SIGNUM_LOOPS_IN(D, STRUCTURE)                                          \
    template std::unique_ptr<Simulation<D>::Engine> make_engine<D, STRUCTURE>( \
        Structure, const State<D>&, const Effects<D>&, Kernel, const std::vector<std::int32_t>&);
#define SIGNUM_LOOPS_OVER(STRUCTURE) SIGNUM_LOOPS_IN(2, STRUCTURE) SIGNUM_LOOPS_IN(3, STRUCTURE)

}  // namespace signum::motion
