#pragma once
/// Any mixture of effects in small worlds, harsher than effects_scenes.hpp.

#include <algorithm>
#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <variant>

#include "effects_scenes.hpp"

namespace signum::motion {

/// Two half spaces between which balls are wedged, or pressed as these close.
template <int D>
void add_wedge(Effects<D>& effects, Choices& choose, double size) {
    for (int wall = 0; wall < 2 + choose.below(2); ++wall) {
        HalfSpace<D> side;
        const int axis = choose.below(D);
        side.normal[axis] = choose.below(2) == 0 ? 1.0 : -1.0;
        if (choose.below(3) == 0) side.normal[(axis + 1) % D] = choose.number(-1.0, 1.0);
        side.offset = side.normal[axis] > 0.0 ? 0.0 : -size;
        if (choose.below(2) == 0) side.speed = choose.number(-0.25, 0.75);
        effects.obstacles.push_back(side);
    }
}

template <int D>
void stop(Obstacle<D>& obstacle) {
    if (auto* wall = std::get_if<HalfSpace<D>>(&obstacle)) wall->speed = 0.0;
    if (auto* wall = std::get_if<Sphere<D>>(&obstacle)) wall->velocity = {};
}

/// Any mixture of effects; harsher than effects_scene(): friction up to 3, masses up to 2^20,
/// walls that close, fluids that drag hard, balls in corners.
/// `crushes`: boxes shake as far, walls close as well on balls that lose nothing, and balls are as
/// heavy there as anywhere, which takes up to a million strikes before such a scene ends.
template <int D>
Scene<D> harsh_scene(std::uint64_t seed, bool crushes = false) {
    Choices choose(seed);
    choose.be_round(choose.below(2) == 0);
    const double size = 2.0 + 2.0 * choose.below(3);
    Scene<D> scene{"harsh scene, seed " + std::to_string(seed), {}, {}};
    Effects<D>& effects = scene.effects;
    const int around = choose.below(4);
    if (around < 2) effects.box = cube<D>(size);
    if (around == 1) effects.periodic = choose.below(2) == 0;
    if (around == 2) add_wedge(effects, choose, size);
    for (int effect = 0; effect < effects_in_all; ++effect)
        if (choose.below(5) < 2) add(effects, static_cast<Effect>(effect), choose, size);
    if (effects.shake && !crushes) effects.shake->amplitude[0] *= 0.0625;
    if (!crushes && (effects.restitution == 1.0 || effects.contact_duration > 0.0))
        for (Obstacle<D>& each : effects.obstacles) stop<D>(each);
    if (effects.friction && choose.below(2) == 0) {
        constexpr std::array<double, 6> coefficients = {1.0, 1.5, 2.0, 3.0, 0.5, 0.9};
        effects.friction->coefficient = choose.of(coefficients);
        effects.friction->wall_coefficient = choose.of(coefficients);
    }
    if (effects.fluid && choose.below(3) == 0) effects.fluid->linear = 50.0;
    if (effects.contacts && choose.below(2) == 0) effects.contacts->speed = 2.0;
    if (effects.growth && choose.below(2) == 0) effects.growth = Growth{0.5, 4.0};
    const int most = 1 + choose.below(30);
    const bool is_in_corners = choose.below(3) == 0;
    for (int tries = 0; tries < 80 && static_cast<int>(scene.bodies.size()) < most; ++tries) {
        Body<D> body;
        body.radius = std::max(choose.number(0.0, 0.7), 0.125);
        const bool closes =
            !crushes && (effects.growth || effects.shake || !effects.obstacles.empty());
        body.mass = choose.below(6) == 0 ? (closes ? 0x1p8 : 0x1p20)
                                         : std::max(choose.number(0.0, 4.0), 0.125);
        for (int k = 0; k < D; ++k) {
            body.x[k] = choose.number(body.radius, size - body.radius);
            if (is_in_corners) body.x[k] = choose.below(2) == 0 ? body.radius : size - body.radius;
            body.v[k] = choose.below(4) == 0 ? 0.0 : choose.number(-2.0, 2.0);
        }
        if (!scene.bodies.empty() && choose.below(2) == 0) {
            const Body<D>& other = scene.bodies.back();
            const int axis = choose.below(D);
            body.x = other.x;
            body.x[axis] += (choose.below(2) == 0 ? 1.0 : -1.0) * (body.radius + other.radius);
        }
        if (effects.friction)
            for (double& w : body.spin.values) w = choose.number(-2.0, 2.0);
        scene.bodies.push_back(body);
        try {
            (void)start<D>(scene.bodies, effects);
        } catch (const std::invalid_argument&) {
            scene.bodies.pop_back();
        }
    }
    return scene;
}

}  // namespace signum::motion
