/// Balls in flight, behind signum.h: one text for the plane and for space.

#include "../../motion/simulation.hpp"

#include <cstdint>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "../../motion/meeting_time.hpp"
#include "../../motion/queries.hpp"
#include "boundary.hpp"
#include "handles.hpp"

namespace signum::c {
namespace {

constexpr double without_end = std::numeric_limits<double>::infinity();

template <int D>
[[nodiscard]] motion::Vector<D> vector_of(const double* numbers) noexcept {
    motion::Vector<D> vector;
    std::copy(numbers, numbers + D, vector.begin());
    return vector;
}

[[nodiscard]] signum_effects read_effects(const signum_effects* effects) {
    expect(effects, "effects");
    signum_effects read = c::read(effects, signum_effects SIGNUM_EFFECTS(2), "effects");
    if (read.dimension != 2 && read.dimension != 3)
        throw Refused("balls are in 2 or 3 dimensions, not in " + std::to_string(read.dimension));
    if (read.box < SIGNUM_NO_BOX || read.box > SIGNUM_PERIODIC)
        throw Refused("there is no kind of box " + std::to_string(read.box));
    return read;
}

template <int D>
[[nodiscard]] motion::Obstacle<D> obstacle_of(const signum_obstacle& given) {
    using Side = typename motion::Sphere<D>::Side;
    switch (given.kind) {
        case SIGNUM_HALF_SPACE:
            return motion::HalfSpace<D>{vector_of<D>(given.at), given.size, given.speed};
        case SIGNUM_PILLAR:
        case SIGNUM_DRUM:
            return motion::Sphere<D>{vector_of<D>(given.at), vector_of<D>(given.to), given.size,
                                     given.kind == SIGNUM_DRUM ? Side::inside : Side::outside};
        case SIGNUM_SEGMENT:
            if constexpr (D == 2)
                return motion::Segment{vector_of<2>(given.at), vector_of<2>(given.to)};
            throw Refused("segments are of the plane");
        default:
            throw Refused("there is no kind of obstacle " + std::to_string(given.kind));
    }
}

template <int D>
[[nodiscard]] motion::Effects<D> effects_of(const signum_effects& given) {
    motion::Effects<D> effects;
    effects.gravity = vector_of<D>(given.gravity);
    effects.restitution = given.restitution;
    effects.wall_restitution = given.wall_restitution;
    effects.contact_duration = given.contact_duration;
    if (given.box != SIGNUM_NO_BOX)
        effects.box = motion::Box<D>{vector_of<D>(given.low), vector_of<D>(given.high)};
    effects.periodic = given.box == SIGNUM_PERIODIC;
    if (given.growth_rate != 0.0)
        effects.growth = motion::Growth{given.growth_rate, given.growth_until};
    if (given.law_speed != 0.0) effects.speed_law = {given.law_speed, given.law_power};
    if (given.has_friction != 0)
        effects.friction = {given.friction, given.wall_friction, given.tangential_restitution,
                            given.inertia};
    if (given.shake_frequency != 0.0)
        effects.shake = {vector_of<D>(given.shake_amplitude), given.shake_frequency,
                         given.shake_phase};
    if (given.fluid_linear != 0.0 || given.fluid_quadratic != 0.0) {
        effects.fluid = {
            vector_of<D>(given.fluid_velocity), {}, given.fluid_linear, given.fluid_quadratic};
        for (int k = 0; k < D; ++k)
            effects.fluid->gradient[k] = vector_of<D>(given.fluid_gradient + 3 * k);
    }
    if (given.contact_speed != 0.0)
        effects.contacts = {given.contact_speed, given.contact_tolerance, given.contact_sweeps};
    effects.time_step = given.time_step;
    expect_array(given.obstacles, given.obstacle_count, "obstacles");
    for (std::int64_t i = 0; i < given.obstacle_count; ++i)
        effects.obstacles.push_back(obstacle_of<D>(given.obstacles[i]));
    return effects;
}

/// What motion::start() refuses of effects, where no balls are started.
template <int D>
void expect_sound(const motion::Effects<D>& effects) {
    (void)motion::start(std::span<const motion::Body<D>>{}, effects);
}

template <int D>
[[nodiscard]] motion::GrowingBall<D> growing(const signum_ball& ball,
                                             const motion::Effects<D>& effects) {
    if (!finite<D>(ball.x) || !finite<D>(ball.v) || !finite<1>(&ball.radius) ||
        !finite<1>(&ball.time))
        throw Refused("a ball is not finite");
    if (ball.radius < 0.0) throw Refused("a radius is negative");
    motion::GrowingBall<D> grown;
    grown.x = vector_of<D>(ball.x);
    grown.v = vector_of<D>(ball.v);
    grown.radius = ball.radius;
    grown.time = ball.time;
    grown.growth = motion::growth_of(grown, effects);
    return grown;
}

[[nodiscard]] signum_strike told(const motion::Strike& strike) noexcept {
    return {strike.time, strike.impulse, strike.wall ? 1 : 0, strike.a, strike.b, 0};
}

/// The balls of D dimensions, and what acts on them.
template <int D>
struct World {
    World(const motion::State<D>& start, motion::Effects<D> acting)
        : effects(std::move(acting)), size(start.balls.size()), simulation(start, effects) {}

