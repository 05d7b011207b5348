#pragma once
/// Small hostile scenes with effects: balls on a lattice of eighths or anywhere, many that touch,
/// in every kind of world.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "motion_scenes.hpp"

namespace signum::motion {

/// How many scenes of a kind a test draws; `thorough` is for a slow test of its own of the same
/// source.
inline std::uint64_t scenes_to_draw([[maybe_unused]] std::uint64_t thorough) {
#if defined(SIGNUM_THOROUGH)
    return thorough;
#else
    return is_fast ? 150 : 15;
#endif
}

/// What a scene may be asked for beside its world.
enum class Effect {
    gravity,
    losses,
    speed_law,
    contact_duration,
    friction,
    shake,
    obstacles,
    growth,
    fluid,
    time_steps,
    contacts
};
inline constexpr int effects_in_all = 11;

enum class Around { nothing, box, periodic, obstacles };

/// The same choices with every standard library.
class Choices {
 public:
    explicit Choices(std::uint64_t seed) : random_(seed * 0x9e3779b97f4a7c15U + 1) {}
    int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
    double unit() { return static_cast<double>(random_() >> 34) * 0x1p-30; }
    /// A multiple of 1/8 where numbers are round.
    double number(double low, double high) {
        const double x = low + (high - low) * unit();
        return is_round_ ? std::round(8.0 * x) / 8.0 : x;
    }
    void be_round(bool is_round) { is_round_ = is_round; }
    template <class T, std::size_t n>
    const T& of(const std::array<T, n>& all) {
        return all[static_cast<std::size_t>(below(static_cast<int>(n)))];
    }

