/// Files of other programs: nodes of Triangle and TetGen in and out, grids of VTK, PLY, well-known
/// text, and attributes of sites that are carried from file to file.

#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "../../tool/io/read_sites.hpp"
#include "../../tool/io/write_sites.hpp"
#include "../../tool/io/write_space_cells.hpp"
#include "../../tool/io/write_tessellation.hpp"
#include "../../tool/io/write_voronoi.hpp"
#include "../../triangulation/space/triangulate.hpp"
#include "../../triangulation/triangulate.hpp"
#include "../../voronoi/space/cells.hpp"

#include "io_refusal.hpp"
#include "io_scratch.hpp"

namespace signum {
namespace {

using Sites = std::vector<Site>;
using Sites3 = std::vector<Site3>;

SitesFile read(std::string_view contents, const ReadOptions& options) {
    const test::Scratch scratch;
    return read_sites(scratch.file("f", contents), options);
}

SitesFile nodes(std::string_view contents, const Columns& columns = {}) {
    return read(contents, {.columns = columns, .input = SitesInput::node});
}

template <class Write>
std::string text_of(const Write& write) {
    std::ostringstream out;
    write(out);
    return out.str();
}

/// The error message that reading nodes gives, without the path and the advice behind it.
std::string error(std::string_view contents, const ReadOptions& options) {
    return test::refusal(contents,
                         [&](const std::string& path) { return read_sites(path, options); });
}
std::string wrong(std::string_view contents, const Columns& columns = {}) {
    return error(contents, {.columns = columns, .input = SitesInput::node});
}

const Sites hard = {{0.1, 4.9e-324, 1}, {1.7976931348623157e308, -0.0, 2}, {1. / 3, 5, 0}};
const Sites square = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 3, 0}};
const Sites3 corner = {{0, 0, 0, 1}, {2, 0, 0, 1}, {0, 2, 0, 1}, {0, 0, 2, 1}, {2, 2, 2, 1.5}};

TEST(NodeSites, AreNumberedFromZeroOrOne) {
    for (const std::string head : {"# of a box\n3 2\n0", "3 2 0 0\n 1"}) {
        const int first = head.back() - '0';
        const SitesFile file = nodes(head + " 1 2.5 # the first\n\n" + std::to_string(first + 1) +
                                     " 0x1p-3 -4\n" + std::to_string(first + 2) + " 1e308 0");
        EXPECT_EQ(file.dimension, 2);
        EXPECT_EQ(file.sites, (Sites{{1, 2.5, 0}, {0.125, -4, 0}, {1e308, 0, 0}}));
        EXPECT_EQ(file.first_number, first);
        EXPECT_EQ(file.note, "");
        EXPECT_TRUE(file.first_beyond_single);
    }
    const SitesFile space = nodes("2 3\n1 1 2 3\n2 4 5 6\n");
    EXPECT_EQ(space.dimension, 3);
    EXPECT_EQ(space.in_space, (Sites3{{1, 2, 3, 0}, {4, 5, 6, 0}}));
}

TEST(NodeSites, LeaveOutAttributesAndMarkersWithAWord) {
    const std::string file = "2 2 2 1\n0 1 2 -3 4 1\n1 5 6 7 8 0\n";
    EXPECT_EQ(nodes(file).sites, (Sites{{1, 2, 0}, {5, 6, 0}}));
    const std::string note = nodes(file).note;
    EXPECT_NE(
        note.find("2 attributes and the boundary markers are left out: no attribute is "
                  "called a radius; --columns 2,3,4 takes the first one for it. --columns 2,3 "
                  "leaves all of it out without a word"),
        std::string::npos)
        << note;
    EXPECT_NE(nodes("1 3 1\n0 1 2 3 4\n").note.find(": an attribute is left out: "),
              std::string::npos);
    EXPECT_NE(nodes("1 3 0 1\n0 1 2 3 4\n").note.find(": the boundary markers are left out. "),
              std::string::npos);
    EXPECT_EQ(nodes(file, {"2", "3"}).note, "");
    const SitesFile chosen = nodes(file, {"2", "3", "4"});
    EXPECT_EQ(chosen.sites, (Sites{{1, 2, -3}, {5, 6, 7}}));
    EXPECT_EQ(chosen.note, "");
    ASSERT_TRUE(chosen.first_negative);
    EXPECT_EQ(chosen.first_negative->line, 2);
    EXPECT_EQ(chosen.first_negative->column, 7);
    const SitesFile all = read(file, {.input = SitesInput::node, .attributes = true});
    EXPECT_EQ(all.attributes, (std::vector<Attribute>{{"attribute1", {"-3", "7"}, true},
                                                      {"attribute2", {"4", "8"}, true},
                                                      {"marker", {"1", "0"}, true}}));
}

