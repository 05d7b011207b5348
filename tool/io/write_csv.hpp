#pragma once
/// The faces of a tessellation, or the cells of one of space, as a table for spreadsheets and data
/// frames.

#include <ostream>

#include "../../triangulation/space/triangulate.hpp"
#include "../../triangulation/tessellation.hpp"

namespace signum {

/// A header "a,b,c" and one face a line in face order: numbers of sites from 0, -1 for infinity.
void write_csv(std::ostream& out, const Tessellation& tessellation);

/// The same of cells under a header "a,b,c,d"; of flat sites there are fewer columns.
void write_csv(std::ostream& out, const SpaceTessellation& tessellation);

}  // namespace signum
