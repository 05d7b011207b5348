#pragma once
/// What a strike does, in plain doubles: beside strike.hpp it shows what exactness costs.

#include <cmath>

#include "ball.hpp"
#include "strike.hpp"

namespace signum::motion::naive {

template <int D>
[[nodiscard]] Ball<D> arrived(const Ball<D>& ball, double t, const Effects<D>& effects) noexcept {
    Ball<D> result = ball;
    result.time = t;
    for (int i = 0; i < D; ++i) {
        result.x[i] = in_box(coordinate(ball, i, t, effects), i, effects);
        result.v[i] = speed(ball, i, t, effects);
    }
    return result;
}

template <int D>
[[nodiscard]] Exchange strike(Ball<D>& a, Ball<D>& b, const Image<D>& image, double mass_a,
                              double mass_b, const Law& law, const Effects<D>& effects) noexcept {
    Vector<D> x;
    double product = 0.0;
    double square = 0.0;
    for (int i = 0; i < D; ++i) {
        x[i] = a.x[i] - b.x[i];
        if (image[i] != 0) x[i] -= image[i] * (effects.box->high[i] - effects.box->low[i]);
        product += x[i] * (a.v[i] - b.v[i]);
        square += x[i] * x[i];
    }
    product -= law.growth * std::sqrt(square);
    if (product >= 0.0) return {false, 0.0, square, 0.0};
    const double impulse =
        (1.0 + law.restitution) * (mass_a * mass_b / (mass_a + mass_b)) * (product / square);
    for (int i = 0; i < D; ++i) {
        a.v[i] -= impulse / mass_a * x[i];
        b.v[i] += impulse / mass_b * x[i];
    }
    return {true, -product, square, -impulse * square};
}

}  // namespace signum::motion::naive
