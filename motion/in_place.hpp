#pragma once
/// Whether a ball has stayed in place since its last strike, exactly. For sources only.

#include <algorithm>
#include <cmath>

#include "../exact/multiprecision.hpp"
#include "ball.hpp"

namespace signum::motion {

/// The largest of the ball's coordinates and radius.
template <int D>
[[nodiscard]] double size_of(const Ball<D>& ball) noexcept {
    double size = ball.radius;
    for (const double x : ball.x) size = std::max(size, std::fabs(x));
    return size;
}

/// approach² (its time - before)² <= 2^-80 size² square.
template <int D>
[[nodiscard]] bool in_place(const Ball<D>& ball, double before, const exact::Rational& approach,
                            const exact::Rational& square) {
    const exact::Rational flown =
        approach * (exact::to_rational(ball.time) - exact::to_rational(before));
    const exact::Rational size = exact::to_rational(size_of(ball)) / (exact::Integer(1) << 40);
    return flown * flown <= size * size * square;
}

}  // namespace signum::motion
