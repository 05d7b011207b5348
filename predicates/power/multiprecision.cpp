#include "multiprecision.hpp"

#include "../exact_number.hpp"
#include "in_circle.hpp"
#include "infinite.hpp"

namespace signum::power::multiprecision {
namespace {

using predicates::exactly;
using predicates::ExactNumber;

template <Arithmetic arithmetic>
ExactNumber<arithmetic> weight(const Point&) {
    return {};
}
template <Arithmetic arithmetic>
ExactNumber<arithmetic> weight(const Site& s) {
    return exactly<arithmetic>(s.w);
}
template <Arithmetic arithmetic>
ExactNumber<arithmetic> weight(const signum::Site& s) {
    const auto r = exactly<arithmetic>(s.r);
    return r * r;
}

template <Arithmetic arithmetic, PowerSite S>
Row<ExactNumber<arithmetic>> exact_row(const S& m, const S& q) {
    return {exactly<arithmetic>(m.x) - exactly<arithmetic>(q.x),
            exactly<arithmetic>(m.y) - exactly<arithmetic>(q.y),
            weight<arithmetic>(m) - weight<arithmetic>(q)};
}

template <Arithmetic arithmetic, PowerSite S>
ExactNumber<arithmetic> distance(Point p, const S& s) {
    const auto dx = exactly<arithmetic>(p.x) - exactly<arithmetic>(s.x);
    const auto dy = exactly<arithmetic>(p.y) - exactly<arithmetic>(s.y);
    return dx * dx + dy * dy - weight<arithmetic>(s);
}

}  // namespace

template <Arithmetic arithmetic, PowerSite S>
Sign in_circle(const S& i, const S& j, const S& k, const S& q) noexcept {
    return in_circle_determinant(exact_row<arithmetic>(i, q), exact_row<arithmetic>(j, q),
                                 exact_row<arithmetic>(k, q))
        .sign();
}

template <Arithmetic arithmetic, PowerSite S>
Sign in_segment(const S& a, const S& b, const S& q) noexcept {
    const auto row_a = exact_row<arithmetic>(a, q);
    const auto row_b = exact_row<arithmetic>(b, q);
    const bool along_x = row_a.x != row_b.x;
    const auto& t_a = along_x ? row_a.x : row_a.y;
    const auto& t_b = along_x ? row_b.x : row_b.y;
    const Sign direction = t_a < t_b ? 1 : -1;
    return direction * in_segment_determinant(row_a, row_b, t_a, t_b).sign();
}

template <Arithmetic arithmetic, PowerSite S>
Sign nearer(Point p, const S& a, const S& b) noexcept {
    return (distance<arithmetic>(p, b) - distance<arithmetic>(p, a)).sign();
}

#define SIGNUM_INSTANTIATE(arithmetic, S)                                                 \
    template Sign in_circle<arithmetic>(const S&, const S&, const S&, const S&) noexcept; \
    template Sign in_segment<arithmetic>(const S&, const S&, const S&) noexcept;          \
    template Sign nearer<arithmetic>(Point, const S&, const S&) noexcept;
SIGNUM_INSTANTIATE(Arithmetic::multiprecision, Point)
SIGNUM_INSTANTIATE(Arithmetic::multiprecision, Site)
SIGNUM_INSTANTIATE(Arithmetic::multiprecision, signum::Site)
SIGNUM_INSTANTIATE(predicates::judging, Point)
SIGNUM_INSTANTIATE(predicates::judging, Site)
SIGNUM_INSTANTIATE(predicates::judging, signum::Site)
#undef SIGNUM_INSTANTIATE

}  // namespace signum::power::multiprecision
