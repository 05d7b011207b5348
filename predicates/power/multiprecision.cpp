#include "multiprecision.hpp"

#include "../../exact/dyadic.hpp"
#include "edge.hpp"
#include "in_circle.hpp"
#include "infinite.hpp"

namespace signum::power::multiprecision {

using Number = exact::Dyadic<>;

template <PowerSite S>
Sign in_circle(const S& i, const S& j, const S& k, const S& q) noexcept {
    return in_circle_determinant(row<Number>(i, q), row<Number>(j, q), row<Number>(k, q)).sign();
}

template <PowerSite S>
Sign in_segment(const S& a, const S& b, const S& q) noexcept {
    const Row<Number> row_a = row<Number>(a, q);
    const Row<Number> row_b = row<Number>(b, q);
    const bool along_x = row_a.x != row_b.x;
    const Number& t_a = along_x ? row_a.x : row_a.y;
    const Number& t_b = along_x ? row_b.x : row_b.y;
    const Sign direction = t_a < t_b ? 1 : -1;
    return direction * in_segment_determinant(row_a, row_b, t_a, t_b).sign();
}

template <PowerSite S>
Sign nearer(Point p, const S& a, const S& b) noexcept {
    return nearer_difference<Number>(p, a, b).sign();
}

template Sign in_circle(const Point&, const Point&, const Point&, const Point&) noexcept;
template Sign in_circle(const Site&, const Site&, const Site&, const Site&) noexcept;
template Sign in_circle(const signum::Site&, const signum::Site&, const signum::Site&,
                        const signum::Site&) noexcept;
template Sign in_segment(const Point&, const Point&, const Point&) noexcept;
template Sign in_segment(const Site&, const Site&, const Site&) noexcept;
template Sign in_segment(const signum::Site&, const signum::Site&, const signum::Site&) noexcept;
template Sign nearer(Point, const Point&, const Point&) noexcept;
template Sign nearer(Point, const Site&, const Site&) noexcept;
template Sign nearer(Point, const signum::Site&, const signum::Site&) noexcept;

}  // namespace signum::power::multiprecision
