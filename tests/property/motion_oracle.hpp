#pragma once
/// Balls, walls and what acts on them as the oracle of motion takes them, and its answers.

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "../../motion/meeting_time.hpp"
#include "../../motion/simulation.hpp"
#include "../oracle/motion.hpp"
#include "motion_scenes.hpp"

namespace signum::motion {

namespace brute = oracle::motion;

template <int D>
std::array<double, 3> in_space(const Vector<D>& v) {
    std::array<double, 3> result{};
    std::ranges::copy(v, result.begin());
    return result;
}

template <int D>
brute::World to_brute(const Effects<D>& effects) {
    brute::World world;
    world.dimension = D;
    world.g = in_space(effects.gravity);
    world.restitution = effects.restitution;
    world.wall_restitution = effects.wall_restitution;
    if (!effects.box) return world;
    const auto low = in_space(effects.box->low);
    const auto high = in_space(effects.box->high);
    world.periodic = effects.periodic;
    if (effects.periodic) {
        world.low = low;
        world.high = high;
    } else {
        world.walls = brute::box_walls(low, high, D);
    }
    return world;
}

brute::Ball flying(const auto& ball) {
    brute::Ball result;
    result.x = in_space(ball.x);
    result.v = in_space(ball.v);
    result.r = ball.radius;
    return result;
}
template <int D>
brute::Ball to_brute(const Body<D>& body) {
    brute::Ball result = flying(body);
    result.m = body.mass;
    return result;
}
template <int D>
brute::Ball to_brute(const GrowingBall<D>& ball) {
    brute::Ball result = flying(ball);
    result.t0 = ball.time;
    result.growth = ball.growth;
    return result;
}

template <int D>
brute::Wall to_brute(const HalfSpace<D>& wall) {
    brute::Wall result;
    result.kind = brute::Wall::Kind::half_space;
    result.n = in_space(wall.normal);
    result.c = wall.offset;
    result.w = wall.speed;
    return result;
}
template <int D>
brute::Wall to_brute(const Sphere<D>& wall) {
    brute::Wall result;
    result.kind = wall.side == Sphere<D>::Side::inside ? brute::Wall::Kind::inside
                                                       : brute::Wall::Kind::outside;
    result.centre = in_space(wall.centre);
    result.u = in_space(wall.velocity);
    result.radius = wall.radius;
    return result;
}

inline double or_never(const std::optional<double>& time) {
    return time.value_or(infinity);
}

/// The oracle's meeting_time().
template <int D, class Partner>
double brute_meeting_time(const GrowingBall<D>& ball, const Partner& partner,
                          const Effects<D>& effects, double until = infinity) {
    return or_never(
        brute::meeting_time(to_brute(ball), to_brute(partner), to_brute(effects), until));
}

/// All structures write the oracle's log, up to a time and a number of strikes; told is how many
/// there were. Precondition: there is no segment.
template <int D>
void expect_log_of_oracle(const Scene<D>& scene, double until, std::size_t most,
                          std::size_t* strikes = nullptr) {
    std::vector<brute::Ball> balls;
    for (const Body<D>& body : scene.bodies) balls.push_back(to_brute(body));
    brute::World world = to_brute(scene.effects);
    // The oracle numbers those walls alone that there are.
    const int first_wall = static_cast<int>(2 * D - world.walls.size());
    for (const Obstacle<D>& obstacle : scene.effects.obstacles) {
        std::visit(
            [&](const auto& wall) {
                if constexpr (!std::is_same_v<decltype(wall), const Segment&>)
                    world.walls.push_back(to_brute(wall));
            },
            obstacle);
    }
    const brute::Run expected = brute::simulate(balls, world, until, most);
    if (strikes != nullptr) *strikes += expected.log.size();
    const State<D> first = start<D>(scene.bodies, scene.effects);
    for (const Structure structure : all_structures) {
        SCOPED_TRACE(std::string(name_of(structure)));
        Simulation<D> simulation(first, scene.effects, {.structure = structure});
        std::vector<Strike> log;
        const Outcome outcome =
            simulation.run({.until = until, .strikes = most},
                           [&](const Strike& strike) { log.push_back(strike); });
        for (std::size_t i = 0; i < std::min(log.size(), expected.log.size()); ++i) {
            const brute::Strike& e = expected.log[i];
            ASSERT_EQ(log[i],
                      (Strike{e.time, e.wall, e.a, e.wall ? e.b + first_wall : e.b, e.impulse}))
                << "strike " << i << ": " << log[i].time << " " << log[i].wall << " " << log[i].a
                << " " << log[i].b << " " << log[i].impulse << ", expected " << e.time << " "
                << e.wall << " " << e.a << " " << e.b << " " << e.impulse;
        }
        ASSERT_EQ(log.size(), expected.log.size());
        ASSERT_EQ(outcome.ending == Ending::collapse, expected.collapsed);
    }
}

}  // namespace signum::motion
