#pragma once
/// One frame as an SVG file: the balls and the walls, and below them the time. In space it is seen
/// along z, far balls first and paler.

#include <span>
#include <string>
#include <string_view>

#include "../draw/movie.hpp"
#include "../io/write_motion.hpp"

namespace signum {

/// Shows the frame's box. Its width and height in pixels are even, as videos want them, and at most
/// 800. `unit` is that of the time; it may be empty. O(balls log balls).
[[nodiscard]] std::string frame_picture(const MotionFrame& frame,
                                        std::span<const Movie::Wall> walls, std::string_view unit);

}  // namespace signum
