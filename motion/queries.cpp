#include "queries.hpp"

#include <cmath>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include "../exact/floating_environment.hpp"
#include "check_parts.hpp"
#include "gap.hpp"
#include "near_pairs.hpp"
#include "stop.hpp"

namespace signum::motion {
namespace {

void refuse_time(double time, double no_sooner, const char* what) {
    if (!(time >= no_sooner))
        throw std::invalid_argument(std::string(what) +
                                    ": a time that is no number, or before the one it follows");
}

/// The closest of some pairs at the time of the state, and its gap.
template <int D>
std::pair<NearPair<D>, Gap> closest_of(std::span<const NearPair<D>> pairs, const State<D>& state,
                                       const Effects<D>& effects) {
    const auto gap_of = [&](const NearPair<D>& pair) {
        return Gap(couple_of<D>(pair, state.balls), effects, state.time);
    };
    NearPair<D> best = pairs.front();
    Gap gap = gap_of(best);
    for (const NearPair<D>& pair : pairs.subspan(1)) {
        if (pair.gap.low > best.gap.high) continue;
        Gap other = gap_of(pair);
        const Sign order = compare(other, gap);
        if (order > 0 || (order == 0 && numbers_of(best) < numbers_of(pair))) continue;
        best = pair;
        gap = std::move(other);
    }
    return {best, gap};
}

}  // namespace

template <int D>
State<D> state_at(const State<D>& state, const Effects<D>& effects, double time,
                  const Options& options) {
    refuse_time(time, state.time, "time");
    if (!std::isfinite(time)) throw std::invalid_argument("time: give a finite one");
    Simulation<D> ahead(state, effects, options);
    if (ahead.run({.until = time}).ending == Ending::collapse)
        throw std::range_error("the balls collapse before that time");
    State<D> result = ahead.state();
    result.time = time;
    return result;
}

template <int D>
StrikeList strikes_between(const State<D>& state, const Effects<D>& effects, double begin,
                           double end, const Options& options) {
    refuse_time(begin, state.time, "begin");
    refuse_time(end, begin, "end");
    StrikeList list;
    Simulation<D> ahead(state, effects, options);
    list.outcome = ahead.run({.until = end}, [&](const Strike& strike) {
        if (strike.time >= begin) list.strikes.push_back(strike);
    });
    return list;
}

template <int D>
std::optional<Strike> next_strike(const State<D>& state, const Effects<D>& effects, double time,
                                  double until, const Options& options) {
    refuse_time(time, state.time, "time");
    refuse_time(until, time, "until");
    Simulation<D> ahead(state, effects, options);
    std::optional<Strike> next;
    if (ahead.run({.until = time}).ending == Ending::collapse) return next;
    // At the end of a time step some may be left for the next one (Limits::until).
    do {
        next.reset();
        ahead.run({.until = until, .strikes = 1}, [&](const Strike& strike) { next = strike; });
    } while (next && next->time <= time);
    return next;
}

template <int D>
std::optional<Neighbour> nearest(const State<D>& state, const Effects<D>& effects,
                                 std::int32_t ball) {
    check_parts(state, effects);
    require_free_flight(effects);
    if (ball < 0 || static_cast<std::size_t>(ball) >= state.balls.size())
        throw std::out_of_range("ball: a number that no ball has");
    if (state.balls.size() < 2) return std::nullopt;
    const exact::IeeeEnvironment environment;
    const NearPairs<D> near(state.balls, effects, state.time, state.time);
    const std::vector<NearPair<D>> pairs = near.closest_to(static_cast<std::uint32_t>(ball));
    const auto [best, gap] = closest_of<D>(pairs, state, effects);
    return Neighbour{best.a == ball ? best.b : best.a, gap.nearest_double()};
}

template <int D>
std::optional<ClosestPair> closest_pair(const State<D>& state, const Effects<D>& effects) {
    check_parts(state, effects);
    require_free_flight(effects);
    if (state.balls.size() < 2) return std::nullopt;
    const exact::IeeeEnvironment environment;
    const NearPairs<D> near(state.balls, effects, state.time, state.time);
    const std::function<bool()> nobody;
    Stop never(nobody);
    const std::vector<NearPair<D>> pairs = *near.closest(NearPairs<D>::no_limit, never);
    const auto [best, gap] = closest_of<D>(pairs, state, effects);
    return ClosestPair{state.time, best.a, best.b, gap.nearest_double()};
}

#define SIGNUM_QUERIES(D)                                                                          \
    template State<D> state_at(const State<D>&, const Effects<D>&, double, const Options&);        \
    template StrikeList strikes_between(const State<D>&, const Effects<D>&, double, double,        \
                                        const Options&);                                           \
    template std::optional<Strike> next_strike(const State<D>&, const Effects<D>&, double, double, \
                                               const Options&);                                    \
    template std::optional<Neighbour> nearest(const State<D>&, const Effects<D>&, std::int32_t);   \
    template std::optional<ClosestPair> closest_pair(const State<D>&, const Effects<D>&);
SIGNUM_QUERIES(2)
SIGNUM_QUERIES(3)
#undef SIGNUM_QUERIES

}  // namespace signum::motion
