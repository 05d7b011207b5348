#pragma once
/// Contacts that stand, within a time step and when one begins: which of them wait, and what their
/// reactions make of the balls.

#include <algorithm>
#include <cmath>
#include <vector>

#include "../apart.hpp"
#include "../in_place.hpp"
#include "system.hpp"

namespace signum::motion {

/// What laws that are not rational go by: doubles, each operation rounded once.
template <int D>
struct Facts {
    Vector<D> normal{};   ///< from b to a
    Vector<D> sliding{};  ///< v_a - v_b
    double distance = 0.0;
    double approach = 0.0;
    bool stays = false;
    bool rubs = false;
    bool jams = false;
};
template <int D>
[[nodiscard]] inline Facts<D> facts_of(const Ball<D>& a, const Ball<D>& b, const Image<D>& seen,
                                       const Effects<D>& effects, double growth = 0.0) {
    Facts<D> facts;
    facts.normal = apart<double>(a.x, b.x, seen, effects);
    facts.sliding = a.v - b.v;
    facts.distance = norm(facts.normal);
    for (double& each : facts.normal) each /= facts.distance;
    facts.approach = std::max(growth - dot(facts.normal, facts.sliding), 0.0);
    return facts;
}

/// The length of which two in contact may overlap by a visible part: the least radius that is not
/// 0. A point has no radius: its overlap with a wall is beside what its place is rounded by. It may
/// be 2^-40, a 256th of this part, of its largest coordinate, which is 2^13 roundings.
template <int D, Known known>
[[nodiscard]] double scale_of(const System<D, known>& system, Slot i, Partner partner) noexcept {
    constexpr double of_places = 0x1p-32;
    const Ball<D>& a = system.world.balls[i];
    const double other = partner.is_ball() ? system.world.balls[partner.slot()].radius : 0.0;
    if (a.radius > 0.0 && other > 0.0) return std::min(a.radius, other);
    const double radius = std::max(a.radius, other);
    return radius > 0.0 ? radius : of_places * size_of(a);
}

/// Two in contact that approach so slowly that they do not overlap by a visible part of a radius
/// before the next step: that is left to the reactions then. In a chain of contacts each strike
/// would bring about others, ever slower ones.
template <int D, Known known>
[[nodiscard]] bool waits(const System<D, known>& system, Slot i, Partner partner, double t,
                         double approach, double gap) {
    return approach * (system.turn - t) <=
               StandingContacts<D>::allowed(gap, scale_of(system, i, partner)) &&
           system.contacts.has(system.pair_of(i, partner));
}
/// The same of two that have waited, one of which has struck something else now.
template <int D, Known known>
[[nodiscard]] bool waits_still(const System<D, known>& system, Slot i, Partner partner) {
    if (partner.is_wall()) return false;
    const World<D>& world = system.world;
    const auto at_now = [&](Slot slot) {
        Ball<D> ball = world.balls[slot];
        ball.x = world.centre(slot, system.now);
        ball.v = world.velocity(slot, system.now);
        ball.time = system.now;
        return ball;
    };
    const Ball<D> a = at_now(i);
    const Ball<D> b = at_now(partner.slot());
    const Facts<D> facts = facts_of(a, b, nearest_image(a.x, b.x, world.effects), world.effects);
    return waits(system, i, partner, system.now, facts.approach,
                 facts.distance - (a.radius + b.radius));
}
/// What a ball was not to strike it may strike now, but for those in contact that wait.
template <int D, Known known>
inline void release(System<D, known>& system, Slot i) {
    PassedMeetings& passed = system.passed;
    if (passed.is_empty()) return;
    if (!system.laws.has_contacts()) {
        passed.release(i);
        return;
    }
    std::vector<Partner> waiting;
    for (const auto& [partner, until] : passed.of(i))
        if (until >= system.turn && waits_still(system, i, partner)) waiting.push_back(partner);
    passed.release(i);
    for (const Partner partner : waiting) passed.pass(i, partner, system.turn);
}
template <int D, Known known>
void stand(System<D, known>& system, Slot i, Partner partner) {
    if (system.contacts.join(system.pair_of(i, partner))) ++system.counts.joins;
}

/// How the two of a pair lie now.
template <int D, Known known>
[[nodiscard]] auto place_of(const System<D, known>& system,
                            const typename StandingContacts<D>::Pair& pair) {
    const World<D>& world = system.world;
    const Slot i = system.slot_of(pair.first);
    const Partner partner = system.in_slot(pair.second);
    const Ball<D>& a = world.balls[i];
    const bool rubs = system.laws.has_friction();
    typename StandingContacts<D>::Place place;
    place.scale = scale_of(system, i, partner);
    if (partner.is_ball()) {
        const Ball<D>& b = world.balls[partner.slot()];
        const Facts<D> facts =
            facts_of(a, b, nearest_image(a.x, b.x, world.effects), world.effects);
        place.normal = facts.normal;
        place.gap = facts.distance - (a.radius + b.radius);
        if (rubs) place.friction = world.effects.friction->coefficient;
        return place;
    }
    const Wall wall = partner.wall();
    place.normal = unit_normal(system.walls.facing(a, wall));
    place.gap = system.walls.gap(a, wall);
    place.wall_velocity = wall < 2 * D ? system.side_velocities[static_cast<std::size_t>(wall)]
                                       : system.walls.velocity(wall, system.now);
    place.curvature = system.walls.curvature(a, wall);
    if (rubs) place.friction = world.effects.friction->wall_coefficient;
    return place;
}

/// The contacts that are taken, from now until the step that began then is over.
template <int D, Known known, class Takes>
void react(System<D, known>& system, double began, double step, const Takes& takes) {
    World<D>& world = system.world;
    Laws<D, known>& laws = system.laws;
    system.side_velocities = system.walls.side_velocities(began, system.steps.length());
    const auto body = [&](std::int32_t number) {
        const Slot i = system.slot_of(number);
        const Ball<D>& ball = world.balls[i];
        const double mass = system.agenda[i].mass;
        ContactBody<D> result{ball.v, {}, {mass, ball.radius, 1.0}};
        // A point does not turn.
        if (laws.has_friction() && ball.radius > 0.0) {
            result.spin = laws.spin(i);
            result.inert.inertia =
                world.effects.friction->inertia * mass * (ball.radius * ball.radius);
        }
        return result;
    };
    const auto put_body = [&](std::int32_t number, const ContactBody<D>& after) {
        const Slot i = system.slot_of(number);
        world.balls[i].v = after.velocity;
        if (laws.has_friction() && world.balls[i].radius > 0.0) laws.spin(i) = after.spin;
    };
    const ContactReport report = system.contacts.begin_step(
        step, StandingContacts<D>::undone_a_step * (step / system.steps.length()),
        *world.effects.contacts, takes, [&](const auto& pair) { return place_of(system, pair); },
        body, put_body, system.counts.breaks);
    system.counts.residual = std::max(system.counts.residual, report.residual);
    system.counts.unsolved += static_cast<std::uint64_t>(!report.converged());
}
inline constexpr auto all_contacts = [](const auto&) { return true; };
/// Until the next step they are no strikes, but for those that the reactions found in the step's
/// sweeps leave too fast.
template <int D, Known known, class Takes>
void pass_contacts(System<D, known>& system, const Takes& takes) {
    for (const auto& [pair, momenta] : system.contacts.all())
        if (momenta.waits && takes(pair))
            system.passed.pass(system.slot_of(pair.first), system.in_slot(pair.second),
                               system.turn);
}

}  // namespace signum::motion
