#pragma once
/// The meeting of a ball and a wall whose time has come: whether it is a strike, and what that
/// does.

#include <algorithm>
#include <cmath>

#include "strikes.hpp"

namespace signum::motion {

/// A flight along a hollow wall until the next step.
template <int D>
struct Hollow {
    double approach = 0.0;  ///< the mean speed at which it would enter; 0 where it does not
    double turn = 0.0;      ///< the sine of the angle by which a chord parts from it
    Vector<D> normal{};
    Vector<D> wall_velocity{};
};
template <int D, Known known>
[[nodiscard]] Hollow<D> hollow_of(const System<D, known>& system, const Ball<D>& ball,
                                  const Facing<D>& faces, Wall wall) {
    const double curvature = system.walls.curvature(ball, wall);
    if (!(curvature > 0.0)) return {};
    Hollow<D> hollow{0.0, 0.0, unit_normal(faces), system.walls.velocity(wall, ball.time)};
    const double speed =
        StandingContacts<D>::speed_along(ball.v, hollow.wall_velocity, hollow.normal);
    const double length = speed * (system.turn - ball.time);
    hollow.turn = StandingContacts<D>::sine_inwards(curvature, length);
    hollow.approach = 0.5 * curvature * length * speed;
    return hollow;
}
/// Makes it a chord, as fast.
template <int D>
void turn_inwards(Ball<D>& ball, const Hollow<D>& hollow) noexcept {
    const Vector<D> v = ball.v - hollow.wall_velocity;
    const double speed =
        StandingContacts<D>::speed_along(ball.v, hollow.wall_velocity, hollow.normal);
    const double ahead = std::sqrt(1.0 - hollow.turn * hollow.turn);
    ball.v = hollow.wall_velocity + ahead * (v - dot(v, hollow.normal) * hollow.normal) +
             hollow.turn * speed * hollow.normal;
}

/// A ball that comes to a wall, and is not changed. Where the gap between them bends down it lies
/// on it, and would go through.
template <int D, Known known>
[[nodiscard]] Met rest(System<D, known>& system, Slot i, const Ball<D>& came, Wall wall) {
    if (system.walls.bends_down(came, wall)) return Met::rests;
    system.passed.pass(i, Partner::wall(wall), came.time);
    return Met::passed;
}

template <int D, Known known>
inline void tell_strike(System<D, known>& system, Slot i, double impulse,
                        const typename System<D, known>::Record& record) {
    if (record) {
        system.last.impulse = impulse;
        record(system.last);
    }
    ++system.counts.strikes;
    ++system.agenda[i].strikes;
}

/// Any wall, by any law.
template <int D, Known known>
[[gnu::cold, gnu::noinline]] Met strike_surface(System<D, known>& system, Slot i, Wall wall,
                                                const Ball<D>& came,
                                                const typename System<D, known>::Record& record) {
    const Effects<D>& effects = system.world.effects;
    Laws<D, known>& laws = system.laws;
    const Walls<D>& walls = system.walls;
    const double t = came.time;
    const Partner partner = Partner::wall(wall);
    Ball<D> ball = came;
    const double mass = system.agenda[i].mass;
    const Facing<D> faces = walls.facing(ball, wall);
    const double growth = growth_of(ball, effects);
    const double approach = laws.is_plain() ? 0.0 : approach_of(ball, faces, growth);
    const auto bounce = laws.bounce({i}, t, effects.wall_restitution, approach);
    Exchange exchange = strike(ball, faces, mass, bounce.restitution, growth);
    if (!system.is_side(wall) && system.kernel == Kernel::exact &&
        !system.contacts.has(system.pair_of(i, partner)))
        refuse_missed_wall(system, i, wall, came);
    if (bounce.stays) {
        const Hollow<D> hollow = hollow_of(system, came, faces, wall);
        if (waits(system, i, partner, t, approach + hollow.approach, walls.gap(came, wall))) {
            exchange.struck = false;
        } else if (hollow.approach > 0.0) {
            turn_inwards(ball, hollow);
            exchange.struck = true;
        }
    }
    if (exchange.struck && is_jammed(system, {i}, bounce.stays, t)) return Met::jammed;
    if (!exchange.struck) {
        if (!bounce.stays) return rest(system, i, came, wall);
        system.passed.pass(i, partner, std::max(t, system.turn));
        stand(system, i, partner);
        return Met::passed;
    }
    tell_strike(system, i, exchange.impulse, record);
    count_in_place(
        system, i, came, exchange.approach, exchange.square, growth,
        [&] { return stayed_in_place_exactly(came, faces, growth, system.world.balls[i].time); },
        system.moves(wall));
    if (bounce.rubs) {
        slide<D>({ball.v, laws.spin(i), system.grown_radius(ball), mass}, unit_normal(faces),
                 came.v - walls.velocity(wall, t), exchange.impulse, *effects.friction);
    }
    laws.struck(i, t);
    system.put(i, ball);
    if (bounce.stays) stand(system, i, partner);
    release(system, i);
    return Met::struck;
}

template <int D, Known known>
inline Met strike_wall(System<D, known>& system, Slot i,
                       const typename System<D, known>::Record& record) {
    const Particle& particle = system.agenda[i];
    const Wall wall = particle.next.partner.wall();
    const double t = particle.next.early;
    StrikeTally tally;
    Ball<D> ball = system.arrive(i, t, tally);
    const Ball<D> came = ball;
    system.last = {t, true, particle.number, wall, 0.0};
    const Law law{system.world.effects.wall_restitution, 0.0};
    if (!system.laws.is_plain() || !system.is_side(wall)) [[unlikely]]
        return strike_surface(system, i, wall, ball, record);
    if (!strike(ball, wall, law)) return rest(system, i, came, wall);
    tell_strike(system, i, record ? impulse(came, wall, particle.mass, law) : 0.0, record);
    count_in_place(system, i, came, std::fabs(came.v[wall / 2]), 1.0, 0.0, [&] {
        return stayed_in_place_exactly(came, facing_side<D>(wall), 0.0, system.world.balls[i].time);
    });
    system.put(i, ball);
    release(system, i);
    return Met::struck;
}

}  // namespace signum::motion
