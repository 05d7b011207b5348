#pragma once
/// The Voronoi diagram of balls as JSON and as a table of its vertices.
///
/// Law: numbers are written so that reading them gives the same double; those beyond a double's
/// range are null in JSON and empty in the table.

#include <ostream>

#include "../../voronoi/balls/diagram.hpp"

namespace signum {

/// Everything. The spheres of "vertices" are [x, y, z, r], "touching" has the balls that touch each
/// and "turns" how the points of contact turn. An edge has the balls that touch along it and its
/// two ends: vertices, -1 for infinity; a closed one has none. "hidden": a ball, and one that hides
/// it.
void write_json(std::ostream& out, const BallDiagram& diagram);

/// A vertex a line: the four balls of the smallest numbers that touch there, the sphere, the turn,
/// and the other balls, of which there are none in general.
void write_csv(std::ostream& out, const BallDiagram& diagram);

}  // namespace signum
