#pragma once
/// Points as vectors. For sources only.

#include <cmath>

#include "../core/site.hpp"

namespace signum {

[[nodiscard]] inline double dot(Point a, Point b) noexcept {
    return a.x * b.x + a.y * b.y;
}
[[nodiscard]] inline double cross(Point a, Point b) noexcept {
    return a.x * b.y - a.y * b.x;
}
[[nodiscard]] inline Point minus(Point a, Point b) noexcept {
    return {a.x - b.x, a.y - b.y};
}
/// a + times b.
[[nodiscard]] inline Point plus(Point a, Point b, double times) noexcept {
    return {a.x + times * b.x, a.y + times * b.y};
}
/// Times 2^exponent.
[[nodiscard]] inline Point scaled(Point p, int exponent) noexcept {
    return {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)};
}

}  // namespace signum
