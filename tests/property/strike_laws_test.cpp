/// The laws of strikes against rationals written anew, and by what they conserve.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <gmpxx.h>
#include <gtest/gtest.h>

#include "../../motion/effects/friction.hpp"
#include "../../motion/effects/speed_law.hpp"
#include "../../motion/strike.hpp"
#include "../../motion/wall_strike.hpp"
#include "effects_scenes.hpp"
#include "rounded.hpp"

namespace signum::motion {
namespace {

const std::uint64_t trials = is_fast ? 2000 : 200;

template <int D>
using Rationals = std::array<mpq_class, D>;
template <int D>
Rationals<D> exactly(const Vector<D>& v) {
    Rationals<D> result;
    for (int k = 0; k < D; ++k) result[static_cast<std::size_t>(k)] = v[k];
    return result;
}
template <std::size_t D>
mpq_class product(const std::array<mpq_class, D>& a, const std::array<mpq_class, D>& b) {
    mpq_class sum = 0;
    for (std::size_t k = 0; k < D; ++k) sum += a[k] * b[k];
    return sum;
}

/// The double nearest to a + b √c: of rationals that enclose the root to 400 bits, which round to
/// one double. (An a + b √c that is a tie has a root that is rational, and is found with it.)
double rounded_with_root(const mpq_class& a, const mpq_class& b, const mpq_class& c) {
    constexpr unsigned long bits = 400;
    // √(n/d) = √(n d) / d
    const mpz_class square = (c.get_num() * c.get_den()) << (2 * bits);
    const mpz_class root = sqrt(square);
    const mpz_class scale = c.get_den() << bits;
    const mpq_class low(root, scale);
    if (root * root == square) return rounded(a + b * mpq_class(root) / mpq_class(scale)) + 0.0;
    const mpz_class next = root + 1;
    const double one = rounded(a + b * mpq_class(root) / mpq_class(scale)) + 0.0;
    const double other = rounded(a + b * mpq_class(next) / mpq_class(scale)) + 0.0;
    EXPECT_EQ(one, other);
    return one;
}

/// (1+e) (w - n·v + q √(n·n)) n / n·n is added to v.
template <int D>
void expect_law_of_wall(const Ball<D>& ball, const Rationals<D>& n, const mpq_class& w, double e,
                        double q, double mass, const Exchange& exchange, const Ball<D>& after) {
    const mpq_class square = product(n, n);
    const mpq_class closing = w - product(n, exactly<D>(ball.v));
    // Its sign, by 400 bits.
    const double approach = rounded_with_root(closing / square, q / square, square);
    if (!(approach > 0.0)) {
        ASSERT_FALSE(exchange.struck);
        ASSERT_EQ(after.v, ball.v);
        return;
    }
    bool changed = false;
    for (int k = 0; k < D; ++k) {
        const mpq_class step = (1 + mpq_class(e)) * n[static_cast<std::size_t>(k)];
        const double expected =
            rounded_with_root(ball.v[k] + step * closing / square, step * q / square, square);
        ASSERT_EQ(after.v[k], expected);
        changed = changed || expected != ball.v[k];
    }
    ASSERT_EQ(exchange.struck, changed);
    // m (1+e) (closing/√s + q) = m (1+e) (q + closing/s √s)
    const mpq_class factor = (1 + mpq_class(e)) * mass;
    ASSERT_EQ(exchange.impulse, rounded_with_root(factor * q, factor * closing / square, square));
}

template <int D>
Ball<D> ball_of(Choices& choose) {
    Ball<D> ball;
    for (int k = 0; k < D; ++k) {
        ball.x[k] = choose.number(-4.0, 4.0);
        ball.v[k] = choose.number(-2.0, 2.0);
    }
    ball.radius = choose.number(0.125, 1.0);
    ball.time = choose.below(2) == 0 ? 0.0 : choose.number(0.0, 4.0);
    return ball;
}
double restitution_of(Choices& choose) {
    constexpr std::array<double, 4> some = {0.0, 0.5, 0.9, 1.0};
    return choose.of(some);
}

template <int D, class Wall>
void expect_wall(const Wall& wall, const Rationals<D>& n, const mpq_class& w, const Ball<D>& ball,
                 Choices& choose) {
    const double e = restitution_of(choose);
    const double q = choose.below(2) == 0 ? 0.0 : choose.number(0.0, 1.0);
    const double mass = 0.125 + choose.unit();
    Ball<D> after = ball;
    const Exchange exchange = strike(after, facing(ball, wall), mass, e, q);
    expect_law_of_wall<D>(ball, n, w, e, q, mass, exchange, after);
}

template <int D>
void expect_laws_of_walls(std::uint64_t seed) {
    SCOPED_TRACE(seed);
    Choices choose(seed);
    choose.be_round(choose.below(2) == 0);
    const Ball<D> ball = ball_of<D>(choose);
    HalfSpace<D> plane;
    for (double& n : plane.normal) n = choose.number(-2.0, 2.0);
    plane.speed = choose.number(-1.0, 1.0);
    if (plane.normal != Vector<D>{})
        expect_wall<D>(plane, exactly<D>(plane.normal), plane.speed, ball, choose);
    Sphere<D> sphere;
    for (int k = 0; k < D; ++k) {
        sphere.centre[k] = choose.number(-4.0, 4.0);
        sphere.velocity[k] = choose.number(-1.0, 1.0);
    }
    for (const auto side : {Sphere<D>::Side::outside, Sphere<D>::Side::inside}) {
        sphere.side = side;
        Rationals<D> n = exactly<D>(ball.x);
        const Rationals<D> u = exactly<D>(sphere.velocity);
        for (int k = 0; k < D; ++k) {
            const auto i = static_cast<std::size_t>(k);
            n[i] -= sphere.centre[k] + u[i] * ball.time;
            if (side == Sphere<D>::Side::inside) n[i] = -n[i];
        }
        if (product(n, n) != 0) expect_wall<D>(sphere, n, product(n, u), ball, choose);
    }
    if constexpr (D == 2) {
        const Segment segment{{choose.number(-2.0, 2.0), choose.number(-2.0, 2.0)},
                              {choose.number(2.125, 4.0), choose.number(-2.0, 2.0)}};
        // From the nearest point of it.
        const Rationals<2> from = exactly<2>(segment.from);
        Rationals<2> along = exactly<2>(segment.to);
        Rationals<2> n = exactly<2>(ball.x);
        for (std::size_t k = 0; k < 2; ++k) {
            along[k] -= from[k];
            n[k] -= from[k];
        }
        mpq_class foot = product(n, along) / product(along, along);
        foot = std::clamp(foot, mpq_class(0), mpq_class(1));
        for (std::size_t k = 0; k < 2; ++k) n[k] -= foot * along[k];
        if (product(n, n) == 0) return;
        // Its length does not matter, but for the rounding of nothing.
        expect_wall<2>(segment, n, 0, ball, choose);
    }
}

TEST(StrikeLaws, OfWallsAreThoseOfRationals) {
    for (std::uint64_t seed = 0; seed < trials; ++seed) {
        expect_laws_of_walls<2>(seed);
        expect_laws_of_walls<3>(seed);
        if (HasFatalFailure()) return;
    }
}

/// v_a - (1+e) μ_b (V·D / D·D - ρ / √(D·D)) D, of balls that grow.
template <int D>
void expect_law_of_pair(std::uint64_t seed) {
    SCOPED_TRACE(seed);
    Choices choose(seed);
    choose.be_round(choose.below(2) == 0);
    const Ball<D> a = ball_of<D>(choose);
    Ball<D> b = ball_of<D>(choose);
    b.time = a.time;
    const double mass_a = 0.125 + choose.unit();
    const double mass_b = choose.below(3) == 0 ? std::ldexp(mass_a, 40) : 0.125 + choose.unit();
    const Law law{restitution_of(choose), choose.number(0.0, 1.0)};
    Rationals<D> d = exactly<D>(a.x);
    Rationals<D> v = exactly<D>(a.v);
    for (int k = 0; k < D; ++k) {
        d[static_cast<std::size_t>(k)] -= b.x[k];
        v[static_cast<std::size_t>(k)] -= b.v[k];
    }
    const mpq_class square = product(d, d);
    if (square == 0) return;
    const mpq_class speed = product(v, d);
    const mpq_class growth = law.growth;
    const bool approach = rounded_with_root(-speed / square, growth / square, square) > 0.0;
    Ball<D> a_after = a;
    Ball<D> b_after = b;
    StrikeTally tally;
    const Exchange exchange =
        strike(a_after, b_after, Image<D>{}, mass_a, mass_b, law, Effects<D>{}, tally);
    bool changed = false;
    const mpq_class masses = mpq_class(mass_a) + mpq_class(mass_b);
    for (int k = 0; k < D; ++k) {
        const auto part = [&](double mass, int sign, double before) {
            const mpq_class f = sign * (1 + mpq_class(law.restitution)) * mass / masses *
                                d[static_cast<std::size_t>(k)];
            return rounded_with_root(before + f * speed / square, -f * growth / square, square);
        };
        const double of_a = approach ? part(mass_b, -1, a.v[k]) : a.v[k];
        const double of_b = approach ? part(mass_a, 1, b.v[k]) : b.v[k];
        ASSERT_EQ(a_after.v[k], of_a);
        ASSERT_EQ(b_after.v[k], of_b);
        changed = changed || of_a != a.v[k] || of_b != b.v[k];
    }
    ASSERT_EQ(exchange.struck, changed);
    if (!changed) return;
    const mpq_class factor =
        (1 + mpq_class(law.restitution)) * mpq_class(mass_a) * mpq_class(mass_b) / masses;
    ASSERT_EQ(impulse(a, b, Image<D>{}, mass_a, mass_b, law, Effects<D>{}, tally),
              rounded_with_root(factor * growth, -factor * speed / square, square));
}

TEST(StrikeLaws, OfBallsThatGrowAreThoseOfRationals) {
    for (std::uint64_t seed = 0; seed < trials; ++seed) {
        expect_law_of_pair<2>(seed);
        expect_law_of_pair<3>(seed);
        if (HasFatalFailure()) return;
    }
}

TEST(StrikeLaws, RestitutionThatDependsOnSpeed) {
    for (std::uint64_t seed = 0; seed < trials; ++seed) {
        Choices choose(seed);
        const SpeedLaw law{0.01 + 4.0 * choose.unit(), 0.1 + 2.0 * choose.unit()};
        const double e = choose.unit();
        const double v = std::ldexp(choose.unit(), choose.below(40) - 30);
        const long double ratio =
            std::pow(static_cast<long double>(v) / law.speed, static_cast<long double>(law.power));
        const auto expected = std::max(0.0L, 1.0L - (1.0L - e) * ratio);
        ASSERT_NEAR(restitution_at(law, e, v), static_cast<double>(expected),
                    8e-16 * static_cast<double>(1.0L + (1.0L - e) * ratio));
        ASSERT_GE(restitution_at(law, e, v), 0.0);
        ASSERT_LE(restitution_at(law, e, v), 1.0);
        ASSERT_EQ(restitution_at(law, 1.0, v), 1.0);
        ASSERT_EQ(restitution_at(law, e, 0.0), 1.0);
    }
    EXPECT_NEAR(restitution_at({2.0, 0.2}, 0.75, 2.0), 0.75, 1e-16);
}

// Friction

template <int D>
struct Spinning {
    Vector<D> v{};
    Spin<D> spin{};
    double radius = 0.5;
    double mass = 1.0;
    Slider<D> slider() { return {v, spin, radius, mass}; }
};
template <int D>
Spinning<D> spinning(Choices& choose) {
    Spinning<D> ball;
    for (double& each : ball.v) each = choose.number(-2.0, 2.0);
    for (double& each : ball.spin.values) each = choose.number(-3.0, 3.0);
    ball.radius = choose.below(4) > 0 ? 0.125 + choose.unit() : 0.0;
    ball.mass = 0.125 + choose.unit();
    return ball;
}
template <int D>
Vector<D> direction(Choices& choose) {
    Vector<D> n;
    do {
        for (double& each : n) each = choose.number(-1.0, 1.0);
    } while (dot(n, n) < 0.01);
    const double size = std::sqrt(dot(n, n));
    for (double& each : n) each /= size;
    return n;
}
/// Of the surfaces, along them; n from b to a.
template <int D>
Vector<D> sliding_of(const Spinning<D>& a, const Spinning<D>* b, const Vector<D>& n) {
    Vector<D> arm;
    for (int k = 0; k < D; ++k) arm[k] = -a.radius * n[k];
    Vector<D> w = turned(a.spin, arm);
    for (int k = 0; k < D; ++k) w[k] += a.v[k];
    if (b != nullptr) {
        for (int k = 0; k < D; ++k) arm[k] = b->radius * n[k];
        const Vector<D> other = turned(b->spin, arm);
        for (int k = 0; k < D; ++k) w[k] -= b->v[k] + other[k];
    }
    const double along = dot(w, n);
    for (int k = 0; k < D; ++k) w[k] -= along * n[k];
    return w;
}
template <int D>
double energy_of(const Spinning<D>& ball, const Friction& friction) {
    return 0.5 * ball.mass * dot(ball.v, ball.v) +
           motion::energy_of<D>(ball.spin, ball.radius, ball.mass, friction);
}

/// Two balls or one and a wall: by what is conserved, the law of sliding and Coulomb's limit.
template <int D>
void expect_law_of_friction(std::uint64_t seed, bool with_wall) {
    SCOPED_TRACE(seed);
    Choices choose(seed);
    const Spinning<D> a = spinning<D>(choose);
    const Spinning<D> b = spinning<D>(choose);
    const Vector<D> n = direction<D>(choose);
    const double mu = choose.below(3) == 0 ? 1e6 : choose.unit();
    const Friction friction{with_wall ? 0.0 : mu, with_wall ? mu : 0.0,
                            0.25 * (choose.below(9) - 4), D == 2 ? 0.5 : 0.4};
    Vector<D> approach = a.v;
    for (int k = 0; k < D && !with_wall; ++k) approach[k] -= b.v[k];
    const double push = 0.1 + choose.unit();
    Spinning<D> p = a;
    Spinning<D> q = b;
    if (with_wall)
        slide<D>(p.slider(), n, approach, push, friction);
    else
        slide<D>(p.slider(), q.slider(), n, approach, push, friction);
    const double tolerance = 1e-13;
    Vector<D> rub;
    for (int k = 0; k < D; ++k) {
        rub[k] = a.mass * (p.v[k] - a.v[k]);
        if (!with_wall) {
            ASSERT_NEAR(rub[k], -b.mass * (q.v[k] - b.v[k]), tolerance);
        }
    }
    ASSERT_NEAR(dot(rub, n), 0.0, tolerance);
    const double size = std::sqrt(dot(rub, rub));
    ASSERT_LE(size, mu * push * (1.0 + tolerance) + tolerance);
    // Angular momentum about the point of contact, of each: I Δω = arm × rub.
    for (const auto& [before, after, sign] :
         {std::tuple(&a, &p, 1.0), std::tuple(&b, &q, with_wall ? 0.0 : 1.0)}) {
        Vector<D> arm;
        for (int k = 0; k < D; ++k) arm[k] = -before->radius * n[k];
        const Spin<D> turn = torque(arm, rub);
        const double inertia = friction.inertia * before->mass * before->radius * before->radius;
        for (int k = 0; k < (D == 2 ? 1 : 3); ++k)
            ASSERT_NEAR(inertia * (after->spin[k] - before->spin[k]), sign * turn[k], tolerance);
    }
    const Vector<D> slid = sliding_of<D>(a, with_wall ? nullptr : &b, n);
    const Vector<D> slides = sliding_of<D>(p, with_wall ? nullptr : &q, n);
    const double speed = std::sqrt(dot(slid, slid));
    if (size < mu * push * (1.0 - 1e-9)) {
        for (int k = 0; k < D; ++k)
            ASSERT_NEAR(slides[k], -friction.tangential_restitution * slid[k],
                        tolerance * (1.0 + speed));
    } else {  // slower, and not beyond what β asks for
        ASSERT_GE(dot(slides, slid), -friction.tangential_restitution * speed * speed - tolerance);
        ASSERT_LE(dot(slides, slid), speed * speed + tolerance);
    }
    const double before = energy_of(a, friction) + (with_wall ? 0.0 : energy_of(b, friction));
    const double after = energy_of(p, friction) + (with_wall ? 0.0 : energy_of(q, friction));
    ASSERT_LE(after, before * (1.0 + tolerance));
}

TEST(StrikeLaws, FrictionConservesMomentaAndKeepsItsLimits) {
    for (std::uint64_t seed = 0; seed < trials; ++seed) {
        for (const bool with_wall : {false, true}) {
            expect_law_of_friction<2>(seed, with_wall);
            expect_law_of_friction<3>(seed, with_wall);
            if (HasFatalFailure()) return;
        }
    }
}

/// Balls that recede from one another more slowly than they grow: what rubs is the share of the
/// momentum that they exchange.
TEST(StrikeLaws, FrictionOfBallsThatGrowIsThatOfTheirImpulse) {
    Effects<2> effects;
    effects.growth = Growth{0.1, 20.0};
    effects.friction = Friction{0.25, 0.25, 0.0, 0.5};
    effects.restitution = 0.5;
    const std::vector<Body<2>> bodies = {{{0.0, 0.0}, {0.0, 0.0}, 1.0, 2.0},
                                         {{2.5, -25.0}, {0.1, 5.0}, 1.0, 2.0}};
    Simulation<2> simulation(start<2>(bodies, effects), effects);
    Strike strike;
    (void)simulation.run({.until = 10.0, .strikes = 1}, [&](const Strike& s) { strike = s; });
    const State<2> state = simulation.state();
    const Vector<2> a = centre(state.balls[0], strike.time, effects);
    const Vector<2> b = centre(state.balls[1], strike.time, effects);
    const double distance = std::hypot(b[0] - a[0], b[1] - a[1]);
    const Vector<2> n = {(b[0] - a[0]) / distance, (b[1] - a[1]) / distance};
    const Vector<2> p = {2.0 * state.balls[0].v[0], 2.0 * state.balls[0].v[1]};
    const double along = n[0] * p[1] - n[1] * p[0];
    EXPECT_GT(strike.impulse, 0.0);
    EXPECT_NEAR(dot(n, p), -strike.impulse, 1e-14);
    EXPECT_NEAR(std::fabs(along), 0.25 * strike.impulse, 1e-14);
}

/// A second strike right after the first one loses nothing.
TEST(StrikeLaws, ContactsOfSomeDurationAreElasticWithin) {
    for (const auto& [duration, restitution] : {std::pair(0.6, 1.0), std::pair(0.4, 0.5)}) {
        Effects<2> effects;
        effects.restitution = effects.wall_restitution = 0.5;
        effects.contact_duration = duration;
        effects.box = Box<2>{{0.0, -9.0}, {9.0, 9.0}};
        const std::vector<Body<2>> bodies = {{{1.0, 0.0}, {-1.0, 0.0}, 0.5, 1.0},
                                             {{2.25, 0.0}, {-0.5, 0.0}, 0.5, 1.0}};
        std::vector<Strike> log;
        // At 1/2 it strikes the wall, at 1 the other one.
        Simulation<2> simulation(start<2>(bodies, effects), effects);
        simulation.run({.strikes = 2}, [&](const Strike& s) { log.push_back(s); });
        ASSERT_EQ(log.size(), 2U);
        EXPECT_EQ(log[0], (Strike{0.5, true, 0, 0, 1.5}));
        EXPECT_EQ(log[1], (Strike{1.0, false, 0, 1, (1.0 + restitution) * 0.5}));
    }
}

}  // namespace
}  // namespace signum::motion
