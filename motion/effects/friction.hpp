#pragma once
/// Friction at a strike, and spin (Walton 1993).
///
/// The law is not rational. So it is a sequence of double operations, each rounded once, and
/// compiled so that none are fused: the same numbers on every machine. It comes after the law along
/// the normal, whose numbers are rounded from exact ones, and uses the balls as they were when they
/// met.

#include "../ball.hpp"

namespace signum::motion {

/// A ball that may slide: a wall has no mass and is nobody.
template <int D>
struct Slider {
    Vector<D>& v;
    Spin<D>& spin;
    double radius = 0.0;
    double mass = 0.0;
};

/// Exchanges momentum along the surfaces. `normal` is a unit vector from b to a, `sliding` the
/// velocity of a's centre relative to b's before the strike, `push` the momentum exchanged along
/// the normal. Of two balls.
template <int D>
void slide(Slider<D> a, Slider<D> b, const Vector<D>& normal, const Vector<D>& sliding, double push,
           const Friction& friction);
/// The same of a ball and a wall; `sliding` is relative to the wall.
template <int D>
void slide(Slider<D> ball, const Vector<D>& normal, const Vector<D>& sliding, double push,
           const Friction& friction);

/// I ω² / 2, rounded.
template <int D>
[[nodiscard]] double energy_of(const Spin<D>& spin, double radius, double mass,
                               const Friction& friction) noexcept;

}  // namespace signum::motion
