#pragma once
/// The faces of a tessellation as a table for spreadsheets and data frames.

#include <ostream>

#include "../triangulation/tessellation.hpp"

namespace signum {

/// A header "a,b,c" and one face a line in face order: numbers of sites from 0, -1 for infinity.
void write_csv(std::ostream& out, const Tessellation& tessellation);

}  // namespace signum
