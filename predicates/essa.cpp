#include "essa.hpp"

#include "../exact/expansion.hpp"
#include "../exact/floating_environment.hpp"
#include "../exact/sum.hpp"
#include "ccw.hpp"
#include "multiprecision.hpp"

namespace signum::essa {
namespace {

/// The window of expansions is that of sums: both keep to multiples of 2^-252d in degree d.
[[nodiscard]] bool in_window(const Point& p) noexcept {
    return exact::in_expansion_window(p.x) && exact::in_expansion_window(p.y);
}

[[nodiscard]] Decision decide(const Point& a, const Point& b, const Point& c) noexcept {
    if (!in_window(a) || !in_window(b) || !in_window(c))
        return {multiprecision::ccw(a, b, c), Stage::multiprecision};
    using exact::Sum;
    return {predicates::ccw_determinant(Sum(a.x) - Sum(c.x), Sum(a.y) - Sum(c.y),
                                        Sum(b.x) - Sum(c.x), Sum(b.y) - Sum(c.y))
                .sign(),
            Stage::essa};
}

}  // namespace

Decision ccw(Point a, Point b, Point c) noexcept {
    return exact::in_ieee_environment(decide, a, b, c);
}

}  // namespace signum::essa
