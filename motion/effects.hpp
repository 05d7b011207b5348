#pragma once
/// What acts on balls: the effects that a simulation is asked for. What is not named is not
/// computed. each_field() of an effect calls visit(pointer to member, Field) for each of its
/// members: checks, states, scenes and Python know no other list of them.

#include <optional>
#include <type_traits>
#include <vector>

#include "field.hpp"
#include "obstacle.hpp"
#include "vector.hpp"

namespace signum::motion {

/// The box's sides go to and fro together: by amplitude · sin(frequency · t + phase).
template <int D>
struct Shake {
    Vector<D> amplitude{};   ///< along each axis
    double frequency = 0.0;  ///< in radians per unit of time
    double phase = 0.0;      ///< in radians
    friend bool operator==(const Shake&, const Shake&) = default;

    /// Describes the members.
    static constexpr void each_field(const auto& visit) {
        visit(&Shake::amplitude,
              {"amplitude",
               dimensions::length,
               {},
               "say how far the box goes along each axis, as in amplitude = [0, 5]"});
        visit(&Shake::frequency, {.name = "frequency",
                                  .dimension = dimensions::angular_speed,
                                  .advice = "say how often, as in frequency = \"20 Hz\"",
                                  .written = {.least = 0.0,
                                              .is_open = true,
                                              .words = "a frequency above 0, as in \"20 Hz\""}});
        visit(&Shake::phase, {"phase", dimensions::angle});
    }
};

/// Restitution that depends on the speed v of approach along the normal: the number that is given
/// is that at `speed`, and 1 - e goes as v^power, e not below 0. A power of 1/5 is that of
/// viscoelastic balls (Brilliantov, Spahn, Hertzsch, Pöschel, Phys. Rev. E 53:5382, 1996), to
/// leading order.
struct SpeedLaw {
    double speed = 1.0;  ///< above 0
    double power = 0.2;  ///< above 0, at most 8

    /// Describes the members.
    static constexpr void each_field(const auto& visit) {
        visit(&SpeedLaw::speed, {"speed", dimensions::speed, above_0,
                                 "give the speed at which restitution is as given"});
        visit(&SpeedLaw::power,
              {"power", {}, {0.0, 8.0, true, "a number above 0, at most 8", true}});
    }
};

/// Balls spin, and surfaces that slide at a strike exchange momentum along them (Walton 1993): as
/// much as makes the sliding speed -β times what it was, at most μ times the momentum along the
/// normal.
struct Friction {
    double coefficient = 0.0;             ///< μ of two balls, from 0
    double wall_coefficient = 0.0;        ///< μ of a ball and a wall or obstacle
    double tangential_restitution = 0.0;  ///< β, from -1 to 1: 0 stops the sliding, 1 turns it back
    /// I / m r², above 0: 1/2 of discs, 2/5 of balls. A ball of radius 0 does not turn.
    double inertia = 0.5;

    /// Describes the members.
    static constexpr void each_field(const auto& visit) {
        visit(&Friction::coefficient, {"coefficient", {}, from_0});
        visit(&Friction::wall_coefficient, {"wall_coefficient", {}, from_0});
        visit(&Friction::tangential_restitution,
              {"tangential_restitution", {}, {-1.0, 1.0, false, "a number from -1 to 1", true}});
        visit(&Friction::inertia, {.name = "inertia",
                                   .range = {0.0, 1.0, true, "a number above 0, at most 1"},
                                   .in_space = 0.4});
    }
};

/// All radii grow: at time t they are r (1 + rate · t), t from 0 to `until`, and stay as they are
/// then.
struct Growth {
    double rate = 0.0;   ///< above 0
    double until = 0.0;  ///< above 0

    /// Describes the members.
    static constexpr void each_field(const auto& visit) {
        visit(&Growth::rate,
              {"rate", dimensions::rate, above_0,
               "give the share of its radius by which a ball grows in a unit of time"});
        visit(&Growth::until,
              {"until", dimensions::time, above_0, "give the time at which radii stay"});
    }
};

/// A fluid that flows with velocity u(x) = velocity + gradient · x and drags balls along: it pulls
/// with the force linear · r · (u - v) + quadratic · r^(D-1) · |u - v| (u - v). Needs time steps.
template <int D>
struct Fluid {
    Vector<D> velocity{};              ///< at the origin
    PerAxis<Vector<D>, D> gradient{};  ///< a row an axis
    double linear = 0.0;               ///< from 0
    double quadratic = 0.0;            ///< from 0

    /// Describes the members.
    static constexpr void each_field(const auto& visit) {
        visit(&Fluid::velocity, {"velocity", dimensions::speed});
        visit(&Fluid::gradient, {"gradient", dimensions::rate});
        visit(&Fluid::linear, {"linear", {.length = -1, .time = -1, .mass = 1}, from_0});
        visit(&Fluid::quadratic, {"quadratic", {.length = -D, .mass = 1}, from_0});
    }
};

/// Balls whose speed along the normal after a strike would be below a threshold stay in contact, as
/// long as what presses them together does. Needs time steps, and friction is that of Friction.
struct LastingContacts {
    double speed = 0.0;  ///< the threshold, above 0
    /// Their reactions are found by sweeps through all contacts, until what is left of the laws is
    /// that part of the largest speed of approach (effects/contact_forces.hpp), or the sweeps are
    /// spent.
    double tolerance = 1e-10;  ///< between 0 and 1
    int sweeps = 1000;         ///< from 2

