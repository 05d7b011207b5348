#include "truth.hpp"

#include <gmpxx.h>

#include "../../../predicates/euclidean.hpp"
#include "../../../predicates/manhattan.hpp"
#include "../../../predicates/power.hpp"
#include "../../../predicates/supremum.hpp"

namespace truth {
namespace {

template <class S>
mpq_class weight(const S& s) {
    if constexpr (requires { s.w; })
        return s.w;
    else if constexpr (requires { s.r; })
        return mpq_class(s.r) * s.r;
    else
        return 0;
}

/// Relative to q; in the plane z is 0.
struct Row {
    mpq_class x;
    mpq_class y;
    mpq_class z;
    mpq_class height;
};
template <class S>
Row row_of(const S& m, const S& q) {
    const mpq_class x = mpq_class(m.x) - q.x;
    const mpq_class y = mpq_class(m.y) - q.y;
    mpq_class z = 0;
    if constexpr (requires { m.z; }) z = mpq_class(m.z) - q.z;
    return {x, y, z, x * x + y * y + z * z - weight(m) + weight(q)};
}
mpq_class determinant(const Row& a, const Row& b, const Row& c) {
    return a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) +
           a.z * (b.x * c.y - b.y * c.x);
}

/// The same predicates in rationals, of which there is one more for each metric.
template <class Metric>
struct Rational;
template <>
struct Rational<signum::euclidean::Perturbed<>> {
    using Type = signum::euclidean::Perturbed<signum::Arithmetic::multiprecision>;
};
template <>
struct Rational<signum::supremum::Perturbed<>> {
    using Type = signum::supremum::Perturbed<signum::Arithmetic::multiprecision>;
};
template <>
struct Rational<signum::manhattan::Perturbed<>> {
    using Type = signum::manhattan::Perturbed<signum::Arithmetic::multiprecision>;
};

}  // namespace

template <class S>
Sign ccw(const S& a, const S& b, const S& c) {
    const Row of_a = row_of(a, c);
    const Row of_b = row_of(b, c);
    return sgn(mpq_class(of_a.x * of_b.y - of_a.y * of_b.x));
}

template <class S>
Sign ccw(const S& a, const S& b, const S& c, const S& d) {
    return sgn(determinant(row_of(b, a), row_of(c, a), row_of(d, a)));
}

/// Minus the determinant of four rows, by their heights.
template <class S>
Sign in_sphere(const S& i, const S& j, const S& k, const S& l, const S& q) {
    const Row a = row_of(i, q);
    const Row b = row_of(j, q);
    const Row c = row_of(k, q);
    const Row d = row_of(l, q);
    return sgn(mpq_class(a.height * determinant(b, c, d) - b.height * determinant(a, c, d) +
                         c.height * determinant(a, b, d) - d.height * determinant(a, b, c)));
}

template <class S>
Sign in_circle(const S& i, const S& j, const S& k, const S& q) {
    const Row a = row_of(i, q);
    const Row b = row_of(j, q);
    const Row c = row_of(k, q);
    return sgn(mpq_class(a.height * (b.x * c.y - c.x * b.y) + b.height * (c.x * a.y - a.x * c.y) +
                         c.height * (a.x * b.y - b.x * a.y)));
}

template <class S>
Sign in_circle_infinite(const S& a, const S& b, const S& q) {
    const Sign side = ccw(a, b, q);
    if (side != 0) return -side;
    const Row of_a = row_of(a, q);
    const Row of_b = row_of(b, q);
    const bool along_x = a.x != b.x;
    const mpq_class t_a = along_x ? of_a.x : of_a.y;
    const mpq_class t_b = along_x ? of_b.x : of_b.y;
    return sgn(mpq_class(of_a.height * t_b - of_b.height * t_a)) * sgn(mpq_class(t_b - t_a));
}

template <class S>
Sign nearer(const Point& p, const S& a, const S& b) {
    const auto distance = [&p](const S& s) -> mpq_class {
        const mpq_class x = mpq_class(s.x) - p.x;
        const mpq_class y = mpq_class(s.y) - p.y;
        return x * x + y * y - weight(s);
    };
    return sgn(mpq_class(distance(b) - distance(a)));
}

template <class Metric>
bool Additive<Metric>::hides(const Site& i, const Site& q) {
    return Rational<Metric>::Type::hides(i, q, {0, 1}).sign > 0;
}
template <class Metric>
bool Additive<Metric>::nearer(const Point& p, const Site& a, const Site& b) {
    return Rational<Metric>::Type::nearer(p, a, b, {0, 1}).sign > 0;
}
template <class Metric>
bool Additive<Metric>::exists(const Site& i, const Site& j, const Site& k) {
    return Rational<Metric>::Type::exists(i, j, k, {0, 1, 2}).sign > 0;
}
template <class Metric>
bool Additive<Metric>::exists_twice(const Site& i, const Site& j, const Site& k) {
    return Rational<Metric>::Type::exists_twice(i, j, k, {0, 1, 2}).sign > 0;
}
template <class Metric>
bool Additive<Metric>::precedes_on_bisector(const Site& i, const Site& j, const Site& q,
                                            const Site& k) {
    return Rational<Metric>::Type::precedes_on_bisector(i, j, q, k, {0, 1, 2, 3}).sign > 0;
}
template <class Metric>
bool Additive<Metric>::in_circle(const Site& i, const Site& j, const Site& k, const Site& q) {
    return Rational<Metric>::Type::in_circle(i, j, k, q, {0, 1, 2, 3}).sign > 0;
}
template <class Metric>
bool Additive<Metric>::in_circle_infinite(const Site& a, const Site& b, const Site& q) {
    return Rational<Metric>::Type::in_circle_infinite(a, b, q, {0, 1, 2}).sign > 0;
}

template Sign ccw(const Point&, const Point&, const Point&);
template Sign ccw(const Site&, const Site&, const Site&);
template Sign ccw(const signum::power::Site&, const signum::power::Site&,
                  const signum::power::Site&);
template Sign in_circle(const Point&, const Point&, const Point&, const Point&);
template Sign in_circle(const Site&, const Site&, const Site&, const Site&);
template Sign in_circle(const signum::power::Site&, const signum::power::Site&,
                        const signum::power::Site&, const signum::power::Site&);
template Sign in_circle_infinite(const Point&, const Point&, const Point&);
template Sign in_circle_infinite(const Site&, const Site&, const Site&);
template Sign in_circle_infinite(const signum::power::Site&, const signum::power::Site&,
                                 const signum::power::Site&);
template Sign nearer(const Point&, const Point&, const Point&);
template Sign nearer(const Point&, const Site&, const Site&);
template Sign nearer(const Point&, const signum::power::Site&, const signum::power::Site&);
template Sign ccw(const Point3&, const Point3&, const Point3&, const Point3&);
template Sign ccw(const Site3&, const Site3&, const Site3&, const Site3&);
template Sign ccw(const signum::power::Site3&, const signum::power::Site3&,
                  const signum::power::Site3&, const signum::power::Site3&);
template Sign in_sphere(const Point3&, const Point3&, const Point3&, const Point3&, const Point3&);
template Sign in_sphere(const Site3&, const Site3&, const Site3&, const Site3&, const Site3&);
template Sign in_sphere(const signum::power::Site3&, const signum::power::Site3&,
                        const signum::power::Site3&, const signum::power::Site3&,
                        const signum::power::Site3&);
template struct Additive<signum::euclidean::Perturbed<>>;
template struct Additive<signum::supremum::Perturbed<>>;
template struct Additive<signum::manhattan::Perturbed<>>;

}  // namespace truth
