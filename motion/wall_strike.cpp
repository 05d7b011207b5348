#include "wall_strike.hpp"

#include <cmath>

#include "../exact/surd.hpp"
#include "apart.hpp"
#include "in_place.hpp"

namespace signum::motion {
namespace {

using exact::Dyadic;
using exact::Rational;
using exact::to_rational;

/// w - n·v, n·n and q: how they approach is (w - n·v) / √(n·n) + q.
template <int D>
struct Closing {
    Rational speed;
    Rational square;
    Rational growth;

    Closing(const Ball<D>& ball, const Facing<D>& wall, double rate)
        : speed(to_rational(wall.speed - dot(wall.normal, dyadic(ball.v)))),
          square(to_rational(dot(wall.normal, wall.normal))),
          growth(to_rational(rate)) {}

    /// Of the speed at which they approach, times a positive number.
    [[nodiscard]] int sign() const {
        // Of x + q √c by the squares where the two differ in sign.
        const int of_speed = speed.sign();
        const int of_growth = growth.sign();
        if (of_speed == of_growth || of_growth == 0) return of_speed;
        if (of_speed == 0) return of_growth;
        const Rational rest = speed * speed - growth * growth * square;
        return rest.sign() * of_speed;
    }
    /// a times the approach speed.
    [[nodiscard]] double rounded(const Rational& a) const {
        // Of an axis.
        if (square == 1) return exact::round_to_double(Rational(a * (speed + growth))) + 0.0;
        return exact::round_surd(Rational(a * growth), Rational(a * speed / square), square) + 0.0;
    }
};

/// Of derivatives from the second on, which tell how a gap goes on.
Sign first_not_0(std::initializer_list<Sign> signs) {
    for (const Sign sign : signs)
        if (sign != 0) return sign;
    return 0;
}

}  // namespace

template <int D>
Facing<D> facing(const Ball<D>& ball, const ShakingWall& wall) {
    Facing<D> result;
    const bool is_upper = wall.wall % 2 != 0;
    const double u = speed_at(wall, ball.time);
    result.normal[wall.wall / 2] = Dyadic(is_upper ? -1.0 : 1.0);
    result.speed = Dyadic(is_upper ? -u : u);
    return result;
}

template <int D>
Facing<D> facing_side(Wall wall) {
    Facing<D> result;
    result.normal[wall / 2] = Dyadic(wall % 2 != 0 ? -1.0 : 1.0);
    return result;
}

template <int D>
Vector<D> unit_normal(const Facing<D>& wall) {
    Vector<D> n;
    for (int k = 0; k < D; ++k) n[k] = exact::round_to_double(to_rational(wall.normal[k]));
    const double size = norm(n);
    for (double& each : n) each /= size;
    return n;
}

template <int D>
Facing<D> facing(const Ball<D>&, const HalfSpace<D>& wall) {
    return {dyadic(wall.normal), Dyadic(wall.speed)};
}

template <int D>
Facing<D> facing(const Ball<D>& ball, const Sphere<D>& wall) {
    const PerAxis<Dyadic, D> u = dyadic(wall.velocity);
    const PerAxis<Dyadic, D> centre = dyadic(wall.centre) + Dyadic(ball.time) * u;
    const PerAxis<Dyadic, D> x = dyadic(ball.x);
    const bool is_outside = wall.side == Sphere<D>::Side::outside;
    const PerAxis<Dyadic, D> normal = is_outside ? x - centre : centre - x;
    return {normal, dot(normal, u)};
}

Facing<2> facing(const Ball<2>& ball, const Segment& wall) {
    const PerAxis<Dyadic, 2> from = dyadic(wall.from);
    const PerAxis<Dyadic, 2> along = dyadic(wall.to) - from;
    const PerAxis<Dyadic, 2> seen = dyadic(ball.x) - from;
    const Dyadic foot = dot(seen, along);
    const Dyadic rest = dot(along, along) - foot;
    if (foot.sign() < 0) return {seen, Dyadic()};
    if (rest.sign() < 0) return {seen - along, Dyadic()};
    PerAxis<Dyadic, 2> normal{{-along[1], along[0]}};
    const int side = dot(normal, seen).sign();
    const int away = dot(normal, dyadic(ball.v)).sign();
    if (side < 0 || (side == 0 && away > 0)) normal = {{along[1], -along[0]}};
    return {normal, Dyadic()};
}

template <int D>
bool bends_down(const Ball<D>& ball, const ShakingWall& wall, const Vector<D>& gravity, double) {
    const Dyadic omega(wall.frequency);
    const Dyadic shift(shift_at(wall, ball.time));
    const Sign bend = first_not_0({(Dyadic(gravity[wall.wall / 2]) + omega * omega * shift).sign(),
                                   Dyadic(speed_at(wall, ball.time)).sign(), -shift.sign()});
    return wall.wall % 2 != 0 ? bend > 0 : bend < 0;
}

template <int D>
bool bends_down(const Ball<D>&, const HalfSpace<D>& wall, const Vector<D>& gravity, double) {
    return dot(dyadic(wall.normal), dyadic(gravity)).sign() < 0;
}

template <int D>
bool bends_down(const Ball<D>& ball, const Sphere<D>& wall, const Vector<D>& gravity,
                double growth) {
    // Of half of |D|² - (q t + …)².
    const PerAxis<Dyadic, D> u = dyadic(wall.velocity);
    const PerAxis<Dyadic, D> d = dyadic(ball.x) - (dyadic(wall.centre) + Dyadic(ball.time) * u);
    const PerAxis<Dyadic, D> v = dyadic(ball.v) - u;
    const Dyadic q(growth);
    const PerAxis<Dyadic, D> g = dyadic(gravity);
    const Sign bend =
        first_not_0({(dot(v, v) + dot(d, g) - q * q).sign(), dot(v, g).sign(), dot(g, g).sign()});
    return wall.side == Sphere<D>::Side::outside ? bend < 0 : bend > 0;
}

bool bends_down(const Ball<2>& ball, const Segment& wall, const Vector<2>& gravity, double growth) {
    const PerAxis<Dyadic, 2> from = dyadic(wall.from);
    const PerAxis<Dyadic, 2> along = dyadic(wall.to) - from;
    const Dyadic foot = dot(dyadic(ball.x) - from, along);
    if (foot.sign() < 0) return bends_down(ball, Sphere<2>{.centre = wall.from}, gravity, growth);
    if ((dot(along, along) - foot).sign() < 0)
        return bends_down(ball, Sphere<2>{.centre = wall.to}, gravity, growth);
    return dot(facing(ball, wall).normal, dyadic(gravity)).sign() < 0;
}

template <int D>
double approach_of(const Ball<D>& ball, const Facing<D>& wall, double growth) {
    const Closing<D> closing(ball, wall, growth);
    return closing.square.is_zero() ? 0.0 : closing.rounded(Rational(1));
}

template <int D>
Exchange strike(Ball<D>& ball, const Facing<D>& wall, double mass, double restitution,
                double growth) {
    const Closing<D> closing(ball, wall, growth);
    Exchange exchange;
    exchange.square = exact::round_to_double(closing.square);
    if (closing.square.is_zero() || closing.sign() <= 0) return exchange;
    const Rational bounce = 1 + to_rational(restitution);
    exchange.approach = closing.rounded(Rational(1)) * std::sqrt(exchange.square);
    for (int k = 0; k < D; ++k) {
        if (wall.normal[k].sign() == 0) continue;
        const Rational step = bounce * to_rational(wall.normal[k]);
        const double after =
            exact::round_surd(
                Rational(to_rational(ball.v[k]) + step * closing.speed / closing.square),
                Rational(step * closing.growth / closing.square), closing.square) +
            0.0;
        exchange.struck |= after != ball.v[k];
        ball.v[k] = after;
    }
    exchange.impulse = closing.rounded(Rational(bounce * to_rational(mass)));
    return exchange;
}

template <int D>
bool stayed_in_place_exactly(const Ball<D>& ball, const Facing<D>& wall, double growth,
                             double before) {
    const Closing<D> closing(ball, wall, growth);
    if (growth != 0.0) {
        const double speed = closing.rounded(Rational(1));
        return in_place(ball, before, to_rational(speed), Rational(1));
    }
    return in_place(ball, before, closing.speed, closing.square);
}

#define SIGNUM_WALL_STRIKES_OF(D)                                                            \
    template Facing<D> facing(const Ball<D>&, const ShakingWall&);                           \
    template Facing<D> facing(const Ball<D>&, const HalfSpace<D>&);                          \
    template Facing<D> facing(const Ball<D>&, const Sphere<D>&);                             \
    template bool bends_down(const Ball<D>&, const ShakingWall&, const Vector<D>&, double);  \
    template bool bends_down(const Ball<D>&, const HalfSpace<D>&, const Vector<D>&, double); \
    template bool bends_down(const Ball<D>&, const Sphere<D>&, const Vector<D>&, double);    \
    template Facing<D> facing_side(Wall);                                                    \
    template Vector<D> unit_normal(const Facing<D>&);                                        \
    template double approach_of(const Ball<D>&, const Facing<D>&, double);                   \
    template Exchange strike(Ball<D>&, const Facing<D>&, double, double, double);            \
    template bool stayed_in_place_exactly(const Ball<D>&, const Facing<D>&, double, double);
SIGNUM_WALL_STRIKES_OF(2)
SIGNUM_WALL_STRIKES_OF(3)
#undef SIGNUM_WALL_STRIKES_OF

}  // namespace signum::motion
