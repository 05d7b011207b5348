#include "curve.hpp"

#include <algorithm>
#include <cmath>

#include "../exact/floating_environment.hpp"
#include "../exact/surd.hpp"
#include "../predicates/additive.hpp"
#include "../predicates/formulas/apollonius.hpp"
#include "../predicates/ladder/forms.hpp"
#include "../triangulation/kernels/predicates_of.hpp"
#include "in_ieee.hpp"
#include "vector.hpp"

namespace signum {
namespace {

Point turned_left(Point p) noexcept {
    return {-p.y, p.x};
}

/// What bisector() is asked for.
struct Pair {
    const NumberedSite& first;
    const NumberedSite& second;
    Site a;  ///< the first, divided by 2^exponent
    Site b;  ///< the second, likewise
    WeightIs weight_is;
    int exponent;
    Point focus;
};

/// The way from a to b: 2^exponent times a distance, in a direction.
struct Way {
    explicit Way(const Pair& pair) {
        Point to_b = {pair.b.x - pair.a.x, pair.b.y - pair.a.y};
        is_close = std::hypot(to_b.x, to_b.y) < 0x1p-960;
        if (is_close) {
            // Among or below the denormals, which have few bits: as it is given, and by its own
            // power of two.
            const Site& first = pair.first.site;
            const Site& second = pair.second.site;
            to_b = {second.x - first.x, second.y - first.y};
            const double longest = std::max(std::abs(to_b.x), std::abs(to_b.y));
            if (longest > 0) exponent = std::ilogb(longest);
            to_b = {std::ldexp(to_b.x, -exponent), std::ldexp(to_b.y, -exponent)};
        }
        distance = std::hypot(to_b.x, to_b.y);
        right = {to_b.x / distance, to_b.y / distance};
    }
    bool is_close;     ///< too close for what they have been divided by
    int exponent = 0;  ///< of two, and not divided where they are close
    double distance;
    Point right;  ///< not finite where they are at one place
};

/// The points with |x - a|² - w(a) = |x - b|² - w(b), where the excess w(a) - w(b) is `shift` times
/// twice the distance.
std::optional<Curve> straight_bisector(const Pair& pair, const Way& way, double shift) {
    const Site& a = pair.a;
    const Site& b = pair.b;
    const Point& right = way.right;
    const Point& focus = pair.focus;
    // The difference of both sides at the focus, which grows by twice the distance per unit.
    const Point from_a = {focus.x - a.x, focus.y - a.y};
    const Point from_b = {focus.x - b.x, focus.y - b.y};
    const double along = dot(right, from_a) + dot(right, from_b);
    const Point origin = plus(focus, right, shift - along / 2);
    if (!std::isfinite(origin.x + origin.y + right.x + right.y)) return std::nullopt;
    return StraightCurve{origin, right, turned_left(right)};
}

/// √(1 - s²), s the difference of the radii over the distance: of two discs that all but touch from
/// inside nothing is left of it in doubles. 0 where they do, and below the doubles.
double exact_rise(const Site& a, const Site& b) {
    using Exact = euclidean::Uniform<exact::Rational>;
    const auto disc = [](const Site& s) -> euclidean::Disc<Exact> {
        return {exact::to_rational(s.x), exact::to_rational(s.y), exact::to_rational(s.r)};
    };
    const auto row = euclidean::polynomials::row(disc(b), disc(a));
    if (row.p <= 0) return 0.0;
    return exact::round_surd(0, 1, exact::Rational(row.p / (row.x * row.x + row.y * row.y)));
}

std::optional<Curve> hyperbola(const Pair& pair, const Way& way) {
    const Site& a = pair.a;
    const Site& b = pair.b;
    const Point to_b = {b.x - a.x, b.y - a.y};
    const Point middle = plus({a.x, a.y}, to_b, 0.5);
    const double excess = way.is_close
                              ? std::ldexp(pair.first.site.r - pair.second.site.r, -way.exponent)
                              : a.r - b.r;
    const double slant = std::clamp(excess / way.distance, -1.0, 1.0);
    const double rise = std::abs(slant) < 1 - 0x1p-20
                            ? std::sqrt((1 - slant) * (1 + slant))
                            : exact_rise(pair.first.site, pair.second.site);
    if (!std::isfinite(way.right.x + way.right.y + slant)) return std::nullopt;
    if (way.is_close) {
        // From where it can be seen it is its asymptotes.
        const double slope = slant / rise;
        if (!std::isfinite(slope)) return std::nullopt;
        return StraightCurve{middle, way.right, turned_left(way.right), {0, 0}, 0, {slope, slope}};
    }
    return HyperbolaCurve{middle, way.right, turned_left(way.right), slant * (way.distance / 2),
                          rise * (way.distance / 2)};
}

/// For each side of a square (diamond) whether b touches it first, and not a, as squares shrink
/// onto the two. Exact, by the tie rule where both do.
template <class Directions>
std::array<bool, 4> sides_touched_by_second(const NumberedSite& a, const NumberedSite& b) {
    const std::array<const Site*, 2> sites = {&a.site, &b.site};
    rectangular::Forms<Directions, Arithmetic::exact, 2> forms(
        sites, additive::ranks_of<2>(sites, {a.index, b.index}));
    std::array<bool, 4> second{};
    for (int side = 0; side < 4; ++side)
        second[static_cast<std::size_t>(side)] = forms.compare(side, 1, 0) > 0;
    return second;
}

/// The centres of the squares that touch a and b: while a touches the left side and b the right
/// one, a line upwards, and beyond it, where the one that is in the way above or below holds the
/// corner of growing squares, a diagonal ray on either side. "Right" is the direction from a to b
/// in which they lie farther apart.
template <class Directions>
StraightCurve rectangular_bisector(const Site& a, const Site& b,
                                   const std::array<bool, 4>& b_touches) {
    const auto at = [](int side) { return static_cast<std::size_t>(side & 3); };
    const auto direction = [&](int side) -> Point {
        return {Directions::x[at(side)], Directions::y[at(side)]};
    };

    const Point to_b = {b.x - a.x, b.y - a.y};
    double farthest = -1.0;
    int right = 0;
    for (int side = 0; side < 4; ++side)
        if (b_touches[at(side)] && !b_touches[at(side + 2)] &&
            dot(direction(side), to_b) > farthest) {
            farthest = dot(direction(side), to_b);
            right = side;
        }

    // The forms relative to a, whose own are 0: only differences of radii count.
    const double r_b = b.r - a.r;
    const auto form = [&](int side) {
        return b_touches[at(side)] ? dot(direction(side), to_b) - r_b : 0.0;
    };
    const double rho = form(right) / 2;  // of the squares that a and b touch left and right
    const double lowest = form(right + 1) - rho;
    const double highest = std::max(lowest, rho - form(right + 3));
    return {{a.x, a.y},
            direction(right),
            direction(right + 1),
            {lowest, highest},
            rho,
            {b_touches[at(right + 1)] ? 1.0 : -1.0, b_touches[at(right + 3)] ? 1.0 : -1.0}};
}

std::optional<Curve> bisector_in(Power /*metric*/, const Pair& pair) {
    const Way way(pair);
    const bool is_weight = pair.weight_is == WeightIs::weight;
    const double excess = pair.first.site.r - pair.second.site.r;
    const double sum = pair.a.r + pair.b.r;
    if (way.is_close) {
        // Of radii the product of excess and sum, whose exponents may be far apart.
        int exponent = -pair.exponent;
        const double product = is_weight ? excess : std::frexp(excess, &exponent) * sum;
        return straight_bisector(pair, way,
                                 std::ldexp(product / way.distance / 2, exponent - way.exponent));
    }
    const double divided = pair.a.r - pair.b.r;
    return straight_bisector(
        pair, way,
        (is_weight ? std::ldexp(divided, -pair.exponent) : divided * sum) / way.distance / 2);
}

std::optional<Curve> bisector_in(Euclidean /*metric*/, const Pair& pair) {
    const Way way(pair);
    if (pair.first.site.r == pair.second.site.r) return straight_bisector(pair, way, 0);
    return hyperbola(pair, way);
}

template <triangulation::Rectangular M>
std::optional<Curve> bisector_in(M /*metric*/, const Pair& pair) {
    using Directions = typename triangulation::PredicatesOf<M>::Directions;
    return rectangular_bisector<Directions>(
        pair.a, pair.b, sides_touched_by_second<Directions>(pair.first, pair.second));
}

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

template <class C>
Point point_of_curve(const C& curve, double t) noexcept {
    return exact::in_ieee_environment([](const C& on, double at) { return in_ieee::at(on, at); },
                                      curve, t);
}
template <class C>
double parameter_of(const C& curve, Point p) noexcept {
    return exact::in_ieee_environment(
        [](const C& on, Point of) { return in_ieee::parameter(on, of); }, curve, p);
}
template <class C>
double parameter_beyond(const C& curve, double reach) noexcept {
    return exact::in_ieee_environment(
        [](const C& on, double away) { return in_ieee::beyond(on, away); }, curve, reach);
}

}  // namespace

Point StraightCurve::at(double t) const noexcept {
    return point_of_curve(*this, t);
}
double StraightCurve::parameter(Point p) const noexcept {
    return parameter_of(*this, p);
}
double StraightCurve::beyond(double reach) const noexcept {
    return parameter_beyond(*this, reach);
}
Point HyperbolaCurve::at(double t) const noexcept {
    return point_of_curve(*this, t);
}
double HyperbolaCurve::parameter(Point p) const noexcept {
    return parameter_of(*this, p);
}
double HyperbolaCurve::beyond(double reach) const noexcept {
    return parameter_beyond(*this, reach);
}

std::optional<Curve> in_ieee::bisector(Metric metric, WeightIs weight_is, const NumberedSite& a,
                                       const NumberedSite& b, int exponent, Point focus) {
    const auto divided = [exponent](const Site& s) -> Site {
        return {std::ldexp(s.x, -exponent), std::ldexp(s.y, -exponent), std::ldexp(s.r, -exponent)};
    };
    const Pair pair = {a, b, divided(a.site), divided(b.site), weight_is, exponent, focus};
    return with_metric(metric, [&](auto each) { return bisector_in(each, pair); });
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
