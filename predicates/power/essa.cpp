#include "essa.hpp"

#include "../../exact/floating_environment.hpp"
#include "../../exact/sum.hpp"
#include "edge.hpp"
#include "exact_rows.hpp"
#include "in_circle.hpp"
#include "infinite.hpp"
#include "multiprecision.hpp"

namespace signum::power::essa {
namespace {

using exact::Sum;

template <PowerSite S>
Decision decide_in_circle(const S& i, const S& j, const S& k, const S& q) noexcept {
    if (!cold::in_window(i, j, k, q))
        return {multiprecision::in_circle(i, j, k, q), Stage::multiprecision};
    return {in_circle_determinant(row<Sum>(i, q), row<Sum>(j, q), row<Sum>(k, q)).sign(),
            Stage::essa};
}

template <PowerSite S>
Decision decide_in_segment(const S& a, const S& b, const S& q) noexcept {
    if (!cold::in_window(a, b, q))
        return {multiprecision::in_segment(a, b, q), Stage::multiprecision};
    const bool along_x = a.x != b.x;
    const Sign direction = (along_x ? a.x < b.x : a.y < b.y) ? 1 : -1;
    const Row<Sum> row_a = row<Sum>(a, q);
    const Row<Sum> row_b = row<Sum>(b, q);
    return {direction * in_segment_determinant(row_a, row_b, along_x ? row_a.x : row_a.y,
                                               along_x ? row_b.x : row_b.y)
                            .sign(),
            Stage::essa};
}

template <PowerSite S>
Decision decide_nearer(const Point& p, const S& a, const S& b) noexcept {
    if (!cold::in_window(p, a, b)) return {multiprecision::nearer(p, a, b), Stage::multiprecision};
    return {nearer_difference<Sum>(p, a, b).sign(), Stage::essa};
}

}  // namespace

template <PowerSite S>
Decision in_circle(const S& i, const S& j, const S& k, const S& q) noexcept {
    return exact::in_ieee_environment(decide_in_circle<S>, i, j, k, q);
}
template <PowerSite S>
Decision in_segment(const S& a, const S& b, const S& q) noexcept {
    return exact::in_ieee_environment(decide_in_segment<S>, a, b, q);
}
template <PowerSite S>
Decision nearer(Point p, const S& a, const S& b) noexcept {
    return exact::in_ieee_environment(decide_nearer<S>, p, a, b);
}

template Decision in_circle(const Point&, const Point&, const Point&, const Point&) noexcept;
template Decision in_circle(const Site&, const Site&, const Site&, const Site&) noexcept;
template Decision in_circle(const signum::Site&, const signum::Site&, const signum::Site&,
                            const signum::Site&) noexcept;
template Decision in_segment(const Point&, const Point&, const Point&) noexcept;
template Decision in_segment(const Site&, const Site&, const Site&) noexcept;
template Decision in_segment(const signum::Site&, const signum::Site&,
                             const signum::Site&) noexcept;
template Decision nearer(Point, const Point&, const Point&) noexcept;
template Decision nearer(Point, const Site&, const Site&) noexcept;
template Decision nearer(Point, const signum::Site&, const signum::Site&) noexcept;

}  // namespace signum::power::essa
