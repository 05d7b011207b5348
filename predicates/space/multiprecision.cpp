#include "multiprecision.hpp"

#include "../exact_number.hpp"
#include "in_sphere.hpp"

namespace signum {
namespace {

using predicates::exactly;
using predicates::ExactNumber;

template <Arithmetic arithmetic, class S>
predicates::Offset3<ExactNumber<arithmetic>> exact_offset(const S& to, const S& from) {
    return {exactly<arithmetic>(to.x) - exactly<arithmetic>(from.x),
            exactly<arithmetic>(to.y) - exactly<arithmetic>(from.y),
            exactly<arithmetic>(to.z) - exactly<arithmetic>(from.z)};
}

template <Arithmetic arithmetic>
ExactNumber<arithmetic> weight(const Point3&) {
    return {};
}
template <Arithmetic arithmetic>
ExactNumber<arithmetic> weight(const power::Site3& s) {
    return exactly<arithmetic>(s.w);
}
template <Arithmetic arithmetic>
ExactNumber<arithmetic> weight(const Site3& s) {
    const auto r = exactly<arithmetic>(s.r);
    return r * r;
}

}  // namespace

namespace multiprecision {

template <Arithmetic arithmetic>
Sign ccw(const Point3& a, const Point3& b, const Point3& c, const Point3& d) noexcept {
    return predicates::ccw_determinant(exact_offset<arithmetic>(b, a),
                                       exact_offset<arithmetic>(c, a),
                                       exact_offset<arithmetic>(d, a))
        .sign();
}

template Sign ccw<Arithmetic::multiprecision>(const Point3&, const Point3&, const Point3&,
                                              const Point3&) noexcept;
template Sign ccw<predicates::judging>(const Point3&, const Point3&, const Point3&,
                                       const Point3&) noexcept;

}  // namespace multiprecision

namespace power::multiprecision {

template <Arithmetic arithmetic, class S>
Sign in_sphere(const S& i, const S& j, const S& k, const S& l, const S& q) noexcept {
    const auto row = [&](const S& m) -> LiftedRow<ExactNumber<arithmetic>> {
        return {exact_offset<arithmetic>(m, q), weight<arithmetic>(m) - weight<arithmetic>(q)};
    };
    return in_sphere_determinant(row(i), row(j), row(k), row(l)).sign();
}

template <Arithmetic arithmetic, class S>
Sign nearer(const Point3& p, const S& a, const S& b) noexcept {
    const auto distance = [&](const S& s) -> ExactNumber<arithmetic> {
        const auto [x, y, z] = exact_offset<arithmetic>(p, centre3(s));
        return x * x + y * y + z * z - weight<arithmetic>(s);
    };
    return (distance(b) - distance(a)).sign();
}

#define SIGNUM_INSTANTIATE(arithmetic, S)                                       \
    template Sign in_sphere<arithmetic>(const S&, const S&, const S&, const S&, \
                                        const S&) noexcept;                     \
    template Sign nearer<arithmetic>(const Point3&, const S&, const S&) noexcept;
SIGNUM_INSTANTIATE(Arithmetic::multiprecision, Point3)
SIGNUM_INSTANTIATE(Arithmetic::multiprecision, Site3)
SIGNUM_INSTANTIATE(Arithmetic::multiprecision, signum::Site3)
SIGNUM_INSTANTIATE(predicates::judging, Point3)
SIGNUM_INSTANTIATE(predicates::judging, Site3)
SIGNUM_INSTANTIATE(predicates::judging, signum::Site3)
#undef SIGNUM_INSTANTIATE

}  // namespace power::multiprecision
}  // namespace signum
