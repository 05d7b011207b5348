#pragma once
/// The loop: takes the earliest event, lets it happen, and has those asked whom it concerns. Its
/// parts, in loop/, each know only those above them:
///
///     agenda          of every ball the event that comes next, in order
///     system          the balls, what acts on them, and what is remembered of both
///     clock           who flies too far for the clock
///     meetings        when a ball meets a partner, behind the filter
///     inquiry         what one ball strikes first, of those proposed to it
///     broad_phase     which pairs are asked: the structure, and what it proposes
///     contacts        those that stand
///     collapse, jams  strikes that find no end
///     strikes, wall_strikes, turns   what an event does

#include <algorithm>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "engine.hpp"
#include "loop/broad_phase.hpp"
#include "loop/strikes.hpp"
#include "loop/turns.hpp"
#include "loop/wall_strikes.hpp"
#include "sketch.hpp"

namespace signum::motion {

template <int D, template <int> class StructureOf, Known known = Known{}>
class Loop final : public Simulation<D>::Engine {
 public:
    /// `order`: the balls' numbers in the order in which memory shall hold them.
    Loop(Structure structure, const State<D>& state, const Effects<D>& effects, Kernel kernel,
         const std::vector<std::int32_t>& order)
        : system_(state, effects, kernel, order), broad_phase_(system_, structure) {
        broad_phase_.ask_all();
    }
    /// The broad phase looks at this very system.
    Loop(const Loop&) = delete;
    Loop& operator=(const Loop&) = delete;

    Outcome run(const Limits& limits, const typename Simulation<D>::Record& record) override {
        if (system_.agenda.size() == 0) return {Ending::nothing, {}};
        constexpr std::uint32_t turns_between_questions = 4096;
        const double until = limits.until;
        double& now = system_.now;
        const double& turn = system_.turn;
        Agenda& agenda = system_.agenda;
        std::uint64_t done = 0;
        std::uint32_t turns = 0;
        while (done < limits.strikes) {
            if (++turns % turns_between_questions == 0 && limits.stop && limits.stop())
                return {Ending::stopped, {}};
            if (!system_.late.is_nobody()) [[unlikely]]
                broad_phase_.relieve();
            const Slot i = agenda.top();
            const double key = agenda.key(i);
            if constexpr (System<D, known>::has_turns()) {
                if (turn <= key && (turn < key || is_before_strikes(system_)) &&
                    is_turn_due(system_, until)) [[unlikely]] {
                    if (limits.stop && limits.stop()) return {Ending::stopped, {}};
                    take_turn(system_, until);
                    broad_phase_.ask_all_until_turn();
                    continue;
                }
            }
            if (!(key <= until && key < infinity) || waits_for_step(system_, key)) {
                if (until < infinity) now = std::max(now, until);
                return {std::min(key, turn) < infinity ? Ending::until : Ending::nothing, {}};
            }
            now = std::max(now, key);
            broad_phase_.fetch_ahead();
            Proposal& next = agenda[i].next;
            if (agenda[i].own <= next.early) {
                if (!broad_phase_.own_event(i)) [[unlikely]] {
                    if (until < infinity) now = until;
                    return {Ending::nothing, {}};
                }
            } else if (agenda.is_stale(next)) {
                ++system_.counts.stale;
                broad_phase_.ask(i);
            } else if (next.early < next.late) {
                make_exact(system_, i, next);
                agenda.settle(i);
            } else {
                const Met met = meet(i, record);
                if (met == Met::struck) ++done;
                if (met == Met::rests || std::exchange(system_.collapses, false))
                    return {Ending::collapse, system_.last};
            }
        }
        return {Ending::strikes, {}};
    }

    [[nodiscard]] State<D> state() const override { return system_.state(); }
    [[nodiscard]] const Counts& counts() const override { return system_.counts; }
    [[nodiscard]] Sketch<D> sketch() const override {
        Sketch<D> sketch;
        broad_phase_.sketch(sketch);
        std::vector<std::int32_t> numbers;
        for (Slot i = 0; i < system_.agenda.size(); ++i) {
            numbers.push_back(system_.agenda[i].number);
            const Proposal& next = system_.agenda[i].next;
            if (next.partner.is_nobody() || system_.agenda.is_stale(next)) continue;
            sketch.expected.push_back(
                {static_cast<std::int32_t>(i), next.partner.code(), next.early});
        }
        put_in_order<D>(sketch, numbers, system_.world.effects);
        return sketch;
    }

 private:
    /// A ball meets its partner now, and those whom that concerns are asked anew.
    Met meet(Slot i, const typename Simulation<D>::Record& record) {
        const Proposal next = system_.agenda[i].next;
        const bool is_wall = next.partner.is_wall();
        const Met met =
            is_wall ? strike_wall(system_, i, record) : strike_balls(system_, i, record);
        if (met == Met::struck) {
            if (is_wall)
                broad_phase_.ask_after_change({i});
            else
                broad_phase_.ask_after_change({i, next.partner.slot()});
        } else if (met == Met::passed) {
            broad_phase_.ask(i);
        } else if (met == Met::jammed) {
            for (const Slot j : settle_jam(system_, i, next.partner, next.early))
                broad_phase_.ask_after_change({j});
        }
        return met;
    }

    System<D, known> system_;
    BroadPhase<D, StructureOf, known> broad_phase_;
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
