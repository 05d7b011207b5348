#pragma once
/// Forces by kicks: what velocities become while balls stand still.
///
/// A step of time h is half a kick, a flight of h and half a kick (Strang 1968): the error of
/// places and velocities after a given time goes as h². Kicks of gravity, of linear and of
/// quadratic drag are each a formula, in the order g/2, linear/2, quadratic, linear/2, g/2, so that
/// drag never turns a velocity round, however long the step. Where contacts stand a step is a whole
/// kick and a flight, and the error goes as h.
///
/// Doubles, each operation rounded once, sums from left to right: a kick of time t makes of v
///
///     u = velocity + gradient·x,   w = E (v + t/2 g - u),   E = exp(-((linear r) / m) t / 2),
///     v' = u + (E / (1 + c √(w·w) t)) w + t/2 g,            c = (quadratic r^(D-1)) / m,
///
/// r the radius at that time, E the nearest double to the exponential of the rounded number.

#include <vector>

#include "../ball.hpp"

namespace signum::motion {

/// Kicks of one length of time, from 0.
template <int D>
class Kicks {
 public:
    Kicks(const Effects<D>& effects, double time);

    /// The velocity at a place after one.
    [[nodiscard]] Vector<D> kicked(const Vector<D>& x, const Vector<D>& v, double radius,
                                   double mass);

 private:
    /// exp(-rate · time / 2), which is that of the last rate that was asked for.
    [[nodiscard]] double decay(double rate);

    Vector<D> gravity_;
    std::optional<Fluid<D>> fluid_;
    double time_;
    double rate_ = 0.0;
    double decay_ = 1.0;
};

}  // namespace signum::motion
