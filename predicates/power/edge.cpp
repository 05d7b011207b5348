#include "edge.hpp"

#include "../../exact/floating_environment.hpp"
#include "../../filters/wide.hpp"
#include "compared.hpp"
#include "exact_rows.hpp"
#include "multiprecision.hpp"

namespace signum::power {
namespace {

using filters::magnitude;

template <PowerSite S>
[[nodiscard]] Sign expand(const Point& p, const S& a, const S& b) noexcept {
    const auto square = [&p](const S& s) {
        return exact::square(exact::difference(p.x, s.x)) +
               exact::square(exact::difference(p.y, s.y));
    };
    return (square(b) - square(a) + cold::expansion_weight(a, b)).sign();
}

/// Where expansions might over- or underflow.
template <PowerSite S>
[[nodiscard]] Decision decide_beyond_window(const Point& p, const S& a, const S& b) noexcept {
    const auto verdict = nearer_difference<filters::Wide>(p, a, b).sign();
    if (verdict.is_certain()) return {verdict.sign(), Stage::filter};
    return {multiprecision::nearer(p, a, b), Stage::multiprecision};
}

template <PowerSite S>
[[nodiscard]] Decision decide(const Point& p, const S& a, const S& b) noexcept {
    if (!cold::in_window(p, a, b)) return decide_beyond_window(p, a, b);
    const auto [difference, bound] = compared_nearer<double>(p, a, b);
    if (magnitude(difference) > bound) return {filters::sign_of_nonzero(difference), Stage::filter};
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
