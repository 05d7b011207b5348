#include "ccw.hpp"

#include <array>

#include "../../exact/expansion.hpp"
#include "../../exact/floating_environment.hpp"
#include "../../filters/wide.hpp"
#include "multiprecision.hpp"

namespace signum::predicates {
namespace {

[[nodiscard]] bool in_window(const Point3& p) noexcept {
    return exact::in_expansion_window(p.x) && exact::in_expansion_window(p.y) &&
           exact::in_expansion_window(p.z);
}

struct ExpansionOffset {
    exact::Expansion<2> x;
    exact::Expansion<2> y;
    exact::Expansion<2> z;

    ExpansionOffset(const Point3& to, const Point3& from) noexcept
        : x(exact::difference(to.x, from.x)),
          y(exact::difference(to.y, from.y)),
          z(exact::difference(to.z, from.z)) {}
};

[[nodiscard]] Sign expand(const Point3& a, const Point3& b, const Point3& c,
                          const Point3& d) noexcept {
    const ExpansionOffset u(b, a);
    const ExpansionOffset v(c, a);
    const ExpansionOffset w(d, a);
    return (u.x * (v.y * w.z - v.z * w.y) + u.y * (v.z * w.x - v.x * w.z) +
            u.z * (v.x * w.y - v.y * w.x))
        .sign();
}

/// The filter again, with the magnitude itself for a bound. Inside the window nothing overflows,
/// and what underflows is 0.
[[nodiscard]] filters::Verdict filter(const Offset3<double>& u, const Offset3<double>& v,
                                      const Offset3<double>& w) noexcept {
    const auto absolute = [](const Offset3<double>& offset) {
        return Offset3<double>{filters::magnitude(offset.x), filters::magnitude(offset.y),
                               filters::magnitude(offset.z)};
    };
    const double determinant = ccw_determinant(u, v, w);
    const Offset3<double> a = absolute(u);
    const Offset3<double> b = absolute(v);
    const Offset3<double> c = absolute(w);
    const double magnitude = a.x * (b.y * c.z + b.z * c.y) + a.y * (b.z * c.x + b.x * c.z) +
                             a.z * (b.x * c.y + b.y * c.x);
    if (filters::magnitude(determinant) > 9 * filters::epsilon * magnitude)
        return filters::Verdict::certain(filters::sign_of_nonzero(determinant));
    return filters::Verdict::uncertain();
}

/// Where expansions might over- or underflow. The origin may be any of the four: to exchange two
/// of them is to turn the other way.
[[nodiscard]] Decision decide_beyond_window(const Point3& a, const Point3& b, const Point3& c,
                                            const Point3& d) noexcept {
    // It is -det(a-d, b-d, c-d), and the origin is at the end.
    std::array points = {&a, &b, &c, &d};
    const Sign turn = -filters::base_on_least(points);
    const auto seen = [&](std::size_t k) { return offset<filters::Wide>(*points[k], *points[3]); };
    const filters::Verdict verdict = ccw_determinant(seen(0), seen(1), seen(2)).sign();
    if (verdict.is_certain()) return {turn * verdict.sign(), Stage::filter};
    return {multiprecision::ccw(a, b, c, d), Stage::multiprecision};
}

[[nodiscard]] Decision decide(const Point3& a, const Point3& b, const Point3& c,
                              const Point3& d) noexcept {
    if (!in_window(a) || !in_window(b) || !in_window(c) || !in_window(d))
        return decide_beyond_window(a, b, c, d);
    if (const filters::Verdict verdict = filter(offset(b, a), offset(c, a), offset(d, a));
        verdict.is_certain())
        return {verdict.sign(), Stage::filter};
    return {expand(a, b, c, d), Stage::exact};
}

}  // namespace

Decision ccw_cold(const Point3& a, const Point3& b, const Point3& c, const Point3& d) noexcept {
    return exact::in_ieee_environment(decide, a, b, c, d);
}

}  // namespace signum::predicates
