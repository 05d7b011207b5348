#pragma once
/// The frame of a picture: from the plane to pixels, for every finite double.
///
/// Laws:
///  1. Every centre lies in the picture; y points up in the plane and down in pixels.
///  2. Nothing overflows: a power of two first brings all coordinates and radii below 2.
///  3. A disc far larger than the rest is cut off instead of shrinking the rest to a dot.

#include <signum/core/site.hpp>

#include <optional>
#include <span>

namespace signum {

/// A straight line from one pixel to another.
struct Segment {
    Point from;
    Point to;
};

class Frame {
 public:
    /// Fits the discs (centre and radius >= 0, in the plane) into a picture `width` pixels wide and
    /// at most as high.
    Frame(std::span<const Site> discs, double width);

    [[nodiscard]] double width() const noexcept { return width_; }
    [[nodiscard]] double height() const noexcept { return height_; }

    /// Plane to pixels; infinite or NaN for points beyond all measure.
    [[nodiscard]] Point at(Point point) const noexcept;
    [[nodiscard]] double length(double in_plane) const noexcept;
    [[nodiscard]] double area(double in_plane) const noexcept;
    /// The unit vector from a to b, in pixels; NaN where they coincide.
    [[nodiscard]] Point direction(Point a, Point b) const noexcept;

    /// The part of start + t·step, low <= t <= high, that lies in the picture. The bounds may be
    /// infinite; what is not finite, or a point, is not drawn.
    [[nodiscard]] std::optional<Segment> clip(Point start, Point step, double low,
                                              double high) const noexcept;

 private:
    int exponent_ = 0;       // coordinates · 2^-exponent_ are below 2
    double scale_ = 1.0;     // pixels per scaled unit
    Point middle_ = {0, 0};  // scaled
    double width_ = 0.0;
    double height_ = 0.0;
};

}  // namespace signum
