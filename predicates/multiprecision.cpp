#include "multiprecision.hpp"

#include "ccw.hpp"
#include "exact_number.hpp"

namespace signum::multiprecision {

template <Arithmetic arithmetic>
Sign ccw(Point a, Point b, Point c) noexcept {
    using Number = predicates::ExactNumber<arithmetic>;
    const auto difference = [](double from, double to) -> Number {
        return predicates::exactly<arithmetic>(from) - predicates::exactly<arithmetic>(to);
    };
    return predicates::ccw_determinant(difference(a.x, c.x), difference(a.y, c.y),
                                       difference(b.x, c.x), difference(b.y, c.y))
        .sign();
}

template Sign ccw<Arithmetic::multiprecision>(Point, Point, Point) noexcept;
template Sign ccw<predicates::judging>(Point, Point, Point) noexcept;

}  // namespace signum::multiprecision
