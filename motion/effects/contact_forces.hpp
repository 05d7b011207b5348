#pragma once
/// Lasting contacts: the impulses of one time step at all contacts that hang together.
///
/// Given are velocities to which forces have been added already, and contacts with unit normal n
/// (from b to a), gap g, friction coefficient μ; h is the time step. Found are impulses
/// p = p_n n + p_t, p on a and -p on b, such that after them
///
///     p_n >= 0,   u_n + g/h >= 0,   p_n (u_n + g/h) = 0      (no restitution, no overlap after h)
///     |p_t| <= μ p_n,   and where it slides   p_t = -μ p_n u_t / |u_t|               (Coulomb)
///
/// where u is the velocity of a's surface at the contact relative to b's. A gap of at most 2^-36 of
/// the radii counts as 0: a pile has more contacts than ways to move, and what rounding left open
/// cannot be closed everywhere at once.
///
/// Impulses need not be unique, and with friction velocities neither: of a pile that can lie still
/// the laws may as well allow that it slides. Here it lies still. For the associated law, by which
/// a contact that slides also opens, with speed μ |u_t|, makes the step a problem of least energy
/// (Anitescu, Math. Program. 105:113, 2006); its velocities are unique, and they are rest if any
/// impulses within the cones can hold the pile. Where nothing slides the two laws agree. So come
///
///  1. the associated law: Gauss-Seidel sweeps to and fro as the preconditioner of conjugate
///     gradients with exact steps, until Coulomb's residual is within the tolerance, or a hundred
///     times its own (something slides), or half of the sweeps are spent;
///  2. from there Coulomb's law: the same sweeps, accelerated by nonlinear conjugate gradients
///     (Silcowitz-Niebe, Abel, Erleben, Vis. Comput. 26:893, 2010).
///
/// A sweep solves the problem of one contact after the other in closed form, by either law: as the
/// arm of a ball is along the normal, normal and tangential parts of one contact do not mix.
///
/// Sweeps from impulses 0 to a residual of 1e-10; - is more than 6000:
///
///                           stack of    heap of 20 rows, 590 contacts, μ =     1000 discs falling,
///                           50 discs     3     1   0.8   0.6   0.5     0      165, 646 contacts
///     sweeps to and fro        21188     -     -     -     -     -  1974          472      2662
///     2. alone                   980  3698     -     -     -  2092   310          128       544
///     1., then 2.                 60   226   290   528  1390     -   818          158       528
///
/// From 0.6 on the heap can lie still. At 3 both ways end there; at 0.6 to 1 only 1. does: 2. alone
/// ends at a heap that slides with a quarter of what gravity gives in a step, or does not settle.
/// Where a large heap slides, at 0.1 to 0.5, sweeps take very long from anywhere: after 6000
/// residuals are between 1e-4 and 1e-2. Discs that fall into a box pass through that, and once at
/// rest take some sweeps a step, or none, from the last step's impulses.
///
/// Given up, as they settle no better where a heap slides: Anderson's acceleration (the stack in 78
/// sweeps), conjugate gradients with exact steps by Coulomb's law, Newton's method on the sets of
/// contacts that press, stick and slide, with a sparse factorization a step, and the associated law
/// with gaps that make up for its opening, updated between sweeps, damped or not.

#include <cstddef>
#include <limits>
#include <span>

#include "../vector.hpp"

namespace signum::motion {

/// An angular velocity: counterclockwise in the plane, a vector in space. In radians per unit of
/// time.
template <int D>
using Spin = PerAxis<double, D == 2 ? 1 : 3>;

struct ContactMass {
    double mass = 1.0;     ///< above 0
    double radius = 0.0;   ///< from 0: from the centre to its contacts
    double inertia = 1.0;  ///< the moment about the centre, above 0
};

template <int D>
struct ContactBody {
    Vector<D> velocity{};
    Spin<D> spin{};
    ContactMass inert{};
};

template <int D>
struct Contact {
    static constexpr std::size_t wall = std::numeric_limits<std::size_t>::max();

    std::size_t a = 0;     ///< a body
    std::size_t b = wall;  ///< another one, or none
    Vector<D> normal{};    ///< of length 1, from b or the wall to a
    double gap = 0.0;      ///< between the surfaces; below 0 where they overlap
    double friction = 0.0;
    /// Of the wall at the contact, where b is one.
    Vector<D> wall_velocity{};
    /// On a. Before: those of the last step, or 0; they may be anything, and save sweeps where they
    /// are near. After: the solution.
    double normal_impulse = 0.0;
    Vector<D> tangential_impulse{};
};

struct ContactReport {
    /// What is left of the laws, over all contacts: the change of speed that the contact's own
    /// solution would bring, as all others are, divided by the largest speed of approach, less g/h,
    /// of its cluster before. Without what rounding leaves: 2^-48 of the speeds that are summed.
    double residual = 0.0;
    /// The most that a cluster took; a sweep goes through its contacts once.
    int sweeps = 0;
    /// Parts that hang together by contacts between bodies; a wall joins nothing.
    std::size_t clusters = 0;
    /// Those that stayed above the tolerance. They have the impulses with the least residual that
    /// were met: contradictions, such as a ball between walls that approach one another, are among
    /// them.
    std::size_t unconverged = 0;

    [[nodiscard]] bool converged() const noexcept { return unconverged == 0; }
};

/// Changes velocities and spins, and stores the impulses. Without friction spins stay as they are.
/// A function of its arguments, the order of contacts included; sweeps go in that order and back.
/// Preconditions: numbers are finite, the step and the tolerance above 0, sweeps from 0; a and b
/// are different bodies. Time: 0.07 µs a contact and sweep in the plane, acceleration included.
template <int D>
ContactReport solve_contacts(std::span<ContactBody<D>> bodies, std::span<Contact<D>> contacts,
                             double step, double tolerance, int sweeps);

}  // namespace signum::motion
