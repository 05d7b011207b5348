#pragma once
/// signum compare in space: cells in place of edges.

#include "compare_call.hpp"

namespace signum::cli {

/// Writes table or JSON to standard output. Throws CallError where the call asks for what there is
/// in the plane alone.
void compare_in_space(const CompareCall& call, const InputSites& sites);

}  // namespace signum::cli
