#pragma once
/// What a strike does, in plain doubles: beside strike.hpp it shows what exactness costs.

#include <cmath>

#include "apart.hpp"
#include "ball.hpp"
#include "strike.hpp"

namespace signum::motion::naive {

template <int D>
[[nodiscard]] Ball<D> arrived(const Ball<D>& ball, double t, const Effects<D>& effects) noexcept {
    return {centre_in_box(ball, t, effects), velocity(ball, t, effects), ball.radius, t};
}

template <int D>
[[nodiscard]] Exchange strike(Ball<D>& a, Ball<D>& b, const Image<D>& image, double mass_a,
                              double mass_b, const Law& law, const Effects<D>& effects) noexcept {
    const Vector<D> x = apart<double>(a.x, b.x, image, effects);
    const double square = dot(x, x);
    const double product = dot(x, a.v - b.v) - law.growth * std::sqrt(square);
    if (product >= 0.0) return {false, 0.0, square, 0.0};
    const double impulse =
        (1.0 + law.restitution) * (mass_a * mass_b / (mass_a + mass_b)) * (product / square);
    a.v = a.v - impulse / mass_a * x;
    b.v = b.v + impulse / mass_b * x;
    return {true, -product, square, -impulse * square};
}

}  // namespace signum::motion::naive
