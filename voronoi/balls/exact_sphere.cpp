#include "exact_sphere.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace signum::balls {
namespace {

[[nodiscard]] Vector4 vector_of(const Site3& s) {
    return {exact::to_rational(s.x), exact::to_rational(s.y), exact::to_rational(s.z),
            exact::to_rational(s.r)};
}
[[nodiscard]] Vector4 difference(const Vector4& a, const Vector4& b) {
    return along(a, -1, b);
}
/// The others relative to the first.
[[nodiscard]] std::vector<Vector4> rows_of(const std::array<Site3, 4>& balls) {
    const Vector4 first = vector_of(balls[0]);
    std::vector<Vector4> rows;
    for (std::size_t m = 1; m < 4; ++m) rows.push_back(difference(vector_of(balls[m]), first));
    return rows;
}
[[nodiscard]] Rational dot(const Vector4& a, const Vector4& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}
/// The sign of a + b √g - d √h.
[[nodiscard]] Sign sign_of_two_roots(const Rational& a, const Rational& b, const Rational& g,
                                     const Rational& d, const Rational& h) {
    return euclidean::polynomials::sign_of_difference(
        sign_of_surd(a, b, g), d.sign() * h.sign(),
        [&] { return sign_of_surd(a * a + b * b * g - d * d * h, 2 * a * b, g); });
}

/// Three balls relative to the first of them.
struct Curve {
    Vector4 first, b, c;
    Rational p_b, p_c, p_bc;  // <b, b>, <c, c>, <b, c>
    /// (X_b × X_c, 0) or, where this is 0, a row that the others do not span: it varies along the
    /// curve. Of three balls that no sphere touches b and c may depend on one another.
    Vector4 row;
    Sign of_w;

    explicit Curve(const std::array<Site3, 3>& balls)
        : first(vector_of(balls[0])),
          b(difference(vector_of(balls[1]), first)),
          c(difference(vector_of(balls[2]), first)),
          p_b(inner(b, b)),
          p_c(inner(c, c)),
          p_bc(inner(b, c)),
          row{b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0], 0},
          of_w(Rational(p_b * p_c - p_bc * p_bc).sign()) {
        for (std::size_t k = 0; k < 4 && System<4>({b, c, row}).rank() < 3; ++k) {
            row = {};
            row[k] = 1;
        }
    }
};

}  // namespace

Sign ExactSphere::sign(const Surd& number) const {
    return sign_of_surd(number.a, number.b, g_);
}
ExactSphere::Surd ExactSphere::product(const Vector4& row, const Vector4& from) const {
    Vector4 w = middle_;
    for (std::size_t k = 0; k < 3; ++k) w[k] -= from[k];
    w[3] += from[3];
    return {dot(row, w), dot(row, step_)};
}
ExactSphere::Surd ExactSphere::turned(const Vector4& from, const Vector4& b, const Vector4& c,
                                      const Vector4& row) const {
    Vector4 w = difference(middle_, from);
    w[3] = -(middle_[3] + from[3]);
    Vector4 step = step_;
    step[3] = -step[3];
    return {determinant<4>({w, b, c, row}), determinant<4>({step, b, c, row})};
}

std::vector<ExactSphere> ExactSphere::solve(const Vector4& first, const System<4>& system) {
    std::vector<ExactSphere> spheres;
    if (system.rank() < 3) return spheres;
    const auto add = [&](const Vector4& middle, const Vector4& step, const Rational& g,
                         Sign /*side*/) {
        if (sign_of_surd(middle[3], step[3], g) < 0) return;
        ExactSphere& sphere = spheres.emplace_back();
        sphere.middle_ = along(middle, 1, first);
        sphere.middle_[3] = middle[3] - first[3];
        sphere.step_ = step;
        sphere.g_ = g;
    };
    for_points_on_cone(system.solution(), system.directions().front(), 1, add);
    return spheres;
}

std::vector<ExactSphere> ExactSphere::touching(const std::array<Site3, 4>& balls) {
    const std::vector<Vector4> rows = rows_of(balls);
    std::vector<Rational> values;
    for (const Vector4& row : rows) values.push_back(inner(row, row) / 2);
    return solve(vector_of(balls[0]), System<4>(rows, std::move(values)));
}

