#pragma once
/// A grid of points and cells as VTK has it, which ParaView opens: what the files of VTK share.
///
/// Laws:
///  1. Numbers are written in ASCII so that reading them gives the same double.
///  2. The bytes depend on the grid alone.

#include <cstdint>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "../../core/index.hpp"
#include "../../core/site.hpp"

namespace signum {

/// VTK's numbers of what a cell is.
enum class VtkCell : std::uint8_t {
    vertex = 1,
    line = 3,
    triangle = 5,
    polygon = 7,
    tetrahedron = 10,
    polyhedron = 42
};

/// A number for each point or each cell.
struct VtkColumn {
    std::string name;
    bool is_whole = false;  ///< whole numbers of 32 bits
    std::vector<double> values;
};

struct VtkGrid {
    std::string title;  ///< one line, without --
    std::vector<Point3> points;
    std::vector<VtkCell> kinds;         ///< one a cell
    std::vector<std::int64_t> corners;  ///< points of one cell after the other
    std::vector<std::int64_t> ends;     ///< by cell, where its corners end among them
    /// Of polyhedra: how many faces, and of each face how many corners and which; and by cell where
    /// this ends. Either there are no polyhedra, or all cells are.
    std::vector<std::int64_t> faces;
    std::vector<std::int64_t> face_ends;
    std::vector<VtkColumn> of_points;
    std::vector<VtkColumn> of_cells;

    /// A further cell that is no polyhedron.
    template <class Corners>
    void add_cell(VtkCell kind, const Corners& its_corners) {
        kinds.push_back(kind);
        corners.insert(corners.end(), its_corners.begin(), its_corners.end());
        ends.push_back(static_cast<std::int64_t>(corners.size()));
    }
};

/// The legacy form, .vtk: an unstructured grid.
void write_vtk(std::ostream& out, const VtkGrid& grid);
/// XML, .vtu: an unstructured grid.
void write_vtu(std::ostream& out, const VtkGrid& grid);
/// XML, .pvtu: several such grids, in files beside it, of which `one` is the like.
void write_pvtu(std::ostream& out, const VtkGrid& one, std::span<const std::string> pieces);
/// XML, .vtp: vertices, lines and polygons. Precondition: the cells are no others, and come in that
/// order, triangles among the polygons.
void write_vtp(std::ostream& out, const VtkGrid& grid);

}  // namespace signum
