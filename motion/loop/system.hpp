#pragma once
/// The system: the balls, what acts on them, and what the loop remembers of both. The loop's parts
/// are functions of it.

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <variant>
#include <vector>

#include "../effects/growth.hpp"
#include "../laws.hpp"
#include "../naive_strike.hpp"
#include "../noted_pairs.hpp"
#include "../passed_meetings.hpp"
#include "../simulation.hpp"
#include "../standing_contacts.hpp"
#include "../strike.hpp"
#include "../time_steps.hpp"
#include "../walls.hpp"
#include "../world.hpp"
#include "agenda.hpp"

namespace signum::motion {

template <int D, Known known>
struct System {
    using Asker = typename MeetingFilter<D>::Asker;
    using Record = typename Simulation<D>::Record;
    using Pair = typename StandingContacts<D>::Pair;

    /// `order`: the balls' numbers in the order in which memory shall hold them.
    System(const State<D>& state, const Effects<D>& effects, Kernel kernel_then,
           const std::vector<std::int32_t>& order)
        : world(in_order(state.balls, order), in_flight(effects, state.time), state.time),
          kernel(kernel_then),
          agenda(order.size()),
          filter(world.effects, kernel),
          walls(world.effects, kernel),
          laws(effects, order.size()),
          steps(effects, state.half_steps),
          passed(order.size()),
          slots(order.size()),
          now(state.time),
          most_in_place(effects.restitution < 1.0 || effects.wall_restitution < 1.0 ||
                                effects.gravity != Vector<D>{}
                            ? most_in_place_dissipative
                            : most_in_place_elastic) {
        for (Wall wall = 0; effects.box && !effects.periodic && wall < 2 * D; ++wall)
            if (is_side(wall)) sides.push_back(wall);
        for (Slot i = 0; i < slots.size(); ++i) {
            const auto number = static_cast<std::size_t>(order[i]);
            slots[number] = i;
            agenda[i].number = order[i];
            agenda[i].mass = state.masses[number];
            agenda[i].in_place = state.in_place[number];
        }
        if (effects.growth || effects.shake || effects.contact_duration > 0.0 ||
            std::ranges::any_of(effects.obstacles,
                                [](const auto& each) { return is_moving(each); }))
            pressed.resize(slots.size());
        for (const Pressed& each : state.pressed)
            if (!pressed.empty()) pressed[slot_of(each.ball)] = each;
        laws.set(state, slots);
        for (const StandingContact<D>& contact : state.contacts)
            contacts.set({contact.a, Partner::coded(contact.b)}, {contact.push, contact.rub});
        for (const Passed& each : state.passed)
            passed.pass(slot_of(each.a), in_slot(Partner::coded(each.b)), each.time);
        for (const Ball<D>& ball : world.balls) filter.include(ball);
        set_turn();
    }
    [[nodiscard]] State<D> state() const {
        const std::size_t n = agenda.size();
        State<D> state{now,
                       std::vector<Ball<D>>(n),
                       std::vector<double>(n),
                       std::vector<std::uint32_t>(n),
                       {}};
        if (laws.has_friction()) state.spins.resize(n);
        if (laws.has_duration()) state.last_strikes.resize(n);
        for (Slot i = 0; i < n; ++i) {
            const auto number = static_cast<std::size_t>(agenda[i].number);
            state.balls[number] = world.balls[i];
            state.masses[number] = agenda[i].mass;
            state.in_place[number] = agenda[i].in_place;
            if (laws.has_friction()) state.spins[number] = laws.spin(i);
            if (laws.has_duration()) state.last_strikes[number] = laws.last_strike(i);
            for (const auto& [partner, time] : passed.of(i)) {
                const Pair pair = pair_of(i, partner);
                // Both balls of a pair have it.
                if (pair.first == agenda[i].number)
                    state.passed.push_back({pair.first, pair.second.code(), time});
            }
        }
        std::ranges::sort(state.passed, {},
                          [](const Passed& each) { return std::pair(each.a, each.b); });
        for (Slot i : slots) {
            if (pressed.empty() || pressed[i].last == -infinity) continue;
            state.pressed.push_back(pressed[i]);
            state.pressed.back().ball = agenda[i].number;
        }
        state.half_steps = steps.half_steps();
        for (const auto& [pair, momenta] : contacts.all())
            state.contacts.push_back({pair.first, pair.second.code(), momenta.push, momenta.rub});
        return state;
    }

