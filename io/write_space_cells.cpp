#include "write_space_cells.hpp"

#include <cstddef>

#include "text_writer.hpp"

namespace signum {

void write_space_cells_csv(std::ostream& out, const SpaceCells& cells) {
    TextWriter text(out);
    text.put("site,volume,area,centroid_x,centroid_y,centroid_z,faces,neighbours,face_areas\n");
    for (std::size_t i = 0; i < cells.measures.size(); ++i) {
        const auto& [volume, area, centroid] = cells.measures[i];
        const auto faces = cells.faces_of(static_cast<Index>(i));
        text.put(FMT_COMPILE("{},{},{},{},{},{},{},"), i, volume, area, centroid.x, centroid.y,
                 centroid.z, faces.size());
        const char* blank = "";
        for (const SpaceFace& face : faces) {
            text.put(FMT_COMPILE("{}{}"), blank, face.beyond);
            blank = " ";
        }
        text.put(",");
        blank = "";
        for (const SpaceFace& face : faces) {
            text.put(FMT_COMPILE("{}{}"), blank, face.area);
            blank = " ";
        }
        text.put("\n");
    }
    text.flush();
}

void write_space_cells_vtk(std::ostream& out, const SpaceCells& cells,
                           std::span<const SpacePolyhedron> polyhedra) {
    std::vector<const SpacePolyhedron*> shown;
    std::size_t corners = 0;
    std::size_t numbers = 0;
    for (const SpacePolyhedron& each : polyhedra) {
        if (each.corners.empty()) continue;
        shown.push_back(&each);
        corners += each.corners.size();
        // How many follow, how many faces, and for each face its corners and how many.
        numbers += 2 + each.beyond.size() + each.face_corners.size();
    }
    TextWriter text(out);
    text.put("# vtk DataFile Version 3.0\nsignum: power cells\nASCII\nDATASET UNSTRUCTURED_GRID\n");
    text.put(FMT_COMPILE("POINTS {} double\n"), corners);
    for (const SpacePolyhedron* each : shown)
        for (const Point3& p : each->corners) text.put(FMT_COMPILE("{} {} {}\n"), p.x, p.y, p.z);
    text.put(FMT_COMPILE("CELLS {} {}\n"), shown.size(), numbers);
    std::size_t first = 0;
    for (const SpacePolyhedron* each : shown) {
        text.put(FMT_COMPILE("{} {}"), 1 + each->beyond.size() + each->face_corners.size(),
                 each->beyond.size());
        for (std::size_t f = 0; f < each->beyond.size(); ++f) {
            const auto loop = each->corners_of(f);
            text.put(FMT_COMPILE(" {}"), loop.size());
            for (const Index corner : loop)
                text.put(FMT_COMPILE(" {}"), first + static_cast<std::size_t>(corner));
        }
        text.put("\n");
        first += each->corners.size();
    }
    constexpr int polyhedron = 42;
    text.put(FMT_COMPILE("CELL_TYPES {}\n"), shown.size());
    for (std::size_t i = 0; i < shown.size(); ++i) text.put(FMT_COMPILE("{}\n"), polyhedron);
    text.put(FMT_COMPILE("CELL_DATA {}\n"), shown.size());
    const auto put_column = [&](std::string_view name, std::string_view type, const auto& value) {
        text.put(FMT_COMPILE("SCALARS {} {} 1\nLOOKUP_TABLE default\n"), name, type);
        for (const SpacePolyhedron* each : shown) text.put(FMT_COMPILE("{}\n"), value(*each));
    };
    put_column("site", "int", [](const SpacePolyhedron& each) { return each.site; });
    put_column("volume", "double", [&](const SpacePolyhedron& each) {
        return cells.measures.at(static_cast<std::size_t>(each.site)).volume;
    });
    put_column("faces", "int", [](const SpacePolyhedron& each) { return each.beyond.size(); });
    text.flush();
}

}  // namespace signum
