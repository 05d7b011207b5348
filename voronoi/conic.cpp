#include "conic.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include <boost/math/quadrature/gauss_kronrod.hpp>

#include "../exact/floating_environment.hpp"
#include "in_ieee.hpp"
#include "vector.hpp"

namespace signum {
namespace {

constexpr int most_halvings = 16;

Point middle_of(Point a, Point b) noexcept {
    return {a.x + (b.x - a.x) / 2, a.y + (b.y - a.y) / 2};
}
/// a + share (b - a).
Point between(Point a, Point b, double share) noexcept {
    return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
}

/// Of the two lines from the origin to the ends of the arc the chord cuts off a triangle; between
/// chord and arc lies a segment of a hyperbola. With the weight cosh h, and T the triangle of the
/// three control points, its area is T times
///
///     (sinh h cosh h - h) cosh h / sinh³h,
///
/// and its centroid lies on the line from the middle of the chord to the control point, at
///
///     cosh h ((sinh h cosh h - h) cosh h - 2/3 sinh³h) / ((sinh h cosh h - h) sinh²h)
///
/// of the way: in the affine coordinates in which the hyperbola is x² - y² = 1 the chord is x =
/// cosh h, the control point (1/cosh h, 0), and the integrals are elementary. Where h is small the
/// formulas cancel, and their series stand in.
struct Segment {
    double area;
    double centroid;
};
Segment segment_of_hyperbola(double weight) noexcept {
    const double h = std::acosh(weight);
    if (h < 0.25) {
        const double s = h * h;
        return {2.0 / 3 + s * (2.0 / 15 + s * (-2.0 / 63 + s * (4.0 / 675 - s * (2.0 / 2079)))),
                0.2 + s * (8.0 / 175 + s * (-8.0 / 875 + s * (4304.0 / 3031875)))};
    }
    const double sinh = std::sinh(h);
    const double cosh = weight;
    const double n = sinh * cosh - h;
    const double cube = sinh * sinh * sinh;
    return {n * cosh / cube, cosh * (n * cosh - 2.0 / 3 * cube) / (n * sinh * sinh)};
}

/// Appends the roots of (1-s)² b0 + 2s(1-s) b1 + s² b2 strictly between 0 and 1.
void roots(double b0, double b1, double b2, std::vector<double>& found) {
    // With t = s / (1-s) it is b0 + 2 b1 t + b2 t²; of the two roots one is the quotient without
    // cancellation, and the other follows from their product.
    const double size = std::max({std::abs(b0), std::abs(b1), std::abs(b2)});
    if (!(size > 0)) return;
    b0 /= size;
    b1 /= size;
    b2 /= size;
    const double discriminant = b1 * b1 - b0 * b2;
    // Where curve and line all but touch, the place is wanted, too: nobody is to look there whether
    // the curve is inside.
    if (!(discriminant >= -1e-12 * b1 * b1)) return;
    const double sum = -(b1 + std::copysign(std::sqrt(std::max(discriminant, 0.0)), b1));
    const auto add = [&](double numerator, double denominator) {  // t is their quotient
        const double whole = numerator + denominator;
        if ((numerator > 0) != (denominator > 0) || whole == 0) return;
        const double s = numerator / whole;
        if (0 < s && s < 1) found.push_back(s);
    };
    add(sum, b2);
    add(b0, sum);
}

Point point_at(const Conic& conic, double s) noexcept {
    const auto& [from, control, to, weight] = conic;
    if (s == 0) return from;
    if (s == 1) return to;
    if (conic.is_straight()) return between(from, to, s);
    const double u = 1 - s;
    const double at_control = 2 * u * s * weight;
    const double whole = u * u + at_control + s * s;
    // Relative to the control point, to which the others are weighed.
    return {control.x + (u * u * (from.x - control.x) + s * s * (to.x - control.x)) / whole,
            control.y + (u * u * (from.y - control.y) + s * s * (to.y - control.y)) / whole};
}

std::pair<Conic, Conic> halves_of(const Conic& conic) noexcept {
    const auto& [from, control, to, weight] = conic;
    if (conic.is_straight()) {
        const Point middle = middle_of(from, to);
        return {in_ieee::straight(from, middle), in_ieee::straight(middle, to)};
    }
    const Point middle = point_at(conic, 0.5);
    const double share = weight / (1 + weight);
    const double half_weight = std::sqrt((1 + weight) / 2);
    return {{from, between(from, control, share), middle, half_weight},
            {middle, between(to, control, share), to, half_weight}};
}

double bulge_of(const Conic& conic) noexcept {
    const auto& [from, control, to, weight] = conic;
    if (conic.is_straight()) return 0;
    const Point chord = minus(to, from);
    const Point off = minus(point_at(conic, 0.5), from);
    const double length = std::hypot(chord.x, chord.y);
    // Divided first: the product of two lengths may be beyond doubles.
    return length > 0 ? std::abs(cross({chord.x / length, chord.y / length}, off))
                      : std::hypot(off.x, off.y);
}

double off_parabola(const Conic& conic) noexcept {
    const auto& [from, control, to, weight] = conic;
    if (conic.is_straight()) return 0;
    // In coordinates in which the chord runs from (-1, 0) to (1, 0) and the control point is (0,
    // 1), the curve is v² = w² ((1-v)² - u²), the parabola the same with w = 1. At a fixed u
    //     dv/dw = v²/w / (v + w² (1-v)),
    // which rises with v: it is greatest at u = 0, for every w, and so is the difference of both
    // curves, w / (1 + w) - 1/2.
    const Point middle = middle_of(from, to);
    return std::hypot(control.x - middle.x, control.y - middle.y) * (weight - 1) /
           (2 * (weight + 1));
}

}  // namespace

Conic in_ieee::part(const Conic& conic, double first, double last) noexcept {
    if (first == 0 && last == 1) return conic;
    const auto& [from, control, to, w] = conic;
    const double weight = w;  // a binding is captured by no lambda of clang++-14
    const Point start = point_at(conic, first);
    const Point end = point_at(conic, last);
    if (conic.is_straight()) return in_ieee::straight(start, end);
    const auto weight_at = [&](double s, double t) {
        return (1 - s) * (1 - t) + weight * ((1 - s) * t + s * (1 - t)) + s * t;
    };
    const double middle = weight_at(first, last);
    // The blossom, relative to the control point.
    const double of_from = (1 - first) * (1 - last);
    const double of_to = first * last;
    const Point blossom = {(of_from * (from.x - control.x) + of_to * (to.x - control.x)) / middle,
                           (of_from * (from.y - control.y) + of_to * (to.y - control.y)) / middle};
    const double standard = middle / std::sqrt(weight_at(first, first) * weight_at(last, last));
    if (!(standard > 1)) return in_ieee::straight(start, end);
    return {start, {control.x + blossom.x, control.y + blossom.y}, end, standard};
}

Conic::Moments in_ieee::moments(const Conic& conic, Point origin) noexcept {
    const auto& [from, control, to, weight] = conic;
    const Point a = minus(from, origin);
    const Point b = minus(to, origin);
    const double triangle = cross(a, b) / 2;
    Conic::Moments result = {triangle, triangle * (a.x + b.x) / 3, triangle * (a.y + b.y) / 3};
    if (conic.is_straight()) return result;
    const Segment segment = segment_of_hyperbola(weight);
    const Point c = minus(control, origin);
    const double area = segment.area * cross(minus(control, from), minus(to, from)) / 2;
    const Point centroid = between(middle_of(a, b), c, segment.centroid);
    result.area += area;
    result.x += area * centroid.x;
    result.y += area * centroid.y;
    return result;
}

double in_ieee::length(const Conic& conic) {
    const auto& [from, control, to, w] = conic;
    const double weight = w;
    const double chord = std::hypot(to.x - from.x, to.y - from.y);
    if (conic.is_straight()) return chord;
    const Point j = minus(control, from);
    const Point k = minus(to, control);
    const Point c = minus(to, from);
    const auto speed = [&](double s) {
        // The derivative, twice 2 (u² w j + us c + s² w k) / (u² + 2us w + s²)².
        const double u = 1 - s;
        const double whole = u * u + 2 * u * s * weight + s * s;
        const double x = weight * (u * u * j.x + s * s * k.x) + u * s * c.x;
        const double y = weight * (u * u * j.y + s * s * k.y) + u * s * c.y;
        return 2 * std::hypot(x, y) / (whole * whole);
    };
    return boost::math::quadrature::gauss_kronrod<double, 15>::integrate(speed, 0.0, 1.0, 15,
                                                                         1e-10);
}

Conic Conic::straight(Point from, Point to) noexcept {
    return exact::in_ieee_environment(in_ieee::straight, from, to);
}
Point Conic::at(double s) const noexcept {
    return exact::in_ieee_environment(point_at, *this, s);
}
Conic Conic::part(double first, double last) const noexcept {
    return exact::in_ieee_environment(in_ieee::part, *this, first, last);
}
std::pair<Conic, Conic> Conic::halves() const noexcept {
    return exact::in_ieee_environment(halves_of, *this);
}
double Conic::bulge() const noexcept {
    return exact::in_ieee_environment(bulge_of, *this);
}
double Conic::distance_from_parabola() const noexcept {
    return exact::in_ieee_environment(off_parabola, *this);
}
Conic::Moments Conic::moments(Point origin) const noexcept {
    return exact::in_ieee_environment(in_ieee::moments, *this, origin);
}
double Conic::length() const {
    const exact::IeeeEnvironment environment;
    return in_ieee::length(*this);
}

std::vector<Inside> in_ieee::parts_inside(const Conic& conic, const Box& box) {
    const auto [low_x, high_x] = std::minmax({conic.from.x, conic.control.x, conic.to.x});
    const auto [low_y, high_y] = std::minmax({conic.from.y, conic.control.y, conic.to.y});
    // The curve lies in the triangle of its control points.
    if (low_x > box.x0 && high_x < box.x1 && low_y > box.y0 && high_y < box.y1) return {{0, 1}};
    if (high_x <= box.x0 || low_x >= box.x1 || high_y <= box.y0 || low_y >= box.y1) return {};

    std::vector<double> cuts = {0, 1};
    const auto cut = [&](double from, double control, double to) {
        if (conic.is_straight()) {
            const double s = from / (from - to);
            if (0 < s && s < 1) cuts.push_back(s);
        } else {
            roots(from, conic.weight * control, to, cuts);
        }
    };
    for (const double x : {box.x0, box.x1})
        cut(conic.from.x - x, conic.control.x - x, conic.to.x - x);
    for (const double y : {box.y0, box.y1})
        cut(conic.from.y - y, conic.control.y - y, conic.to.y - y);
    std::ranges::sort(cuts);

    std::vector<Inside> parts;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        const Point p = point_at(conic, cuts[i] + (cuts[i + 1] - cuts[i]) / 2);
        if (cuts[i] == cuts[i + 1] ||
            !(box.x0 < p.x && p.x < box.x1 && box.y0 < p.y && p.y < box.y1))
            continue;
        if (!parts.empty() && parts.back().last == cuts[i])
            parts.back().last = cuts[i + 1];
        else
            parts.push_back({cuts[i], cuts[i + 1]});
    }
    return parts;
}

