#include "vtk_grid.hpp"

#include <algorithm>
#include <cstddef>
#include <span>

#include "text_writer.hpp"

namespace signum {
namespace {

using Numbers = std::span<const std::int64_t>;

/// What lies between the end before it and its own.
Numbers part_of(Numbers all, Numbers ends, std::size_t cell) {
    const auto begin = static_cast<std::size_t>(cell == 0 ? 0 : ends[cell - 1]);
    return all.subspan(begin, static_cast<std::size_t>(ends[cell]) - begin);
}

/// What the legacy form says of a cell: its corners, or the faces of a polyhedron.
Numbers told_of(const VtkGrid& grid, std::size_t cell) {
    return grid.faces.empty() ? part_of(grid.corners, grid.ends, cell)
                              : part_of(grid.faces, grid.face_ends, cell);
}

void put_columns(TextWriter& text, std::string_view of, std::size_t count,
                 std::span<const VtkColumn> columns) {
    if (columns.empty()) return;
    text.put(FMT_COMPILE("{} {}\n"), of, count);
    for (const auto& [name, is_whole, values] : columns) {
        text.put(FMT_COMPILE("SCALARS {} {} 1\nLOOKUP_TABLE default\n"), name,
                 is_whole ? "int" : "double");
        for (const double value : values) text.put(FMT_COMPILE("{}\n"), value);
    }
}

/// An array of XML, a value a line; `put` writes one.
template <class Values, class Put>
void put_array(TextWriter& text, std::string_view type, std::string_view name,
               std::string_view further, const Values& values, const Put& put) {
    text.put(FMT_COMPILE("<DataArray type=\"{}\" Name=\"{}\"{} format=\"ascii\">\n"), type, name,
             further);
    for (const auto& value : values) put(value);
    text.put("</DataArray>\n");
}

void put_numbers(TextWriter& text, std::string_view name, Numbers numbers) {
    put_array(text, "Int64", name, "", numbers,
              [&](std::int64_t number) { text.put(FMT_COMPILE("{}\n"), number); });
}

void put_data(TextWriter& text, std::string_view of, std::span<const VtkColumn> columns) {
    text.put(FMT_COMPILE("<{}>\n"), of);
    for (const auto& [name, is_whole, values] : columns) {
        put_array(text, is_whole ? "Int32" : "Float64", name, "", values,
                  [&](double value) { text.put(FMT_COMPILE("{}\n"), value); });
    }
    text.put(FMT_COMPILE("</{}>\n"), of);
}

void put_points(TextWriter& text, const VtkGrid& grid) {
    put_data(text, "PointData", grid.of_points);
    put_data(text, "CellData", grid.of_cells);
    text.put("<Points>\n");
    put_array(text, "Float64", "Points", " NumberOfComponents=\"3\"", grid.points,
              [&](const Point3& p) { text.put(FMT_COMPILE("{} {} {}\n"), p.x, p.y, p.z); });
    text.put("</Points>\n");
}

void put_head(TextWriter& text, const VtkGrid& grid, std::string_view type) {
    text.put(FMT_COMPILE("<?xml version=\"1.0\"?>\n<!-- {} -->\n"
                         "<VTKFile type=\"{}\" version=\"1.0\" byte_order=\"LittleEndian\" "
                         "header_type=\"UInt64\">\n<{}>\n"),
             grid.title, type, type);
}

void put_foot(TextWriter& text, std::string_view type) {
    text.put(FMT_COMPILE("</Piece>\n</{}>\n</VTKFile>\n"), type);
    text.flush();
}

}  // namespace

void write_vtk(std::ostream& out, const VtkGrid& grid) {
    const std::size_t cells = grid.kinds.size();
    TextWriter text(out);
    text.put(FMT_COMPILE("# vtk DataFile Version 3.0\n{}\nASCII\nDATASET UNSTRUCTURED_GRID\n"),
             grid.title);
    text.put(FMT_COMPILE("POINTS {} double\n"), grid.points.size());
    for (const auto& [x, y, z] : grid.points) text.put(FMT_COMPILE("{} {} {}\n"), x, y, z);
    const std::size_t numbers = (grid.faces.empty() ? grid.corners : grid.faces).size();
    text.put(FMT_COMPILE("CELLS {} {}\n"), cells, cells + numbers);
    for (std::size_t cell = 0; cell < cells; ++cell) {
        const Numbers told = told_of(grid, cell);
        text.put(FMT_COMPILE("{} {}\n"), told.size(), fmt::join(told, " "));
    }
    text.put(FMT_COMPILE("CELL_TYPES {}\n"), cells);
    for (const VtkCell kind : grid.kinds) text.put(FMT_COMPILE("{}\n"), static_cast<int>(kind));
    put_columns(text, "POINT_DATA", grid.points.size(), grid.of_points);
    put_columns(text, "CELL_DATA", cells, grid.of_cells);
    text.flush();
}

void write_vtu(std::ostream& out, const VtkGrid& grid) {
    TextWriter text(out);
    put_head(text, grid, "UnstructuredGrid");
    text.put(FMT_COMPILE("<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n"),
             grid.points.size(), grid.kinds.size());
    put_points(text, grid);
    text.put("<Cells>\n");
    put_numbers(text, "connectivity", grid.corners);
    put_numbers(text, "offsets", grid.ends);
    put_array(text, "UInt8", "types", "", grid.kinds,
              [&](VtkCell kind) { text.put(FMT_COMPILE("{}\n"), static_cast<int>(kind)); });
    if (!grid.faces.empty()) {
        put_numbers(text, "faces", grid.faces);
        put_numbers(text, "faceoffsets", grid.face_ends);
    }
    text.put("</Cells>\n");
    put_foot(text, "UnstructuredGrid");
}

void write_pvtu(std::ostream& out, const VtkGrid& one, std::span<const std::string> pieces) {
    TextWriter text(out);
    put_head(text, one, "PUnstructuredGrid");
    const auto put_columns_of = [&](std::string_view of, std::span<const VtkColumn> columns) {
        text.put(FMT_COMPILE("<{}>\n"), of);
        for (const VtkColumn& column : columns)
            text.put(FMT_COMPILE("<PDataArray type=\"{}\" Name=\"{}\"/>\n"),
                     column.is_whole ? "Int32" : "Float64", column.name);
        text.put(FMT_COMPILE("</{}>\n"), of);
    };
    put_columns_of("PPointData", one.of_points);
    put_columns_of("PCellData", one.of_cells);
    text.put(
        "<PPoints>\n<PDataArray type=\"Float64\" Name=\"Points\" "
        "NumberOfComponents=\"3\"/>\n</PPoints>\n");
    for (const std::string& piece : pieces)
        text.put(FMT_COMPILE("<Piece Source=\"{}\"/>\n"), piece);
    text.put("</PUnstructuredGrid>\n</VTKFile>\n");
    text.flush();
}

void write_vtp(std::ostream& out, const VtkGrid& grid) {
    const auto count = [&](VtkCell last) {
        return static_cast<std::size_t>(std::ranges::upper_bound(grid.kinds, last) -
                                        grid.kinds.begin());
    };
    const std::size_t vertices = count(VtkCell::vertex);
    const std::size_t lines = count(VtkCell::line);
    const std::size_t cells = grid.kinds.size();
    TextWriter text(out);
    put_head(text, grid, "PolyData");
    text.put(FMT_COMPILE("<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"{}\" "
                         "NumberOfStrips=\"0\" NumberOfPolys=\"{}\">\n"),
             grid.points.size(), vertices, lines - vertices, cells - lines);
    put_points(text, grid);
    const auto put_section = [&](std::string_view name, std::size_t begin, std::size_t end) {
        const std::int64_t before = begin == 0 ? 0 : grid.ends[begin - 1];
        std::vector<std::int64_t> ends;
        for (std::size_t cell = begin; cell < end; ++cell) ends.push_back(grid.ends[cell] - before);
        const auto size = static_cast<std::size_t>(ends.empty() ? 0 : ends.back());
        text.put(FMT_COMPILE("<{}>\n"), name);
        put_numbers(text, "connectivity",
                    Numbers(grid.corners).subspan(static_cast<std::size_t>(before), size));
        put_numbers(text, "offsets", ends);
        text.put(FMT_COMPILE("</{}>\n"), name);
    };
    put_section("Verts", 0, vertices);
    put_section("Lines", vertices, lines);
    put_section("Polys", lines, cells);
    put_foot(text, "PolyData");
}

}  // namespace signum
