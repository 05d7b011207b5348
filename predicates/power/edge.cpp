#include "edge.hpp"

#include "../../exact/floating_environment.hpp"
#include "exact_rows.hpp"
#include "multiprecision.hpp"

namespace signum::power {
namespace {

using filters::magnitude;

/// |p-b|² - |p-a|² + w_a - w_b. The squares take 4 roundings, their difference 5, the weights at
/// most 3, the last sum 6; one more e for second-order terms and the roundings of the bound.
constexpr double nearer_error = 7 * filters::epsilon;

template <PowerSite S>
[[nodiscard]] Sign expand(const Point& p, const S& a, const S& b) noexcept {
    const auto square = [&p](const S& s) {
        return exact::square(exact::difference(p.x, s.x)) +
               exact::square(exact::difference(p.y, s.y));
    };
    return (square(b) - square(a) + cold::expansion_weight(a, b)).sign();
}

template <PowerSite S>
[[nodiscard]] Decision decide(const Point& p, const S& a, const S& b) noexcept {
    if (!cold::in_window(p, a, b)) return {multiprecision::nearer(p, a, b), Stage::multiprecision};
    const double ax = p.x - a.x;
    const double ay = p.y - a.y;
    const double bx = p.x - b.x;
    const double by = p.y - b.y;
    const double weight = weight_difference(a, b);
    const double a_square = ax * ax + ay * ay;
    const double b_square = bx * bx + by * by;
    const double difference = (b_square - a_square) + weight;
    if (magnitude(difference) > nearer_error * (a_square + b_square + magnitude(weight)))
        return {filters::sign_of_nonzero(difference), Stage::filter};
    return {expand(p, a, b), Stage::exact};
}

}  // namespace

Decision nearer_decision(Point p, const Point& a, const Point& b) noexcept {
    return exact::in_ieee_environment(decide<Point>, p, a, b);
}
Decision nearer_decision(Point p, const Site& a, const Site& b) noexcept {
    return exact::in_ieee_environment(decide<Site>, p, a, b);
}
Decision nearer_decision(Point p, const signum::Site& a, const signum::Site& b) noexcept {
    return exact::in_ieee_environment(decide<signum::Site>, p, a, b);
}

}  // namespace signum::power
