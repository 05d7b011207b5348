#include "multiprecision.hpp"

#include "../exact/dyadic.hpp"
#include "ccw.hpp"

namespace signum::multiprecision {

Sign ccw(Point a, Point b, Point c) noexcept {
    return predicates::rounded_ccw<exact::Dyadic<>>(a, b, c).sign();
}

}  // namespace signum::multiprecision