    /// Describes the members.
    static constexpr void each_field(const auto& visit) {
        visit(&LastingContacts::speed, {"speed", dimensions::speed, above_0,
                                        "give the speed below which balls stay in contact"});
        visit(&LastingContacts::tolerance,
              {"tolerance", {}, {0.0, 1.0 - 0x1p-53, true, "a number above 0, below 1", true}});
        visit(&LastingContacts::sweeps, {.name = "sweeps",
                                         .range = {.least = 2.0, .words = "2 or more"},
                                         .written = {.least = 2.0, .most = 1e6}});
    }
};

/// What acts on balls beside their strikes, and how they strike. None of it is on by default.
template <int D>
struct Effects {
    /// The acceleration of all balls.
    Vector<D> gravity{};
    /// The ratio of the speeds after and before a strike along its normal: from 0 to 1, elastic.
    double restitution = 1.0;
    /// The same against walls and obstacles.
    double wall_restitution = 1.0;
    /// Both depend on speed.
    std::optional<SpeedLaw> speed_law = {};
    /// A strike is elastic that comes no later than that after one of the two has struck last
    /// (Luding, McNamara, Granular Matter 1:113, 1998); 0 is never.
    double contact_duration = 0.0;
    /// Balls spin, and rub.
    std::optional<Friction> friction = {};
    /// Walls around all balls, or the cell of a periodic world.
    std::optional<Box<D>> box = {};
    /// Whether the box is a cell, and what leaves it on one side comes in on the other.
    bool periodic = false;
    /// Of the box, which is not periodic.
    std::optional<Shake<D>> shake = {};
    /// The log's number of the first one is 2 D, after the sides of a box, be there one or not.
    std::vector<Obstacle<D>> obstacles = {};
    /// Radii grow.
    std::optional<Growth> growth = {};
    /// Balls are dragged along.
    std::optional<Fluid<D>> fluid = {};
    /// Balls may come to rest on one another.
    std::optional<LastingContacts> contacts = {};
    /// Forces, gravity among them, act by kicks in steps of that time, between which all balls fly
    /// straight; 0 is none: then flights are parabolas, without error.
    double time_step = 0.0;

    /// Describes the members, in the order in which a state has them.
    static constexpr void each_field(const auto& visit) {
        visit(&Effects::restitution,
              {.name = "restitution", .range = from_0_to_1, .is_always_kept = true});
        visit(&Effects::wall_restitution,
              {.name = "wall_restitution", .range = from_0_to_1, .is_always_kept = true});
        visit(&Effects::periodic, {.name = "periodic", .section = "box", .is_always_kept = true});
        visit(&Effects::gravity,
              {.name = "gravity", .dimension = dimensions::acceleration, .is_always_kept = true});
        visit(&Effects::box, {.name = "box", .dimension = dimensions::length, .section = ""});
        visit(&Effects::speed_law,
              {.name = "speed_law",
               .told = "that restitution at {}; 1 - e goes as speed^{}",
               .costs = "a power a strike, in doubles in a fixed order",
               .without = "restitution is the same at all speeds; slow strikes would lose less"});
        visit(&Effects::contact_duration, {.name = "contact_duration",
                                           .dimension = dimensions::time,
                                           .range = from_0,
                                           .told = "elastic within {} of the last strike",
                                           .costs = "the time of each ball's last strike",
                                           .without = "elastic balls come to no rest"});
        visit(&Effects::friction,
              {.name = "friction",
               .told = "{}, at walls {}; tangential restitution {}, inertia {} m r²",
               .costs = "a spin a ball; strikes exchange momentum along surfaces, too",
               .without =
                   "balls are smooth and have no spin; what slides would be slowed, and roll"});
        visit(
            &Effects::shake,
            {.name = "shake",
             .section = "box",
             .told = "by {}, {}",
             .costs = "meetings with sides are roots of a sine, each told exactly",
             .without = "the box stands still; meetings with its sides are roots of polynomials"});
        visit(&Effects::growth,
              {.name = "growth",
               .told = "radii grow by {} until {}",
               .costs = "a radius is a line in time; pairs still meet at roots of quadratics",
               .without = "radii are as given"});
        visit(&Effects::fluid,
              {.name = "fluid",
               .stepped = "what a fluid does",
               .told = "flows by {0}; linear {2}, quadratic {3}",
               .costs = "time steps: velocities change at each",
               .without = "nothing drags; a flight has a formula and needs no steps"});
        visit(&Effects::contacts,
              {.name = "contacts",
               .stepped = "contact that lasts",
               .told = "below {} after a strike",
               .costs = "time steps: at each the reactions of all who touch are solved for",
               .without = "strikes are instants; nothing rests on anything"});
        visit(&Effects::time_step, {.name = "time_step",
                                    .dimension = dimensions::time,
                                    .range = from_0,
                                    .written = above_0,
                                    .section = "run"});
        visit(&Effects::obstacles, {.name = "obstacles", .section = ""});
    }
};

/// An effect of D dimensions of which nothing is said but that it is on.
template <class Effect, int D>
[[nodiscard]] constexpr Effect by_default() {
    Effect effect;
    Effect::each_field([&]<class Value>(Value Effect::*member, const Field& field) {
        if constexpr (std::is_same_v<Value, double>)
            if (D == 3 && field.in_space) effect.*member = *field.in_space;
    });
    return effect;
}

}  // namespace signum::motion
