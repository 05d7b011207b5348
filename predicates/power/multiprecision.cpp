#include "multiprecision.hpp"

#include "../../exact/multiprecision.hpp"
#include "in_circle.hpp"
#include "infinite.hpp"

namespace signum::power::multiprecision {
namespace {

using exact::Rational;
using exact::to_rational;

Rational weight(const Point&) {
    return 0;
}
Rational weight(const Site& s) {
    return to_rational(s.w);
}
Rational weight(const signum::Site& s) {
    const Rational r = to_rational(s.r);
    return r * r;
}

template <PowerSite S>
Row<Rational> rational_row(const S& m, const S& q) {
    return {to_rational(m.x) - to_rational(q.x), to_rational(m.y) - to_rational(q.y),
            weight(m) - weight(q)};
}

template <PowerSite S>
Rational distance(Point p, const S& s) {
    const Rational dx = to_rational(p.x) - to_rational(s.x);
    const Rational dy = to_rational(p.y) - to_rational(s.y);
    return dx * dx + dy * dy - weight(s);
}

}  // namespace

template <PowerSite S>
Sign in_circle(const S& i, const S& j, const S& k, const S& q) noexcept {
    return in_circle_determinant(rational_row(i, q), rational_row(j, q), rational_row(k, q)).sign();
}

template <PowerSite S>
Sign in_segment(const S& a, const S& b, const S& q) noexcept {
    const Row<Rational> row_a = rational_row(a, q);
    const Row<Rational> row_b = rational_row(b, q);
    const bool along_x = row_a.x != row_b.x;
    const Rational& t_a = along_x ? row_a.x : row_a.y;
    const Rational& t_b = along_x ? row_b.x : row_b.y;
    const Sign direction = t_a < t_b ? 1 : -1;
    return direction * in_segment_determinant(row_a, row_b, t_a, t_b).sign();
}

template <PowerSite S>
Sign nearer(Point p, const S& a, const S& b) noexcept {
    return Rational(distance(p, b) - distance(p, a)).sign();
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