    motion::Effects<D> effects;
    std::size_t size;
    motion::Simulation<D> simulation;
};

template <int D>
[[nodiscard]] World<D> world_of(const signum_ball* balls, std::int64_t count,
                                const signum_effects& given) {
    const motion::Effects<D> effects = effects_of<D>(given);
    std::vector<motion::Body<D>> bodies;
    bodies.reserve(static_cast<std::size_t>(count));
    for (std::int64_t i = 0; i < count; ++i)
        bodies.push_back({.x = vector_of<D>(balls[i].x),
                          .v = vector_of<D>(balls[i].v),
                          .radius = balls[i].radius,
                          .mass = balls[i].mass,
                          .spin = {}});
    return {motion::start(std::span<const motion::Body<D>>(bodies), effects), effects};
}

using AnyWorld = std::variant<World<2>, World<3>>;

template <int D>
[[nodiscard]] motion::Outcome run(motion::Simulation<D>& simulation, const signum_limits& limits) {
    struct SaidStop {};
    motion::Limits until{limits.until, limits.strikes, {}};
    if (limits.stop != nullptr) until.stop = [&limits] { return limits.stop(limits.user) != 0; };
    typename motion::Simulation<D>::Record record;
    if (limits.record != nullptr)
        record = [&limits](const motion::Strike& strike) {
            const signum_strike line = told(strike);
            if (limits.record(&line, limits.user) != 0) throw SaidStop{};
        };
    try {
        return simulation.run(until, record);
    } catch (SaidStop) {
        return {motion::Ending::stopped, {}};
    }
}

}  // namespace
}  // namespace signum::c

struct signum_simulation {
    static constexpr const char* name = "simulation";
    signum::c::AnyWorld world;
    bool is_calling = false;  ///< record or stop, or may do so
};

using namespace signum;
using c::expect;
using c::guarded;

namespace {

/// Gives `ask` the world of a simulation that is not at work, where there is a place for every
/// answer.
template <class Simulation, class Ask>
signum_status with_world(Simulation* simulation, signum_error* error, std::int64_t about,
                         std::initializer_list<std::pair<const void*, const char*>> places,
                         Ask&& ask) noexcept {
    return guarded(error, about, [&] {
        for (const auto& [place, name] : places) expect(place, name);
        c::expect(simulation);
        std::visit(ask, simulation->world);
    });
}

}  // namespace

signum_status signum_meeting_time(const signum_ball* a, const signum_ball* b,
                                  const signum_effects* effects, double until, double* time,
                                  signum_error* error) {
    return guarded(error, [&] {
        expect(a, "a");
        expect(b, "b");
        expect(time, "time");
        const signum_effects given = c::read_effects(effects);
        if (std::isnan(until)) throw c::Refused("until is not a number");
        const auto ask = [&]<int D>(std::integral_constant<int, D>) {
            const motion::Effects<D> acting = c::effects_of<D>(given);
            c::expect_sound(acting);
            return motion::meeting_time(c::growing(*a, acting), c::growing(*b, acting), acting,
                                        until);
        };
        *time = given.dimension == 2 ? ask(std::integral_constant<int, 2>{})
                                     : ask(std::integral_constant<int, 3>{});
    });
}

signum_status signum_simulation_create(const signum_ball* balls, int64_t count,
                                       const signum_effects* effects,
                                       signum_simulation** simulation, signum_error* error) {
    return c::create(simulation, error, [&] {
        c::expect_array(balls, count, "balls");
        const signum_effects given = c::read_effects(effects);
        return given.dimension == 2 ? c::AnyWorld(c::world_of<2>(balls, count, given))
                                    : c::AnyWorld(c::world_of<3>(balls, count, given));
    });
}

