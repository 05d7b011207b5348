#pragma once
/// The frame of a picture: from the plane to pixels, for every finite double.
///
/// Laws:
///  1. Every centre lies in the picture; y points up in the plane and down in pixels.
///  2. Nothing overflows: a power of two first brings all coordinates and radii below 2.
///  3. A disc far larger than the rest is cut off instead of shrinking the rest to a dot.

#include "../../core/site.hpp"
#include "../../voronoi/conic.hpp"

#include <span>

namespace signum {

class Frame {
 public:
    /// Fits the discs (centre and radius >= 0, in the plane) into a picture `width` pixels wide and
    /// at most as high.
    Frame(std::span<const Site> discs, double width);
    /// Shows the box and nothing else. Precondition: x0 < x1 and y0 < y1.
    Frame(const Box& box, double width);

    [[nodiscard]] double width() const noexcept { return width_; }
    [[nodiscard]] double height() const noexcept { return height_; }

    /// How far apart neighbouring doubles are beside the farthest of the picture's corners, in
    /// pixels: what is computed in doubles, as cells are, may be that much off.
    [[nodiscard]] double rounding() const noexcept;

    [[nodiscard]] double length(double in_plane) const noexcept;
    /// The decimal logarithm of a pixel's length in the plane, which itself may be no double.
    [[nodiscard]] double log10_of_pixel() const noexcept;
    /// Plane to pixels, coordinates being divided by 2^exponent; infinite or NaN for points beyond
    /// all measure.
    [[nodiscard]] Point at(Point divided, int exponent = 0) const noexcept;
    /// What the picture shows, all sides divided by 2^exponent.
    [[nodiscard]] Box box(int exponent) const noexcept;

 private:
    int exponent_ = 0;       // coordinates · 2^-exponent_ are below 2
    double scale_ = 1.0;     // pixels per scaled unit
    Point middle_ = {0, 0};  // scaled
    double width_ = 0.0;
    double height_ = 0.0;
};

}  // namespace signum
