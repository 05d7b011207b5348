#pragma once
/// Balls, walls and what acts on them as the oracle of motion takes them, and its answers.

#include <algorithm>
#include <array>
#include <optional>

#include "../../motion/meeting_time.hpp"
#include "../../motion/simulation.hpp"
#include "../oracle/motion.hpp"

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

template <int D>
brute::Ball to_brute(const Body<D>& body) {
    brute::Ball ball;
    ball.x = in_space(body.x);
    ball.v = in_space(body.v);
    ball.r = body.radius;
    ball.m = body.mass;
    return ball;
}
template <int D>
brute::Ball to_brute(const GrowingBall<D>& ball) {
    brute::Ball result;
    result.x = in_space(ball.x);
    result.v = in_space(ball.v);
    result.r = ball.radius;
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

}  // namespace signum::motion
