#pragma once
/// Cells of space as a table, and as polyhedra for programs that draw.
///
/// Law: numbers are written so that reading them gives the same double.

#include <ostream>
#include <span>

#include "../voronoi/space_cells.hpp"
#include "../voronoi/space_polyhedra.hpp"

namespace signum {

/// One site a line, hidden ones included: volume and area of its cell, the centroid, how many faces
/// there are, the sites beyond these (the sides of the box from -1 to -6) and their areas, each
/// list in one column.
void write_space_cells_csv(std::ostream& out, const SpaceCells& cells);

/// The polyhedra that have corners, as an unstructured grid of polyhedra in VTK's legacy format,
/// which ParaView and VisIt open: with site, volume and number of faces of each. `cells` are those
/// of the same sites in the same box.
void write_space_cells_vtk(std::ostream& out, const SpaceCells& cells,
                           std::span<const SpacePolyhedron> polyhedra);

}  // namespace signum