    World<D> world;
    Kernel kernel;
    Agenda agenda;
    MeetingFilter<D> filter;
    Walls<D> walls;
    std::vector<Wall> sides;  ///< of the box, those at rest
    Laws<D, known> laws;
    TimeSteps<D> steps;
    bool has_steps = steps.length() > 0.0;
    NotedPairs<D> noted = NotedPairs<D>(notes_pairs() ? agenda.size() : 0);
    PassedMeetings passed;
    StandingContacts<D> contacts;
    std::array<Vector<D>, 2 * D> side_velocities{};  ///< of this step
    std::vector<Slot> slots;                         ///< of balls by their numbers
    Counts counts;
    Strike last;
    double now;
    double turn = infinity;  ///< when something happens to all balls
    /// How many strikes in place end a run (collapse.hpp), and whether one is to end.
    std::uint32_t most_in_place;
    bool collapses = false;
    std::vector<Pressed> pressed;  ///< of each ball, where count_in_gap() is asked
    /// How far a ball may fly from time 0 on (clock.hpp), and who flies farther.
    double farthest = infinity;
    Partner late;

    [[nodiscard]] static constexpr bool has_turns() noexcept {
        return known.growth || known.time_steps;
    }
    [[nodiscard]] static constexpr bool has_walls() noexcept { return known.walls; }
    [[nodiscard]] bool notes_pairs() const noexcept { return known.time_steps && has_steps; }
    /// Whether a wall is a side of the box at rest.
    [[nodiscard]] bool is_side(Wall wall) const noexcept {
        return !has_walls() || walls.numbers().empty() || !walls.has(wall);
    }
    /// Whether a wall moves: a side of the box that shakes, or an obstacle.
    [[nodiscard]] bool moves(Wall wall) const {
        if (wall < 2 * D) return !is_side(wall);
        return is_moving(world.effects.obstacles[static_cast<std::size_t>(wall - 2 * D)]);
    }
    void set_turn() {
        turn = steps.next();
        if (world.effects.growth) turn = std::min(turn, world.effects.growth->until);
    }

    // Names.

    [[nodiscard]] Slot slot_of(std::int32_t number) const noexcept {
        return slots[static_cast<std::size_t>(number)];
    }
    /// One whose ball is named by its slot, with the ball's number; and the other way round.
    [[nodiscard]] Partner numbered(Partner partner) const noexcept {
        return partner.is_ball() ? Partner::coded(agenda[partner.slot()].number) : partner;
    }
    [[nodiscard]] Partner in_slot(Partner partner) const noexcept {
        return partner.is_ball() ? Partner::ball(slot_of(partner.code())) : partner;
    }
    [[nodiscard]] Pair pair_of(Slot i, Partner partner) const noexcept {
        const std::int32_t a = agenda[i].number;
        const Partner b = numbered(partner);
        return b.is_ball() && b.code() < a ? Pair(b.code(), Partner::coded(a)) : Pair(a, b);
    }

    // Flights.

    [[nodiscard]] double grown_radius(const Ball<D>& ball) const noexcept {
        return ball.radius + growth_of(ball, world.effects) * ball.time;
    }
    /// The nearest image of a pair at a time.
    [[nodiscard]] Image<D> image(Slot i, Slot j, double t) const {
        return nearest_image(world.centre(i, t), world.centre(j, t), world.effects);
    }
    [[nodiscard]] Ball<D> arrive(Slot i, double t, StrikeTally& tally) const {
        return kernel == Kernel::exact ? arrived(world.balls[i], t, world.effects, tally)
                                       : naive::arrived(world.balls[i], t, world.effects);
    }
    /// A ball flies otherwise than before.
    [[gnu::always_inline]] void put(Slot i, const Ball<D>& ball) {
        world.balls[i] = ball;
        filter.include(ball);
        if (notes_pairs()) [[unlikely]]
            noted.fly(ball.v);
    }

 private:
    [[nodiscard]] static Balls<D> in_order(const std::vector<Ball<D>>& balls,
                                           const std::vector<std::int32_t>& order) {
        Balls<D> result;
        result.reserve(order.size());
        for (const std::int32_t number : order)
            result.push_back(balls[static_cast<std::size_t>(number)]);
        return result;
    }
    /// What acts in flight, from a time on.
    [[nodiscard]] static Effects<D> in_flight(Effects<D> effects, double time) {
        if (effects.time_step > 0.0) {
            effects.gravity = {};
            effects.fluid.reset();
        }
        if (effects.growth && time >= effects.growth->until) effects.growth.reset();
        return effects;
    }

    static constexpr std::uint32_t most_in_place_dissipative = 1000;
    static constexpr std::uint32_t most_in_place_elastic = 100'000;
};

}  // namespace signum::motion
