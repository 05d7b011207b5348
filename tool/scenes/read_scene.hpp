#pragma once
/// A scene from its file; the format is described in docs/scenes.md.
///
/// Laws:
///  1. What cannot be is refused with file, line and column, or with the option that says it: a
///     message says what is wrong and what would be right.
///  2. The same file and overrides give the same scene on every machine, but for balls that are
///     made in a box that shakes and does not begin in its middle: where that is a sine tells.

#include <span>
#include <string>

#include "scene.hpp"

namespace signum {

/// Whether a file is taken for a scene: its name ends in .toml, in any case.
[[nodiscard]] bool is_name_of_scene(std::string_view path);

/// Reads the file `path`, with what the overrides say in place of its keys, and puts its balls in
/// their places. Throws InputError, OverrideError, MachineError. O(bytes + balls) expected, but for
/// arrangements, which say what they take (arrangement.hpp).
[[nodiscard]] AnyScene read_scene(const std::string& path, std::span<const Override> overrides);

}  // namespace signum
