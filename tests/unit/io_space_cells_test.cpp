/// The files of cells of space, read back.

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "../../tool/draw/svg.hpp"
#include "../../tool/io/write_space_cells.hpp"

namespace signum {
namespace {

/// A ball that hides another one, and two beside them.
const std::vector<Site3> sites = {
    {0.1, 0.2, 0.3, 0.25}, {0.1, 0.2, 0.3, 0.1}, {0.7, 0.2, 0.4, 0.1}, {0.3, 0.9, 0.7, 0.0}};
constexpr Box3 box = {{0, 0, 0}, {1, 1, 1}};

SpaceCells cells() {
    return space_cells(triangulate(std::span<const Site3>(sites)), std::span<const Site3>(sites),
                       box);
}
std::vector<SpacePolyhedron> polyhedra() {
    return space_polyhedra(triangulate(std::span<const Site3>(sites)),
                           std::span<const Site3>(sites), box, std::vector<Index>{0, 1, 2, 3});
}

std::vector<std::string> parts(const std::string& text, char separator) {
    std::vector<std::string> result;
    std::istringstream in(text);
    for (std::string part; std::getline(in, part, separator);) result.push_back(part);
    return result;
}
double number(const std::string& text) {
    return std::strtod(text.c_str(), nullptr);
}

TEST(SpaceCellsFiles, TheTableHasTheNumbers) {
    std::ostringstream out;
    write_space_cells_csv(out, cells());
    const auto lines = parts(out.str(), '\n');
    ASSERT_EQ(lines.size(), 5U);
    EXPECT_EQ(lines[0],
              "site,volume,area,centroid_x,centroid_y,centroid_z,faces,neighbours,face_areas");
    EXPECT_EQ(lines[2], "1,0,0,0.1,0.2,0.3,0,,");
    const SpaceCells expected = cells();
    for (std::size_t s : {0U, 2U, 3U}) {
        const auto columns = parts(lines[s + 1], ',');
        ASSERT_EQ(columns.size(), 9U);
        const SpaceMeasure& measure = expected.measures[s];
        EXPECT_EQ(number(columns[0]), static_cast<double>(s));
        EXPECT_EQ(number(columns[1]), measure.volume);
        EXPECT_EQ(number(columns[2]), measure.area);
        EXPECT_EQ(number(columns[3]), measure.centroid.x);
        EXPECT_EQ(number(columns[4]), measure.centroid.y);
        EXPECT_EQ(number(columns[5]), measure.centroid.z);
        const auto faces = expected.faces_of(static_cast<Index>(s));
        EXPECT_EQ(number(columns[6]), static_cast<double>(faces.size()));
        const auto neighbours = parts(columns[7], ' ');
        const auto areas = parts(columns[8], ' ');
        ASSERT_EQ(neighbours.size(), faces.size());
        ASSERT_EQ(areas.size(), faces.size());
        for (std::size_t f = 0; f < faces.size(); ++f) {
            EXPECT_EQ(number(neighbours[f]), faces[f].beyond);
            EXPECT_EQ(number(areas[f]), faces[f].area);
        }
    }
}

TEST(SpaceCellsFiles, TheTableLeavesOutWhatNoDoubleReaches) {
    const std::vector<Site3> apart = {{-1e150, 0, 0, 0}, {1e150, 0, 0, 0}};
    const std::span<const Site3> all(apart);
    std::ostringstream out;
    write_space_cells_csv(
        out, space_cells(triangulate(all), all, {{-1e160, -1e160, -1e160}, {1e160, 1e160, 1e160}}));
    EXPECT_EQ(out.str().find("inf"), std::string::npos) << out.str();
    EXPECT_EQ(out.str().find("nan"), std::string::npos) << out.str();
    const auto columns = parts(parts(out.str(), '\n')[1], ',');
    ASSERT_EQ(columns.size(), 9U);
    EXPECT_EQ(columns[1], "");
    EXPECT_EQ(columns[6], "6");
    EXPECT_EQ(std::ranges::count(columns[8], ' '), 5);
}

TEST(SpaceCellsFiles, JsonHasTheDiagram) {
    // A tetrahedron, whose vertex is (1, 1, 1), and a site beside its first one that this one
    // hides.
    const std::vector<Site3> corners = {
        {0, 0, 0, 0.5}, {2, 0, 0, 0.5}, {0, 2, 0, 0.5}, {0, 0, 2, 0.5}, {0, 0, 0.1, 0}};
    const std::span<const Site3> all(corners);
    const SpaceTessellation t = triangulate(all);
    std::ostringstream out;
    write_space_cells_json(out, space_cells(t, all, {{0, 0, 0}, {2, 2, 2}}), t, WeightIs::radius,
                           vertices(t, all));
    const std::string whole = out.str();
    EXPECT_TRUE(whole.starts_with(
        "{\"format\": \"signum.voronoi\", \"version\": 1, \"dimension\": 3, \"metric\": "
        "\"power\", \"weight_is\": \"radius\", \"sites\": 5, \"clip\": [0, 0, 0, 2, 2, 2],\n"
        "\"vertices\": [\n[1, 1, 1, 2.75]],\n"
        "\"edges\": [\n{\"sites\": [1, 2, 3], \"vertices\": [0, -1]},\n"
        "{\"sites\": [0, 3, 2], \"vertices\": [0, -1]},\n"
        "{\"sites\": [0, 1, 3], \"vertices\": [0, -1]},\n"
        "{\"sites\": [0, 2, 1], \"vertices\": [0, -1]}],\n"
        "\"cells\": [\n{\"site\": 0, \"unbounded\": true, \"clipped\": true, \"volume\": 1, "
        "\"area\": 6, \"centroid\": [0.5, 0.5, 0.5], \"faces\": [{\"neighbour\": 1, \"area\": 1}, "
        "{\"neighbour\": 2, \"area\": 1}, {\"neighbour\": 3, \"area\": 1}, {\"neighbour\": -1, "
        "\"area\": 1}, {\"neighbour\": -3, \"area\": 1}, {\"neighbour\": -5, \"area\": 1}]},\n"
        "{\"site\": 1, "))
        << whole;
    EXPECT_TRUE(whole.ends_with("]}],\n\"hidden\": [\n[4, 0]]}\n")) << whole;
}

TEST(SpaceCellsFiles, JsonOfFlatSitesHasNoVertices) {
    const std::vector<Site3> two = {{0, 0, 0, 0}, {1, 0, 0, 0}};
    const std::span<const Site3> all(two);
    const SpaceTessellation t = triangulate(all);
    std::ostringstream out;
    // The second one's cell does not reach into the box.
    write_space_cells_json(out, space_cells(t, all, {{-2, 0, 0}, {0, 1, 1}}), t, WeightIs::radius,
                           vertices(t, all));
    EXPECT_NE(out.str().find("\"vertices\": [],\n\"edges\": [],\n\"cells\": [\n{\"site\": 0, "
                             "\"unbounded\": true, \"clipped\": true, \"volume\": 2, "),
              std::string::npos)
        << out.str();
    EXPECT_NE(
        out.str().find("{\"site\": 1, \"unbounded\": true, \"clipped\": false, \"volume\": 0, "
                       "\"area\": 0, \"centroid\": null, \"faces\": []}],\n\"hidden\": []}\n"),
        std::string::npos)
        << out.str();
}

TEST(SpaceCellsFiles, ThePictureHasTheSolids) {
    const auto picture = [](std::span<const Site3> all, const Box3& where, std::size_t limit) {
        const SpaceTessellation t = triangulate(all);
        std::vector<Index> which;
        for (Index i = 0; i < static_cast<Index>(all.size()); ++i) which.push_back(i);
        std::ostringstream out;
        write_space_cells_svg(out, all, space_cells(t, all, where),
                              space_polyhedra(t, all, where, which), limit);
        return out.str();
    };
    const auto faces_of = [](const std::string& text) {
        std::size_t count = 0;
        for (std::size_t at = text.find("<polygon"); at != text.npos;
             at = text.find("<polygon", at + 1))
            ++count;
        return count;
    };
    // All cells are cut: three sides of the box are seen, and each of three cells.
    const std::string whole = picture(sites, box, 100);
    EXPECT_NE(whole.find("<title>power cells of 4 sites in space</title>"), std::string::npos);
    EXPECT_NE(whole.find("cells: 3, all cut by the box"), std::string::npos);
    // Of a cross of seven the one in the middle is a cube, of which three faces are seen.
    const std::vector<Site3> cross = {{0, 0, 0, 0},  {1, 0, 0, 0}, {-1, 0, 0, 0}, {0, 1, 0, 0},
                                      {0, -1, 0, 0}, {0, 0, 1, 0}, {0, 0, -1, 0}};
    const Box3 around = {{-2, -2, -2}, {2, 2, 2}};
    const std::string cube = picture(cross, around, 100);
    EXPECT_EQ(faces_of(cube), 3U);
    EXPECT_NE(cube.find("cells: 1 that the box does not cut are drawn, 6 that it cuts are not"),
              std::string::npos);
    EXPECT_NE(cube.find("<g><title>0, volume 1</title>"), std::string::npos);
    const std::string few = picture(cross, around, 2);
    EXPECT_EQ(faces_of(few), 2U);
    EXPECT_NE(few.find("faces: the 2 nearest of 3 drawn"), std::string::npos);
}

TEST(SpaceCellsFiles, TheDefaultBoxIsATenthWider) {
    const auto box_of = [](const std::vector<Site3>& all) { return default_box(all); };
    EXPECT_EQ(box_of({{0, 1, 2, 9}, {10, 5, 4, 9}}), (Box3{{-1, 0, 1}, {11, 6, 5}}));
    EXPECT_EQ(default_box(std::vector<Point3>{{0, 1, 2}, {10, 5, 4}}),
              (Box3{{-1, 0, 1}, {11, 6, 5}}));
    EXPECT_EQ(default_box(std::vector<power::Site3>{{0, 1, 2, -9}, {10, 5, 4, 9}}),
              (Box3{{-1, 0, 1}, {11, 6, 5}}));
    EXPECT_EQ(box_of({{1, 2, 3, 4}}), (Box3{{0, 1, 2}, {2, 3, 4}}));
    const Box3 far = box_of({{1e300, 0, 0, 0}});
    EXPECT_LT(far.low.x, far.high.x);
    constexpr double largest = std::numeric_limits<double>::max();
    const Box3 widest = box_of({{-largest, 0, 0, 0}, {largest, 0, 0, 0}});
    EXPECT_EQ(widest.low.x, -largest);
    EXPECT_EQ(widest.high.x, largest);
    constexpr double least = std::numeric_limits<double>::denorm_min();
    EXPECT_EQ(box_of({{0, 0, 0, 0}, {least, 0, 0, 0}}),
              (Box3{{-least, -least, -least}, {2 * least, least, least}}));
    EXPECT_THROW((void)box_of({}), std::invalid_argument);
    EXPECT_THROW((void)box_of({{std::numeric_limits<double>::quiet_NaN(), 0, 0, 0}}),
                 std::invalid_argument);
}

TEST(SpaceCellsFiles, TheGridHasThePolyhedra) {
    std::ostringstream out;
    write_vtk(out, vtk_grid(cells(), polyhedra()));
    std::istringstream in(out.str());
    std::string line;
    for (const char* expected : {"# vtk DataFile Version 3.0", "signum: power cells", "ASCII",
                                 "DATASET UNSTRUCTURED_GRID"}) {
        std::getline(in, line);
        EXPECT_EQ(line, expected);
    }
    std::vector<SpacePolyhedron> shown;
    std::size_t corners = 0;
    for (const SpacePolyhedron& each : polyhedra())
        if (!each.corners.empty()) {
            shown.push_back(each);
            corners += each.corners.size();
        }
    ASSERT_EQ(shown.size(), 3U);
    std::string word;
    std::size_t count = 0;
    in >> word >> count >> line;
    EXPECT_EQ(word, "POINTS");
    ASSERT_EQ(count, corners);
    EXPECT_EQ(line, "double");
    const auto next = [&] {
        in >> word;
        return number(word);
    };
    for (const SpacePolyhedron& each : shown)
        for (const Point3& p : each.corners) {
            EXPECT_EQ(next(), p.x);
            EXPECT_EQ(next(), p.y);
            EXPECT_EQ(next(), p.z);
        }
    std::size_t numbers = 0;
    in >> word >> count >> numbers;
    EXPECT_EQ(word, "CELLS");
    ASSERT_EQ(count, 3U);
    std::size_t first = 0;
    std::size_t read = 0;
    for (const SpacePolyhedron& each : shown) {
        std::size_t length = 0;
        std::size_t faces = 0;
        in >> length >> faces;
        ASSERT_EQ(faces, each.beyond.size());
        read += length + 1;
        std::size_t left = length - 1;
        for (std::size_t f = 0; f < faces; ++f) {
            std::size_t size = 0;
            in >> size;
            left -= size + 1;
            ASSERT_EQ(size, each.corners_of(f).size());
            for (const Index corner : each.corners_of(f))
                EXPECT_EQ(next(), static_cast<double>(first + static_cast<std::size_t>(corner)));
        }
        EXPECT_EQ(left, 0U);
        first += each.corners.size();
    }
    EXPECT_EQ(read, numbers);
    in >> word >> count;
    EXPECT_EQ(word, "CELL_TYPES");
    for (std::size_t k = 0; k < count; ++k) EXPECT_EQ(next(), 42.0);
    in >> word >> count;
    EXPECT_EQ(word, "CELL_DATA");
    ASSERT_EQ(count, 3U);
    const SpaceCells all = cells();
    for (const char* name : {"site", "volume", "faces"}) {
        std::string type;
        in >> word >> line >> type >> count;
        EXPECT_EQ(line, name);
        in >> word >> line;
        for (const SpacePolyhedron& each : shown) {
            const double value = next();
            EXPECT_EQ(value, line.empty()                  ? 0.0
                             : std::string(name) == "site" ? each.site
                             : std::string(name) == "volume"
                                 ? all.measures[static_cast<std::size_t>(each.site)].volume
                                 : static_cast<double>(each.beyond.size()));
        }
    }
    in >> word;
    EXPECT_TRUE(in.eof());
}

}  // namespace
}  // namespace signum
