#include "write_vtk.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "text_writer.hpp"

namespace signum {

void write_vtk(std::ostream& out, const SpaceTessellation& tessellation,
               std::span<const Site3> sites, WeightIs weight_is) {
    // VTK's numbers of vertex, line, triangle and tetrahedron.
    constexpr std::array kinds = {1, 3, 5, 10};
    TextWriter text(out);
    text.put(
        "# vtk DataFile Version 3.0\nsignum: power tessellation of space\nASCII\n"
        "DATASET UNSTRUCTURED_GRID\n");
    text.put(FMT_COMPILE("POINTS {} double\n"), sites.size());
    for (const auto& [x, y, z, r] : sites) text.put(FMT_COMPILE("{} {} {}\n"), x, y, z);
    const std::ptrdiff_t vertices = tessellation.dimension + 1;
    const auto is_finite = [](const SpaceCell& cell) { return cell[0] != infinite; };
    const auto finite = std::ranges::count_if(tessellation.cells, is_finite);
    text.put(FMT_COMPILE("CELLS {} {}\n"), finite, finite * (vertices + 1));
    for (const SpaceCell& cell : tessellation.cells)
        if (is_finite(cell))
            text.put(FMT_COMPILE("{} {}\n"), vertices,
                     fmt::join(cell.begin(), cell.begin() + vertices, " "));
    text.put(FMT_COMPILE("CELL_TYPES {}\n"), finite);
    const int kind = kinds[static_cast<std::size_t>(tessellation.dimension)];
    for (std::ptrdiff_t i = 0; i < finite; ++i) text.put(FMT_COMPILE("{}\n"), kind);
    text.put(FMT_COMPILE("POINT_DATA {}\nSCALARS {} double 1\nLOOKUP_TABLE default\n"),
             sites.size(), name_of(weight_is));
    for (const Site3& site : sites) text.put(FMT_COMPILE("{}\n"), site.r);
    std::vector<int> hidden(sites.size(), 0);
    for (const auto& [site, by] : tessellation.hidden) hidden[static_cast<std::size_t>(site)] = 1;
    text.put("SCALARS hidden int 1\nLOOKUP_TABLE default\n");
    for (const int each : hidden) text.put(FMT_COMPILE("{}\n"), each);
    text.flush();
}

}  // namespace signum
