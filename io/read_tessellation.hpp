#pragma once
/// A tessellation from the JSON that write_json() writes, or anyone else.

#include <string>

#include "../triangulation/tessellation.hpp"

namespace signum {

/// Reads the file `path`, or standard input for "-". "format", "version", "metric", "sites" and
/// "faces" must be there; "neighbours" and "hidden" may be missing, which means empty, and
/// "weight_is", which means radius; other keys are ignored. The indices may be anything that 32
/// bits hold: judging them is validate()'s task. Throws InputError with line and column, and
/// MachineError. O(bytes).
[[nodiscard]] TessellationArrays read_tessellation(const std::string& path);

}  // namespace signum
