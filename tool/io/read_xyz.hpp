#pragma once
/// Balls from frames in extended XYZ, as write_xyz() writes them.
///
/// Laws: as of read_sites().

#include <string>
#include <string_view>

#include "read_balls.hpp"

namespace signum {

/// Whether a text begins as frames do: with a number alone, and Properties in the second line.
[[nodiscard]] bool looks_like_frames(std::string_view text);

/// The balls of the last frame; their masses are 0, for frames have none. They lie in the plane
/// where no third coordinate is other than 0. Throws InputError where a frame is not as write_xyz()
/// writes it, MachineError. O(bytes).
[[nodiscard]] BallsFile read_last_frame(const std::string& path);

}  // namespace signum
