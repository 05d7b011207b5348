/// The files of cells of space, read back.

#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "../../io/write_space_cells.hpp"

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

TEST(SpaceCellsFiles, TheGridHasThePolyhedra) {
    std::ostringstream out;
    write_space_cells_vtk(out, cells(), polyhedra());
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
