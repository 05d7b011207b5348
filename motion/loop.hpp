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
#include <map>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "engine.hpp"
#include "event_queue.hpp"
#include "exact_meeting.hpp"
#include "meeting.hpp"
#include "naive_strike.hpp"
#include "simulation.hpp"
#include "sketch.hpp"
#include "strike.hpp"
#include "world.hpp"

namespace signum::motion {

template <int D, bool Falls, Kernel kernel, template <int> class StructureOf>
class Loop final : public Simulation<D>::Engine {
 public:
    /// `order`: the balls' numbers in the order in which memory shall hold them.
    Loop(Structure structure, const State<D>& state, const Effects<D>& effects,
         const std::vector<std::int32_t>& order)
        : world_{in_order(state.balls, order), effects, state.time},
          particles_(order.size()),
          filter_(effects),
          kind_(structure),
          structure_(std::in_place, world_, kind_),
          farthest_(margins_to_fly * structure_->margin()),
          queue_(particles_.size()),
          walls_(effects.box && !effects.periodic ? 2 * D : 0),
          // Of fewer balls all lies near the processor.
          fetches_(order.size() > 8192),
          most_in_place_(effects.restitution < 1.0 || effects.wall_restitution < 1.0 || Falls
                             ? most_in_place_dissipative
                             : most_in_place_elastic),
          now_(state.time) {
        std::vector<Slot> slots(particles_.size());
        for (Slot i = 0; i < slots.size(); ++i) {
            const auto number = static_cast<std::size_t>(order[i]);
            slots[number] = i;
            particles_[i].number = order[i];
            particles_[i].mass = state.masses[number];
            particles_[i].in_place = state.in_place[number];
        }
        for (const Passed& passed : state.passed) {
            pass(slots[static_cast<std::size_t>(passed.a)],
                 passed.b < 0 ? first_wall + static_cast<Slot>(-1 - passed.b)
                              : slots[static_cast<std::size_t>(passed.b)],
                 passed.time);
        }
        for (const Ball<D>& ball : world_.balls) filter_.include(ball);
        for (Slot i = 0; i < slots.size(); ++i) ask_after_change({i});
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
            if (!(key <= until && key < infinity)) {
                if (until < infinity) now_ = std::max(now_, until);
                return {key < infinity ? Ending::until : Ending::nothing, {}};
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
                structure_->own_event(
                    i, now_, [&](Slot j) { propose(inquiry, j); }, [&](Slot j) { touch(j); });
                particles_[i].own = structure_->next(i, now_);
                refuse_standstill(i);
                see_clock(i);
                look(inquiry);
                counts_.own_checks += counts_.checks - asked_before;
                end(inquiry);
            } else if (is_stale(next)) {
                ++counts_.stale;
                ask(i);
            } else if (next.early < next.late) {
                make_exact(i, next);
                settle(i);
            } else {
                done += static_cast<std::uint64_t>(is_wall(next) ? strike_wall(i, record)
                                                                 : strike_ball(i, record));
                if (collapses_) return {Ending::collapse, last_};
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
        for (const auto& [pair, time] : passed_) {
            const auto [i, j] = pair;
            state.passed.push_back({particles_[i].number,
                                    j >= first_wall ? -1 - static_cast<std::int32_t>(j - first_wall)
                                                    : particles_[j].number,
                                    time});
        }
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
    static constexpr Slot first_wall = nobody - 6;
    static constexpr std::uint32_t most_in_place_dissipative = 1000;
    static constexpr std::uint32_t most_in_place_elastic = 100'000;

    using Asker = typename MeetingFilter<D, Falls, kernel>::Asker;

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
        for (Slot i = 0; i < particles_.size(); ++i) ask_after_change({i});
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
        Crowd crowd;
        for (Slot i = 0; i < particles_.size(); ++i) {
            const Asker asker = filter_.asker(world_.balls[i], now_);
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

    /// What a ball strikes first, of those that have been considered.
    struct Inquiry {
        Slot ball = nobody;
        Asker asker;
        Proposal best;
        Crowd crowd;
    };
    void open(Inquiry& inquiry, Slot i, const Proposal& best) {
        inquiry.ball = i;
        inquiry.asker = filter_.asker(world_.balls[i], now_);
        inquiry.best = best;
    }
    void begin(Inquiry& inquiry, Slot i) {
        open(inquiry, i, {});
        for (Wall wall = 0; wall < walls_; ++wall) consider_wall(inquiry, wall);
        if constexpr (requires { structure_->list(i); }) {
            std::span<const Slot> list = structure_->list(i);
            for (; list.size() > Crowd::capacity; list = list.subspan(Crowd::capacity)) {
                inquiry.crowd.assign(list.first(Crowd::capacity));
                look(inquiry);
                consider_all(inquiry);
            }
            inquiry.crowd.assign(list);
        } else {
            structure_->near(i, [&](Slot j) { propose(inquiry, j); });
        }
        look(inquiry);
    }
    void end(Inquiry& inquiry) {
        consider_all(inquiry);
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
            meeting = exactly(i, j);
            if (!(meeting.early <= best.late)) return;
        }
        if (meeting.early == infinity) return;
        // The partner strikes something before, and is then asked again.
        if (meeting.early > particles_[j].next.late) return;
        Proposal candidate{meeting.early, meeting.late, j, particles_[j].strikes};
        if (!passed_.empty() && is_passed(i, candidate)) return;
        take(i, candidate, best);
    }
    void consider_wall(Inquiry& inquiry, Wall wall) {
        const Slot i = inquiry.ball;
        Proposal& best = inquiry.best;
        const Box<D>& box = *world_.effects.box;
        const double side = wall % 2 != 0 ? box.high[wall / 2] : box.low[wall / 2];
        Meeting meeting = inquiry.asker.meeting(wall, side);
        if (!(meeting.early <= best.late)) return;
        if (meeting.early == -infinity) [[unlikely]] {
            ++counts_.exact;
            const double t = exact_meeting(world_.balls[i], wall, world_.effects);
            meeting = {t, t};
        }
        if (meeting.early == infinity) return;
        Proposal candidate{meeting.early, meeting.late, first_wall + static_cast<Slot>(wall), 0};
        if (!passed_.empty() && is_passed(i, candidate)) return;
        take(i, candidate, best);
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
                // Whichever begins first: at its turn the ball is asked again.
                if (candidate.early < best.early) best = candidate;
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
        const auto tell = [&](const auto&... other) {
            const double t = refined_meeting(ball, other..., world_.effects, about);
            const bool tells = !std::isnan(t);
            ++(tells ? counts_.refined : counts_.exact);
            return tells ? t : exact_meeting(ball, other..., world_.effects);
        };
        // Now another image may be nearer than the one that will be struck.
        p.early = p.late = is_wall(p) ? tell(wall_of(p))
                                      : tell(world_.balls[p.partner], image(i, p.partner, about));
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
        Exchange exchange;
        if constexpr (kernel == Kernel::exact)
            exchange =
                strike(a, b, seen, particles_[i].mass, particles_[j].mass, world_.effects, tally);
        else
            exchange =
                naive::strike(a, b, seen, particles_[i].mass, particles_[j].mass, world_.effects);
        counts_.rounded += tally.refined;
        counts_.rounded_exactly += tally.exact;
        refuse_missed_strike(i, j, a, b, exchange.square);
        if (!exchange.struck) {
            pass(i, j, t);
            ask(i);
            return false;
        }
        counts_.virial += exchange.virial;
        const std::int32_t first = std::min(particles_[i].number, particles_[j].number);
        const std::int32_t second = std::max(particles_[i].number, particles_[j].number);
        last_ = {t, false, first, second, 0.0};
        if (record) {
            last_.impulse = impulse(a_before, b_before, seen, particles_[i].mass,
                                    particles_[j].mass, world_.effects, tally);
            record(last_);
        }
        ++counts_.strikes;
        count(i, a_before, exchange.approach, exchange.square, [&] {
            return stayed_in_place_exactly(a_before, b_before, seen, world_.effects,
                                           world_.balls[i].time);
        });
        count(j, b_before, exchange.approach, exchange.square, [&] {
            // D and V of the pair, whichever comes first.
            Image<D> back;
            for (int k = 0; k < D; ++k) back[k] = -seen[k];
            return stayed_in_place_exactly(b_before, a_before, back, world_.effects,
                                           world_.balls[j].time);
        });
        world_.balls[i] = a;
        world_.balls[j] = b;
        filter_.include(a);
        filter_.include(b);
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
        const bool struck = strike(ball, wall, world_.effects);
        last_ = {t, true, particles_[i].number, wall, 0.0};
        if (!struck) {
            const double g = world_.effects.gravity[wall / 2];
            collapses_ = wall % 2 != 0 ? g > 0.0 : g < 0.0;
            if (collapses_) return false;
            pass(i, first_wall + static_cast<Slot>(wall), t);
            ask(i);
            return false;
        }
        if (record) {
            last_.impulse = impulse(ball_before, wall, particles_[i].mass, world_.effects);
            record(last_);
        }
        ++counts_.strikes;
        count(i, ball_before, std::fabs(ball_before.v[wall / 2]), 1.0,
              [&] { return stayed_in_place_exactly(ball_before, wall, world_.balls[i].time); });
        world_.balls[i] = ball;
        filter_.include(ball);
        release(i);
        ask_after_change({i});
        return true;
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
    /// Ends of a ball's projections change places with all others', at one time, at most.
    void refuse_standstill(Slot i) {
        Particle& particle = particles_[i];
        if (particle.own > now_) [[likely]]
            particle.own_at_once = 0;
        else if (++particle.own_at_once > 1000 + 8 * particles_.size())
            refuse(i);
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
        const double radii = a.radius + b.radius;
        if (std::fabs(square - radii * radii) < 0x1p-10 * (radii * radii)) [[likely]]
            return;
        if constexpr (kernel == Kernel::naive) return;
        throw std::range_error(
            "balls " + std::to_string(std::min(particles_[i].number, particles_[j].number)) +
            " and " + std::to_string(std::max(particles_[i].number, particles_[j].number)) +
            " meet at time " + std::to_string(a.time) +
            ", but they fly too far from one double to the next for a strike then; use slower "
            "balls, or a shorter time");
    }

    [[nodiscard]] Ball<D> arrive(Slot i, double t, StrikeTally& tally) const {
        if constexpr (kernel == Kernel::exact)
            return arrived(world_.balls[i], t, world_.effects, tally);
        else
            return naive::arrived(world_.balls[i], t, world_.effects);
    }

    /// Counts a strike of a ball, which is given as it was when it came.
    template <class Exactly>
    void count(Slot i, const Ball<D>& came, double approach, double square,
               const Exactly& exactly) {
        ++particles_[i].strikes;
        const InPlace stayed =
            stayed_in_place(came, came.time - world_.balls[i].time, approach, square);
        if (stayed == InPlace::no || (stayed == InPlace::uncertain && !exactly())) [[likely]] {
            particles_[i].in_place = 0;
        } else if (++particles_[i].in_place >= most_in_place_) {
            collapses_ = true;
            particles_[i].in_place = 0;
        }
    }

    /// A meeting that is no strike is passed over, as long as neither strikes something else.
    void pass(Slot i, Slot j, double t) { passed_[{std::min(i, j), std::max(i, j)}] = t; }
    [[nodiscard]] bool is_passed(Slot i, Proposal& candidate) {
        const Slot j = candidate.partner;
        const auto found = passed_.find({std::min(i, j), std::max(i, j)});
        if (found == passed_.end() || candidate.early > found->second) return false;
        make_exact(i, candidate);
        return candidate.early <= found->second;
    }
    void release(Slot i) {
        if (passed_.empty()) return;
        std::erase_if(passed_, [i](const auto& entry) {
            return entry.first.first == i || entry.first.second == i;
        });
    }

    static constexpr std::uint64_t own_events_a_ball = 16;
    static constexpr double margins_to_fly = 0x1p50;

    World<D> world_;
    std::array<Inquiry, 2> inquiries_;
    std::array<std::uint32_t, 3> fetched_{};  // up to which bucket
    LargeArray<Particle, Pages::large> particles_;
    MeetingFilter<D, Falls, kernel> filter_;
    Structure kind_;
    std::optional<StructureOf<D>> structure_;
    double farthest_;     // to fly from time 0 on
    Slot late_ = nobody;  // who flies farther
    EventQueue queue_;
    Wall walls_;
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
    std::map<std::pair<Slot, Slot>, double> passed_;
};

template <int D, template <int> class StructureOf>
std::unique_ptr<typename Simulation<D>::Engine> make_engine(
    Structure structure, const State<D>& state, const Effects<D>& effects, Kernel kernel,
    const std::vector<std::int32_t>& order) {
    const auto make =
        [&]<bool falls, Kernel k>() -> std::unique_ptr<typename Simulation<D>::Engine> {
        return std::make_unique<Loop<D, falls, k, StructureOf>>(structure, state, effects, order);
    };
    const bool falls = effects.gravity != Vector<D>{};
    if (kernel == Kernel::naive) {
        return falls ? make.template operator()<true, Kernel::naive>()
                     : make.template operator()<false, Kernel::naive>();
    }
    return falls ? make.template operator()<true, Kernel::exact>()
                 : make.template operator()<false, Kernel::exact>();
}

/// Compiles the loops over a structure, in a source of its own.
#define SIGNUM_LOOPS_IN(D, STRUCTURE)                                          \
    template std::unique_ptr<Simulation<D>::Engine> make_engine<D, STRUCTURE>( \
        Structure, const State<D>&, const Effects<D>&, Kernel, const std::vector<std::int32_t>&);
#define SIGNUM_LOOPS_OVER(STRUCTURE) SIGNUM_LOOPS_IN(2, STRUCTURE) SIGNUM_LOOPS_IN(3, STRUCTURE)

}  // namespace signum::motion
