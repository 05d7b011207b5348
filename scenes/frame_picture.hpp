#pragma once
/// One frame as an SVG file: the balls, the box and the walls. In space it is seen along z, far
/// balls first and paler.

#include <string>

#include "../io/write_motion.hpp"
#include "../motion/effects.hpp"

namespace signum {

/// Its width and height in pixels are even, as videos want them, and at most 800. What the frame
/// shows is its box. O(balls log balls).
template <int D>
[[nodiscard]] std::string frame_picture(const MotionFrame& frame,
                                        const motion::Effects<D>& effects);

}  // namespace signum
