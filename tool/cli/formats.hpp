#pragma once
/// What triangulate and voronoi write: a row an ending, in the order of the help. The first one of
/// each is what standard output gets.

#include <array>

#include "outputs.hpp"

namespace signum::cli {

inline constexpr std::string_view writes_png =
    "the picture as pixels, by rsvg-convert or\ninkscape";
inline constexpr std::string_view writes_pdf = "the picture for print, by the same";

inline constexpr std::array<Format, 15> triangulate_formats = {
    {{"json", "faces, in space cells, neighbours, hidden sites"},
     {"svg", "a picture"},
     {"png", writes_png},
     {"pdf", writes_pdf},
     {"csv", "a table a,b,c of faces, in space a,b,c,d of\ncells; -1 is infinity"},
     {"npy", "the same table as a NumPy array"},
     {"i32", "the same as integers without a head"},
     {"obj", "a mesh of the finite faces"},
     {"ply", "the same with radii, in space sites alone"},
     {"vtk", "the finite faces, in space tetrahedra, for\nParaView; the legacy form of VTK"},
     {"vtp", "the same faces as XML of VTK", Dimension::two, "vtu"},
     {"vtu", "the same tetrahedra as XML of VTK", Dimension::three, "vtp"},
     {"node", "the sites for Triangle, in space TetGen"},
     {"ele", "the finite faces, in space cells, for these"},
     {"neigh", "which of them are neighbours"}}};

inline constexpr std::array<Format, 10> voronoi_formats = {
    {{"json",
      "vertices, edges with their curves,\ncells with their measures, in space\nwith their faces"},
     {"svg", "a picture with true arcs, in space of\nsolid cells"},
     {"png", writes_png},
     {"pdf", writes_pdf},
     {"geojson", "the cells as polygons, with all that FILE\nhas in named columns", Dimension::two,
      "vtk"},
     {"csv",
      "the cells as a table, polygons as WKT, in\nspace volumes, areas, faces, neighbours;\nof "
      "balls the vertices"},
     {"wkt", "a cell a line as well-known text", Dimension::two, "vtk"},
     {"vtk", "the cells as polygons, in space polyhedra,\nfor ParaView; the legacy form of VTK"},
     {"vtp", "the same polygons as XML of VTK", Dimension::two, "vtu"},
     {"vtu", "the same polyhedra as XML of VTK", Dimension::three, "vtp"}}};

}  // namespace signum::cli
