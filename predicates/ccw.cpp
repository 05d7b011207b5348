#include "ccw.hpp"

#include "../exact/expansion.hpp"
#include "../exact/floating_environment.hpp"
#include "../filters/wide.hpp"
#include "multiprecision.hpp"

namespace signum {
namespace predicates {
namespace {

[[nodiscard]] bool in_window(const Point& p) noexcept {
    return exact::in_expansion_window(p.x) && exact::in_expansion_window(p.y);
}

[[nodiscard]] Sign expand(const Point& a, const Point& b, const Point& c) noexcept {
    const auto ax = exact::difference(a.x, c.x);
    const auto ay = exact::difference(a.y, c.y);
    const auto bx = exact::difference(b.x, c.x);
    const auto by = exact::difference(b.y, c.y);
    return (ax * by - ay * bx).sign();
}

/// Where expansions might over- or underflow. The origin may be any of the three: to exchange two
/// of them is to turn the other way.
[[nodiscard]] Decision decide_beyond_window(const Point& a, const Point& b,
                                            const Point& c) noexcept {
    std::array points = {&a, &b, &c};
    const Sign turn = filters::base_on_least(points);
    const filters::Verdict verdict =
        rounded_ccw<filters::Wide>(*points[0], *points[1], *points[2]).sign();
    if (verdict.is_certain()) return {turn * verdict.sign(), Stage::filter};
    return {multiprecision::ccw(a, b, c), Stage::multiprecision};
}

[[nodiscard]] Decision decide(const Point& a, const Point& b, const Point& c) noexcept {
    if (!in_window(a) || !in_window(b) || !in_window(c)) return decide_beyond_window(a, b, c);
    if (const filters::Verdict verdict = ccw_filter(a, b, c); verdict.is_certain())
        return {verdict.sign(), Stage::filter};
    return {expand(a, b, c), Stage::exact};
}

}  // namespace

Decision ccw_cold(Point a, Point b, Point c) noexcept {
    return exact::in_ieee_environment(decide, a, b, c);
}

}  // namespace predicates
}  // namespace signum
