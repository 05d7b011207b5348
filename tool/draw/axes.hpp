#pragma once
/// The axes of a picture: round numbers along its left and its lower side.
///
/// Laws:
///  1. A tick stands where a site with the coordinate that it names would be drawn.
///  2. One step, 1, 2 or 5 times a power of ten, serves both axes; no step is finer than doubles.
///  3. Where plain numbers would be long they are in units of a power of ten, and less a number
///     that they begin with; the legend says which.

#include "frame.hpp"
#include "legend.hpp"
#include "svg_text.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace signum {

class Axes {
 public:
    explicit Axes(const Frame& frame);

    void describe(Legend& legend) const;
    /// Outside the frame, which begins at 0 0.
    void write(SvgText& text) const;

 private:
    struct Tick {
        std::int64_t units;  // its value is units · 10^exponent_
        double pixel;
    };
    struct Axis {
        std::vector<Tick> ticks;
        std::int64_t offset = 0;  // in units, too
    };
    [[nodiscard]] Axis axis(double low, double high, int multiple, double Point::*coordinate) const;
    void choose_numbers();
    [[nodiscard]] std::size_t longest_number() const;

    const Frame& frame_;
    int exponent_ = 0;  // of ten
    int unit_ = 0;      // numbers are in 10^unit_
    std::array<Axis, 2> axes_;
};

}  // namespace signum
