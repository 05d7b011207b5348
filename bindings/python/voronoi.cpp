/// Voronoi diagrams of the plane, and their cells in a box.

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "../../voronoi/clip.hpp"
#include "../../voronoi/polygon.hpp"
#include "../../voronoi/voronoi.hpp"
#include "names.hpp"
#include "parts.hpp"
#include "results.hpp"
#include "watched.hpp"

namespace signum::python {
namespace {

using Shared = std::shared_ptr<const Voronoi>;

/// The cells in a box, and what they measure.
struct Clip {
    Clip(Shared of, const Box& in_box)
        : voronoi(std::move(of)), box(in_box), cells(*voronoi, box) {}

    Shared voronoi;
    Box box;
    ClippedVoronoi cells;
    std::vector<Measure> measures;
};

std::shared_ptr<Clip> clipped(const std::shared_ptr<Voronoi>& voronoi, const py::object& object) {
    const Box box =
        box_of(object).value_or(default_box(voronoi->tessellation().sites(), voronoi->exponent()));
    return watched([&](Watch&) {
        auto clip = std::make_shared<Clip>(voronoi, box);
        clip->measures = measures(clip->cells);
        return clip;
    });
}

double tolerance_of(const Clip& clip, const py::object& tolerance) {
    if (!tolerance.is_none()) return number_of(tolerance, "tolerance");
    return std::max(clip.box.x1 - clip.box.x0, clip.box.y1 - clip.box.y0) * 0x1p-12;
}

py::list polygon(const Clip& clip, Index site, const py::object& tolerance) {
    py::list loops;
    for (std::vector<Point>& loop : polygons(clip.cells.cell(site), tolerance_of(clip, tolerance)))
        loops.append(table<double>(std::move(loop)));
    return loops;
}

/// Of all cells: points, where each loop begins, and whose it is.
py::tuple all_polygons(const Clip& clip, const py::object& tolerance) {
    const double within = tolerance_of(clip, tolerance);
    std::vector<Point> points;
    std::vector<std::int64_t> first = {0};
    std::vector<Index> sites;
    watched([&](Watch& watch) {
        for (std::size_t s = 0; s < clip.measures.size(); ++s) {
            watch.at(s, clip.measures.size());
            for (const auto& loop : polygons(clip.cells.cell(static_cast<Index>(s)), within)) {
                points.insert(points.end(), loop.begin(), loop.end());
                first.push_back(static_cast<std::int64_t>(points.size()));
                sites.push_back(static_cast<Index>(s));
            }
        }
    });
    return py::make_tuple(table<double>(std::move(points)), column(std::move(first)),
                          column(std::move(sites)));
}

/// The parts of an edge in the box, each a chain of points.
py::list edge_lines(const Clip& clip, Index edge, const py::object& tolerance) {
    const double within = tolerance_of(clip, tolerance);
    py::list lines;
    std::vector<Point> points;
    for (const Conic& conic : clip.cells.edge(edge)) {
        if (points.empty() || points.back() != conic.from) {
            if (!points.empty()) lines.append(table<double>(std::exchange(points, {})));
            points.push_back(conic.from);
        }
        sample(conic, within, points);
    }
    if (!points.empty()) lines.append(table<double>(std::move(points)));
    return lines;
}

py::array cell(const Voronoi& voronoi, Index site) {
    std::vector<Edge> steps;
    for (const VoronoiStep& step : voronoi.cell(site)) steps.push_back({step.edge, step.forward});
    return table<Index>(std::move(steps));
}

void bind_diagram(py::module_& module) {
    static_assert(sizeof(VoronoiEdge) == 6 * sizeof(Index));
    py::class_<Voronoi, std::shared_ptr<Voronoi>> bound(
        module, "Voronoi",
        R"(The Voronoi diagram of a tessellation of the plane.

Vertices, edges along bisectors and cells; unbounded ones as well. What voronoi() gives. Its arrays are
read-only views of its memory.)");
    complete(bound);
    bound
        .def_property_readonly(
            "tessellation", &Voronoi::tessellation, py::return_value_policy::reference_internal,
            "The Tessellation whose diagram it is; a copy of that it was made of.")
        .def_property_readonly(
            "vertices", shown<double>(&Voronoi::vertices),
            "float64 (v, 3), x, y, rho: each number the double nearest to the exact value.")
        .def_property_readonly(
            "vertex_of_face",
            [](const py::object& self) {
                return column(self.cast<const Voronoi&>().vertex_of_face(), self);
            },
            "int32, by face of the tessellation: its vertex, -1 where it has none.")
        .def_property_readonly(
            "edges", shown<Index>(&Voronoi::edges),
            R"(int32 (e, 6): the sites to the left and right, the vertices from and to, their faces.

An edge runs with its first site on the left; a vertex of -1 lies at infinity.)")
        .def(
            "cell", &cell, py::arg("site"),
            R"(The boundary of a cell, counterclockwise: int32 (k, 2), an edge and whether it runs forward.

It begins behind infinity where the cell is unbounded; empty for a hidden site and for one that is alone.
Raises IndexError where there is no such site.)")
        .def("is_hidden", &Voronoi::is_hidden, py::arg("site"), "Whether the site has no cell.")
        .def("is_unbounded", &Voronoi::is_unbounded, py::arg("site"),
             "Whether its cell has no end.")
        .def(
            "edge_kind",
            [](const Voronoi& v, Index edge) -> py::object {
                const auto geometry = v.geometry(edge);
                return geometry ? py::object(text(name_of(geometry->kind))) : py::none();
            },
            py::arg("edge"),
            R"(What an edge looks like: 'point', 'segment', 'ray', 'line', 'polyline' or 'hyperbola'.

None where its sites are too near to each other for a direction. Raises IndexError where there is no such
edge.)")
        .def("clip", &clipped, py::arg("box") = py::none(),
             R"(The cells in a box, (x0, y0, x1, y1): a Cells.

Without one in the smallest box around all centres, wider by a tenth of its longer side. Raises ValueError
unless x0 < x1 and y0 < y1, and where doubles cannot tell the box beside the sites. O(n).)")
        .def("__repr__", [](const Voronoi& v) {
            return "<signum.Voronoi: " + std::string(name_of(v.tessellation().metric())) + ", " +
                   std::to_string(v.vertices().size()) + " vertices, " +
                   std::to_string(v.edges().size()) + " edges>";
        });
}

void bind_cells(py::module_& module) {
    static_assert(sizeof(Measure) == 4 * sizeof(double));
    const auto measures = [](const py::object& self, std::size_t offset, std::size_t columns) {
        return part<double>(std::span<const Measure>(self.cast<const Clip&>().measures), offset,
                            columns, self);
    };
    py::class_<Clip, std::shared_ptr<Clip>> bound(
        module, "Cells",
        R"(The cells of the plane in a box, which they tile.

What Voronoi.clip() gives. Areas and centroids are those of the true shapes, arcs of hyperbolas included.)");
    complete(bound);
    bound
        .def_property_readonly(
            "voronoi",
            [](const Clip& clip) { return std::const_pointer_cast<Voronoi>(clip.voronoi); },
            "The Voronoi diagram whose cells they are.")
        .def_property_readonly(
            "box",
            [](const Clip& clip) {
                return py::make_tuple(clip.box.x0, clip.box.y0, clip.box.x1, clip.box.y1);
            },
            "(x0, y0, x1, y1).")
        .def_property_readonly(
            "areas", [=](const py::object& self) { return measures(self, 0, 1); },
            "float64 (n,); 0 for a hidden site and for one whose cell is not in the box.")
        .def_property_readonly(
            "perimeters", [=](const py::object& self) { return measures(self, 1, 1); },
            "float64 (n,), pieces of the box's border included.")
        .def_property_readonly(
            "centroids", [=](const py::object& self) { return measures(self, 2, 2); },
            "float64 (n, 2); NaN where there is no area.")
        .def("polygon", &polygon, py::arg("site"), py::arg("tolerance") = py::none(),
             R"(A cell as a list of polygons (k, 2), counterclockwise, the first point not repeated.

More than one where the box cuts the cell in pieces. Arcs get as many points as keep within tolerance,
2^-12 of the box's longer side unless it is given; both cells at an edge get the same ones. Raises
IndexError where there is no such site, ValueError for a tolerance that is not positive.)")
        .def("polygons", &all_polygons, py::arg("tolerance") = py::none(),
             R"(All cells as (points, first, sites): float64 (k, 2), int64 (m + 1,), int32 (m,).

Polygon p is points[first[p]:first[p + 1]], of the cell of sites[p]. See polygon().)")
        .def("edge_lines", &edge_lines, py::arg("edge"), py::arg("tolerance") = py::none(),
             R"(The parts of an edge of the diagram in the box, each a chain of points (k, 2).

Raises IndexError where there is no such edge.)")
        .def(
            "__len__", [](const Clip& clip) { return clip.measures.size(); },
            "How many sites there are.");
}

}  // namespace

void bind_voronoi(py::module_& module) {
    bind_diagram(module);
    bind_cells(module);
    module.def(
        "voronoi",
        [](const Tessellation& tessellation, bool merge, int threads) {
            const VoronoiOptions options{.merge = merge, .threads = threads_of(threads)};
            return watched(
                [&](Watch&) { return std::make_shared<Voronoi>(tessellation, options); });
        },
        py::arg("tessellation"), py::kw_only(), py::arg("merge") = false, py::arg("threads") = 0,
        R"(The Voronoi diagram of a tessellation, of which it keeps a copy: a Voronoi. O(n).

merge: one vertex for neighbouring faces whose circles are the same, as on grids.
threads: as for triangulate().)");
}

}  // namespace signum::python
