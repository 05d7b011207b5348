/// Steps of time: drag and currents against formulas and fine references, contacts that stand by
/// the weights that they bear.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "../thoroughness.hpp"
#include "effects_scenes.hpp"

namespace signum::motion {
namespace {

template <int D>
State<D> after(const std::vector<Body<D>>& bodies, const Effects<D>& effects, double until) {
    Simulation<D> simulation(start<D>(bodies, effects), effects);
    const Outcome outcome = simulation.run({.until = until});
    EXPECT_EQ(outcome.ending, Ending::until);
    return simulation.state();
}

TEST(TimeSteps, LinearDragRelaxesExponentially) {
    for (const double step : {0.5, 0.0625, 0.01}) {
        Effects<3> effects;
        effects.time_step = step;
        effects.fluid.emplace();
        effects.fluid->velocity = {1.0, -0.5, 0.25};
        effects.fluid->linear = 0.75;
        const std::vector<Body<3>> bodies = {{{0, 0, 0}, {-2.0, 0.0, 3.0}, 0.5, 2.0}};
        const double until = 8.0;
        const State<3> state = after(bodies, effects, until);
        const double steps = std::round(until / step);
        const double left = std::exp(-0.75 * 0.5 / 2.0 * steps * step);
        for (int k = 0; k < 3; ++k) {
            const double u = effects.fluid->velocity[k];
            EXPECT_NEAR(state.balls[0].v[k], u + left * (bodies[0].v[k] - u), 1e-15 * (steps + 1.0))
                << "step " << step;
        }
    }
}

TEST(TimeSteps, QuadraticDragSlowsAsItsFormula) {
    Effects<2> effects;
    effects.time_step = 0.125;
    effects.fluid.emplace();
    effects.fluid->quadratic = 0.5;
    const std::vector<Body<2>> bodies = {{{0, 0}, {3.0, 4.0}, 0.5, 2.0}};
    const State<2> state = after(bodies, effects, 16.0);
    // c = 0.5 · 0.5 / 2, v = v0 / (1 + c |v0| t); places by trapezoids or so.
    const double factor = 1.0 / (1.0 + 0.125 * 5.0 * 16.0);
    for (int k = 0; k < 2; ++k) EXPECT_NEAR(state.balls[0].v[k], factor * bodies[0].v[k], 1e-14);
}

using Real = long double;
/// x, v of a disc by Runge and Kutta's method, in steps so short that they are exact here.
std::array<Real, 4> reference(const Body<2>& body, const Effects<2>& effects, Real until) {
    const auto slope = [&](const std::array<Real, 4>& s) {
        const Fluid<2>& fluid = *effects.fluid;
        std::array<Real, 2> w;
        for (int k = 0; k < 2; ++k)
            w[static_cast<std::size_t>(k)] = fluid.velocity[k] + fluid.gradient[k][0] * s[0] +
                                             fluid.gradient[k][1] * s[1] -
                                             s[static_cast<std::size_t>(k) + 2];
        const Real speed = std::sqrt(w[0] * w[0] + w[1] * w[1]);
        const Real r = body.radius;
        const Real pull = (fluid.linear * r + fluid.quadratic * r * speed) / body.mass;
        return std::array<Real, 4>{s[2], s[3], effects.gravity[0] + pull * w[0],
                                   effects.gravity[1] + pull * w[1]};
    };
    const auto moved = [](std::array<Real, 4> s, Real h, const std::array<Real, 4>& d) {
        for (std::size_t k = 0; k < 4; ++k) s[k] += h * d[k];
        return s;
    };
    std::array<Real, 4> s = {body.x[0], body.x[1], body.v[0], body.v[1]};
    constexpr int steps = 4000;
    const Real h = until / steps;
    for (int i = 0; i < steps; ++i) {
        const auto a = slope(s);
        const auto b = slope(moved(s, h / 2, a));
        const auto c = slope(moved(s, h / 2, b));
        const auto d = slope(moved(s, h, c));
        for (std::size_t k = 0; k < 4; ++k) s[k] += h / 6 * (a[k] + 2 * b[k] + 2 * c[k] + d[k]);
    }
    return s;
}

TEST(TimeSteps, ADiscInACurrentConvergesQuadratically) {
    Effects<2> effects;
    effects.gravity = {0.25, -1.0};
    effects.fluid.emplace();
    effects.fluid->velocity = {0.5, 1.0};
    effects.fluid->gradient = {{{0.25, -0.5}, {0.75, -0.125}}};
    effects.fluid->linear = 0.5;
    effects.fluid->quadratic = 0.75;
    const std::vector<Body<2>> bodies = {{{1.0, -0.5}, {-2.0, 1.0}, 0.5, 0.75}};
    const std::array<Real, 4> exact = reference(bodies[0], effects, 4.0L);
    double before = 0.0;
    for (const double step : {0.125, 0.0625, 0.03125, 0.015625, 0.0078125}) {
        effects.time_step = step;
        const State<2> state = after(bodies, effects, 4.0);
        double error = 0.0;
        for (int k = 0; k < 2; ++k) {
            const auto i = static_cast<std::size_t>(k);
            error = std::max({error,
                              std::fabs(coordinate(state.balls[0], k, 4.0, effects) -
                                        static_cast<double>(exact[i])),
                              std::fabs(state.balls[0].v[k] - static_cast<double>(exact[i + 2]))});
        }
        if (before > 0.0) {
            EXPECT_NEAR(before / error, 4.0, 0.3) << "step " << step;
        }
        before = error;
    }
    EXPECT_LT(before, 1e-4);
}

// Contacts that stand

Effects<2> standing(double g) {
    Effects<2> effects;
    effects.gravity = {0.0, -g};
    effects.restitution = effects.wall_restitution = 0.25;
    effects.contacts = LastingContacts{0.25, 1e-12, 2000};
    effects.time_step = 0.01;
    return effects;
}
double push_between(const State<2>& state, std::int32_t a, std::int32_t b) {
    for (const StandingContact<2>& contact : state.contacts)
        if (contact.a == a && contact.b == b) return contact.push;
    return 0.0;
}

TEST(TimeSteps, ABallRestsOnAFloorThatBearsItsWeight) {
    for (const bool with_friction : {false, true}) {
        Effects<2> effects = standing(10.0);
        effects.box = Box<2>{{-5.0, 0.0}, {5.0, 10.0}};
        if (with_friction) effects.friction = Friction{0.5, 0.5, 0.0, 0.5};
        const State<2> state = after<2>({{{0.0, 2.0}, {}, 0.5, 3.0}}, effects, 5.0);
        EXPECT_NEAR(state.balls[0].v[1], 0.0, 1e-12);
        EXPECT_NEAR(state.balls[0].x[1], 0.5, 1e-3);
        EXPECT_NEAR(push_between(state, 0, -3) / effects.time_step, 30.0, 1e-9);
    }
}

TEST(TimeSteps, AStackBearsAllThatIsAbove) {
    constexpr int size = 10;
    Effects<2> effects = standing(10.0);
    effects.box = Box<2>{{-5.0, 0.0}, {5.0, 40.0}};
    std::vector<Body<2>> bodies;
    for (int i = 0; i < size; ++i) bodies.push_back({{0.0, 0.5 + i}, {}, 0.5, 1.0 + i % 3});
    Simulation<2> simulation(start<2>(bodies, effects), effects);
    EXPECT_EQ(simulation.run({.until = 4.0}).ending, Ending::until);
    const State<2> state = simulation.state();
    double above = 0.0;
    for (int i = size - 1; i >= 0; --i) {
        above += bodies[static_cast<std::size_t>(i)].mass * 10.0;
        const double push = i > 0 ? push_between(state, i - 1, i) : push_between(state, 0, -3);
        EXPECT_NEAR(push / effects.time_step, above, 1e-6 * above) << i;
        EXPECT_NEAR(state.balls[static_cast<std::size_t>(i)].v[1], 0.0, 1e-9);
        EXPECT_NEAR(coordinate(state.balls[static_cast<std::size_t>(i)], 1, 4.0, effects), 0.5 + i,
                    0x1p-8);
    }
    EXPECT_EQ(simulation.counts().unsolved, 0U);
}

/// Down a slope of angle θ a disc rolls with 2/3 g sin θ where μ >= tan θ / 3, and slides with
/// g (sin θ - μ cos θ) where it is less.
TEST(TimeSteps, ADiscRollsOrSlidesDownASlope) {
    constexpr double g = 10.0;
    const double sine = 0.6;
    const double cosine = 0.8;
    for (const double mu : {0.0, 0.125, 0.5}) {
        Effects<2> effects = standing(g);
        effects.friction = Friction{mu, mu, 0.0, 0.5};
        effects.obstacles.emplace_back(HalfSpace<2>{{3.0, 4.0}, 0.0});  // down is (4, -3) / 5
        const std::vector<Body<2>> bodies = {{{3.0, 4.0}, {}, 5.0, 2.0}};
        const State<2> first = after(bodies, effects, 1.0);
        const State<2> last = after(bodies, effects, 3.0);
        const double expected =
            mu >= sine / cosine / 3.0 ? 2.0 / 3.0 * g * sine : g * (sine - mu * cosine);
        const auto down = [](const Vector<2>& v) { return 0.8 * v[0] - 0.6 * v[1]; };
        EXPECT_NEAR((down(last.balls[0].v) - down(first.balls[0].v)) / 2.0, expected, 1e-9) << mu;
        EXPECT_NEAR(0.6 * last.balls[0].v[0] + 0.8 * last.balls[0].v[1], 0.0, 1e-9);
        EXPECT_NEAR(push_between(last, 0, -5) / effects.time_step, 2.0 * g * cosine, 1e-9);
        if (mu >= 0.5) {  // ω r = v, clockwise
            EXPECT_NEAR(-last.spins[0][0] * 5.0, down(last.balls[0].v), 1e-9);
        }
        if (mu == 0.0) {
            EXPECT_EQ(last.spins[0][0], 0.0);
        }
    }
}

/// A heap is the same one whatever the units are, by powers of two in every bit.
TEST(TimeSteps, ContactsDoNotDependOnUnits) {
    const auto heap = [](double length, double mass, bool with_friction) {
        Effects<2> effects = standing(10.0 * length);
        effects.contacts->speed *= length;
        effects.box = Box<2>{{0.0, 0.0}, {3.0 * length, 60.0 * length}};
        if (with_friction) effects.friction = Friction{0.5, 0.5, 0.0, 0.5};
        Choices choose(3);
        std::vector<Body<2>> bodies;
        for (int i = 0; i < 12; ++i)
            bodies.push_back({{(0.75 + 1.1 * (i % 2) + 0.05 * choose.unit()) * length,
                               (0.75 + 1.1 * (i / 2)) * length},
                              {},
                              (0.25 + 0.25 * choose.unit()) * length,
                              mass});
        Simulation<2> simulation(start<2>(bodies, effects), effects);
        EXPECT_EQ(simulation.run({.until = 1.5}).ending, Ending::until);
        return simulation.state();
    };
    for (const bool with_friction : {false, true}) {
        const State<2> one = heap(1.0, 1.0, with_friction);
        for (const double length : {0x1p-20, 0x1p14})
            for (const double mass : {0x1p-30, 0x1p30}) {
                const State<2> other = heap(length, mass, with_friction);
                for (std::size_t i = 0; i < one.balls.size(); ++i)
                    for (int k = 0; k < 2; ++k)
                        ASSERT_EQ(one.balls[i].x[k], other.balls[i].x[k] / length)
                            << with_friction << " " << length << " " << mass << " " << i;
            }
    }
}

/// It has nothing to turn: friction stops it, and the floor bears it.
TEST(TimeSteps, APointRestsOnAFloor) {
    Effects<2> effects = standing(10.0);
    effects.box = Box<2>{{-50.0, 0.0}, {50.0, 10.0}};
    effects.friction = Friction{0.5, 0.5, 0.0, 0.5};
    Simulation<2> simulation(start<2>(std::vector<Body<2>>{{{0.0, 2.0}, {3.0, 0.0}, 0.0, 1.0},
                                                           {{5.0, 0.5}, {}, 0.5, 2.0}},
                                      effects),
                             effects);
    EXPECT_EQ(simulation.run({.until = 5.0}).ending, Ending::until);
    const State<2> state = simulation.state();
    EXPECT_NEAR(centre(state.balls[0], 5.0, effects)[1], 0.0, 1e-6);
    EXPECT_NEAR(state.balls[0].v[0], 0.0, 1e-12);
    EXPECT_NEAR(push_between(state, 0, -3) / effects.time_step, 10.0, 1e-9);
    EXPECT_NEAR(push_between(state, 1, -3) / effects.time_step, 20.0, 1e-9);
    EXPECT_EQ(simulation.counts().unsolved, 0U);
    EXPECT_EQ(state.spins[0][0], 0.0);
}

/// Points slide along oblique floors that rise, and lie on discs: what rounding leaves of their
/// approach is no strike, though they have no radius of which an overlap would be a part.
TEST(TimeSteps, PointsStayInContact) {
    for (std::uint64_t seed = 0; seed < (is_fast ? 60 : 10); ++seed) {
        Choices choose(seed);
        Effects<2> effects = standing(10.0);
        effects.time_step = 0.03;
        const double friction = choose.of(std::array{0.0, 0.1, 0.5, 1.0});
        if (seed % 4 > 0) effects.friction = Friction{friction, friction, 0.0, 0.5};
        const double angle = 0.8 * choose.unit();
        effects.obstacles.emplace_back(
            HalfSpace<2>{{-std::sin(angle), std::cos(angle)}, 0.0, seed % 3 == 0 ? 0.2 : 0.0});
        std::vector<Body<2>> bodies;
        for (int i = 0; i < 3; ++i) {
            const double radius = 0.2 + 0.1 * choose.unit();
            const double x = 0.7 * i;
            const double y = x * std::tan(angle) + radius / std::cos(angle) + 0.05;
            bodies.push_back({{x, y}, {choose.number(-1.0, 1.0), 0.0}, radius, 100.0});
            bodies.push_back({{x + 0.05 * choose.unit(), y + radius + 0.1}, {}, 0.0, 1.0});
        }
        Simulation<2> simulation(start<2>(bodies, effects), effects);
        ASSERT_EQ(simulation.run({.until = 3.0}).ending, Ending::until) << seed;
        EXPECT_LT(simulation.counts().strikes, 1000U) << seed;
        const State<2> state = simulation.state();
        for (std::size_t i = 1; i < bodies.size(); i += 2) {
            const Vector<2> x = centre(state.balls[i], state.time, effects);
            const auto& floor = std::get<HalfSpace<2>>(effects.obstacles[0]);
            EXPECT_GT(dot(x, floor.normal) - floor.speed * state.time, -1e-9) << seed;
        }
    }
}

/// A heavy disc falls on a light one on the floor, which goes to and fro between the two ever
/// faster, until they lie on one another.
TEST(TimeSteps, AHeavyDiscFallsOnALightOne) {
    for (const double heavy : {10.0, 1e3, 1e4, 1e6})
        for (const double restitution : {0.0, 0.25, 0.5, 0.75}) {
            Effects<2> effects = standing(10.0);
            effects.restitution = effects.wall_restitution = restitution;
            effects.box = Box<2>{{0.0, 0.0}, {1.0, 10.0}};
            effects.friction = Friction{0.5, 0.5, 0.0, 0.5};
            const std::vector<Body<2>> bodies = {{{0.5, 0.25}, {}, 0.25, 1.0},
                                                 {{0.5, 2.0}, {}, 0.5, heavy}};
            Simulation<2> simulation(start<2>(bodies, effects), effects);
            ASSERT_EQ(simulation.run({.until = 6.0}).ending, Ending::until)
                << heavy << ' ' << restitution;
            EXPECT_LT(simulation.counts().strikes, 5000U);
            const State<2> state = simulation.state();
            EXPECT_NEAR(state.balls[1].v[1], 0.0, 1e-9);
            EXPECT_NEAR(push_between(state, 0, 1) / effects.time_step / heavy, 10.0, 1e-6);
        }
}

/// How deep the first ball is in the first obstacle, a circle around it, at most.
double deepest_in_circle(const Effects<2>& effects, Simulation<2>& simulation, double until) {
    const auto& circle = std::get<Sphere<2>>(effects.obstacles.front());
    double deepest = 0.0;
    for (double t = simulation.state().time; t < until; t += 0.003) {
        EXPECT_EQ(simulation.run({.until = t}).ending, Ending::until);
        const State<2> state = simulation.state();
        const Vector<2> x = centre(state.balls[0], t, effects);
        deepest = std::max(deepest, std::hypot(x[0], x[1]) + state.balls[0].radius - circle.radius);
    }
    return deepest;
}

/// Along a circle from inside it flies along chords, as fast as before; over short and long steps,
/// and however it came there.
TEST(TimeSteps, ADiscSlidesAlongACircle) {
    for (const double step : {0.01, 0.1, 0.3})
        for (const double inwards : {0.0, -0.05}) {
            Effects<2> effects = standing(0.0);
            effects.time_step = step;
            effects.obstacles.emplace_back(
                Sphere<2>{.radius = 1.0, .side = Sphere<2>::Side::inside});
            constexpr double r = 0.05;
            const std::vector<Body<2>> bodies = {
                {{0.0, -0.95 - 0.25 * inwards}, {1.0, inwards}, r, 2.0}};
            Simulation<2> simulation(start<2>(bodies, effects), effects);
            EXPECT_LE(deepest_in_circle(effects, simulation, 6.0), 0x1.4p-8 * r)
                << step << " " << inwards;
            const State<2> state = simulation.state();
            ASSERT_EQ(state.contacts.size(), 1U) << step << " " << inwards;
            // A chord as fast along the surface as what came is longer than its way there; and
            // where it comes at an angle, it stays without what came along the normal.
            EXPECT_NEAR(std::hypot(state.balls[0].v[0], state.balls[0].v[1]), 1.0,
                        1e-3 + 0.3 * step * step - 0.3 * inwards);
            // What presses is what turns it: m v² / (R - r).
            EXPECT_NEAR(state.contacts[0].push / step, 2.0 / 0.95, 0.06 * 2.0 / 0.95);
        }
}

/// In a bowl without friction it is a pendulum.
TEST(TimeSteps, ADiscInABowlIsAPendulum) {
    Effects<2> effects = standing(10.0);
    effects.time_step = 0.002;
    effects.obstacles.emplace_back(Sphere<2>{.radius = 1.0, .side = Sphere<2>::Side::inside});
    const double angle = 0.1;
    const double length = 0.9;
    const std::vector<Body<2>> bodies = {
        {{length * std::sin(angle), -length * std::cos(angle) + 1e-9}, {}, 0.1, 1.0}};
    Simulation<2> simulation(start<2>(bodies, effects), effects);
    const double period =
        2.0 * std::numbers::pi * std::sqrt(length / 10.0) * (1.0 + angle * angle / 16.0);
    EXPECT_LE(deepest_in_circle(effects, simulation, 1.5 * period), 0x1p-8 * 0.1);
    // At the other side, and slower than a hundredth of the fastest.
    const State<2> state = simulation.state();
    EXPECT_NEAR(centre(state.balls[0], state.time, effects)[0], -length * std::sin(angle), 5e-4);
    EXPECT_NEAR(state.balls[0].v[0], 0.0, 0.01);
}

/// A floor that shakes more gently than things fall carries what lies on it, through all phases.
TEST(TimeSteps, AFloorThatShakesCarriesADisc) {
    Effects<2> effects = standing(10.0);
    effects.box = Box<2>{{-5.0, 0.0}, {5.0, 10.0}};
    effects.shake = Shake<2>{{0.0, 0.05}, 4.0 * std::numbers::pi, 0.25};
    const double r = 0.25;
    Simulation<2> simulation(start<2>(std::vector<Body<2>>{{{0.0, 0.5}, {}, r, 1.0}}, effects),
                             effects);
    double deepest = 0.0;
    double highest = 0.0;
    for (double t = 1.0; t < 3.0; t += 0.0027) {
        EXPECT_EQ(simulation.run({.until = t}).ending, Ending::until);
        const State<2> state = simulation.state();
        const double floor = 0.05 * std::sin(4.0 * std::numbers::pi * t + 0.25);
        const double gap = centre(state.balls[0], t, effects)[1] - r - floor;
        deepest = std::max(deepest, -gap);
        highest = std::max(highest, gap);
        ASSERT_EQ(state.contacts.size(), 1U);
    }
    EXPECT_LE(deepest, 1e-6);
    // a ω² Δ² / 2, and some.
    EXPECT_LE(highest, 6e-4);
}

/// Where one sweep to and fro is all that there is, strikes keep what falls from sinking in.
TEST(TimeSteps, WhatTheSweepsLeaveIsNoWayIn) {
    Effects<2> effects = standing(10.0);
    effects.contacts->sweeps = 2;
    effects.box = Box<2>{{0.0, 0.0}, {3.0, 60.0}};
    std::vector<Body<2>> bodies;
    Choices choose(8);
    for (int i = 0; i < 16; ++i)
        bodies.push_back({{0.75 + 1.1 * (i % 2) + 0.05 * choose.unit(), 0.75 + 1.1 * (i / 2)},
                          {},
                          0.25 + 0.25 * choose.unit(),
                          1.0});
    Simulation<2> simulation(start<2>(bodies, effects), effects);
    double deepest = 0.0;
    for (int look = 1; look <= 40; ++look) {
        ASSERT_EQ(simulation.run({.until = 0.0503 * look}).ending, Ending::until);
        const State<2> state = simulation.state();
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            const Vector<2> x = centre(state.balls[i], state.time, effects);
            const double r = bodies[i].radius;
            deepest = std::max(deepest, (r - x[1]) / r);
            for (std::size_t j = 0; j < i; ++j) {
                const Vector<2> y = centre(state.balls[j], state.time, effects);
                const double apart = std::hypot(x[0] - y[0], x[1] - y[1]);
                deepest = std::max(deepest,
                                   (r + bodies[j].radius - apart) / std::min(r, bodies[j].radius));
            }
        }
    }
    EXPECT_LT(deepest, 0x1p-5);
}

/// Many strikes are just at the end of a step, where the next begins: the log is one log, whether a
/// run is cut there, resumed from a state, or not at all.
TEST(TimeSteps, AStrikeBetweenTwoStepsIsOneHoweverARunIsCut) {
    constexpr double step = 0.125;
    Choices choose(11);
    choose.be_round(true);
    std::size_t at_steps = 0;
    const std::size_t scenes = is_fast ? 150 : is_sanitized ? 15 : 50;
    for (std::size_t scene = 0; scene < scenes; ++scene) {
        Effects<2> effects;
        effects.time_step = step;
        effects.box = Box<2>{{0.0, 0.0}, {6.0, 6.0}};
        effects.gravity = {0.0, scene % 2 == 0 ? -8.0 : 0.0};
        std::vector<Body<2>> bodies;
        for (int i = 0; i < 16; ++i)
            bodies.push_back({{0.75 + 1.5 * (i % 4), 0.75 + 1.5 * (i / 4)},
                              {choose.number(-2.0, 2.0), choose.number(-2.0, 2.0)},
                              choose.below(2) == 0 ? 0.625 : 0.5,
                              1.0});
        const State<2> first = start<2>(bodies, effects);
        std::vector<Strike> whole;
        Simulation<2> simulation(first, effects, {Structure::pairs});
        ASSERT_EQ(
            simulation.run({.until = 4.0}, [&](const Strike& s) { whole.push_back(s); }).ending,
            Ending::until);
        for (const Strike& strike : whole)
            at_steps += std::fmod(strike.time, step) == 0.0 ? 1U : 0U;
        for (const Structure structure : {Structure::levels, Structure::lists, Structure::cells}) {
            std::vector<Strike> cut;
            State<2> state = first;
            for (double until = 0.0; until <= 4.0; until += step) {
                Simulation<2> piece(state, effects, {structure});
                (void)piece.run({.until = until}, [&](const Strike& s) { cut.push_back(s); });
                (void)piece.run({.until = until + 0.375 * step},
                                [&](const Strike& s) { cut.push_back(s); });
                state = piece.state();
            }
            std::erase_if(cut, [](const Strike& s) { return s.time > 4.0; });
            // What is then at the end comes with the next step.
            while (cut.size() > whole.size() && cut.back().time == 4.0) cut.pop_back();
            ASSERT_EQ(whole, cut) << "scene " << scene << ", " << name_of(structure);
        }
    }
    EXPECT_GT(at_steps, 2 * scenes / 3);
}

/// Discs that fall into a box: none is ever deeper in another or in the floor than 2^-8 of a
/// radius; the run that is cut in the middle is the same.
TEST(TimeSteps, DiscsThatAreThrownIntoABoxHardlyOverlap) {
    Effects<2> effects = standing(10.0);
    effects.box = Box<2>{{0.0, 0.0}, {6.0, 20.0}};
    effects.friction = Friction{0.5, 0.5, 0.0, 0.5};
    effects.contacts->tolerance = 1e-8;
    Choices choose(5);
    std::vector<Body<2>> bodies;
    for (int i = 0; i < 24; ++i) {
        const double r = 0.25 + 0.25 * choose.unit();
        bodies.push_back({{0.75 + 1.1 * (i % 5) + 0.05 * choose.unit(), 0.75 + 1.1 * (i / 5)},
                          {choose.number(-1.0, 1.0), choose.number(-1.0, 1.0)},
                          r,
                          r * r});
    }
    const State<2> first = start<2>(bodies, effects);
    Simulation<2> simulation(first, effects);
    State<2> middle;
    double deepest = 0.0;
    const int looks = is_sanitized ? 150 : 300;
    for (int look = 1; look <= looks; ++look) {
        const double t = 0.0101 * look;
        ASSERT_EQ(simulation.run({.until = t}).ending, Ending::until);
        const State<2> state = simulation.state();
        if (look == looks / 2) middle = state;
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            const Vector<2> x = centre(state.balls[i], t, effects);
            const double r = bodies[i].radius;
            deepest = std::max({deepest, (r - x[0]) / r, (r - x[1]) / r, (x[0] + r - 6.0) / r});
            for (std::size_t j = 0; j < i; ++j) {
                const Vector<2> y = centre(state.balls[j], t, effects);
                const double reach = r + bodies[j].radius;
                const double apart = std::hypot(x[0] - y[0], x[1] - y[1]);
                deepest = std::max(deepest, (reach - apart) / std::min(r, bodies[j].radius));
            }
        }
    }
    EXPECT_LT(deepest, 0x1.4p-8);
    EXPECT_GT(simulation.counts().joins, 20U);
    Simulation<2> rest(middle, effects, {Structure::cells});
    (void)rest.run({.until = 0.0101 * looks});
    const State<2> one = simulation.state();
    const State<2> other = rest.state();
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        EXPECT_EQ(one.balls[i].x, other.balls[i].x);
        EXPECT_EQ(one.balls[i].v, other.balls[i].v);
    }
    EXPECT_EQ(one.contacts, other.contacts);
    EXPECT_EQ(one.spins, other.spins);
}

}  // namespace
}  // namespace signum::motion