 private:
    std::mt19937_64 random_;
    bool is_round_ = false;
};

/// Around the cube [0, size]^D, or in the midst of it.
template <int D>
Obstacle<D> obstacle(Choices& choose, double size) {
    const int kind = choose.below(D == 2 ? 4 : 3);
    Vector<D> middle;
    middle.fill(0.5 * size);
    if (kind == 0) {
        HalfSpace<D> wall;
        for (double& n : wall.normal) n = choose.number(-2.0, 2.0);
        if (wall.normal == Vector<D>{}) wall.normal[D - 1] = 1.0;
        wall.offset = dot(wall.normal, middle) -
                      0.5 * size * std::sqrt(dot(wall.normal, wall.normal)) * choose.unit();
        if (choose.below(3) == 0) wall.speed = choose.number(-0.5, 0.5);
        return wall;
    }
    Sphere<D> sphere;
    if (kind == 1) {
        sphere.side = Sphere<D>::Side::inside;
        sphere.centre = middle;
        sphere.radius = size * (0.5 + 0.25 * choose.below(3));
        if (choose.below(4) == 0) sphere.velocity[0] = 0.125;
        return sphere;
    }
    for (double& x : sphere.centre) x = choose.number(0.0, size);
    sphere.radius = choose.number(0.0, 1.5);
    if (choose.below(3) == 0) sphere.velocity[0] = choose.number(-1.0, 1.0);
    if constexpr (D == 2) {
        if (kind == 3) {
            Segment segment{sphere.centre, sphere.centre};
            for (double& x : segment.to) x += choose.number(-3.0, 3.0);
            if (segment.from == segment.to) segment.to[0] += 1.0;
            return segment;
        }
    }
    return sphere;
}

template <int D>
void add(Effects<D>& effects, Effect effect, Choices& choose, double size) {
    constexpr std::array<double, 5> restitutions = {0.9, 0.5, 0.0, 0.75, 1.0};
    switch (effect) {
        case Effect::gravity:
            effects.gravity[D - 1] = -choose.number(0.25, 1.0);
            if (choose.below(4) == 0) effects.gravity[0] = choose.number(-0.5, 0.5);
            break;
        case Effect::losses:
            effects.restitution = choose.of(restitutions);
            effects.wall_restitution = choose.of(restitutions);
            break;
        case Effect::speed_law:
            if (effects.restitution == 1.0) effects.restitution = 0.75;
            effects.speed_law = SpeedLaw{choose.number(0.25, 2.0), 0.2 * (1 + choose.below(6))};
            break;
        case Effect::contact_duration:
            if (effects.restitution == 1.0) effects.restitution = 0.25;
            effects.contact_duration = choose.below(2) == 0 ? 0.125 : 0.01;
            break;
        case Effect::friction:
            effects.friction = Friction{choose.number(0.0, 2.0), choose.number(0.0, 2.0),
                                        0.25 * (choose.below(9) - 4), D == 2 ? 0.5 : 0.4};
            break;
        case Effect::shake:
            if (!effects.box || effects.periodic) return;
            effects.shake.emplace();
            effects.shake->amplitude[D - 1] = choose.number(-0.5, 0.5);
            if (choose.below(3) == 0) effects.shake->amplitude[0] = choose.number(0.0, 2.0 * size);
            effects.shake->frequency = choose.number(0.0, 6.0);
            effects.shake->phase = choose.below(2) == 0 ? 0.0 : choose.number(-3.0, 3.0);
            break;
        case Effect::obstacles:
            if (effects.periodic) return;
            for (int i = 1 + choose.below(3); i > 0; --i)
                effects.obstacles.push_back(obstacle<D>(choose, size));
            break;
        case Effect::growth:
            if (effects.contacts) return;
            effects.growth = Growth{0.125 * (1 + choose.below(2)), choose.number(0.25, 2.0)};
            break;
        case Effect::fluid:
            effects.fluid.emplace();
            effects.fluid->linear = choose.below(2) == 0 ? 0.0 : choose.number(0.0, 1.0);
            effects.fluid->quadratic = choose.below(2) == 0 ? 0.0 : choose.number(0.0, 1.0);
            for (double& u : effects.fluid->velocity) u = choose.number(-1.0, 1.0);
            if (choose.below(2) == 0) effects.fluid->gradient[0][D - 1] = choose.number(-0.5, 0.5);
            effects.time_step = 0.0625;
            break;
        case Effect::time_steps:
            effects.time_step = choose.below(2) == 0 ? 0.125 : 0.03;
            break;
        case Effect::contacts:
            if (effects.growth) return;
            effects.contacts = LastingContacts{choose.below(2) == 0 ? 0.25 : 0.02, 1e-8, 200};
            if (effects.time_step == 0.0) effects.time_step = 0.0625;
            break;
    }
}

/// With these effects, as far as they go together.
template <int D>
Scene<D> effects_scene(std::uint64_t seed, const std::vector<Effect>& wanted) {
    Choices choose(seed);
    choose.be_round(choose.below(2) == 0);
    constexpr double size = 6.0;
    Scene<D> scene{"small", {}, {}};
    Effects<D>& effects = scene.effects;
    const auto around = static_cast<Around>(choose.below(4));
    if (around == Around::box || around == Around::periodic) {
        effects.box = cube<D>(size);
        effects.periodic = around == Around::periodic;
    }
    if (around == Around::obstacles) add(effects, Effect::obstacles, choose, size);
    for (const Effect effect : wanted) add(effects, effect, choose, size);
    const bool equal = choose.below(2) == 0;
    const bool touching = choose.below(2) == 0;
    const int most = 2 + choose.below(9);
    for (int tries = 0; tries < 40 && static_cast<int>(scene.bodies.size()) < most; ++tries) {
        Body<D> body;
        body.radius = equal ? 0.5 : choose.number(0.0, 0.7);
        body.mass = equal ? 1.0 : std::max(choose.number(0.0, 4.0), 0.125);
        for (int k = 0; k < D; ++k) {
            body.x[k] = choose.number(body.radius, size - body.radius);
            body.v[k] = choose.below(4) == 0 ? 0.0 : choose.number(-2.0, 2.0);
        }
        if (effects.friction)
            for (double& w : body.spin.values) w = choose.number(-2.0, 2.0);
        if (touching && !scene.bodies.empty()) {
            const Body<D>& other = scene.bodies.back();
            body.x = other.x;
            body.x[choose.below(D)] += body.radius + other.radius;
        }
        scene.bodies.push_back(body);
        try {
            (void)start<D>(scene.bodies, effects);
        } catch (const BallError&) {
            scene.bodies.pop_back();
        }
    }
    return scene;
}

inline std::string_view name_of(Effect effect) {
    constexpr std::array<std::string_view, effects_in_all> names = {
        "gravity",   "losses", "speed law", "contact duration", "friction", "shake",
        "obstacles", "growth", "fluid",     "time steps",       "contacts"};
    return names[static_cast<std::size_t>(effect)];
}

}  // namespace signum::motion
