#pragma once
/// Diagrams of space: power cells as JSON, as a table and as polyhedra of VTK, and the Voronoi
/// diagram of balls as JSON and as a table of its vertices.
///
/// Law: numbers are written so that reading them gives the same double; those beyond a double's
/// range are null in JSON and empty in tables, and in JSON the centroid of a cell without volume is
/// null.

#include <ostream>
#include <span>

#include "../../triangulation/space/vertices.hpp"
#include "../../voronoi/balls/diagram.hpp"
#include "../../voronoi/space/cells.hpp"
#include "../../voronoi/space/polyhedra.hpp"
#include "site_names.hpp"
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
void write_space_cells_csv(std::ostream& out, const SpaceCells& cells, const SiteNames& names = {});

/// The polyhedra that have corners, with site, volume and number of faces of each. `cells` are
/// those of the same sites in the same box.
[[nodiscard]] VtkGrid vtk_grid(const SpaceCells& cells, std::span<const SpacePolyhedron> polyhedra,
                               const SiteNames& names = {});

/// Everything. The spheres of "vertices" are [x, y, z, r], "touching" has the balls that touch each
/// and "turns" how the points of contact turn. An edge has the balls that touch along it and its
/// two ends: vertices, -1 for infinity; a closed one has none. "hidden": a ball, and one that hides
/// it.
void write_json(std::ostream& out, const BallDiagram& diagram);

/// A vertex a line: the four balls of the smallest numbers that touch there, the sphere, the turn,
/// and the other balls, of which there are none in general.
void write_csv(std::ostream& out, const BallDiagram& diagram);

}  // namespace signum