TEST(NodeSites, RefuseWhatIsWrongAtItsPlace) {
    const auto begins = [](const std::string& message, std::string_view start) {
        EXPECT_TRUE(message.starts_with(start)) << message;
    };
    begins(wrong(""), "1:1: no point in this file; a .node file begins with");
    begins(wrong("0 2\n"), "1:1: no point in this file");
    begins(wrong("3\n"), "1:2: the dimension is missing; the first line is");
    begins(wrong("3 2 0 0 0\n"), "1:9: one word more");
    begins(wrong("3 x\n"), "1:3: 'x' is no whole number");
    begins(wrong("-3 2\n"), "1:1: '-3' is no whole number");
    begins(wrong("3 4\n"), "1:3: the dimension of the points is 2 or 3");
    begins(wrong("3 2 1001\n"), "1:5: at most 1000 attributes");
    begins(wrong("3 2 0 2\n"), "1:7: there are 0 or 1 boundary markers");
    begins(wrong("2 2\n2 1 1\n"), "2:1: points are numbered from 0 or from 1");
    begins(wrong("2 2\n1 1 1\n3 1 1\n"), "3:1: '3' where point 2 comes");
    begins(wrong("2 2\n1 1 1\n"), "2:1: the file ends after 1 of 2 points");
    begins(wrong("18446744073709551615 2\n1 1 1\n"), "2:1: the file ends after 1 of 1844674407");
    begins(wrong("1 2\n1 1 1\n2 1 1\n"), "3:1: a line beyond the 1 points");
    begins(wrong("1 2\n1 1\n"), "2:4: 2 words, but by the first line a point has 3");
    begins(wrong("1 2\n1 1 1 1\n"), "2:7: 4 words, but");
    begins(wrong("1 2\n1 1 y\n"), "2:5: 'y'");
    begins(wrong("1 2\n1 1 1e999\n"), "2:5: ");
    begins(wrong("1 2\n1 1 2\n", {"2"}), "1:3: 1 columns are chosen");
    begins(wrong("1 2\n1 1 2\n", {"2", "4"}), "1:1: column '4' is chosen");
    begins(wrong("1 2\n1 1 2\n", {"2", "x"}), "1:1: column 'x' is chosen");
    begins(wrong("1 2\n1 1 2\n", {"2", "2"}), "1:1: column 2 is chosen twice");
    begins(error("1 3\n1 1 2 3\n", {.dimension = 2, .input = SitesInput::node}),
           "1:3: the points have 3 dimensions, and sites of the plane are asked for");
}

TEST(NodeSites, ReadBackToTheSame) {
    const std::string text =
        text_of([](std::ostream& out) { write_sites(out, hard, SitesFormat::node); });
    EXPECT_EQ(text,
              "3 2 1 0\n0 0.1 5e-324 1\n1 1.7976931348623157e+308 -0 2\n2 0.3333333333333333 5 "
              "0\n");
    EXPECT_EQ(nodes(text, {"2", "3", "4"}).sites, hard);
    const std::string in_space =
        text_of([](std::ostream& out) { write_sites(out, corner, SitesFormat::node); });
    EXPECT_EQ(nodes(in_space, {"2", "3", "4", "5"}).in_space, corner);
}

TEST(Elements, AreTheFiniteFacesAndCells) {
    const Tessellation plane = triangulate(square, Power{});
    EXPECT_EQ(text_of([&](std::ostream& out) { write_ele(out, plane); }),
              "2 3 0\n0 0 1 2\n1 1 3 2\n");
    EXPECT_EQ(text_of([&](std::ostream& out) { write_neigh(out, plane); }),
              "2 3\n0 1 -1 -1\n1 -1 0 -1\n");
    EXPECT_EQ(text_of([&](std::ostream& out) { write_ele(out, plane, 1); }),
              "2 3 0\n1 1 2 3\n2 2 4 3\n");
    EXPECT_EQ(text_of([&](std::ostream& out) { write_neigh(out, plane, 1); }),
              "2 3\n1 2 -1 -1\n2 -1 1 -1\n");
    EXPECT_EQ(text_of([](std::ostream& out) { write_sites(out, square, SitesFormat::node, 1); }),
              "4 2 1 0\n1 0 0 0\n2 2 0 0\n3 0 2 0\n4 2 3 0\n");
    const SpaceTessellation space = triangulate(corner, Power{});
    EXPECT_EQ(text_of([&](std::ostream& out) { write_ele(out, space); }),
              "3 4 0\n0 0 1 2 4\n1 0 1 4 3\n2 0 2 3 4\n");
    EXPECT_EQ(text_of([&](std::ostream& out) { write_neigh(out, space); }),
              "3 4\n0 -1 2 1 -1\n1 -1 2 -1 0\n2 -1 1 0 -1\n");
    const SpaceTessellation flat = triangulate(Sites3{{0, 0, 0, 0}, {1, 1, 1, 0}}, Power{});
    EXPECT_EQ(text_of([&](std::ostream& out) { write_ele(out, flat); }), "0 4 0\n");
}

