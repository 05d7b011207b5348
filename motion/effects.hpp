#pragma once
/// What acts on balls: the effects that a simulation is asked for. What is not named is not
/// computed.

#include <optional>
#include <vector>

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
};

/// Restitution that depends on the speed v of approach along the normal: the number that is given
/// is that at `speed`, and 1 - e goes as v^power, e not below 0. A power of 1/5 is that of
/// viscoelastic balls (Brilliantov, Spahn, Hertzsch, Pöschel, Phys. Rev. E 53:5382, 1996), to
/// leading order.
struct SpeedLaw {
    double speed = 1.0;  ///< above 0
    double power = 0.2;  ///< above 0
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
};

/// All radii grow: at time t they are r (1 + rate · t), t from 0 to `until`, and stay as they are
/// then.
struct Growth {
    double rate = 0.0;   ///< above 0
    double until = 0.0;  ///< above 0
};

/// A fluid that flows with velocity u(x) = velocity + gradient · x and drags balls along: it pulls
/// with the force linear · r · (u - v) + quadratic · r^(D-1) · |u - v| (u - v). Needs time steps.
template <int D>
struct Fluid {
    Vector<D> velocity{};              ///< at the origin
    PerAxis<Vector<D>, D> gradient{};  ///< a row an axis
    double linear = 0.0;               ///< from 0
    double quadratic = 0.0;            ///< from 0
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
};

}  // namespace signum::motion
