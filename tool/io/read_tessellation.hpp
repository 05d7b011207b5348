#pragma once
/// A tessellation of the plane or of space from the JSON that write_json() writes, or anyone else.

#include <optional>
#include <string>

#include "../../triangulation/space/triangulate.hpp"
#include "../../triangulation/tessellation.hpp"

namespace signum {

/// A tessellation of the plane or of space.
struct ReadTessellation {
    /// Of space its metric and what its weights are, and nothing else.
    TessellationArrays arrays;
    std::optional<SpaceTessellation> in_space;
    /// What has been ignored, for people to read; empty where all keys are the format's.
    std::string note;
};

/// Reads the file `path`, or standard input for "-". "format", "version", "metric", "sites" and
/// "faces" must be there; "neighbours" and "hidden" may be missing, which means empty, and
/// "weight_is", which means radius. "cells" in place of "faces" make it one of space: it must say
/// its "dimension" k, from -1 to 3, and have k+1 numbers in each entry of "cells" and "neighbours";
/// the arrays it lacks are empty. "vertices", "statistics" and keys of others are ignored, but for
/// one that reads like a misspelt name of what may be missing and is: that is an error. The indices
/// may be anything that 32 bits hold: judging them is validate()'s task. Throws InputError with
/// line and column, and MachineError. O(bytes).
[[nodiscard]] ReadTessellation read_tessellation(const std::string& path);

}  // namespace signum
