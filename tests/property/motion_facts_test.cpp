/// What is known to be true of balls in motion: formulas of physics that nobody put into the code.
/// The pressure of gases is in slow/large_motion_test.cpp.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "../../motion/simulation.hpp"

namespace signum::motion {
namespace {

/// The same numbers on every machine.
class Random {
 public:
    explicit Random(std::uint64_t seed) : state_(seed) {}
    double unit() {
        state_ = state_ * 6364136223846793005 + 1442695040888963407;
        return std::ldexp(static_cast<double>(state_ >> 11), -53);
    }
    double normal() {
        return std::sqrt(-2.0 * std::log(1.0 - unit())) * std::cos(2.0 * std::numbers::pi * unit());
    }

 private:
    std::uint64_t state_;
};

template <int D>
double kinetic(const State<D>& state, const Effects<D>& effects) {
    double energy = 0.0;
    for (std::size_t i = 0; i < state.balls.size(); ++i)
        for (int k = 0; k < D; ++k) {
            const double v = speed(state.balls[i], k, state.time, effects);
            energy += 0.5 * state.masses[i] * v * v;
        }
    return energy;
}

/// χ² of cells that are equally likely, the sum of (found - expected)² / expected, less its mean
/// and in units of its spread, which is that of a normal variable for many cells (Wilson, Hilferty
/// 1931).
double deviation(const std::vector<double>& found) {
    double all = 0.0;
    for (const double each : found) all += each;
    const double expected = all / static_cast<double>(found.size());
    double square = 0.0;
    for (std::size_t k = 0; k < found.size(); ++k)
        square += (found[k] - expected) * (found[k] - expected) / expected;
    const double freedom = static_cast<double>(found.size()) - 1.0;
    const double width = 2.0 / (9.0 * freedom);
    return (std::cbrt(square / freedom) - (1.0 - width)) / std::sqrt(width);
}

TEST(MotionFacts, ABallBouncesAtTheKnownTimes) {
    constexpr double g = 9.81;
    constexpr double e = 0.8;
    constexpr double height = 2.0;
    Effects<2> effects;
    effects.gravity = {0.0, -g};
    effects.box = Box<2>{{-1.0, 0.0}, {1.0, 10.0}};
    effects.restitution = effects.wall_restitution = e;
    const std::vector<Body<2>> bodies = {{{0.0, 0.1 + height}, {0.0, 0.0}, 0.1, 1.0}};
    std::vector<double> times;
    Simulation<2> simulation(start<2>(bodies, effects), effects);
    (void)simulation.run({.strikes = 40}, [&](const Strike& s) { times.push_back(s.time); });
    ASSERT_EQ(times.size(), 40U);
    double expected = std::sqrt(2.0 * height / g);
    double flight = 2.0 * expected;
    for (const double time : times) {
        EXPECT_NEAR(time, expected, 1e-12 * expected);
        flight *= e;
        expected += flight;
    }
    // The last bounce: the sum of all flights.
    EXPECT_NEAR(times.back(), std::sqrt(2.0 * height / g) * (1.0 + e) / (1.0 - e), 1e-3);
}

TEST(MotionFacts, ACradlePassesItsImpulseOn) {
    std::vector<Body<2>> bodies;
    for (int i = 0; i < 9; ++i) bodies.push_back({{2.0 * i, 0.0}, {0.0, 0.0}, 1.0, 1.0});
    bodies[0].x[0] = -3.5;
    bodies[0].v[0] = 0.7;
    std::vector<Strike> log;
    const Effects<2> effects;
    Simulation<2> simulation(start<2>(bodies, effects), effects);
    (void)simulation.run({.until = 100.0}, [&](const Strike& s) { log.push_back(s); });
    ASSERT_EQ(log.size(), 8U);
    for (std::size_t k = 0; k < log.size(); ++k) {
        EXPECT_EQ(log[k].time, log[0].time);
        EXPECT_EQ(log[k].a, static_cast<std::int32_t>(k));
        EXPECT_EQ(log[k].impulse, 0.7);
    }
    const State<2> end = simulation.state();
    for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(end.balls[i].v, (Vector<2>{0.0, 0.0}));
    EXPECT_EQ(end.balls[8].v, (Vector<2>{0.7, 0.0}));
}

/// T(t) = T₀ / (1 + t/τ)^α with α = 2 (Haff 1983), until clusters form: so a dilute gas, at rest as
/// a whole, and not for too long.
TEST(MotionFacts, AGranularGasCoolsAsHaffSays) {
    constexpr int side = 60;
    constexpr double packing = 0.02;
    Effects<2> effects;
    const double length = side * std::sqrt(std::numbers::pi * 0.25 / packing);
    effects.box = Box<2>{{0.0, 0.0}, {length, length}};
    effects.periodic = true;
    Random random(1);
    std::vector<Body<2>> bodies;
    Vector<2> drift{};
    for (int i = 0; i < side * side; ++i) {
        bodies.push_back({{(i % side + 0.5) * length / side, (i / side + 0.5) * length / side},
                          {random.normal(), random.normal()},
                          0.5,
                          1.0});
        for (int k = 0; k < 2; ++k) drift[k] += bodies.back().v[k] / (side * side);
    }
    for (Body<2>& body : bodies)
        for (int k = 0; k < 2; ++k) body.v[k] -= drift[k];
    // Elastic, until speeds are those of a gas.
    Simulation<2> elastic(start<2>(bodies, effects), effects);
    (void)elastic.run({.strikes = 10 * side * side});
    effects.restitution = 0.9;
    Simulation<2> simulation(elastic.state(), effects);
    const double begin = elastic.state().time;
    std::vector<double> times;
    std::vector<double> temperatures;
    for (int k = 0; k < 50; ++k) {
        const State<2> state = simulation.state();
        times.push_back(state.time - begin);
        temperatures.push_back(kinetic(state, effects) / (side * side));
        (void)simulation.run({.strikes = side * side / 2});
    }
    // ln T is a straight line over ln(1 + t/τ) for the right τ; α is its slope.
    const auto fit = [&](double tau) {
        double sx = 0.0;
        double sy = 0.0;
        double sxx = 0.0;
        double sxy = 0.0;
        const auto n = static_cast<double>(times.size());
        for (std::size_t k = 0; k < times.size(); ++k) {
            const double x = std::log1p(times[k] / tau);
            const double y = std::log(temperatures[k]);
            sx += x;
            sy += y;
            sxx += x * x;
            sxy += x * y;
        }
        const double slope = (n * sxy - sx * sy) / (n * sxx - sx * sx);
        const double level = (sy - slope * sx) / n;
        double rest = 0.0;
        for (std::size_t k = 0; k < times.size(); ++k) {
            const double error =
                std::log(temperatures[k]) - level - slope * std::log1p(times[k] / tau);
            rest += error * error;
        }
        return std::array{rest, -slope};
    };
    double best_tau = 0.0;
    double least = INFINITY;
    for (double tau = 1.0; tau < 1e4; tau *= 1.002) {
        if (fit(tau)[0] < least) {
            least = fit(tau)[0];
            best_tau = tau;
        }
    }
    EXPECT_NEAR(fit(best_tau)[1], 2.0, 0.06) << "tau " << best_tau;
    EXPECT_LT(temperatures.back(), 0.02 * temperatures.front());
}

/// A dilute elastic gas that starts with one speed and falls upon itself: density over height is
/// exponential, components of velocity are normal, with one temperature.
TEST(MotionFacts, AGasUnderGravityIsBarometricAndMaxwellian) {
    constexpr int balls = 400;
    constexpr double g = 1.0;
    Effects<2> effects;
    effects.gravity = {0.0, -g};
    effects.box = Box<2>{{0.0, 0.0}, {1.0, 100.0}};
    Random random(2);
    std::vector<Body<2>> bodies;
    for (int i = 0; i < balls; ++i) {
        const double angle = 2.0 * std::numbers::pi * random.unit();
        bodies.push_back({{(i % 20 + 0.5) / 20.0, 0.05 + 0.1 * (i / 20)},
                          {1.5 * std::cos(angle), 1.5 * std::sin(angle)},
                          0.002,
                          1.0});
    }
    Simulation<2> simulation(start<2>(bodies, effects), effects);
    (void)simulation.run({.strikes = 40'000});
    std::vector<double> heights;
    std::vector<double> speeds;
    double energy = 0.0;
    constexpr int looks = 25;
    for (int look = 0; look < looks; ++look) {
        (void)simulation.run({.strikes = 8'000});
        const State<2> state = simulation.state();
        for (const Ball<2>& ball : state.balls) {
            heights.push_back(coordinate(ball, 1, state.time, effects) - ball.radius);
            for (int k = 0; k < 2; ++k) speeds.push_back(speed(ball, k, state.time, effects));
        }
        energy += kinetic(state, effects);
    }
    const double temperature = energy / (looks * balls);
    constexpr int cells = 20;
    std::vector<double> of_height(cells);
    std::vector<double> of_speed(cells);
    for (const double h : heights)
        ++of_height[static_cast<std::size_t>(
            std::min<double>(cells - 1, cells * -std::expm1(-g * h / temperature)))];
    for (const double v : speeds)
        ++of_speed[static_cast<std::size_t>(
            std::min<double>(cells - 1, cells * 0.5 * std::erfc(-v / std::sqrt(2 * temperature))))];
    // Equally likely cells; beyond 3.7 is one in ten thousand.
    EXPECT_LT(deviation(of_height), 3.7);
    EXPECT_LT(deviation(of_speed), 3.7);
    // And where they all begin is neither.
    std::vector<double> at_first(cells);
    for (const Body<2>& body : bodies)
        ++at_first[static_cast<std::size_t>(
            std::min<double>(cells - 1, cells * -std::expm1(-g * body.x[1] / temperature)))];
    EXPECT_GT(deviation(at_first), 6.0);
}

/// Discs fall onto a floor of fixed ones, come to rest, and lie at less than the angle of friction.
TEST(MotionFacts, APileLiesAtRest) {
    constexpr double g = 10.0;
    constexpr double mu = 0.5;
    Effects<2> effects;
    effects.gravity = {0.0, -g};
    effects.restitution = effects.wall_restitution = 0.2;
    effects.friction = Friction{mu, mu, 0.0, 0.5};
    effects.contacts = LastingContacts{0.2, 1e-8, 200};
    effects.time_step = 0.01;
    for (int i = -25; i <= 25; ++i)
        effects.obstacles.emplace_back(Sphere<2>{.centre = {1.3 * i, 0.0}, .radius = 0.5});
    std::vector<Body<2>> bodies;
    Random random(3);
    for (int i = 0; i < 40; ++i) {
        const double r = 0.4 + 0.2 * random.unit();
        bodies.push_back({{(i % 6 - 2.5) * 1.25 + 0.02 * random.unit(), 1.7 + 1.25 * (i / 6)},
                          {0.0, 0.0},
                          r,
                          r * r});
    }
    Simulation<2> simulation(start<2>(bodies, effects), effects);
    const Outcome outcome = simulation.run({.until = 20.0});
    ASSERT_EQ(outcome.ending, Ending::until);
    const State<2> end = simulation.state();
    double weight = 0.0;
    double reaction = 0.0;
    double fastest = 0.0;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        weight += end.masses[i] * g;
        fastest = std::max(fastest, std::sqrt(dot(end.balls[i].v, end.balls[i].v)));
    }
    for (const StandingContact<2>& contact : end.contacts) {
        if (contact.b >= 0) continue;
        const auto number = static_cast<std::size_t>(-1 - contact.b - 4);
        const Vector<2>& floor = std::get<Sphere<2>>(effects.obstacles[number]).centre;
        const Vector<2>& x = end.balls[static_cast<std::size_t>(contact.a)].x;
        const double distance = std::hypot(x[0] - floor[0], x[1] - floor[1]);
        reaction += (contact.push * (x[1] - floor[1]) / distance + contact.rub[1]) / 0.01;
    }
    EXPECT_LT(fastest, 1e-6);
    EXPECT_NEAR(reaction, weight, 1e-6 * weight);
    // Of a triangle, by the means of height and of distance from the middle: both are a third.
    double middle = 0.0;
    double mass = 0.0;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        middle += end.masses[i] * end.balls[i].x[0];
        mass += end.masses[i];
    }
    middle /= mass;
    double height = 0.0;
    double width = 0.0;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        height += end.masses[i] / mass * (end.balls[i].x[1] - 0.5);
        width += end.masses[i] / mass * std::fabs(end.balls[i].x[0] - middle);
    }
    EXPECT_LT(height / width, mu);
    EXPECT_GT(height / width, 0.1);
}

/// The shaker by steps of time, where gravity acts by kicks, tends to the one that knows no steps.
/// As h, not as h²: a strike finds the velocity of the middle of its step.
TEST(MotionFacts, TimeStepsTendToEvents) {
    Effects<2> effects;
    effects.gravity = {0.0, -9.81};
    effects.box = Box<2>{{0.0, 0.0}, {200.0, 200.0}};
    effects.restitution = effects.wall_restitution = 0.9;
    effects.shake = Shake<2>{{0.0, 5.0}, 2.0 * std::numbers::pi, 0.0};
    // Until they have struck often, all is determined but for the steps' own errors.
    std::vector<Body<2>> bodies;
    for (int i = 0; i < 100; ++i)
        bodies.push_back({{20.0 * (i % 10) + 10.0 + (i / 10) % 2, 20.0 * (i / 10) + 10.0},
                          {std::sin(7.0 * i) * 20.0, std::cos(5.0 * i) * 20.0},
                          6.5,
                          1.0});
    const auto places_at = [&](double step) {
        Effects<2> stepped = effects;
        stepped.time_step = step;
        Simulation<2> simulation(start<2>(bodies, stepped), stepped);
        (void)simulation.run({.until = 0.4});
        const State<2> state = simulation.state();
        std::vector<double> result;
        for (const Ball<2>& ball : state.balls)
            for (int k = 0; k < 2; ++k) result.push_back(coordinate(ball, k, 0.4, stepped));
        result.push_back(static_cast<double>(simulation.counts().strikes));
        result.push_back(kinetic(state, stepped));
        return result;
    };
    const std::vector<double> exact = places_at(0.0);
    double before = INFINITY;
    for (const double step : {0.005, 0.0025, 0.00125, 0.000625}) {
        const std::vector<double> found = places_at(step);
        double error = 0.0;
        for (std::size_t k = 0; k + 2 < exact.size(); ++k)
            error = std::max(error, std::fabs(found[k] - exact[k]));
        EXPECT_LT(error, 0.7 * before) << "step " << step;
        before = error;
    }
    EXPECT_LT(before, 0.01);
    EXPECT_EQ(places_at(0.000625)[200], exact[200]);
    EXPECT_NEAR(places_at(0.000625)[201], exact[201], 1e-3 * exact[201]);
}

}  // namespace
}  // namespace signum::motion
