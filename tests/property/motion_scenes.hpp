#pragma once
/// Scenes that are meant to break a simulation, of any number of balls.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "../../motion/simulation.hpp"
#include "../thoroughness.hpp"

namespace signum::motion {

template <int D>
struct Scene {
    std::string name;
    std::vector<Body<D>> bodies;
    Effects<D> effects;
};

/// A cube [0, size]^D.
template <int D>
Box<D> cube(double size) {
    Box<D> box;
    box.high.fill(size);
    return box;
}

/// About so many places of a cubic lattice of width 1, from (0.5, …) on; at least 2^D.
template <int D>
std::vector<Vector<D>> lattice(std::size_t number) {
    int side = 2;
    while (std::pow(side + 1, D) <= static_cast<double>(number)) ++side;
    std::vector<Vector<D>> places;
    Vector<D> x;
    x.fill(0.5);
    for (;;) {
        places.push_back(x);
        int k = 0;
        for (; k < D; ++k) {
            if ((x[k] += 1.0) < side) break;
            x[k] = 0.5;
        }
        if (k == D) return places;
    }
}
inline double side_of(std::size_t places, int dimension) {
    return std::round(std::pow(static_cast<double>(places), 1.0 / dimension));
}

/// A gas: a lattice with random velocities, of packing π/6·0.7³ or so.
template <int D>
Scene<D> gas(std::size_t number, bool periodic, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> speed;
    Scene<D> scene{periodic ? "gas in a periodic box" : "gas", {}, {}};
    const std::vector<Vector<D>> places = lattice<D>(number);
    for (const Vector<D>& x : places) {
        Body<D> body{x, {}, 0.35, 1.0};
        for (double& v : body.v) v = speed(random);
        scene.bodies.push_back(body);
    }
    scene.effects.box = cube<D>(side_of(places.size(), D));
    scene.effects.periodic = periodic;
    return scene;
}

/// A lattice at rest whose balls touch, struck by one: chains of strikes at one time.
template <int D>
Scene<D> struck_lattice(std::size_t number, double radius) {
    Scene<D> scene{
        radius == 0.5 ? "touching lattice struck by one" : "lattice struck by one", {}, {}};
    const std::vector<Vector<D>> places = lattice<D>(number);
    for (const Vector<D>& x : places) scene.bodies.push_back({x, {}, radius, 1.0});
    Body<D> cue{places.front(), {}, radius, 1.0};
    cue.x[0] = -2.0;
    cue.v[0] = 1.0;
    cue.v[1] = 0.125;
    scene.bodies.push_back(cue);
    scene.effects.box = cube<D>(side_of(places.size(), D) + 2.0);
    scene.effects.box->low.fill(-4.0);
    return scene;
}

/// Every ball has mirror images: many strikes at the same time.
template <int D>
Scene<D> symmetric(std::size_t number, std::uint64_t seed) {
    Scene<D> scene = gas<D>(std::max<std::size_t>(number >> D, 1U << D), false, seed);
    scene.name = "symmetric";
    std::vector<Body<D>> all;
    for (int mirror = 0; mirror < 1 << D; ++mirror) {
        for (Body<D> body : scene.bodies) {
            for (int k = 0; k < D; ++k) {
                if ((mirror >> k & 1) == 0) continue;
                body.x[k] = -body.x[k];
                body.v[k] = -body.v[k];
            }
            all.push_back(body);
        }
    }
    scene.bodies = std::move(all);
    for (int k = 0; k < D; ++k) scene.effects.box->low[k] = -scene.effects.box->high[k];
    return scene;
}

/// Balls in a row that touch; one end is struck.
template <int D>
Scene<D> cradle(std::size_t number) {
    Scene<D> scene{"Newton's cradle", {}, {}};
    for (std::size_t i = 0; i < number; ++i) {
        Body<D> body{{}, {}, 0.5, 1.0};
        body.x[0] = static_cast<double>(i) + (i == 0 ? -3.0 : 0.0);
        if (i == 0) body.v[0] = 1.0;
        scene.bodies.push_back(body);
    }
    scene.effects.box = cube<D>(static_cast<double>(number) + 4.0);
    scene.effects.box->low.fill(-6.0);
    return scene;
}

/// Columns that fly past one another at a distance that is the sum of the radii, or an ulp more or
/// less.
template <int D>
Scene<D> grazing(std::size_t number) {
    Scene<D> scene{"grazing", {}, {}};
    const std::size_t pairs = number / 2;
    for (std::size_t i = 0; i < pairs; ++i) {
        Body<D> still{{}, {}, 0.5, 1.0};
        Body<D> flying{{}, {}, 0.5, 1.0};
        still.x[1] = 4.0 * static_cast<double>(i) + 2.0;
        flying.x[0] = -6.0;
        flying.x[1] = still.x[1] + 1.0;
        if (i % 3 == 1) flying.x[1] = std::nextafter(flying.x[1], 1e9);
        if (i % 3 == 2) flying.x[1] = std::nextafter(flying.x[1], -1e9);
        flying.v[0] = 1.0 + 0.25 * static_cast<double>(i % 7);
        scene.bodies.push_back(still);
        scene.bodies.push_back(flying);
    }
    scene.effects.box = cube<D>(4.0 * static_cast<double>(pairs) + 4.0);
    scene.effects.box->low.fill(-8.0);
    return scene;
}

/// A gas whose masses go from 1 to 10^12.
template <int D>
Scene<D> masses(std::size_t number, std::uint64_t seed) {
    Scene<D> scene = gas<D>(number, false, seed);
    scene.name = "masses 1 : 10^12";
    for (std::size_t i = 0; i < scene.bodies.size(); ++i)
        scene.bodies[i].mass = std::pow(10.0, static_cast<double>(i % 13));
    return scene;
}

/// Radii from 10^-6 to 1: a large ball among small ones.
template <int D>
Scene<D> radii(std::size_t number, std::uint64_t seed) {
    Scene<D> scene = gas<D>(number, false, seed);
    scene.name = "radii 1 : 10^6";
    std::mt19937_64 random(seed);
    for (Body<D>& body : scene.bodies) {
        body.radius =
            0.45 *
            std::pow(10.0, -6.0 * std::pow(static_cast<double>(random() % 1000) / 1000.0, 2.0));
        body.mass = std::pow(body.radius, D);
    }
    scene.bodies.front().radius = 0.5;
    scene.bodies.back().radius = 0.5e-6;
    return scene;
}

/// Balls that fall, with losses at their strikes.
template <int D>
Scene<D> falling(std::size_t number, std::uint64_t seed) {
    Scene<D> scene = gas<D>(number, false, seed);
    scene.name = "falling";
    scene.effects.gravity[D - 1] = -0.5;
    scene.effects.restitution = 0.9;
    scene.effects.wall_restitution = 1.0;
    return scene;
}

/// Without a box, shrinking toward one place and flying apart.
template <int D>
Scene<D> meeting_place(std::size_t number, std::uint64_t seed) {
    Scene<D> scene = gas<D>(number, false, seed);
    scene.name = "without a box";
    const double middle = 0.5 * scene.effects.box->high[0];
    scene.effects.box.reset();
    for (Body<D>& body : scene.bodies)
        for (int k = 0; k < D; ++k) body.v[k] = 0.125 * body.v[k] - (body.x[k] - middle);
    return scene;
}

template <int D>
std::vector<Scene<D>> all_scenes(std::size_t number) {
    return {gas<D>(number, false, 1),
            gas<D>(number, true, 2),
            struck_lattice<D>(number, 0.5),
            struck_lattice<D>(number, 0.375),
            symmetric<D>(number, 3),
            cradle<D>(std::min<std::size_t>(number, 300)),
            grazing<D>(number),
            masses<D>(number, 4),
            radii<D>(number, 5),
            falling<D>(number, 6),
            meeting_place<D>(number, 7)};
}

/// Of two places, in a periodic box that of the nearest images; rounded.
template <int D>
double square_of_distance(const Vector<D>& a, const Vector<D>& b, const Effects<D>& effects) {
    double square = 0.0;
    for (int k = 0; k < D; ++k) {
        double d = a[k] - b[k];
        if (effects.periodic) {
            const double length = effects.box->high[k] - effects.box->low[k];
            d -= length * std::round(d / length);
        }
        square += d * d;
    }
    return square;
}

/// Of balls of mass 1.
template <int D>
double energy(const Simulation<D>& simulation) {
    double sum = 0.0;
    for (const Ball<D>& ball : simulation.state().balls) sum += 0.5 * dot(ball.v, ball.v);
    return sum;
}

/// No two balls are deeper in each other than a few ulps, whenever one looks.
template <int D>
void expect_nothing_through(const Scene<D>& scene, int looks, double every,
                            Structure structure = Structure::automatic) {
    Simulation<D> simulation(start<D>(scene.bodies, scene.effects), scene.effects, {structure});
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> pause(0.0, 2.0 * every);
    double t = 0.0;
    for (int look = 1; look <= looks; ++look) {
        t += pause(random);
        ASSERT_EQ(simulation.run({.until = t}).ending, Ending::until);
        const State<D> state = simulation.state();
        std::vector<Vector<D>> x;
        for (const Ball<D>& ball : state.balls) x.push_back(centre(ball, t, scene.effects));
        for (std::size_t i = 0; i < x.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                const double reach = state.balls[i].radius + state.balls[j].radius;
                ASSERT_GT(square_of_distance(x[i], x[j], scene.effects),
                          (reach - 1e-13) * (reach - 1e-13))
                    << i << " and " << j << " at " << t;
            }
        }
    }
}

}  // namespace signum::motion
