#pragma once
/// The meeting of two balls whose time has come: whether it is a strike, and what that does.

#include <algorithm>

#include "clock.hpp"
#include "collapse.hpp"
#include "jams.hpp"

namespace signum::motion {

/// What has become of a meeting.
enum class Met {
    struck,  ///< both fly otherwise
    passed,  ///< it was no strike; the ball strikes something else next
    rests,   ///< the ball lies on a wall and would go through it: a collapse
    jammed   ///< it is to be solved together with others (jams.hpp); nothing has been done
};

/// Two balls that rub. Sums and products of doubles depend on their order: it is that of the balls'
/// numbers.
template <int D, Known known>
void rub(System<D, known>& system, Slot i, Slot j, Ball<D>& a, Ball<D>& b, Facts<D>& facts,
         double push) {
    Slider<D> first{a.v, system.laws.spin(i), system.grown_radius(a), system.agenda[i].mass};
    Slider<D> second{b.v, system.laws.spin(j), system.grown_radius(b), system.agenda[j].mass};
    const Friction& friction = *system.world.effects.friction;
    if (system.agenda[i].number < system.agenda[j].number) {
        slide<D>(first, second, facts.normal, facts.sliding, push, friction);
    } else {
        for (double& each : facts.normal) each = -each;
        for (double& each : facts.sliding) each = -each;
        slide<D>(second, first, facts.normal, facts.sliding, push, friction);
    }
}

template <int D, Known known>
inline Met strike_balls(System<D, known>& system, Slot i,
                        const typename System<D, known>::Record& record) {
    const Effects<D>& effects = system.world.effects;
    Laws<D, known>& laws = system.laws;
    Particle& particle_a = system.agenda[i];
    const Partner partner = particle_a.next.partner;
    const Slot j = partner.slot();
    Particle& particle_b = system.agenda[j];
    const double t = particle_a.next.early;
    StrikeTally tally;
    Ball<D> a = system.arrive(i, t, tally);
    Ball<D> b = system.arrive(j, t, tally);
    const Image<D> seen = nearest_image(a.x, b.x, effects);
    const Ball<D> a_before = a;
    const Ball<D> b_before = b;
    Law law{effects.restitution, 0.0};
    Facts<D> facts;
    if (!laws.is_plain()) [[unlikely]] {
        if (effects.growth) law.growth = growth_of(a, effects) + growth_of(b, effects);
        facts = facts_of(a, b, seen, effects, law.growth);
        const auto bounce = laws.bounce({i, j}, t, law.restitution, facts.approach);
        law.restitution = bounce.restitution;
        facts.stays = bounce.stays;
        facts.rubs = bounce.rubs;
        facts.jams = is_jammed(system, {i, j}, facts.stays, t);
    }
    const double mass_a = particle_a.mass;
    const double mass_b = particle_b.mass;
    Exchange exchange;
    if (system.kernel == Kernel::exact)
        exchange = strike(a, b, seen, mass_a, mass_b, law, effects, tally);
    else
        exchange = naive::strike(a, b, seen, mass_a, mass_b, law, effects);
    system.counts.rounded += tally.refined;
    system.counts.rounded_exactly += tally.exact;
    refuse_missed_strike(system, i, j, a, b, exchange.square);
    if (facts.stays) [[unlikely]]
        if (waits(system, i, partner, t, facts.approach, facts.distance - (a.radius + b.radius)))
            exchange.struck = false;
    if (facts.jams && exchange.struck) [[unlikely]]
        return Met::jammed;
    if (!exchange.struck) {
        system.passed.pass(i, partner, facts.stays ? std::max(t, system.turn) : t);
        if (facts.stays) stand(system, i, partner);
        return Met::passed;
    }
    system.counts.virial += exchange.virial;
    system.last = {t, false, std::min(particle_a.number, particle_b.number),
                   std::max(particle_a.number, particle_b.number), 0.0};
    if (record) {
        system.last.impulse =
            impulse(a_before, b_before, seen, mass_a, mass_b, law, effects, tally);
        record(system.last);
    }
    ++system.counts.strikes;
    ++particle_a.strikes;
    ++particle_b.strikes;
    const auto count = [&](Slot slot, const Ball<D>& came, const Ball<D>& other,
                           const Image<D>& image) {
        count_in_place(system, slot, came, exchange.approach, exchange.square, law.growth, [&] {
            return stayed_in_place_exactly(came, other, image, effects,
                                           system.world.balls[slot].time);
        });
    };
    count(i, a_before, b_before, seen);
    count(j, b_before, a_before, -1 * seen);
    if (!laws.is_plain()) [[unlikely]] {
        if (facts.rubs)
            rub(system, i, j, a, b, facts,
                (1.0 + law.restitution) * facts.approach * (mass_a * mass_b / (mass_a + mass_b)));
        laws.struck(i, t);
        laws.struck(j, t);
    }
    system.put(i, a);
    system.put(j, b);
    if (facts.stays) stand(system, i, partner);
    release(system, i);
    release(system, j);
    return Met::struck;
}

}  // namespace signum::motion
