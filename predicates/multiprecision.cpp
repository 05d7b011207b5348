#include "multiprecision.hpp"

#include "../exact/multiprecision.hpp"
#include "ccw.hpp"

namespace signum::multiprecision {

Sign ccw(Point a, Point b, Point c) noexcept {
    using exact::Rational;
    using exact::to_rational;
    const auto difference = [](double from, double to) {
        return Rational(to_rational(from) - to_rational(to));
    };
    return predicates::ccw_determinant(difference(a.x, c.x), difference(a.y, c.y),
                                       difference(b.x, c.x), difference(b.y, c.y))
        .sign();
}

}  // namespace signum::multiprecision