TEST(Vtk, HasFacesOfThePlane) {
    const VtkGrid grid = vtk_grid(triangulate(square, Power{}));
    EXPECT_EQ(text_of([&](std::ostream& out) { write_vtk(out, grid); }),
              "# vtk DataFile Version 3.0\nsignum: power tessellation\nASCII\n"
              "DATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n0 0 0\n2 0 0\n0 2 0\n2 3 0\n"
              "CELLS 2 8\n3 0 1 2\n3 1 3 2\nCELL_TYPES 2\n5\n5\nPOINT_DATA 4\n"
              "SCALARS radius double 1\nLOOKUP_TABLE default\n0\n0\n0\n0\n"
              "SCALARS hidden int 1\nLOOKUP_TABLE default\n0\n0\n0\n0\n");
}

TEST(Vtk, HasLinesWhereNoFaceIs) {
    const Sites line = {{0, 0, 1}, {4, 0, 1}, {9, 0, 1}, {9, 0.25, 0.125}};
    const VtkGrid grid = vtk_grid(triangulate(line, Euclidean{}));
    EXPECT_EQ(grid.kinds, (std::vector{VtkCell::line, VtkCell::line}));
    EXPECT_EQ(grid.corners, (std::vector<std::int64_t>{0, 1, 1, 2}));
    const std::string text = text_of([&](std::ostream& out) { write_vtp(out, grid); });
    EXPECT_NE(text.find("<Piece NumberOfPoints=\"4\" NumberOfVerts=\"0\" NumberOfLines=\"2\" "
                        "NumberOfStrips=\"0\" NumberOfPolys=\"0\">"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("Name=\"hidden\" format=\"ascii\">\n0\n0\n0\n1\n</DataArray>"),
              std::string::npos)
        << text;
}

TEST(Vtk, HasTheBytesOfOneTetrahedron) {
    const Sites3 four(corner.begin(), corner.begin() + 4);
    const VtkGrid grid = vtk_grid(triangulate(four, Power{}), four, WeightIs::weight);
    EXPECT_EQ(text_of([&](std::ostream& out) { write_vtu(out, grid); }),
              R"(<?xml version="1.0"?>
<!-- signum: power tessellation of space -->
<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian" header_type="UInt64">
<UnstructuredGrid>
<Piece NumberOfPoints="4" NumberOfCells="1">
<PointData>
<DataArray type="Float64" Name="weight" format="ascii">
1
1
1
1
</DataArray>
<DataArray type="Int32" Name="hidden" format="ascii">
0
0
0
0
</DataArray>
</PointData>
<CellData>
</CellData>
<Points>
<DataArray type="Float64" Name="Points" NumberOfComponents="3" format="ascii">
0 0 0
2 0 0
0 2 0
0 0 2
</DataArray>
</Points>
<Cells>
<DataArray type="Int64" Name="connectivity" format="ascii">
0
1
2
3
</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">
4
</DataArray>
<DataArray type="UInt8" Name="types" format="ascii">
10
</DataArray>
</Cells>
</Piece>
</UnstructuredGrid>
</VTKFile>
)");
}

TEST(Ply, ReadsBackToTheSame) {
    const Tessellation tessellation = triangulate(square, Manhattan{});
    const std::string text = text_of([&](std::ostream& out) { write_ply(out, tessellation); });
    EXPECT_NE(text.find("element face 2\nproperty list uchar int vertex_indices\nend_header\n0 0 0 "
                        "0\n2 0 0 0\n0 2 0 0\n2 3 0 0\n3 0 1 2\n3 1 3 2\n"),
              std::string::npos)
        << text;
    for (const WeightIs third : {WeightIs::radius, WeightIs::weight}) {
        const SitesFile file =
            read(text_of([&](std::ostream& out) { write_ply(out, corner, third); }),
                 {.input = SitesInput::ply});
        EXPECT_EQ(file.in_space, corner);
        EXPECT_EQ(file.third, third);
    }
}

const std::string cities =
    "x,y,r,name,code,rank,area\n0,0,1,\"New \"\"York\"\"\",007,1,5\n4,0,1,Zürich,1,,-2.5e1\n"
    "0,4,1,\"a, b\",2,3,\n4,4,0,,3,4,1\n";

TEST(Attributes, AreNumbersWhereJsonHasThem) {
    const SitesFile file = read(cities, {.attributes = true});
    EXPECT_EQ(file.attributes,
              (std::vector<Attribute>{{"name", {"New \"York\"", "Zürich", "a, b", ""}, false},
                                      {"code", {"007", "1", "2", "3"}, false},
                                      {"rank", {"1", "", "3", "4"}, true},
                                      {"area", {"5", "-2.5e1", "", "1"}, true}}));
    EXPECT_TRUE(read(cities, {}).attributes.empty());
    EXPECT_EQ(read(cities, {}).sites, file.sites);
    const SitesFile chosen = read(cities, {.columns = {"2", "x"}, .attributes = true});
    ASSERT_EQ(chosen.attributes.size(), 5U);
    EXPECT_EQ(chosen.attributes[0].name, "r");
    const SitesFile in_space = read("x,y,z,name\n1,2,3,Gea Norvegica\n", {.attributes = true});
    EXPECT_EQ(in_space.attributes, (std::vector<Attribute>{{"name", {"Gea Norvegica"}, false}}));
    for (const char* number : {"0", "-0", "10", "0.50", "1e5", "1E+05", "-1.5e-3"})
        EXPECT_TRUE(is_json_number(number)) << number;
    for (const char* word : {"", "-", "01", "+1", ".5", "5.", "1e", "0x1", "1 ", "nan", "1.e5"})
        EXPECT_FALSE(is_json_number(word)) << word;
}

TEST(Attributes, AreCarriedToFeaturesAndTables) {
    SitesFile file = read(cities, {.attributes = true});
    file.attributes.push_back({"area", {"9007199254740993", "1", "2", "3"}, true});
    file.attributes.push_back({"byte", {"\xff", "\n", "", ""}, false});
    const Voronoi diagram(triangulate(file.sites, Euclidean{}));
    const Box box = {-1, -1, 5, 5};
    const ClippedVoronoi clipped(diagram, box);
    const std::string text = text_of(
        [&](std::ostream& out) { write_voronoi_geojson(out, clipped, box, 0.1, file.attributes); });
    const auto features = nlohmann::json::parse(text).at("features");
    ASSERT_EQ(features.size(), 4U);
    const auto& first = features[0].at("properties");
    EXPECT_EQ(first.at("name"), "New \"York\"");
    EXPECT_EQ(first.at("code"), "007");
    EXPECT_EQ(first.at("rank"), 1);
    EXPECT_EQ(first.at("input_area"), 5);
    EXPECT_EQ(first.at("input_area_2"), 9007199254740993);
    EXPECT_EQ(first.at("byte"), "\xef\xbf\xbd");
    EXPECT_EQ(first.at("area"), 9);
    EXPECT_TRUE(features[1].at("properties").at("rank").is_null());
    EXPECT_EQ(features[1].at("properties").at("name"), "Zürich");
    EXPECT_EQ(features[3].at("properties").at("name"), "");
    const std::string table = text_of([&](std::ostream& out) {
        write_voronoi_csv(out, clipped, 0.1, std::span(file.attributes).first(4));
    });
    EXPECT_TRUE(
        table.starts_with("site,x,y,radius,unbounded,clipped,area,perimeter,centroid_x,"
                          "centroid_y,neighbours,name,code,rank,input_area,WKT\n"))
        << table;
    EXPECT_NE(table.find(",\"New \"\"York\"\"\",007,1,5,\"POLYGON (("), std::string::npos) << table;
}

TEST(WellKnownText, IsALineASite) {
    const Sites sites = {{0, 0, 2}, {0.5, 0, 0}, {4, 0, 2}};
    const Voronoi diagram(triangulate(sites, Euclidean{}));
    const ClippedVoronoi clipped(diagram, {-1, -1, 5, 1});
    EXPECT_EQ(
        text_of([&](std::ostream& out) { write_voronoi_wkt(out, clipped, 0.1); }),
        "POLYGON ((2 1, -1 1, -1 -1, 2 -1, 2 1))\nPOLYGON EMPTY\nPOLYGON ((2 -1, 5 -1, 5 1, 2 1, "
        "2 -1))\n");
    const VtkGrid grid = vtk_grid(clipped, 0.1);
    EXPECT_EQ(grid.kinds, (std::vector{VtkCell::polygon, VtkCell::polygon}));
    EXPECT_EQ(grid.ends, (std::vector<std::int64_t>{4, 8}));
    EXPECT_EQ(grid.of_cells[0].values, (std::vector<double>{0, 2}));
    EXPECT_EQ(grid.of_cells[2].values, (std::vector<double>{6, 6}));
}

}  // namespace
}  // namespace signum
