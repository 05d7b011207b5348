#pragma once
/// The curve on which an edge of a diagram lies: the bisector of two sites, walked with the first
/// of them on the left.
///
/// Laws:
///  1. at(t) rises along the curve with t, from -infinity to infinity; its distances from the two
///     sites are equal (to rounding).
///  2. In the power metric, and between discs of equal radius, it is a straight line, and t the
///     length along it. In the Euclidean metric it is the half of a hyperbola
///         middle + a cosh t forward + b sinh t upward
///     with two unit vectors at a right angle. In the Manhattan and supremum metrics it is a line
///     of at most three straight pieces, and t rises with the direction `upward`.

#include <array>
#include <optional>
#include <variant>
#include <vector>

#include "../core/index.hpp"
#include "../triangulation/tessellation.hpp"
#include "conic.hpp"

namespace signum {

/// Pieces of straight lines between two knots, beyond which each runs on for ever. Both are the
/// same where there is one line alone.
struct StraightCurve {
    Point origin;                          ///< at t = 0, were it not for the knots
    Point right;                           ///< towards the second site; not always a unit vector
    Point upward;                          ///< `right` turned left by a quarter
    std::array<double, 2> knots = {0, 0};  ///< parameters where the pieces meet
    double shift = 0;  ///< the piece between the knots is that far right of the origin
    std::array<double, 2> slopes = {0, 0};  ///< how far right each unit of t beyond a knot leads

    /// The point at a parameter.
    [[nodiscard]] Point at(double t) const noexcept;
    /// The parameter of a point of the curve.
    [[nodiscard]] double parameter(Point p) const noexcept;
    /// Where it is at least that far from the origin: |t| of this.
    [[nodiscard]] double beyond(double reach) const noexcept;
};

/// One branch of a hyperbola.
struct HyperbolaCurve {
    Point middle;   ///< of the two centres
    Point forward;  ///< unit vector from the first centre to the second
    Point upward;   ///< `forward` turned left by a quarter
    double a;  ///< half the difference of the radii, that of the first minus that of the second
    double b;  ///< the other semiaxis

    /// The point at a parameter.
    [[nodiscard]] Point at(double t) const noexcept;
    /// The parameter of a point of the curve.
    [[nodiscard]] double parameter(Point p) const noexcept;
    /// Where it is at least that far from the middle: |t| of this.
    [[nodiscard]] double beyond(double reach) const noexcept;
};

/// What edges lie on.
using Curve = std::variant<StraightCurve, HyperbolaCurve>;

/// A site as its tessellation knows it.
struct NumberedSite {
    Site site;    ///< itself
    Index index;  ///< its number
};

/// The bisector of sites a and b of a tessellation, all lengths divided by 2^exponent. In the power
/// metric the origin is the point next to `focus` (divided, too), so that little is lost near it.
/// Nothing is returned where the two are too near to each other for a direction, or too far apart
/// for a double.
[[nodiscard]] std::optional<Curve> bisector(Metric metric, WeightIs weight_is,
                                            const NumberedSite& a, const NumberedSite& b,
                                            int exponent, Point focus);

/// The stretch of a curve from one parameter to another, both finite, which begins and ends at the
/// given points: straight pieces, or arcs of moderate weight. Empty unless from < to.
[[nodiscard]] std::vector<Conic> stretch(const Curve& curve, double from, Point start, double to,
                                         Point end);

}  // namespace signum
