#pragma once
/// A Voronoi diagram as JSON, as GeoJSON and as a table.
///
/// Laws:
///  1. The bytes depend on the diagram, the box and the tolerance alone.
///  2. Numbers are written so that reading them gives the same double; infinite areas and the like
///     are null in JSON and empty in a table.

#include <ostream>

#include "../voronoi/clip.hpp"

namespace signum {

/// Everything: vertices, edges with their curves, cells with their measures in the box. See
/// docs/voronoi.md for the format.
void write_voronoi_json(std::ostream& out, const ClippedVoronoi& diagram, const Box& box);

/// The cells in the box as a FeatureCollection of polygons (RFC 7946, in the coordinates of the
/// sites), arcs sampled to the tolerance. Site, measures and neighbours are properties. A cell that
/// does not reach into the box has no geometry.
void write_voronoi_geojson(std::ostream& out, const ClippedVoronoi& diagram, const Box& box,
                           double tolerance);

/// One cell a line, with measures and the polygon as well-known text.
void write_voronoi_csv(std::ostream& out, const ClippedVoronoi& diagram, double tolerance);

}  // namespace signum
