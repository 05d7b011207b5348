#pragma once
/// Cells of space as JSON, as a table, and as polyhedra of VTK.
///
/// Law: numbers are written so that reading them gives the same double; in JSON those beyond a
/// double's range, and the centroid of a cell without volume, are null.

#include <ostream>
#include <span>

#include "../../triangulation/space/vertices.hpp"
#include "../../voronoi/space/cells.hpp"
#include "../../voronoi/space/polyhedra.hpp"
#include "vtk_grid.hpp"

namespace signum {

/// The diagram: its vertices, the edges between them, and of every visible site the measures of its
/// cell in the box and its faces. `vertices` are those of the tessellation, one a cell, of which
/// the finite ones are written. An edge has the three sites around it, a, b and c, such that (b-a)
/// x (c-a) leads from its first vertex to its second one, which is -1 where the edge runs to
/// infinity; flat sites have neither vertices nor edges. The other arguments are of the same sites.
void write_space_cells_json(std::ostream& out, const SpaceCells& cells,
                            const SpaceTessellation& tessellation, WeightIs weight_is,
                            std::span<const SpaceVertex> vertices);

/// One site a line, hidden ones included: volume and area of its cell, the centroid, how many faces
/// there are, the sites beyond these (the sides of the box from -1 to -6) and their areas, each
/// list in one column.
void write_space_cells_csv(std::ostream& out, const SpaceCells& cells);

/// The polyhedra that have corners, with site, volume and number of faces of each. `cells` are
/// those of the same sites in the same box.
[[nodiscard]] VtkGrid vtk_grid(const SpaceCells& cells, std::span<const SpacePolyhedron> polyhedra);

}  // namespace signum
