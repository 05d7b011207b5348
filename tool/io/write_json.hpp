#pragma once
/// A tessellation as JSON, in the plane the format that read_tessellation() reads.
///
/// Laws:
///  1. Without statistics the bytes depend on the tessellation alone.
///  2. Numbers are written so that reading them gives the same double; what is beyond a double's
///     range and what was not counted is null.

#include <optional>
#include <ostream>
#include <span>

#include "../../triangulation/space/triangulate.hpp"
#include "../../triangulation/space/vertices.hpp"
#include "../../triangulation/tessellation.hpp"

namespace signum {

/// What goes in besides faces, neighbours and hidden sites.
struct JsonOptions {
    bool vertices = false;    ///< centre and distance of every face; costs exact arithmetic
    bool statistics = false;  ///< the counters and the time; not the same every time
};

void write_json(std::ostream& out, const Tessellation& tessellation,
                const JsonOptions& options = {});

/// One of space: its "dimension", and "cells" in place of faces, each with one vertex more than
/// that. Statistics go in where there are any, and so do vertices, one a cell (precondition): null
/// for infinite cells and for those of flat sites.
void write_json(std::ostream& out, const SpaceTessellation& tessellation, Metric metric,
                WeightIs weight_is, const std::optional<Statistics>& statistics = {},
                std::span<const SpaceVertex> vertices = {});

}  // namespace signum