std::optional<ExactSphere> ExactSphere::on_curve(const std::array<Site3, 3>& balls) {
    const Curve curve(balls);
    Rational value = 0;
    if (curve.of_w < 0) {
        // The middle of the ellipse lies in the span of the (X, -R), and inside the cone.
        const Rational w = curve.p_b * curve.p_c - curve.p_bc * curve.p_bc;
        const Rational of_b = curve.p_c * (curve.p_b - curve.p_bc) / (2 * w);
        const Rational of_c = curve.p_b * (curve.p_c - curve.p_bc) / (2 * w);
        Vector4 middle = along(along({}, of_b, curve.b), of_c, curve.c);
        middle[3] = -middle[3];
        if (inner(middle, middle).sign() >= 0 || middle[3].sign() < 0) return std::nullopt;
        value = dot(curve.row, middle);
    }
    const std::vector<ExactSphere> spheres =
        solve(curve.first,
              System<4>({curve.b, curve.c, curve.row}, {curve.p_b / 2, curve.p_c / 2, value}));
    if (spheres.empty()) return std::nullopt;
    return spheres.front();
}

Sign ExactSphere::conflict(const Site3& q) const {
    const Vector4 ball = vector_of(q);
    // (rho + r)² - |c - c_q|²
    const Vector4 w = [&] {
        Vector4 result = difference(middle_, ball);
        result[3] = middle_[3] + ball[3];
        return result;
    }();
    return -sign({inner(w, w) + inner(step_, step_) * g_, 2 * inner(w, step_)});
}

Sign ExactSphere::turn(const Site3& a, const Site3& b, const Site3& c, const Site3& l) const {
    const Vector4 first = vector_of(a);
    return sign(turned(first, difference(vector_of(b), first), difference(vector_of(c), first),
                       difference(vector_of(l), first)));
}

/// Along a direction d of the plane in which the curve lies, y_l·d is a multiple of <w, d>: both
/// are 0 along the tangent. And along the curve w moves by its tangent and a part e of second order
/// with 2 <w, e> = -<tangent, tangent> < 0.
bool ExactSphere::is_only_one_free_of(const std::array<Site3, 3>& balls, const Site3& l) const {
    const Curve curve(balls);
    const Vector4 row = difference(vector_of(l), curve.first);
    for (Vector4 d : System<4>({curve.b, curve.c}).directions()) {
        const Sign of_row = dot(row, d).sign();
        d[3] = -d[3];
        const Sign of_w = sign(product(d, curve.first));
        if (of_w != 0) return of_row * of_w < 0;
    }
    return false;
}

bool touch_along_a_curve(const std::array<Site3, 4>& balls) {
    return System<4>(rows_of(balls)).rank() < 3;
}

bool is_loop(const std::array<Site3, 3>& curve) {
    return Curve(curve).of_w < 0;
}

/// By the values of the row of Curve: rising where it grows forward, then falling; at most two
/// spheres, those of an ellipse's least and greatest value, lie between.
std::vector<std::size_t> forward_order(const std::array<Site3, 3>& balls,
                                       std::span<const ExactSphere> spheres) {
    const Curve curve(balls);
    std::vector<ExactSphere::Surd> values;
    std::vector<Sign> growth;
    for (const ExactSphere& sphere : spheres) {
        values.push_back(sphere.product(curve.row, curve.first));
        growth.push_back(sphere.sign(sphere.turned(curve.first, curve.b, curve.c, curve.row)));
    }
    const auto compare = [&](std::size_t i, std::size_t j) -> Sign {
        return sign_of_two_roots(values[i].a - values[j].a, values[i].b, spheres[i].g_, values[j].b,
                                 spheres[j].g_);
    };
    std::vector<std::size_t> order(spheres.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::vector<int> part(spheres.size());  // the least, rising, the greatest, falling
    for (const std::size_t i : order) {
        part[i] = growth[i] > 0 ? 1 : 3;
        if (growth[i] == 0)
            part[i] = std::all_of(order.begin(), order.end(),
                                  [&](std::size_t j) { return compare(i, j) <= 0; })
                          ? 0
                          : 2;
    }
    std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
        if (part[i] != part[j]) return part[i] < part[j];
        return part[i] == 1 ? compare(i, j) < 0 : part[i] == 3 && compare(i, j) > 0;
    });
    return order;
}

}  // namespace signum::balls