void signum_simulation_free(signum_simulation* simulation) {
    c::free_at_rest(simulation);
}

signum_status signum_simulation_run(signum_simulation* simulation, const signum_limits* limits,
                                    signum_ending* ending, signum_strike* last,
                                    signum_error* error) {
    return guarded(error, [&] {
        const signum_limits far = c::read(limits, signum_limits SIGNUM_LIMITS, "limits");
        c::expect(simulation);
        const c::Calling calling(simulation->is_calling);
        const motion::Outcome outcome = std::visit(
            [&](auto& world) { return c::run(world.simulation, far); }, simulation->world);
        if (ending != nullptr) *ending = static_cast<signum_ending>(outcome.ending);
        if (last != nullptr) *last = c::told(outcome.last);
    });
}

signum_status signum_simulation_time(const signum_simulation* simulation, double* time,
                                     signum_error* error) {
    return with_world(simulation, error, -1, {{time, "time"}},
                      [&](const auto& world) { *time = world.simulation.state().time; });
}

signum_status signum_simulation_balls(const signum_simulation* simulation, signum_ball* balls,
                                      int64_t count, signum_error* error) {
    return with_world(simulation, error, -1, {}, [&]<int D>(const c::World<D>& world) {
        c::expect_room(balls, count, world.size, "balls");
        const motion::State<D> state = world.simulation.state();
        for (std::size_t i = 0; i < state.balls.size(); ++i) {
            const motion::Ball<D>& ball = state.balls[i];
            signum_ball told = {{}, {}, ball.radius, ball.time, state.masses[i]};
            std::copy(ball.x.begin(), ball.x.end(), told.x);
            std::copy(ball.v.begin(), ball.v.end(), told.v);
            balls[i] = told;
        }
    });
}

signum_status signum_simulation_spins(const signum_simulation* simulation, double* spins,
                                      int64_t count, signum_error* error) {
    return with_world(simulation, error, -1, {}, [&]<int D>(const c::World<D>& world) {
        c::expect_room(spins, count, world.size, "balls");
        std::fill(spins, spins + 3 * count, 0.0);
        const motion::State<D> state = world.simulation.state();
        for (std::size_t i = 0; i < state.spins.size(); ++i)
            std::copy(state.spins[i].begin(), state.spins[i].end(),
                      spins + 3 * i + (D == 2 ? 2 : 0));
    });
}

int64_t signum_simulation_size(const signum_simulation* simulation) {
    if (simulation == nullptr) return 0;
    return std::visit([](const auto& world) { return static_cast<std::int64_t>(world.size); },
                      simulation->world);
}

uint64_t signum_simulation_strikes(const signum_simulation* simulation) {
    if (simulation == nullptr) return 0;
    return std::visit([](const auto& world) { return world.simulation.counts().strikes; },
                      simulation->world);
}

signum_status signum_simulation_next_strike(const signum_simulation* simulation, double time,
                                            double until, int32_t* found, signum_strike* strike,
                                            signum_error* error) {
    const auto ask = [&](const auto& world) {
        const std::optional<motion::Strike> next =
            motion::next_strike(world.simulation.state(), world.effects, time, until);
        *found = next.has_value();
        if (next) *strike = c::told(*next);
    };
    return with_world(simulation, error, -1, {{found, "found"}, {strike, "strike"}}, ask);
}

signum_status signum_simulation_nearest(const signum_simulation* simulation, int32_t ball,
                                        int32_t* neighbour, double* gap, signum_error* error) {
    const auto ask = [&](const auto& world) {
        const auto near = motion::nearest(world.simulation.state(), world.effects, ball)
                              .value_or(motion::Neighbour{-1, c::without_end});
        *neighbour = near.ball;
        *gap = near.gap;
    };
    return with_world(simulation, error, ball, {{neighbour, "neighbour"}, {gap, "gap"}}, ask);
}

signum_status signum_simulation_closest_pair(const signum_simulation* simulation, int32_t* a,
                                             int32_t* b, double* gap, signum_error* error) {
    const auto ask = [&](const auto& world) {
        const auto pair = motion::closest_pair(world.simulation.state(), world.effects)
                              .value_or(motion::ClosestPair{0.0, -1, -1, c::without_end});
        *a = pair.a;
        *b = pair.b;
        *gap = pair.gap;
    };
    return with_world(simulation, error, -1, {{a, "a"}, {b, "b"}, {gap, "gap"}}, ask);
}
