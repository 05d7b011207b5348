#pragma once
/// How pictures look at space: from far away, 23 degrees to the right of z and 16 degrees above it.
/// The sines and cosines are rational, so that pictures are the same everywhere.

#include "../../core/site.hpp"
#include "svg_text.hpp"

namespace signum {

inline constexpr double view_sine = 5.0 / 13.0;
inline constexpr double view_cosine = 12.0 / 13.0;
inline constexpr double view_sine_up = 7.0 / 25.0;
inline constexpr double view_cosine_up = 24.0 / 25.0;
/// The directions of the picture, and the one toward the eye.
inline constexpr Point3 to_the_right = {view_cosine, 0.0, -view_sine};
inline constexpr Point3 upward = {-view_sine * view_sine_up, view_cosine_up,
                                  -view_cosine* view_sine_up};
inline constexpr Point3 to_the_eye = {view_sine * view_cosine_up, view_sine_up,
                                      view_cosine* view_cosine_up};

[[nodiscard]] constexpr double dot_product(const Point3& a, const Point3& b) noexcept {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Arrows that show where x, y and z point, beside the lower left corner of a frame of that height.
void write_directions(SvgText& text, double height);

}  // namespace signum
