#pragma once
/// Bisectors that are straight lines, and the way from one centre to the other. For sources only.

#include <algorithm>
#include <cmath>
#include <optional>

#include "of_metric.hpp"
#include "vector.hpp"

namespace signum {

[[nodiscard]] inline Point turned_left(Point p) noexcept {
    return {-p.y, p.x};
}

/// The way from a to b: 2^exponent times a distance, in a direction.
struct Way {
    explicit Way(const PairOfSites& pair) {
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
[[nodiscard]] inline std::optional<Curve> straight_bisector(const PairOfSites& pair, const Way& way,
                                                            double shift) {
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

}  // namespace signum
