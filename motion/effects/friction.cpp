#include "friction.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace signum::motion {
namespace {

template <int D>
Vector<D> scaled(double factor, const Vector<D>& v) noexcept {
    Vector<D> result;
    for (int k = 0; k < D; ++k) result[k] = factor * v[k];
    return result;
}

/// By how much a momentum of 1 along the surfaces changes their sliding speed: each ball's gives
/// 1/m (1 + 1/q), I = q m r². A point does not turn, and gives 1/m.
template <int D>
double mobility(std::initializer_list<const Slider<D>*> balls, double inertia) noexcept {
    double of_turning = 0.0;
    double of_points = 0.0;
    for (const Slider<D>* ball : balls)
        (ball->radius > 0.0 ? of_turning : of_points) += 1.0 / ball->mass;
    return of_turning * (1.0 + 1.0 / inertia) + of_points;
}

/// The momentum along the surface that a gets, of a sliding velocity with spins.
template <int D>
Vector<D> rub(Vector<D> sliding, const Vector<D>& normal, double mobility, double most,
              double restitution) noexcept {
    const double along_normal = dot(sliding, normal);
    for (int k = 0; k < D; ++k) sliding[k] -= along_normal * normal[k];
    const double speed = std::sqrt(dot(sliding, sliding));
    if (!(speed > 0.0)) return {};
    const double wanted = (1.0 + restitution) * speed / mobility;
    return scaled(-std::min(wanted, most) / speed, sliding);
}

template <int D>
void push(Slider<D>& ball, const Vector<D>& momentum, const Vector<D>& arm, double inertia) {
    for (int k = 0; k < D; ++k) ball.v[k] += momentum[k] / ball.mass;
    if (ball.radius == 0.0) return;
    const Spin<D> turn = torque(arm, momentum);
    const double moment = inertia * ball.mass * (ball.radius * ball.radius);
    for (int k = 0; k < (D == 2 ? 1 : 3); ++k) ball.spin[k] += turn[k] / moment;
}

/// Of the point of a ball's surface that touches, relative to its centre.
template <int D>
void add(Vector<D>& sliding, double sign, const Slider<D>& ball, const Vector<D>& arm) noexcept {
    const Vector<D> w = turned(ball.spin, arm);
    for (int k = 0; k < D; ++k) sliding[k] += sign * w[k];
}

}  // namespace

template <int D>
void slide(Slider<D> a, Slider<D> b, const Vector<D>& normal, const Vector<D>& sliding,
           double momentum, const Friction& friction) {
    const Vector<D> arm_a = scaled(-a.radius, normal);
    const Vector<D> arm_b = scaled(b.radius, normal);
    Vector<D> at_surface = sliding;
    add(at_surface, 1.0, a, arm_a);
    add(at_surface, -1.0, b, arm_b);
    const Vector<D> rubbed =
        rub<D>(at_surface, normal, mobility<D>({&a, &b}, friction.inertia),
               friction.coefficient * momentum, friction.tangential_restitution);
    push(a, rubbed, arm_a, friction.inertia);
    push(b, scaled(-1.0, rubbed), arm_b, friction.inertia);
}

template <int D>
void slide(Slider<D> ball, const Vector<D>& normal, const Vector<D>& sliding, double momentum,
           const Friction& friction) {
    const Vector<D> arm = scaled(-ball.radius, normal);
    Vector<D> at_surface = sliding;
    add(at_surface, 1.0, ball, arm);
    push(ball,
         rub<D>(at_surface, normal, mobility<D>({&ball}, friction.inertia),
                friction.wall_coefficient * momentum, friction.tangential_restitution),
         arm, friction.inertia);
}

template <int D>
double energy_of(const Spin<D>& spin, double radius, double mass,
                 const Friction& friction) noexcept {
    double square = 0.0;
    for (const double w : spin) square += w * w;
    return 0.5 * friction.inertia * mass * (radius * radius) * square;
}

#define SIGNUM_FRICTION_IN(D)                                                                    \
    template void slide(Slider<D>, Slider<D>, const Vector<D>&, const Vector<D>&, double,        \
                        const Friction&);                                                        \
    template void slide(Slider<D>, const Vector<D>&, const Vector<D>&, double, const Friction&); \
    template double energy_of<D>(const Spin<D>&, double, double, const Friction&) noexcept;
SIGNUM_FRICTION_IN(2)
SIGNUM_FRICTION_IN(3)
#undef SIGNUM_FRICTION_IN

}  // namespace signum::motion
