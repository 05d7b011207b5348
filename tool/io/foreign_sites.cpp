#include "foreign_sites.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <vector>

#include <fmt/format.h>

#include "number.hpp"

namespace signum {
namespace {

struct Format {
    std::string_view mark;  ///< with which the first line that has something begins
    std::string_view name;
    std::string_view way;  ///< to go on
};
constexpr std::string_view as_table =
    "is not read; save the points as CSV with a header x,y[,r], or as GeoJSON, such as by ogr2ogr "
    "or "
    "QGIS's Export";
constexpr std::string_view as_mesh = "is not read; save the vertices as PLY";
constexpr std::string_view as_atoms = "is not read; save the atoms as PDB, mmCIF, XYZ or PQR";

/// Those that come in XML, by what stands near the beginning.
constexpr auto xml = std::to_array<Format>({{"<kml", "KML", as_table},
                                            {"<gpx", "GPX", as_table},
                                            {"<gml:", "GML", as_table},
                                            {"<osm", "OpenStreetMap's XML", as_table},
                                            {"<VTKFile", "VTK's XML", as_mesh},
                                            {"<svg", "a picture in SVG", as_table},
                                            {"<html", "a page in HTML", as_table}});
constexpr auto formats = std::to_array<Format>(
    {{"# vtk DataFile", "VTK's legacy format", as_mesh},
     {"solid ", "STL", as_mesh},
     {"OFF", "OFF", "is no list of sites by its ending; add --read-as off"},
     {"COFF", "OFF with colors", as_mesh},
     {"NOFF", "OFF with normals", as_mesh},
     {"ply", "PLY", "is no list of sites by its ending; add --read-as ply"},
     {"@<TRIPOS>", "MOL2", as_atoms},
     {"ITEM: TIMESTEP", "a dump of LAMMPS", "is known by its ending; add --read-as lammpstrj"},
     {"LAMMPS data file", "LAMMPS' data", as_atoms},
     {"data_", "CIF", "is known by its ending; add --read-as cif"},
     {"HEADER    ", "PDB", "is known by its ending; add --read-as pdb"},
     {"CRYST1", "PDB", "is known by its ending; add --read-as pdb"},
     {"TITLE     ", "PDB", "is known by its ending; add --read-as pdb"},
     {"REMARK ", "PDB or PQR", "is known by its ending; add --read-as pdb or --read-as pqr"},
     {"$MeshFormat", "Gmsh's format", as_mesh},
     {"%!PS", "PostScript", as_table},
     {"%PDF", "PDF", as_table},
     {"POINT(", "WKT", as_table},
     {"POINT (", "WKT", as_table},
     {"POINT Z", "WKT", as_table},
     {"MULTIPOINT", "WKT", as_table},
     {"POLYGON", "WKT", as_table},
     {"LINESTRING", "WKT", as_table}});

std::string message(const Format& format) {
    return fmt::format("this is {}, which {}", format.name, format.way);
}

bool is_whole_number(std::string_view line) {
    const std::size_t begin = std::min(line.find_first_not_of(" \t"), line.size());
    line.remove_prefix(begin);
    line = line.substr(0, line.find_last_not_of(" \t\r") + 1);
    return parse_whole_number(line).has_value();
}
bool has_letter(std::string_view text) {
    return std::ranges::any_of(
        text, [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; });
}

}  // namespace

std::string other_format(std::string_view beginning) {
    constexpr std::size_t most_lines = 40;
    std::vector<std::string_view> lines;
    for (std::size_t begin = 0; begin < beginning.size() && lines.size() < most_lines;) {
        const std::size_t end = std::min(beginning.find('\n', begin), beginning.size());
        const std::string_view line = beginning.substr(begin, end - begin);
        const std::size_t text = line.find_first_not_of(" \t\r");
        const bool is_comment = text != std::string_view::npos && line[text] == '#' &&
                                !line.substr(text).starts_with(formats.front().mark);
        if (!is_comment && (!lines.empty() || text != std::string_view::npos))
            lines.push_back(line);
        begin = end + 1;
    }
    if (lines.empty()) return {};
    std::string_view first = lines[0];
    first.remove_prefix(first.find_first_not_of(" \t"));
    if (first.starts_with('<')) {
        constexpr std::size_t head = 4000;
        for (const Format& format : xml)
            if (beginning.substr(0, head).find(format.mark) != std::string_view::npos)
                return message(format);
        return message({"", "XML", as_table});
    }
    for (const Format& format : formats) {
        if (!first.starts_with(format.mark)) continue;
        // A header may begin with the same letters.
        const char next = first.size() > format.mark.size() ? first[format.mark.size()] : ' ';
        const bool is_word = std::isalnum(static_cast<unsigned char>(format.mark.back())) == 0 ||
                             format.mark.ends_with('_') || next == ' ' || next == '\r' ||
                             next == '(';
        const bool is_alone = format.mark.size() > 5 || format.mark == "%PDF" ||
                              first.find_first_of(",;\t") == std::string_view::npos;
        if (is_word && is_alone) return message(format);
    }
    // An atom of PDB whose file has no head.
    if ((first.starts_with("ATOM  ") || first.starts_with("HETATM")) && first.size() >= 54)
        return message(
            {"", "PDB or PQR", "is known by its ending; add --read-as pdb or --read-as pqr"});
    if (lines.size() < 3) return {};
    if (is_whole_number(lines[0]) && has_letter(lines[2]) &&
        lines[2].find_first_of(",;") == std::string_view::npos)
        return message({"", "XYZ", "is known by its ending; add --read-as xyz"});
    constexpr std::size_t least_of_gro = 44;
    if (is_whole_number(lines[1]) && lines[2].size() >= least_of_gro && lines[2].find('.') >= 20 &&
        has_letter(lines[2].substr(0, 20)))
        return message({"", "GRO", "is known by its ending; add --read-as gro"});
    std::size_t vertices = 0;
    for (const std::string_view line : lines) {
        if (line.find("xlo xhi") != std::string_view::npos)
            return message({"", "LAMMPS' data", as_atoms});
        vertices += line.starts_with("v ") ? 1 : 0;
    }
    if (vertices > 2) return message({"", "OBJ", as_mesh});
    // Behind a title, a factor, three vectors, symbols and numbers, and perhaps a word on dynamics.
    for (std::size_t k = 5; k < std::min<std::size_t>(lines.size(), 9); ++k)
        if (lines[k].starts_with("Direct") || lines[k].starts_with("Cartesian"))
            return message({"", "POSCAR", as_atoms});
    return {};
}

}  // namespace signum
