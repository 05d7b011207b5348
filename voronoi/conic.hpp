#pragma once
/// The stretches that edges of a diagram are made of: parts of straight lines and arcs of
/// hyperbolas, as rational quadratic Bézier curves.
///
/// Laws:
///  1. A point of the curve is, for s from 0 to 1 and u = 1 - s,
///         (u² from + 2us weight control + s² to) / (u² + 2us weight + s²).
///     Where the tangents at both ends meet lies `control`; the weight is 1 for a straight part,
///     whose control is its middle, and more for an arc of a hyperbola.
///  2. Halfway in s the curve is parallel to its chord and farthest from it.
///  3. Every part of such a curve is one again.
/// Source: G. Farin, NURBS: from projective geometry to practical use, on conics in standard form.

#include <utility>
#include <vector>

#include "../core/contract.hpp"
#include "../core/site.hpp"

SIGNUM_IEEE_BEGIN

namespace signum {

/// All points with x0 <= x <= x1 and y0 <= y <= y1.
struct Box {
    double x0;  ///< left
    double y0;  ///< bottom
    double x1;  ///< right
    double y1;  ///< top
    friend bool operator==(const Box&, const Box&) = default;
};

/// A piece of a conic: a rational quadratic Bézier curve, s from 0 to 1.
struct Conic {
    Point from;     ///< where it begins
    Point control;  ///< where the tangents at its ends meet
    Point to;       ///< where it ends
    double weight;  ///< of the control point: 1 of a segment

    friend bool operator==(const Conic&, const Conic&) = default;

    /// The segment between two points.
    [[nodiscard]] static Conic straight(Point from, Point to) noexcept;
    /// Whether it is a segment.
    [[nodiscard]] bool is_straight() const noexcept { return weight == 1.0; }
    /// The same from its end to its beginning.
    [[nodiscard]] Conic reversed() const noexcept { return {to, control, from, weight}; }

    /// Precondition: 0 <= s <= 1.
    [[nodiscard]] Point at(double s) const noexcept;
    /// The part from at(first) to at(last). Precondition: 0 <= first < last <= 1.
    [[nodiscard]] Conic part(double first, double last) const noexcept;
    /// The parts before and behind the middle, s = 1/2.
    [[nodiscard]] std::pair<Conic, Conic> halves() const noexcept;
    /// How far the curve is from its chord at most.
    [[nodiscard]] double bulge() const noexcept;
    /// How far any of its points is from the plain quadratic Bézier curve with the same three
    /// points at most, in the direction from the middle of the chord to the control point.
    [[nodiscard]] double distance_from_parabola() const noexcept;

    /// Integrals over the region between the curve and the two lines from `origin` to its ends,
    /// positive where they run counterclockwise: area, and x and y relative to the origin.
    struct Moments {
        double area;  ///< the integral of 1
        double x;     ///< of x
        double y;     ///< of y
    };
    /// See Moments.
    [[nodiscard]] Moments moments(Point origin) const noexcept;
    /// Length, by quadrature; relative error below 1e-9.
    [[nodiscard]] double length() const;
};

/// A part of a curve that lies in a box, in terms of s.
struct Inside {
    double first;  ///< where it begins
    double last;   ///< where it ends
};

/// The parts of a conic in the open box, in order; a part that runs along the border is not among
/// them. At most five.
[[nodiscard]] std::vector<Inside> parts_inside(const Conic& conic, const Box& box);

/// Appends points of the curve, without its first one and with its last one, so that the polygon
/// through them and the first is nowhere farther than `tolerance` from the curve. At most 2^16.
/// Throws std::invalid_argument unless the tolerance is positive, as parabolas() does.
void sample(const Conic& conic, double tolerance, std::vector<Point>& points);

/// Splits the curve into parts each of which a plain quadratic Bézier curve follows to `tolerance`.
[[nodiscard]] std::vector<Conic> parabolas(const Conic& conic, double tolerance);

}  // namespace signum

SIGNUM_IEEE_END
