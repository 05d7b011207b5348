#include "set.hpp"

#include <algorithm>
#include <cmath>

#include "../../predicates/space/ccw.hpp"
#include "../../predicates/space/euclidean.hpp"
#include "exact_sphere.hpp"

namespace signum::balls {

BallSet::BallSet(std::span<const Site3> balls) : balls_(balls) {
    double largest = 0.0;
    for (const Site3& b : balls_)
        for (const double number : {b.x, b.y, b.z, b.r})
            largest = std::max(largest, std::fabs(number));
    int exponent = 0;
    std::frexp(largest, &exponent);
    scaled_.reserve(balls_.size());
    for (const Site3& b : balls_)
        scaled_.push_back({std::ldexp(b.x, -exponent), std::ldexp(b.y, -exponent),
                           std::ldexp(b.z, -exponent), std::ldexp(b.r, -exponent)});
}

bool BallSet::touch_along_a_curve(const Quadruple& four) const {
    const auto [a, b, c, d] = of(four);
    if (same_radius(a, b, c, d))
        return ccw_decision(centre3(a), centre3(b), centre3(c), centre3(d)).sign == 0;
    if (euclidean::exists_decision(a, b, c, d).sign > 0) return false;
    if (euclidean::exists_decision(a, c, b, d).sign > 0) return false;
    return balls::touch_along_a_curve({a, b, c, d});
}

}  // namespace signum::balls