std::vector<Inside> parts_inside(const Conic& conic, const Box& box) {
    const exact::IeeeEnvironment environment;
    return in_ieee::parts_inside(conic, box);
}

namespace {

template <typename IsFine, typename Take>
void split(const Conic& conic, int halvings, const IsFine& is_fine, const Take& take) {
    if (halvings == 0 || is_fine(conic)) {
        take(conic);
        return;
    }
    const auto [first, second] = halves_of(conic);
    split(first, halvings - 1, is_fine, take);
    split(second, halvings - 1, is_fine, take);
}

void require_positive(double tolerance) {
    if (!(tolerance > 0)) throw std::invalid_argument("a tolerance is positive");
}

}  // namespace

void sample(const Conic& conic, double tolerance, std::vector<Point>& points) {
    const exact::IeeeEnvironment environment;
    require_positive(tolerance);
    split(
        conic, most_halvings, [&](const Conic& part) { return bulge_of(part) <= tolerance; },
        [&](const Conic& part) { points.push_back(part.to); });
}

std::vector<Conic> parabolas(const Conic& conic, double tolerance) {
    const exact::IeeeEnvironment environment;
    require_positive(tolerance);
    std::vector<Conic> parts;
    split(
        conic, most_halvings, [&](const Conic& part) { return off_parabola(part) <= tolerance; },
        [&](const Conic& part) { parts.push_back(part); });
    return parts;
}

}  // namespace signum
