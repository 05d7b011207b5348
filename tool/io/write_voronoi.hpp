#pragma once
/// A Voronoi diagram as JSON, as GeoJSON, as a table, as well-known text and as polygons of VTK.
///
/// Laws:
///  1. The bytes depend on the diagram, the box and the tolerance alone.
///  2. Numbers are written so that reading them gives the same double; infinite areas and the like
///     are null in JSON and empty in a table.

#include <algorithm>
#include <limits>
#include <ostream>
#include <span>

#include "../../voronoi/clip.hpp"
#include "attributes.hpp"
#include "site_names.hpp"
#include "vtk_grid.hpp"

namespace signum {

/// Everything: vertices, edges with their curves, cells with their measures in the box. See
/// docs/voronoi.md for the format.
void write_voronoi_json(std::ostream& out, const ClippedVoronoi& diagram, const Box& box);

/// The cells in the box as a FeatureCollection of polygons (RFC 7946, in the coordinates of the
/// sites), arcs sampled to the tolerance. Site, measures and neighbours are properties, and so are
/// the site's attributes: numbers, strings, null where there is none. An attribute whose name is
/// taken gets input_ before it; bytes that are no UTF-8 become U+FFFD. A cell that does not reach
/// into the box has no geometry. Precondition: an attribute has a value a site.
void write_voronoi_geojson(std::ostream& out, const ClippedVoronoi& diagram, const Box& box,
                           double tolerance, std::span<const Attribute> attributes = {});

/// How far polygons may be from arcs where nobody says it: a ten-thousandth of the box.
[[nodiscard]] inline double default_tolerance(const Box& box) noexcept {
    const double longer = std::max(box.x1 / 2 - box.x0 / 2, box.y1 / 2 - box.y0 / 2);
    return std::max(longer / 5'000, std::numeric_limits<double>::denorm_min());
}

/// One cell a line, with measures, the site's attributes and the polygon as well-known text.
void write_voronoi_csv(std::ostream& out, const ClippedVoronoi& diagram, double tolerance,
                       std::span<const Attribute> attributes = {}, const SiteNames& names = {});

/// One site a line, its cell in the box as well-known text: POLYGON, MULTIPOLYGON, or POLYGON EMPTY
/// where it is hidden or does not reach into the box.
void write_voronoi_wkt(std::ostream& out, const ClippedVoronoi& diagram, double tolerance);

/// The cells in the box as polygons at z = 0, with site, radius or weight, and area of the cell; of
/// one that the box cuts into pieces several.
[[nodiscard]] VtkGrid vtk_grid(const ClippedVoronoi& diagram, double tolerance,
                               const SiteNames& names = {});

}  // namespace signum
