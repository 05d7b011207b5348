#pragma once
/// A tessellation of the plane or of space as JSON, as a table, as a mesh that others open, and as
/// the files of Triangle and TetGen.
///
/// Laws:
///  1. Without statistics the bytes depend on the tessellation alone.
///  2. Numbers are written so that reading them gives the same double; in JSON what is beyond a
///     double's range and what was not counted is null.
///  3. Sites, faces and cells are numbered from 0, in OBJ from 1; -1 is infinity.

#include <optional>
#include <ostream>
#include <span>

#include "../../triangulation/space/triangulate.hpp"
#include "../../triangulation/space/vertices.hpp"
#include "../../triangulation/tessellation.hpp"
#include "vtk_grid.hpp"

namespace signum {

class TextWriter;

/// What goes into JSON besides faces, neighbours and hidden sites.
struct JsonOptions {
    bool vertices = false;    ///< centre and distance of every face; costs exact arithmetic
    bool statistics = false;  ///< the counters and the time; not the same every time
    int threads = 0;          ///< that compute vertices, as Options::threads
};

/// The format that read_tessellation() reads.
void write_json(std::ostream& out, const Tessellation& tessellation,
                const JsonOptions& options = {});
/// One of space: its "dimension", and "cells" in place of faces, each with one vertex more than
/// that. Statistics go in where there are any, and so do vertices, one a cell (precondition): null
/// for infinite cells and for those of flat sites.
void write_json(std::ostream& out, const SpaceTessellation& tessellation, Metric metric,
                WeightIs weight_is, const std::optional<Statistics>& statistics = {},
                std::span<const SpaceVertex> vertices = {});
/// The member "hidden" of a tessellation or diagram: a site, and one that hides it.
void put_hidden(TextWriter& text, std::span<const Hidden> hidden);

/// A header "a,b,c" and one face a line in face order.
void write_csv(std::ostream& out, const Tessellation& tessellation);
/// The same of cells under a header "a,b,c,d"; of flat sites there are fewer columns.
void write_csv(std::ostream& out, const SpaceTessellation& tessellation);

/// The same numbers as an array of NumPy's, of 32-bit integers, a row a face or cell.
void write_npy(std::ostream& out, const Tessellation& tessellation);
void write_npy(std::ostream& out, const SpaceTessellation& tessellation);
/// The same without a head.
void write_i32(std::ostream& out, const Tessellation& tessellation);
void write_i32(std::ostream& out, const SpaceTessellation& tessellation);

/// The finite faces, counterclockwise; in space the finite cells, which turn positively. Of flat
/// sites in space none. Their sites are what write_sites() writes as SitesFormat::node. Sites and
/// what is written are numbered from `first`, 0 or 1.
void write_ele(std::ostream& out, const Tessellation& tessellation, int first = 0);
void write_ele(std::ostream& out, const SpaceTessellation& tessellation, int first = 0);
/// By face or cell of write_ele() those across from its corners; -1 beyond the hull.
void write_neigh(std::ostream& out, const Tessellation& tessellation, int first = 0);
void write_neigh(std::ostream& out, const SpaceTessellation& tessellation, int first = 0);

/// As Wavefront OBJ, which Blender and MeshLab open: "v x y 0" for every site, hidden ones
/// included, and "f a b c", counterclockwise, for every finite face.
void write_obj(std::ostream& out, const Tessellation& tessellation);
/// "v x y z" for every site, and all finite facets of the cells, each once: those of the hull,
/// which turn counterclockwise as seen from outside, as group hull, the others as group inside. Of
/// flat sites triangles "f a b c", lines "l a b" or a point "p a".
void write_obj(std::ostream& out, const SpaceTessellation& tessellation,
               std::span<const Site3> sites);

/// As PLY in ASCII, whose vertices read_sites() reads back: a vertex a site, at z = 0, with its
/// radius or weight, and the finite faces.
void write_ply(std::ostream& out, const Tessellation& tessellation);
/// A vertex a site, with its radius or weight, and no faces.
void write_ply(std::ostream& out, std::span<const Site3> sites, WeightIs weight_is);

/// All sites as points at z = 0 with their radius or weight and whether they are hidden; the finite
/// faces as triangles, and before them as lines the edges that bound none of these. O(n log n).
[[nodiscard]] VtkGrid vtk_grid(const Tessellation& tessellation);
/// All sites as points with their radius or weight and whether they are hidden, and the finite
/// cells: tetrahedra, turning as VTK wants them; of flat sites triangles, lines or a vertex. O(n).
[[nodiscard]] VtkGrid vtk_grid(const SpaceTessellation& tessellation, std::span<const Site3> sites,
                               WeightIs weight_is);

}  // namespace signum
