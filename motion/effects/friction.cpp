#include "friction.hpp"

#include <algorithm>
#include <initializer_list>

namespace signum::motion {
namespace {

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
    sliding = sliding - dot(sliding, normal) * normal;
    const double speed = norm(sliding);
    if (!(speed > 0.0)) return {};
    const double wanted = (1.0 + restitution) * speed / mobility;
    return -std::min(wanted, most) / speed * sliding;
}

template <int D>
void push(Slider<D>& ball, const Vector<D>& momentum, const Vector<D>& arm, double inertia) {
    for (int k = 0; k < D; ++k) ball.v[k] += momentum[k] / ball.mass;
    if (ball.radius == 0.0) return;
    const Spin<D> turn = torque(arm, momentum);
    const double moment = inertia * ball.mass * (ball.radius * ball.radius);
    for (int k = 0; k < (D == 2 ? 1 : 3); ++k) ball.spin[k] += turn[k] / moment;
}

}  // namespace

template <int D>
void slide(Slider<D> a, Slider<D> b, const Vector<D>& normal, const Vector<D>& sliding,
           double momentum, const Friction& friction) {
    const Vector<D> arm_a = -a.radius * normal;
    const Vector<D> arm_b = b.radius * normal;
    const Vector<D> at_surface = sliding + turned(a.spin, arm_a) - turned(b.spin, arm_b);
    const Vector<D> rubbed =
        rub<D>(at_surface, normal, mobility<D>({&a, &b}, friction.inertia),
               friction.coefficient * momentum, friction.tangential_restitution);
    push(a, rubbed, arm_a, friction.inertia);
    push(b, -1.0 * rubbed, arm_b, friction.inertia);
}

template <int D>
void slide(Slider<D> ball, const Vector<D>& normal, const Vector<D>& sliding, double momentum,
           const Friction& friction) {
    const Vector<D> arm = -ball.radius * normal;
    const Vector<D> at_surface = sliding + turned(ball.spin, arm);
    push(ball,
         rub<D>(at_surface, normal, mobility<D>({&ball}, friction.inertia),
                friction.wall_coefficient * momentum, friction.tangential_restitution),
         arm, friction.inertia);
}

template <int D>
double energy_of(const Spin<D>& spin, double radius, double mass,
                 const Friction& friction) noexcept {
    return 0.5 * friction.inertia * mass * (radius * radius) * dot(spin, spin);
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
