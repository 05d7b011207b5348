#include "curve.hpp"

#include <algorithm>
#include <cmath>

#include "../exact/floating_environment.hpp"
#include "in_ieee.hpp"
#include "of_metric.hpp"
#include "vector.hpp"

namespace signum {
namespace {

/// Half the range of the parameter of an arc: its weight is at most cosh 3, about 10.
constexpr double widest_arc = 3.0;

void append(const HyperbolaCurve& curve, double from, Point start, double to, Point end,
            std::vector<Conic>& pieces) {
    if (from < 0 && 0 < to) {
        // From where it turns on, a chord leaves both centres on their sides, as the tangents do:
        // the line through the points at s and t meets the axis a cosh((s-t)/2) / cosh((s+t)/2)
        // from the middle, no farther than a. So polygons through points of a cell's border are
        // star-shaped around its centre, as the cell is.
        append(curve, from, start, 0, in_ieee::at(curve, 0), pieces);
        append(curve, 0, in_ieee::at(curve, 0), to, end, pieces);
        return;
    }
    const double range = to - from;
    const int count = std::max(1, static_cast<int>(std::ceil(range / (2 * widest_arc))));
    for (int i = 0; i < count; ++i) {
        const double first = from + range * i / count;
        const double last = i + 1 < count ? from + range * (i + 1) / count : to;
        const Point next = i + 1 < count ? in_ieee::at(curve, last) : end;
        const double weight = std::cosh((last - first) / 2);
        // Where the tangents meet: on the line from the middle of the hyperbola to the middle of
        // the arc.
        const double middle = first + (last - first) / 2;
        const Point control =
            plus(plus(curve.middle, curve.forward, curve.a * std::cosh(middle) / weight),
                 curve.upward, curve.b * std::sinh(middle) / weight);
        pieces.push_back(weight > 1 ? Conic{start, control, next, weight}
                                    : in_ieee::straight(start, next));
        start = next;
    }
}

void append(const StraightCurve& curve, double from, Point start, double to, Point end,
            std::vector<Conic>& pieces) {
    const auto line_to = [&](Point next) {
        if (start != next) pieces.push_back(in_ieee::straight(start, next));
        start = next;
    };
    if (curve.slopes[0] != 0 || curve.slopes[1] != 0)
        for (const double knot : curve.knots)
            if (from < knot && knot < to) line_to(in_ieee::at(curve, knot));
    line_to(end);
}

}  // namespace

Point in_ieee::at(const StraightCurve& curve, double t) noexcept {
    double aside = curve.shift;
    if (t < curve.knots[0]) aside += curve.slopes[0] * (curve.knots[0] - t);
    if (t > curve.knots[1]) aside += curve.slopes[1] * (t - curve.knots[1]);
    const double square = dot(curve.upward, curve.upward);
    return plus(plus(curve.origin, curve.right, aside / square), curve.upward, t / square);
}

double in_ieee::parameter(const StraightCurve& curve, Point p) noexcept {
    return dot(curve.upward, minus(p, curve.origin));
}

double in_ieee::beyond(const StraightCurve& curve, double reach) noexcept {
    // A direction is at most √2 long. Beyond the knots a unit of t leads as far aside as they
    // slope.
    return 2 * reach /
           std::max(1.0, std::min(std::abs(curve.slopes[0]), std::abs(curve.slopes[1])));
}

Point in_ieee::at(const HyperbolaCurve& curve, double t) noexcept {
    return plus(plus(curve.middle, curve.forward, curve.a * std::cosh(t)), curve.upward,
                curve.b * std::sinh(t));
}

double in_ieee::parameter(const HyperbolaCurve& curve, Point p) noexcept {
    const Point from_middle = minus(p, curve.middle);
    const double cosh = dot(from_middle, curve.forward) / curve.a;
    const double sinh = dot(from_middle, curve.upward) / curve.b;
    // The coordinate that changes faster tells the parameter better.
    // The product of the roots is finite where that of their squares is not.
    const bool by_cosh =
        std::isfinite(cosh) && cosh > 1 &&
        std::abs(curve.a) * std::sqrt(cosh - 1) * std::sqrt(cosh + 1) > curve.b * cosh;
    return by_cosh ? std::copysign(std::acosh(cosh), sinh) : std::asinh(sinh);
}

double in_ieee::beyond(const HyperbolaCurve& curve, double reach) noexcept {
    return std::asinh(reach / std::hypot(curve.a, curve.b));
}

namespace {

// In in_ieee the functions have two curves each.
constexpr auto point_at_parameter = [](const auto& curve, double t) {
    return in_ieee::at(curve, t);
};
constexpr auto parameter_of_point = [](const auto& curve, Point p) {
    return in_ieee::parameter(curve, p);
};
constexpr auto parameter_beyond = [](const auto& curve, double t) {
    return in_ieee::beyond(curve, t);
};

}  // namespace

Point StraightCurve::at(double t) const noexcept {
    return exact::in_ieee_environment(point_at_parameter, *this, t);
}
double StraightCurve::parameter(Point p) const noexcept {
    return exact::in_ieee_environment(parameter_of_point, *this, p);
}
double StraightCurve::beyond(double reach) const noexcept {
    return exact::in_ieee_environment(parameter_beyond, *this, reach);
}
Point HyperbolaCurve::at(double t) const noexcept {
    return exact::in_ieee_environment(point_at_parameter, *this, t);
}
double HyperbolaCurve::parameter(Point p) const noexcept {
    return exact::in_ieee_environment(parameter_of_point, *this, p);
}
double HyperbolaCurve::beyond(double reach) const noexcept {
    return exact::in_ieee_environment(parameter_beyond, *this, reach);
}

std::optional<Curve> in_ieee::bisector(Metric metric, WeightIs weight_is, const NumberedSite& a,
                                       const NumberedSite& b, int exponent, Point focus) {
    const auto divided = [exponent](const Site& s) -> Site {
        return {std::ldexp(s.x, -exponent), std::ldexp(s.y, -exponent), std::ldexp(s.r, -exponent)};
    };
    const PairOfSites pair = {a, b, divided(a.site), divided(b.site), weight_is, exponent, focus};
    return with_metric(metric, [&]<class M>(M) { return bisector_in<M>(pair); });
}
std::optional<Curve> bisector(Metric metric, WeightIs weight_is, const NumberedSite& a,
                              const NumberedSite& b, int exponent, Point focus) {
    const exact::IeeeEnvironment environment;
    return in_ieee::bisector(metric, weight_is, a, b, exponent, focus);
}

std::vector<Conic> in_ieee::stretch(const Curve& curve, double from, Point start, double to,
                                    Point end) {
    std::vector<Conic> pieces;
    if (from < to)
        std::visit([&](const auto& of) { append(of, from, start, to, end, pieces); }, curve);
    return pieces;
}
std::vector<Conic> stretch(const Curve& curve, double from, Point start, double to, Point end) {
    const exact::IeeeEnvironment environment;
    return in_ieee::stretch(curve, from, start, to, end);
}

}  // namespace signum
